// Figures 3 and 4 on the AP-120B, which the paper names: what its floating point changes, and the
// time it takes.
#include "tests/claims/ground.hpp"

#include "shadow/ap120b/cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string_view>

namespace umbra78::claims {
namespace {

using shadow::figure_settings;

struct Comparison {
    int differ = 0, only_array = 0;
    ShadowError fixed, array;
};

// A figure in fixed point and on the AP-120B, both with these settings, which may change what is
// drawn too; the first with another bias.
Comparison compare_figure(int figure, const Settings& s, std::int64_t less_bias_q16 = 0) {
    Settings on_fixed = s, on_array = s;
    on_fixed.bias_q16 -= less_bias_q16;
    on_array.arithmetic = shadow::Arithmetic::ap120b;
    const Machine fixed(on_fixed), array(on_array);
    Comparison c;
    for (std::size_t a = 0; a < fixed.visible.size(); ++a) {
        if (fixed.buffers().lights[0].mask[a] == array.buffers().lights[0].mask[a]) continue;
        ++c.differ;
        c.only_array += array.buffers().lights[0].mask[a] == shadow::mask_shadow;
    }
    c.fixed = shadow_error(ground().truth, fixed.compared());
    c.array = shadow_error(ground().truth, array.compared());
    std::printf("figure %d: %d pixels differ, %d of them in shadow on the AP-120B only; false "
                "shadow %.5f fixed, %.5f AP-120B; false light %.5f and %.5f\n",
                figure, c.differ, c.only_array, c.fixed.false_shadow_rate(),
                c.array.false_shadow_rate(), c.fixed.false_light_rate(),
                c.array.false_light_rate());
    return c;
}

// The error is the stores', not the arithmetic's: 27 bits of fraction instead of 16-bit words
// change one visible pixel in 600 of figure 3 and one in 6000 of figure 4.
TEST(Ap120b, ChangesFewPixelsAndNoRate) {
    const Comparison three = compare_figure(3, figure_settings(3));
    const Comparison four = compare_figure(4, figure_settings(4));
    EXPECT_EQ(three.differ, 168);
    EXPECT_EQ(four.differ, 18);
    for (const Comparison& c : {three, four}) {
        EXPECT_NEAR(c.array.false_shadow_rate(), c.fixed.false_shadow_rate(), 0.005);
        EXPECT_NEAR(c.array.false_light_rate(), c.fixed.false_light_rate(), 0.0005);
    }
}

// What it changes in figure 3 is where the roundings lie: the fixed unit rounds X to 1/128 pixel
// and Z to a code half up, then takes X's floor for the texel and lets an equal code be lit. With
// the floor instead, which is no step before another floor, and a quantum less bias, which makes
// the equal code dark, hardly a pixel is left.
TEST(Ap120b, DiffersFromTheFixedMachineByItsRoundings) {
    const Comparison three = compare_figure(3, figure_settings(3));
    EXPECT_EQ(three.only_array, three.differ) << "all one way";
    EXPECT_LT(compare_figure(3, figure_settings(3), 1 << 15).differ, three.differ);
    Settings floor = figure_settings(3);
    floor.machine.transform_rounding = fixed::Rounding::floor;
    EXPECT_LT(4 * compare_figure(3, floor, 1 << 16).differ, three.differ);
    floor.machine.coefficient_bits = 32;
    EXPECT_EQ(compare_figure(3, floor, 1 << 16).differ, 0) << "the rest is the coefficients";
}

// A frame's ledger: seconds, not the fixed unit's tenth of one; most of it is bookkeeping.
TEST(Ap120b, TakesSecondsAFrame) {
    const auto expected_ms = [](int figure, std::string_view profile) {
        if (figure == 3) return profile == "ap120b" ? 2033 : 1498;
        return profile == "ap120b" ? 4868 : 3441;
    };
    for (const int figure : {3, 4}) {
        for (const char* profile : {"ap120b", "ap120b_fast"}) {
            Settings s = figure_settings(figure);
            apply(*shadow::find_profile(profile), s);
            const Machine machine(s);
            const shadow::ArrayCost cost =
                array_cost(machine.frame.counts.lights[0].post_process, s, s.array_memory, true);
            const auto ms = [&](std::uint64_t cycles) {
                return static_cast<double>(cycles) * s.timing.clock_ns * 1e-6;
            };
            std::printf("figure %d, %s: %.0f ms; transfer %.0f ms; %llu calls\n", figure, profile,
                        ms(cost.cycles()), static_cast<double>(cost.transfer_us()) * 1e-3,
                        static_cast<unsigned long long>(cost.calls()));
            double transform = 0;
            for (const shadow::ArrayCostStep& step : cost.list())
                if (step.source == shadow::ArrayCycleSource::replayed)
                    transform += ms(cost.cycles(step));
            EXPECT_EQ(std::lround(ms(cost.cycles())), expected_ms(figure, profile));
            EXPECT_LT(4 * transform, ms(cost.cycles()) + 100);
        }
    }
}

}  // namespace
}  // namespace umbra78::claims
