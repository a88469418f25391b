#include "tools/paper/figure_set.hpp"

#include "tools/render/cycle_report.hpp"

#include <utility>

namespace umbra78::tools {
namespace {

using shadow::figure_settings;

Buffer named(Buffer buffer, const char* name) {
    buffer.name = name;
    return buffer;
}

}  // namespace

LoadedScene figures_scene() {
    LoadedScene scene;
    scene.name = "figures";
    scene.materials = {shadow::figure_material};
    scene.spheres.assign(shadow::figure_spheres.begin(), shadow::figure_spheres.end());
    const shadow::FigurePatches patches = shadow::figure_patches();
    scene.patches.assign(patches.begin(), patches.end());
    scene.observer = shadow::figure_view(0);
    scene.light() = shadow::figure_view(shadow::figure_azimuth_q16);
    scene.settings = figure_settings(shadow::figure_count);
    return scene;
}

FigureSet::FigureSet()
    : truth_(*trace(scene_)),
      band_(light_texel_band(truth_)),
      job_(scene_.view(), figure_settings(3)) {
    job_.draw_light();
    job_.draw_observer();
    visible_ = job_.visible();
    const StageTimes drawn = job_.times();
    const auto cycles = [&](int figure) { return of_figure(job_.ledger(), figure).total(true); };
    add(1, "picture, no shadows yet", copy(Plane::intensity),
        job_.buffer(Plane::intensity), cycles(1),
        drawn.matrices_ms + drawn.observer_ms);
    add(2, "the light's depth map", depth_as_gray(job_.buffer(Plane::light_z)),
        job_.buffer(Plane::light_z), cycles(2), drawn.matrices_ms + drawn.light_ms);

    const auto ms_so_far = [&] { return job_.times().total_ms(); };
    job_.cast_shadows();
    mask3_ = copy(Plane::mask);
    add(3, "shadow: nearest lookup, low bias", mask3_, mask_buffer("mask3", mask3_), cycles(3),
        ms_so_far(), mask3_);

    shadow::Settings index = figure_settings(3);
    index.registration = shadow::Registration::index;
    index_mask_ = mask_with(index);
    for (const int figure : {3, 4})
        ap120b_masks_[static_cast<std::size_t>(figure - 3)] =
            mask_with(shadow::array_figure_settings(figure));

    job_.use(figure_settings(4));
    job_.cast_shadows();
    add(4, "shadow: bilinear, dither, bias", copy(Plane::mask),
        named(job_.buffer(Plane::mask), "mask4"), cycles(4), ms_so_far(),
        job_.bytes(Plane::mask));

    // Figures 5 and 6 share figure 4's comparison.
    job_.use(figure_settings(6));
    job_.filter_and_composite();
    add(5, "edges dequantized, low-passed", copy(Plane::filtered),
        named(job_.buffer(Plane::filtered), "filtered5"), cycles(5), ms_so_far(),
        job_.bytes(Plane::filtered));
    add(6, "shadow laid on the picture", copy(Plane::picture),
        named(job_.buffer(Plane::picture), "picture6"), cycles(6), ms_so_far(),
        job_.bytes(Plane::filtered));
}

void FigureSet::add(int number, std::string shows, std::vector<std::uint8_t> picture,
                    const Buffer& golden, std::uint64_t cycles, double host_ms,
                    std::span<const std::uint8_t> mask) {
    const shadow::Settings settings = figure_settings(number);
    std::optional<ShadowReport> error;
    if (!mask.empty())
        error = report(truth_, {mask, visible_}, widened(band_, truth_, settings));
    figures_[static_cast<std::size_t>(number - 1)] = {
        number, std::move(shows), std::move(picture), golden.name,
        hash_of(golden), cycles, host_ms, bias_report(job_),
        error, settings};
}

std::vector<std::uint8_t> FigureSet::copy(Plane plane) const {
    const auto bytes = job_.bytes(plane);
    return {bytes.begin(), bytes.end()};
}

std::vector<std::uint8_t> FigureSet::mask_with(const shadow::Settings& settings) {
    job_.use(settings);
    job_.cast_shadows();
    return copy(Plane::mask);
}

std::vector<Buffer> FigureSet::buffers() const {
    return {job_.buffer(Plane::observer_z),
            job_.buffer(Plane::light_z),
            job_.buffer(Plane::intensity),
            mask_buffer("mask3", mask3_),
            named(job_.buffer(Plane::mask), "mask4"),
            named(job_.buffer(Plane::edges), "edges5"),
            named(job_.buffer(Plane::filtered), "filtered5"),
            named(job_.buffer(Plane::picture), "picture6"),
            mask_buffer("mask3_ap120b", ap120b_mask(3)),
            mask_buffer("mask4_ap120b", ap120b_mask(4))};
}

}  // namespace umbra78::tools
