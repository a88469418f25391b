// The proof that sine_cosine() is correctly rounded for every angle there is. Label: long.
//
// 1. An independent sweep over all 2949121 angles of 0..45 degrees: the exact pair is carried from
//    one angle to the next by one rotation of 2^-16 degree in 256-bit integers,
//      sin(a + d) = sin a cos d + cos a sin d,  cos(a + d) = cos a cos d - sin a sin d.
//    2949120 rotations, each truncating by less than 2^-118, stay within 2^-96, which is checked
//    where it can be: sin 30 = 1/2, sin 45 = cos 45 and sin^2 + cos^2 = 1 at the end.
// 2. At each angle the word must be the nearest, the evaluation's error must be under its stated
//    8 units of 2^-63, and the distance of the exact value from a tie is measured. The closest is
//    51 units, so neither side can have rounded the wrong way.
// 3. The symmetries that take the first octant to all angles are checked for each of them.
#include "fixed/sine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/fixed/sine_model.hpp"

namespace umbra78::fixed {
namespace {

using test::Wide;

constexpr std::uint32_t octant_angles = (45u << 16) + 1;

// |word - exact| in units of 2^-63; exact is Q.120.
std::int64_t error_q63(std::uint64_t word, const Wide& exact) {
    const auto nearest = static_cast<std::uint64_t>((exact >> (test::model_bits - 63)).limb(0));
    return word > nearest ? static_cast<std::int64_t>(word - nearest)
                          : static_cast<std::int64_t>(nearest - word);
}

TEST(SineProof, EveryAngleIsCorrectlyRounded) {
    const Wide one = Wide(1) << test::model_bits;
    const test::SineCosineModel step = test::sine_cosine_model(1);
    test::SineCosineModel exact{0, one};
    Wide closest = one;
    std::uint32_t closest_angle = 0;
    bool closest_is_sine = false;
    std::int64_t worst = 0;
    const auto note_distance = [&](const Wide& distance, std::uint32_t angle, bool is_sine) {
        if (distance < closest) {
            closest = distance;
            closest_angle = angle;
            closest_is_sine = is_sine;
        }
    };
    for (std::uint32_t angle = 0; angle < octant_angles; ++angle) {
        const auto sine = test::nearest_q30(exact.sine), cosine = test::nearest_q30(exact.cosine);
        const SineCosine got = sine_cosine(static_cast<std::int32_t>(angle));
        ASSERT_EQ(got.sine, sine.word) << angle;
        ASSERT_EQ(got.cosine, cosine.word) << angle;
        note_distance(sine.distance_to_tie, angle, true);
        note_distance(cosine.distance_to_tie, angle, false);
        const auto evaluated = detail::octant_sine_cosine(angle);
        worst = std::max({worst, error_q63(evaluated.sine, exact.sine),
                          error_q63(evaluated.cosine, exact.cosine)});
        if (angle == 30u << 16) {
            EXPECT_LE((exact.sine - (one >> 1)).abs().bit_length(), test::model_bits - 96);
        }
        if (angle == 45u << 16) {
            EXPECT_LE((exact.sine - exact.cosine).abs().bit_length(), test::model_bits - 96);
            const Wide square = test::multiply_model(exact.sine, exact.sine) +
                                test::multiply_model(exact.cosine, exact.cosine);
            EXPECT_LE((square - one).abs().bit_length(), test::model_bits - 96);
        }
        exact = {test::multiply_model(exact.sine, step.cosine) +
                     test::multiply_model(exact.cosine, step.sine),
                 test::multiply_model(exact.cosine, step.cosine) -
                     test::multiply_model(exact.sine, step.sine)};
    }
    const std::int64_t closest_q63 = (closest >> (test::model_bits - 63)).to_int64();
    std::cout << "[ measured ] worst error before rounding: " << worst << " * 2^-63\n"
              << "[ measured ] closest to a tie: " << closest_q63 << " * 2^-63, the "
              << (closest_is_sine ? "sine" : "cosine") << " of " << closest_angle << "/65536\n";
    EXPECT_LT(worst, 8);
    EXPECT_EQ(closest_q63, 51);  // as the header states, and more than 8

}

// What carries the first octant's words to all 360 * 2^16 angles, and from turn to turn.
TEST(SineProof, SymmetriesHoldForEveryAngle) {
    constexpr std::int32_t quarter = 90 << 16;
    for (std::int32_t a = 0; a < quarter / 2; ++a) {
        const SineCosine here = sine_cosine(a), mirrored = sine_cosine(quarter - a);
        ASSERT_EQ(mirrored, (SineCosine{here.cosine, here.sine})) << a;
    }
    for (std::int32_t a = 0; a < 4 * quarter; ++a) {
        const SineCosine here = sine_cosine(a);
        ASSERT_EQ(sine_cosine(a + quarter), (SineCosine{here.cosine, -here.sine})) << a;
        ASSERT_EQ(sine_cosine(a - 4 * quarter), here) << a;
    }
}

}  // namespace
}  // namespace umbra78::fixed
