// For ThreadSanitizer (threads.sh): frames of patches and of facets, by one worker and by three
// threads. Ends with 1 where they differ; with an argument the threads share a line of work, which
// the sanitizer must see.
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"
#include "tests/support/workers.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

using namespace umbra78;
using hw::Depth16;

namespace {

struct Frame {
    std::unique_ptr<std::byte, void (*)(std::byte*)> memory{nullptr, nullptr};
    shadow::FrameBuffers<Depth16> buffers;
    shadow::FrameMatrices matrices{};
    shadow::FrameCounts counts{};

    Frame(const shadow::Scene& scene, const shadow::Settings& s, const shadow::Executor& executor) {
        shadow::FrameShape shape(scene, s);
        shape.workers = executor.workers;
        const std::size_t bytes =
            shadow::frame_bytes<Depth16>(s.machine, scene.patches.size(), shape);
        memory = {static_cast<std::byte*>(::operator new(bytes, std::align_val_t{64})),
                  [](std::byte* p) { ::operator delete(p, std::align_val_t{64}); }};
        buffers = shadow::carve<Depth16>({memory.get(), bytes}, s.machine, scene.patches.size(),
                                         shape);
        buffers.executor = executor;
        shadow::render(scene, s, buffers, matrices, counts);
    }
};

bool same(const shadow::Settings& settings) {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    const std::array<raster::World, 3> corners{
        {{-90000, -90000, 0}, {90000, -90000, 30000}, {0, 90000, -30000}}};
    std::array<raster::Facet, 40> facets;
    facets.fill({{0, 1, 2}});
    shadow::Scene scene{patches, materials, shadow::figure_view(0),
                        {{shadow::figure_view(shadow::figure_azimuth_q16)}}};
    scene.mesh = {corners, {}, facets};
    umbra78::test::Threads threads(3);
    const Frame one(scene, settings, {}), many(scene, settings, threads.executor());
    return std::ranges::equal(one.buffers.picture, many.buffers.picture) &&
           std::ranges::equal(one.buffers.lights[0].map.depth, many.buffers.lights[0].map.depth);
}

bool race() {
    umbra78::test::Threads threads(3);
    int shared = 0;
    shadow::for_bands(threads.executor(), 512, [&](hw::Band band, std::size_t) {
        for (int y = band.first; y < band.end; ++y) ++shared;
    });
    return shared > 0;
}

}  // namespace

int main(int argc, char**) {
    if (argc > 1) return race() ? 0 : 1;
    for (const int figure : {3, 4, 6}) {
        for (const shadow::Form form : {shadow::Form::post_process, shadow::Form::correct}) {
            shadow::Settings settings = shadow::figure_settings(figure);
            settings.machine.xy_bits = 7;
            settings.form = form;
            settings.dequantize_passes = 3;
            settings.low_pass_passes = 2;
            if (same(settings)) continue;
            std::printf("figure %d differs\n", figure);
            return 1;
        }
    }
}
