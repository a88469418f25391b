// Ten lines against the installed core: the hash of figure 6.
#include "fixed/fnv.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <cstdio>

using namespace umbra78;

alignas(shadow::frame_alignment) static std::byte memory[14 << 18];

int main() {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    const shadow::Scene scene{patches, materials, shadow::figure_view(0),
                              {{shadow::figure_view(shadow::figure_azimuth_q16)}}};
    const shadow::Settings settings = shadow::figure_settings(6);
    auto frame = shadow::carve<hw::Depth16>(memory, settings.machine, patches.size());
    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;
    if (shadow::render(scene, settings, frame, matrices, counts) != shadow::FrameStatus::ok)
        return 1;
    fixed::Fnv1a64 hash;
    for (const std::uint8_t v : frame.picture) hash.byte(v);
    std::printf("picture6 u8:512x512:fnv1a64:%016llx\n", (unsigned long long)hash.value());
}
