// The smallest program that draws figure 3, or another one of 3 to 6 that is named: it prints the
// lines of tests/goldens/hashes.txt that it has drawn. tests/guards/features.sh builds it with few
// features, runs it and prints its size.
#include "fixed/fnv.hpp"
#include "shadow/frame/features.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <cstdio>

using namespace umbra78;

alignas(shadow::frame_alignment) static std::byte memory[14 << 18];

static void print(const char* name, std::span<const std::uint8_t> plane) {
    fixed::Fnv1a64 hash;
    for (const std::uint8_t v : plane) hash.byte(v);
    std::printf("%s u8:512x512:fnv1a64:%016llx\n", name,
                static_cast<unsigned long long>(hash.value()));
}

static void print(const char* name, std::span<const hw::Depth16> plane) {
    fixed::Fnv1a64 hash;
    for (const hw::Depth16 v : plane) hash.u16be(v);
    std::printf("%s u16be:512x512:fnv1a64:%016llx\n", name,
                static_cast<unsigned long long>(hash.value()));
}

int main(int count, char** arguments) {
    const int figure = count > 1 ? arguments[1][0] - '0' : 3;
    if (figure < 3 || figure > 6) return 2;
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    const raster::View observer = shadow::figure_view(0);
    const raster::View light = shadow::figure_view(shadow::figure_azimuth_q16);
    const shadow::Scene scene{patches, materials, observer, {{light}}};
    const shadow::Settings settings = shadow::figure_settings(figure);
    auto frame = shadow::carve<hw::Depth16>(memory, settings.machine, patches.size());
    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;
    if (shadow::render(scene, settings, frame, matrices, counts) != shadow::FrameStatus::ok) {
        const std::string_view missing = shadow::missing_feature(scene, settings);
        std::printf("figure %d needs the feature %.*s: add it to UMBRA78_FEATURES\n", figure,
                    static_cast<int>(missing.size()), missing.data());
        return 1;
    }
    const shadow::LightBuffers<hw::Depth16>& of_light = frame.lights[0];
    print("light_z", std::span<const hw::Depth16>(of_light.map.depth));
    print("observer_z", std::span<const hw::Depth16>(frame.observer.depth));
    print("intensity", std::span<const std::uint8_t>(frame.observer.intensity));
    if (figure == 3) print("mask3", of_light.mask);
    if (figure == 4) print("mask4", of_light.mask);
    if (figure == 5) print("filtered5", of_light.filtered);
    if (figure == 6) print("picture6", frame.picture);
}
