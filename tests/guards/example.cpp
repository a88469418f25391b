// The README's example of the core as a library: figure 6 as a PGM on standard output. The guard
// readme.sh holds the README's copy equal to this file from the first #include on.
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <cstdio>

using namespace umbra78;

alignas(shadow::frame_alignment) static std::byte memory[14 << 18];  // all that a frame takes

int main() {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    const raster::View observer = shadow::figure_view(0);
    const raster::View light = shadow::figure_view(shadow::figure_azimuth_q16);
    const shadow::Scene scene{patches, materials, observer, {{light}}};
    const shadow::Settings settings = shadow::figure_settings(6);

    // 16 bits a Z word; a machine with more than 16 bits of Z takes hw::Depth32.
    using hw::Depth16;
    const std::size_t bytes = shadow::frame_bytes<Depth16>(settings.machine, patches.size());
    if (bytes > sizeof memory) return 1;
    auto frame = shadow::carve<Depth16>({memory, bytes}, settings.machine, patches.size());

    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;
    const auto status = shadow::render(scene, settings, frame, matrices, counts);
    if (status != shadow::FrameStatus::ok) return 1;

    std::printf("P5\n%d %d\n255\n", settings.machine.size_px(), settings.machine.size_px());
    std::fwrite(frame.picture.data(), 1, frame.picture.size(), stdout);
}
