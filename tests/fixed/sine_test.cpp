// Sine and cosine against the slow model, at special angles and random ones.
#include "fixed/sine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "tests/fixed/boundary.hpp"
#include "tests/fixed/sine_model.hpp"

namespace umbra78::fixed {
namespace {

constexpr std::int32_t degree = 1 << 16;
constexpr std::int32_t one = 1 << 30;

// The five rational sines (Niven), and the published digits of two others.
TEST(Sine, ExactAngles) {
    static_assert(sine_cosine(0) == SineCosine{0, one});
    static_assert(sine_cosine(30 * degree).sine == one / 2);
    static_assert(sine_cosine(60 * degree).cosine == one / 2);
    static_assert(sine_cosine(90 * degree) == SineCosine{one, 0});
    static_assert(sine_cosine(120 * degree).cosine == -one / 2);
    static_assert(sine_cosine(150 * degree).sine == one / 2);
    static_assert(sine_cosine(180 * degree) == SineCosine{0, -one});
    static_assert(sine_cosine(210 * degree).sine == -one / 2);
    static_assert(sine_cosine(270 * degree) == SineCosine{-one, 0});
    static_assert(sine_cosine(-90 * degree) == SineCosine{-one, 0});
    static_assert(sine_cosine(360 * degree) == SineCosine{0, one});
    // sin 45 = 0.70710678118654752440, sin 1 = 0.01745240643728351282 (times 2^30).
    static_assert(sine_cosine(45 * degree) == SineCosine{759250125, 759250125});
    static_assert(sine_cosine(degree).sine == 18739379);
    static_assert(sine_cosine(1).sine == 286);  // 2^30 pi / (180 * 2^16) = 285.95
}

void expect_nearest(std::int32_t angle) {
    const test::SineCosineModel model = test::sine_cosine_model(angle);
    const SineCosine got = sine_cosine(angle);
    ASSERT_EQ(got.sine, test::nearest_q30(model.sine).word) << "angle " << angle << "/65536";
    ASSERT_EQ(got.cosine, test::nearest_q30(model.cosine).word) << "angle " << angle << "/65536";
}

TEST(Sine, CorrectlyRoundedEverySoManyAngles) {
    for (std::int32_t angle = 0; angle < 360 * degree; angle += 3989) {
        expect_nearest(angle);
    }
}

// One quantum to either side of every whole octant, and the ends of the argument.
TEST(Sine, CorrectlyRoundedAroundTheFolds) {
    for (std::int32_t octant = -16; octant <= 16; ++octant) {
        for (std::int32_t step = -2; step <= 2; ++step) {
            expect_nearest(octant * 45 * degree + step);
        }
    }
    for (const std::int32_t angle : {INT32_MIN, INT32_MIN + 1, INT32_MAX - 1, INT32_MAX}) {
        expect_nearest(angle);
    }
}

TEST(Sine, CorrectlyRoundedAtRandomAngles) {
    test::Random random;
    for (int i = 0; i < 3000; ++i) {
        expect_nearest(static_cast<std::int32_t>(random.between(INT32_MIN, INT32_MAX)));
    }
}

// The error the header states: under 8 units of 2^-63 before the rounding.
TEST(Sine, OctantErrorIsAsStated) {
    constexpr int dropped = test::model_bits - 63;
    std::uint64_t worst = 0;
    for (std::uint32_t angle = 0; angle <= 45u << 16; angle += 499) {
        const auto got = detail::octant_sine_cosine(angle);
        const test::SineCosineModel model = test::sine_cosine_model(angle);
        for (const auto& [word, exact] : {std::pair(got.sine, model.sine),
                                          std::pair(got.cosine, model.cosine)}) {
            const auto floor = static_cast<std::uint64_t>((exact >> dropped).limb(0));
            worst = std::max(worst, word > floor ? word - floor : floor - word);
        }
    }
    std::cout << "[ measured ] worst error before rounding: " << worst << " * 2^-63\n";
    EXPECT_LT(worst, 8u);
}

}  // namespace
}  // namespace umbra78::fixed
