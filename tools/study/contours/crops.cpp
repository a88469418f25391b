#include "tools/study/contours/crops.hpp"

#include "tools/render/render_job.hpp"
#include "tools/truth/shadow_edge.hpp"

#include <algorithm>

namespace umbra78::tools::study {
namespace {

constexpr int crop_px = 96, magnified = 3, gap_px = 8;

// The middle of the longest piece of a surface's own shadow line, or of the picture.
ImagePoint middle_of_the_line(const SceneTruth& truth) {
    const auto edges = shadow_edges(truth, cells_of_one_surface(truth.truth, {}));
    ImagePoint middle{truth.truth.size / 2.0, truth.truth.size / 2.0};
    std::size_t most = 0;
    for (const ShadowEdge& edge : edges) {
        if (edge.kind != EdgeKind::self || edge.line.size() <= most) continue;
        most = edge.line.size();
        middle = edge.line[most / 2];
    }
    return middle;
}

}  // namespace

Crops crops(const LoadedScene& scene, std::span<const std::pair<int, int>> passes) {
    Crops out;
    const auto truth = trace(scene);
    if (!truth || !truth->closed_form) return out;
    const int size = truth->truth.size, side = std::min(crop_px, size);
    const ImagePoint middle = middle_of_the_line(*truth);
    const auto from = [&](double at) {
        return std::clamp(static_cast<int>(at) - side / 2, 0, size - side);
    };
    const int left = from(middle.column), top = from(middle.row), shown = side * magnified;
    const int count = static_cast<int>(passes.size());
    out.height = shown;
    out.width = count * (shown + gap_px) - gap_px;
    out.grey.assign(static_cast<std::size_t>(out.width) * out.height, 128);
    shadow::Settings settings = scene.settings;
    RenderJob job(scene.view(), settings);
    for (int k = 0; k < count; ++k) {
        settings.dequantize_passes = passes[k].first;
        settings.low_pass_passes = passes[k].second;
        job.use(settings);
        job.render();
        const auto mask = job.bytes(Plane::filtered);
        for (int y = 0; y < shown; ++y)
            for (int x = 0; x < shown; ++x)
                out.grey[static_cast<std::size_t>(y) * out.width + k * (shown + gap_px) + x] =
                    static_cast<std::uint8_t>(
                        255 - mask[static_cast<std::size_t>(top + y / magnified) * size + left +
                                   x / magnified]);
    }
    return out;
}

}  // namespace umbra78::tools::study
