// Prints a line "buffer hash" for each stage of figures 1 to 6, and for frames that take the other
// paths: leaf sampling, the correct form, perspective, a point light, 24-bit Z. The core alone, so
// that tests/guards/compilers.sh can build it by any compiler in a few seconds.
#include "fixed/fnv.hpp"
#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace umbra78;

template <class Value>
void print(const char* name, std::span<const Value> values, int size) {
    fixed::Fnv1a64 h;
    for (const Value v : values) {
        if constexpr (sizeof(Value) == 1) h.byte(v);
        if constexpr (sizeof(Value) == 2) h.u16be(v);
        if constexpr (sizeof(Value) == 4) h.u32be(v);
    }
    const int bits = 8 * static_cast<int>(sizeof(Value));
    std::printf("%s u%d%s:%dx%d:fnv1a64:%016llx\n", name, bits, bits == 8 ? "" : "be", size, size,
                static_cast<unsigned long long>(h.value()));
}

// One frame's memory, with another value in every byte at the start: nothing may depend on it.
template <class Depth>
struct Memory {
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    std::vector<Line> lines;
    shadow::FrameBuffers<Depth> frame;
    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;

    Memory(const shadow::Scene& scene, const shadow::Settings& settings, int filler) {
        const std::size_t bytes =
            shadow::frame_bytes<Depth>(settings.machine, scene.patches.size());
        Line line;
        for (std::byte& b : line.bytes) b = static_cast<std::byte>(filler);
        lines.assign((bytes + 63) / 64, line);
        frame = shadow::carve<Depth>({lines.front().bytes, 64 * lines.size()}, settings.machine,
                                     scene.patches.size());
        if (shadow::render(scene, settings, frame, matrices, counts) != shadow::FrameStatus::ok)
            std::abort();
    }
};

template <class Value>
void print(const char* name, std::span<Value> values) {
    print<Value>(name, std::span<const Value>(values), 512);
}

void print_figures(int filler) {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    const shadow::Scene scene{patches, materials, shadow::figure_view(0),
                              {{shadow::figure_view(shadow::figure_azimuth_q16)}}};
    const Memory<hw::Depth16> m3(scene, shadow::figure_settings(3), filler);
    const Memory<hw::Depth16> m4(scene, shadow::figure_settings(4), filler);
    const Memory<hw::Depth16> m6(scene, shadow::figure_settings(6), filler);
    print("observer_z", m3.frame.observer.depth);
    print("light_z", m3.frame.lights[0].map.depth);
    print("intensity", m3.frame.observer.intensity);
    print("mask3", m3.frame.lights[0].mask);
    print("mask4", m4.frame.lights[0].mask);
    print("edges5", m6.frame.lights[0].edges);
    print("filtered5", m6.frame.lights[0].filtered);
    print("picture6", m6.frame.picture);
    const Memory<hw::Depth16> a3(scene, shadow::array_figure_settings(3), filler);
    const Memory<hw::Depth16> a4(scene, shadow::array_figure_settings(4), filler);
    print("mask3_ap120b", a3.frame.lights[0].mask);
    print("mask4_ap120b", a4.frame.lights[0].mask);
}

void print_other_paths(int filler) {
    const shadow::FigurePatches patches = shadow::figure_patches();
    const std::array materials{shadow::figure_material};
    raster::View observer, light;
    observer.projection = light.projection = raster::Projection::perspective;
    observer.axes = raster::axes_from_angles(30 << 16, 20 << 16);
    observer.extent = light.extent = 5 << 15;
    observer.distance = 6 << 16;
    light.distance = 440000;
    raster::axes_from_points({-5 << 16, 4 << 16, 2 << 16}, {}, light.axes);
    raster::fit_depth(observer, raster::depth_range(observer, patches));
    raster::fit_depth(light, raster::depth_range(light, patches));
    shadow::Settings settings = shadow::figure_settings(6);
    settings.machine.z_bits = 24;
    settings.machine.coefficient_bits = 32;
    settings.machine.fraction_bits = 12;
    settings.bias_q16 = std::int64_t{192 << 8} << 16;
    const shadow::Scene scene{patches, materials, observer, {{light}}};
    const Memory<hw::Depth32> wide(scene, settings, filler);
    print("observer_z_wide", wide.frame.observer.depth);
    print("light_z_wide", wide.frame.lights[0].map.depth);
    print("mask_wide", wide.frame.lights[0].mask);
    print("picture_wide", wide.frame.picture);
    settings = shadow::figure_settings(3);
    settings.sampling = raster::Sampling::leaf;
    settings.form = shadow::Form::correct;
    const Memory<hw::Depth16> leaf(scene, settings, filler);
    print("observer_z_leaf", leaf.frame.observer.depth);
    print("mask_correct", leaf.frame.lights[0].mask);
    print("picture_correct", leaf.frame.picture);
}

}  // namespace

// The argument is the byte that memory holds before a frame, 0..255.
int main(int argc, char** argv) {
    const int filler = argc > 1 ? std::atoi(argv[1]) : 0;
    print_figures(filler);
    print_other_paths(filler);
}
