// What percentage closer filtering does to the figures' scene, and what filtering depths does.
#include "tests/claims/ground.hpp"

#include "tools/truth/metrics.hpp"

#include <gtest/gtest.h>

#include <cstdio>

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
    GradedError all, inside;  // and without a light texel about the true edge
};

Errors errors(const char* what, const Settings& s) {
    const Machine machine(s);
    const auto band = ground().band(0);
    const Errors e{graded_error(ground().truth, machine.compared()),
                   graded_error(ground().truth, machine.compared(), band)};
    std::printf("%-32s %d taps: off by %.4f, rms %.4f; lit below 98 %% %.4f, umbra above 2 %% "
                "%.4f; away from the edge %.4f, %.4f, %.4f, %.4f\n",
                what, s.taps, e.all.mean_absolute(), e.all.rms(), e.all.lit_below_98_rate(),
                e.all.umbra_above_2_rate(), e.inside.mean_absolute(), e.inside.rms(),
                e.inside.lit_below_98_rate(), e.inside.umbra_above_2_rate());
    return e;
}

TEST(Percentage, Print) {
    for (const int bias : {64, 192, 384, 640}) {
        std::printf("bias %d\n", bias);
        errors("nearest", window(Lookup::nearest, 3, bias));
        errors("bilinear", window(Lookup::bilinear, 3, bias));
        for (int k = 2; k <= 5; ++k) errors("percentage", window(Lookup::percentage, k, bias));
        for (int k = 2; k <= 5; ++k)
            errors("jittered", window(Lookup::percentage, k, bias, TapPlaces::jittered));
        for (int k = 2; k <= 5; ++k)
            errors("filtered depth", window(Lookup::filtered_depth, k, bias));
    }
}

}  // namespace
}  // namespace umbra78::claims
