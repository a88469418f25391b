// What the claims stand on: the figures' scene in truth, the machine's frame of it, and masks made
// with a noise of the test's own.
//
// Every claim prints its numbers; they are the README's. Truth is in closed form and in double
// precision (tools/truth/truth.hpp): nothing of the machine is in it.
#pragma once

#include "tests/shadow/frame/figure_frame.hpp"
#include "tools/truth/edge_bands.hpp"
#include "tools/truth/metrics.hpp"
#include "tools/truth/spectrum.hpp"
#include "tools/truth/truth.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace umbra78::claims {

using shadow::Settings;
using tools::ShadowError;

inline double q16(std::int64_t word) { return static_cast<double>(word) / 65536; }

inline tools::TruthView figure_truth_view(double azimuth, int size_px) {
    const double a = azimuth * std::numbers::pi / 180;
    tools::TruthView v{};
    v.rotation[0] = {std::cos(a), 0, -std::sin(a)};
    v.rotation[1] = {0, 1, 0};
    v.rotation[2] = {std::sin(a), 0, std::cos(a)};
    v.extent = v.far_depth = 2;
    v.near_depth = -2;
    v.size = size_px;
    return v;
}

// The figures' scene in truth, under a light at the azimuth, in degrees.
struct Ground {
    explicit Ground(double azimuth = q16(shadow::figure_azimuth_q16), int size_px = 512)
        : observer(figure_truth_view(0, size_px)),
          light_view(figure_truth_view(azimuth, size_px)) {
        for (const raster::Sphere& s : shadow::figure_spheres)
            scene.spheres.push_back(
                {{q16(s.centre.x), q16(s.centre.y), q16(s.centre.z)}, q16(s.radius)});
        light.direction = light_view.rotation[2];
        truth = tools::trace(scene, observer, light);
    }
    // One light texel mapped back to the observer, and the reach of the mask's filters.
    std::vector<std::uint8_t> band(double filter_radius_px) const {
        return light_texel_band(scene, light, light_view, truth, filter_radius_px);
    }

    tools::TruthScene scene;
    tools::TruthView observer, light_view;
    tools::TruthLight light{};
    tools::Truth truth;
};

// The figures' own truth: traced once.
inline const Ground& ground() {
    static const Ground figures;
    return figures;
}

inline const shadow::test::FigureScene& figures() {
    static const shadow::test::FigureScene scene;
    return scene;
}

// A frame of the figures' scene, and the masks as the metrics want them.
struct Machine {
    explicit Machine(const Settings& s, int azimuth = -100)
        : settings(s), frame(figures().scene(azimuth * 65536), s) {
        for (const hw::Depth16 z : frame.buffers.observer.depth)
            visible.push_back(z != s.machine.background() ? 1 : 0);
    }
    tools::MachineMask compared() const { return {frame.buffers.lights[0].mask, visible}; }
    tools::MachineMask filtered(int threshold = 128) const {
        return {frame.buffers.lights[0].filtered, visible, threshold};
    }
    const shadow::FrameBuffers<hw::Depth16>& buffers() const { return frame.buffers; }

    Settings settings;
    shadow::test::Frame<> frame;
    std::vector<std::uint8_t> visible;
};

// The post-process with another noise: the words of pixel (x, y), whatever they are.
using Noise = std::function<hw::DitherWords(int x, int y)>;

// The same through another depth map.
inline std::vector<std::uint8_t> mask_through(const hw::FrameStore<const hw::Depth16>& depths,
                                              const Machine& machine, const Noise& noise) {
    const Settings& s = machine.settings;
    const auto& b = machine.buffers();
    const shadow::LightMap<hw::Depth16> map{depths, s.machine, s.lookup, s.background};
    const hw::TransformUnit unit(s.machine, machine.frame.matrices.lights[0].observer_to_light);
    std::vector<std::uint8_t> mask(b.lights[0].mask.size());
    for (int y = 0; y < s.machine.size_px(); ++y)
        for (int x = 0; x < s.machine.size_px(); ++x) {
            const std::size_t a = b.observer.address(x, y);
            if (machine.visible[a] == 0) continue;
            const hw::Words words = shadow::pixel_words(x, y, b.observer.depth[a], s);
            mask[a] = in_shadow(map, unit(words), noise(x, y)) ? shadow::mask_shadow
                                                               : shadow::mask_lit;
        }
    return mask;
}

inline std::vector<std::uint8_t> mask_with_noise(const Machine& machine, const Noise& noise) {
    return mask_through(machine.buffers().lights[0].map, machine, noise);
}

// The machine's noise for a whole frame, row by row.
inline std::vector<hw::DitherWords> noise_plane(hw::DitherShape shape,
                                                std::int32_t size_q8 = 256) {
    const hw::MachineSpec spec;
    hw::Dither dither;
    dither.shape = shape;
    dither.size_q8 = size_q8;
    hw::NoiseSource source(dither, spec, 0, 0);
    std::vector<hw::DitherWords> plane(std::size_t{1} << (2 * spec.xy_bits));
    for (hw::DitherWords& w : plane) w = source.next();
    return plane;
}

inline Settings with(Settings s, shadow::Lookup lookup, int bias_quanta,
                     hw::DitherShape shape = hw::DitherShape::none) {
    s.lookup = lookup;
    s.bias_q16 = std::int64_t{bias_quanta} << 16;
    s.bias_unit = shadow::BiasUnit::quanta;
    s.dither.shape = shape;
    return s;
}

inline const char* name(shadow::Lookup lookup) {
    return lookup == shadow::Lookup::nearest ? "nearest" : "bilinear";
}

// False shadow from the limb (first) to the shadow line (last), over all four spheres.
inline std::vector<ShadowError> profile(const Ground& g, const tools::MachineMask& mask,
                                        int bins) {
    std::vector<ShadowError> sum(static_cast<std::size_t>(bins));
    for (int k = 0; k < 4; ++k) {
        const auto one =
            limb_to_line_profile(g.truth, mask, g.scene, k, g.observer, g.light, bins);
        for (std::size_t b = 0; b < sum.size(); ++b) {
            sum[b].lit += one[b].lit;
            sum[b].false_shadow += one[b].false_shadow;
        }
    }
    return sum;
}

}  // namespace umbra78::claims
