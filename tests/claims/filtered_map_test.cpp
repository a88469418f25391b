// A band-limited light's Z: Williams says that to low-pass the depth map "would not improve
// matters". Here it is low-passed before the test, by the 3 x 3 binomial, in two ways: with the
// background as the depth that it holds, and from drawn texels alone.
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

namespace umbra78::claims {
namespace {

using shadow::Lookup;
using Depths = std::vector<hw::Depth16>;

// A pass; ties are rounded up. `background` counts like any depth, or not at all.
Depths low_passed(const Depths& in, int size, std::uint32_t background, bool counts_background) {
    Depths out(in.size());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            std::uint64_t sum = 0, weights = 0;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    const int u = x + i, v = y + j;
                    const bool inside = u >= 0 && v >= 0 && u < size && v < size;
                    const std::uint32_t z =
                        inside ? in[static_cast<std::size_t>(v) * size + u] : background;
                    if (z == background && !counts_background) continue;
                    const std::uint64_t weight = std::uint64_t(2 - (i & 1)) * (2 - (j & 1));
                    sum += weight * z;
                    weights += weight;
                }
            const std::size_t at = static_cast<std::size_t>(y) * size + x;
            const bool empty = weights == 0 || (in[at] == background && !counts_background);
            out[at] = static_cast<hw::Depth16>(empty ? background
                                                     : (2 * sum + weights) / (2 * weights));
        }
    return out;
}

struct MapErrors {
    ShadowError all, outside;
    double wrong() const {
        return static_cast<double>(all.false_shadow + all.false_light) /
               (all.lit + all.shadowed);
    }
};

// With that many passes over the map, through the post-process as it is.
MapErrors through_passes(const Machine& machine, int passes, bool counts_background) {
    const auto& map = machine.buffers().lights[0].map;
    const Settings& s = machine.settings;
    const int size = s.machine.size_px();
    Depths depths;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) depths.push_back(map.depth[map.address(x, y)]);
    for (int k = 0; k < passes; ++k)
        depths = low_passed(depths, size, s.machine.background(), counts_background);
    Depths stored(depths.size());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            stored[map.address(x, y)] = depths[static_cast<std::size_t>(y) * size + x];
    hw::FrameStore<const hw::Depth16> store = map;
    store.depth = stored;
    const auto plane = noise_plane(s.dither.shape == hw::DitherShape::none
                                       ? hw::DitherShape::normal : s.dither.shape);
    const bool silent = s.dither.shape == hw::DitherShape::none;
    const auto mask = mask_through(store, machine, [&](int x, int y) {
        return silent ? hw::DitherWords{0, 0}
                      : plane[static_cast<std::size_t>(y) * size + x];
    });
    const tools::MachineMask seen{mask, machine.visible};
    return {shadow_error(ground().truth, seen), shadow_error(ground().truth, seen,
                                                             ground().band(0))};
}

TEST(FilteredMap, WithNoPassIsTheMachine) {
    const Machine machine(shadow::figure_settings(4));
    const auto e = through_passes(machine, 0, true);
    const ShadowError own = shadow_error(ground().truth, machine.compared());
    EXPECT_EQ(e.all.false_shadow, own.false_shadow);
    EXPECT_EQ(e.all.false_light, own.false_light);
}

TEST(FilteredMap, ABandLimitedLightsZDoesNotImproveMatters) {
    const struct {
        const char* name;
        Settings settings;
    } kinds[] = {{"figure 3: nearest, bias 64", shadow::figure_settings(3)},
                 {"nearest, bias 192", with(shadow::figure_settings(3), Lookup::nearest, 192)},
                 {"bilinear, bias 64", with(shadow::figure_settings(3), Lookup::bilinear, 64)},
                 {"figure 4: bilinear, dither, bias 192", shadow::figure_settings(4)}};
    const double bilinear = through_passes(Machine(kinds[2].settings), 0, true).wrong();
    for (const auto& [name, settings] : kinds) {
        const Machine machine(settings);
        const MapErrors plain = through_passes(machine, 0, true);
        for (const bool counts : {true, false})
            for (const int passes : {0, 1, 2, 4}) {
                const MapErrors e = through_passes(machine, passes, counts);
                std::printf("%-38s %d passes, background %-11s false shadow %.4f (outside the "
                            "band %.4f), false light %.4f, wrong %.4f\n",
                            name, passes, counts ? "filtered:" : "left out:",
                            e.all.false_shadow_rate(), e.outside.false_shadow_rate(),
                            e.all.false_light_rate(), e.wrong());
                if (passes == 0) continue;
                EXPECT_GT(e.wrong(), plain.wrong()) << name << ", " << passes << " passes";
                EXPECT_GT(e.wrong(), 1.2 * bilinear) << "what interpolation alone does";
            }
    }
}

}  // namespace
}  // namespace umbra78::claims
