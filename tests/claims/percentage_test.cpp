// What percentage closer filtering does to the figures' scene, and what filtering depths does.
#include "tests/claims/ground.hpp"

#include "tools/truth/metrics.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <set>

namespace umbra78::claims {
namespace {

using shadow::Lookup;
using shadow::TapPlaces;
using tools::GradedError;

Settings window(Lookup lookup, int taps, int bias_quanta, TapPlaces places = TapPlaces::grid) {
    Settings s = with(shadow::figure_settings(3), lookup, bias_quanta);
    s.taps = taps;
    s.tap_places = places;
    return s;
}

struct Errors {
    GradedError all, away;  // and without a light texel about the true edge
    std::size_t levels;     // different words of the mask
};

Errors errors(const char* what, const Settings& s) {
    const Machine machine(s);
    const auto mask = machine.compared();
    const Errors e{graded_error(ground().truth, mask),
                   graded_error(ground().truth, mask, ground().band(0)),
                   std::set<std::uint8_t>(mask.shadow.begin(), mask.shadow.end()).size()};
    std::printf("%s of %d x %d taps at bias %d: the light is off by %.4f, rms %.4f; lit below "
                "98 %% %.4f, umbra above 2 %% %.4f, away from the edge %.4f and %.4f; %zu levels\n",
                what, s.taps, s.taps, static_cast<int>(s.bias_q16 >> 16), e.all.mean_absolute(),
                e.all.rms(), e.all.lit_below_98_rate(), e.all.umbra_above_2_rate(),
                e.away.lit_below_98_rate(), e.away.umbra_above_2_rate(), e.levels);
    return e;
}

// Each further tap lies farther from the point, where a slope has other depths: at a constant bias
// more lit pixels lose light, the wider the window. (A bias that grows with the window is the
// remedy.)
TEST(Percentage, AcneGrowsWithTheWindowAtAConstantBias) {
    for (const int bias : {64, 384}) {
        double before = errors("nearest", window(Lookup::nearest, 3, bias)).all.lit_below_98_rate();
        for (int k = 2; k <= 5; ++k) {
            const double acne =
                errors("percentage", window(Lookup::percentage, k, bias)).all.lit_below_98_rate();
            EXPECT_GT(acne, before) << k << " taps, bias " << bias;
            before = acne;
        }
        EXPECT_GT(before, bias == 64 ? 0.99 : 0.75) << "5 x 5";
    }
    const double little = errors("percentage", window(Lookup::percentage, 2, 384))
                              .all.lit_below_98_rate();
    const double more = errors("percentage", window(Lookup::percentage, 2, 1536))
                            .all.lit_below_98_rate();
    EXPECT_LT(more, little / 2) << "a bias of 12 texels";
}

// Four taps give five answers, 25 taps 26; a mean of depths gives two, whatever its window.
TEST(Percentage, HasALevelForEachCountOfTaps) {
    for (int k = 2; k <= 5; ++k) {
        const auto all = static_cast<std::size_t>(k * k + 1);
        for (const TapPlaces places : {TapPlaces::grid, TapPlaces::jittered}) {
            const Settings s = window(Lookup::percentage, k, 384, places);
            EXPECT_EQ(errors("percentage", s).levels, all);
        }
        EXPECT_EQ(errors("filtered depth", window(Lookup::filtered_depth, k, 384)).levels, 2u);
    }
}

// Depths that are averaged before they are compared make a hard edge in another place: the error in
// the light is greater (rms), for each window, than that of the same taps compared one by one.
TEST(Percentage, FilteringDepthsFirstIsWorse) {
    for (int k = 2; k <= 5; ++k) {
        const Errors right = errors("percentage", window(Lookup::percentage, k, 384));
        const Errors wrong = errors("filtered depth", window(Lookup::filtered_depth, k, 384));
        EXPECT_GT(wrong.all.rms(), 1.3 * right.all.rms()) << k;
    }
}

}  // namespace
}  // namespace umbra78::claims
