// Binary numbers as words: boundary table, and random bits beside the same in floating point.
#include "tests/tools/models/binary_texts.hpp"
#include "tools/models/scalars.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace umbra78::tools::test {
namespace {

using enum CoordinateStatus;
constexpr Scalar float32{ScalarKind::floating, 4}, float64{ScalarKind::floating, 8};

Coordinate of(float v) { return coordinate_of(std::bit_cast<std::uint32_t>(v), float32); }
Coordinate of(double v) { return coordinate_of(std::bit_cast<std::uint64_t>(v), float64); }

TEST(Scalars, BoundariesOfFloatingNumbers) {
    const double half_unit = std::ldexp(1, -33), unit = std::ldexp(1, -32);
    const struct {
        double value;
        std::int64_t word;
        CoordinateStatus status;
    } cases[] = {
        {0, 0, ok}, {-0.0, 0, ok}, {1, std::int64_t{1} << 32, ok},
        {-2.5, -5 * (std::int64_t{1} << 31), ok}, {unit, 1, ok},
        {half_unit, 0, ok}, {3 * half_unit, 2, ok}, {5 * half_unit, 2, ok},    // half to even
        {-half_unit, 0, ok}, {-3 * half_unit, -2, ok}, {1e-30, 0, ok}, {-1e-30, 0, ok},
        {1048576, max_model, ok}, {-1048576, -max_model, ok}, {1048577, 0, out_of_range},
        {-1048577, 0, out_of_range}, {1e30, 0, out_of_range}, {-3e38, 0, out_of_range},
        {HUGE_VAL, 0, no_number}, {-HUGE_VAL, 0, no_number}, {NAN, 0, no_number},
    };
    for (const auto& c : cases) {
        for (const Coordinate& read : {of(c.value), of(static_cast<float>(c.value))}) {
            EXPECT_EQ(read.word, c.word) << c.value;
            EXPECT_EQ(read.status, c.status) << c.value;
        }
    }
    EXPECT_EQ(of(std::nextafter(half_unit, 1.0)).word, 1);
    EXPECT_EQ(of(std::nextafter(3 * half_unit, 0.0)).word, 1);
    EXPECT_EQ(of(std::nextafter(1048576.0, 2e6)).status, out_of_range);  // 2^-32 more
    EXPECT_EQ(of(std::nextafter(1048576.0, 0.0)).word, max_model);  // 2^-33 less, half to even
    EXPECT_EQ(of(std::nextafter(1048576.0f, 2e6f)).status, out_of_range);
    EXPECT_EQ(of(1e308).status, out_of_range);
    EXPECT_EQ(of(5e-324).word, 0);
    EXPECT_EQ(of(1e-45f).word, 0);
}

// In floating point v * 2^32 is exact, and nearbyint rounds half to even.
TEST(Scalars, AreWhatFloatingPointSays) {
    constexpr unsigned seed = 1978;
    std::mt19937_64 random(seed);
    int good = 0;
    for (int n = 0; n < 400'000; ++n) {
        std::uint64_t bits = random();
        if (n % 4 != 0) {  // an exponent that a word may have
            const std::uint64_t exponent = 1023 - 40 + random() % 62;
            bits = (bits & ~(std::uint64_t{0x7FF} << 52)) | exponent << 52;
        }
        const double wide = std::bit_cast<double>(bits);
        for (const bool narrow : {false, true}) {
            const double v = narrow ? static_cast<double>(static_cast<float>(wide)) : wide;
            const Coordinate read = narrow ? of(static_cast<float>(wide)) : of(wide);
            const double word = std::nearbyint(std::ldexp(v, 32));
            const CoordinateStatus status =
                !std::isfinite(v) ? no_number
                : std::abs(word) > static_cast<double>(max_model) ? out_of_range : ok;
            ASSERT_EQ(read.status, status) << v << ", seed " << seed << ", " << n;
            if (status != ok) continue;
            ++good;
            ASSERT_EQ(static_cast<double>(read.word), word) << v << ", seed " << seed << ", " << n;
        }
    }
    EXPECT_GT(good, 200'000);
}

TEST(Scalars, WholeNumbersOfEverySize) {
    const auto whole = [](std::uint64_t bits, ScalarKind kind, std::uint8_t bytes) {
        return whole_of(bits, {kind, bytes});
    };
    EXPECT_EQ(whole(0x80, ScalarKind::whole, 1), -128);
    EXPECT_EQ(whole(0x80, ScalarKind::natural, 1), 128);
    EXPECT_EQ(whole(0xFFFE, ScalarKind::whole, 2), -2);
    EXPECT_EQ(whole(0xFFFE, ScalarKind::natural, 2), 65534);
    EXPECT_EQ(whole(0xFFFFFFFF, ScalarKind::whole, 4), -1);
    EXPECT_EQ(whole(0xFFFFFFFF, ScalarKind::natural, 4), 4294967295);
    const Coordinate three = coordinate_of(3, {ScalarKind::natural, 2});
    EXPECT_EQ(three.word, 3 * (std::int64_t{1} << 32));
    EXPECT_EQ(coordinate_of(0xFFFFFFFD, {ScalarKind::whole, 4}).word, -three.word);
    EXPECT_EQ(coordinate_of(1048577, {ScalarKind::whole, 4}).status, out_of_range);
    EXPECT_EQ(coordinate_of(0xFFFFFFFF, {ScalarKind::natural, 4}).status, out_of_range);
    EXPECT_EQ(bits_of("\x01\x02\x03\x04", true), 0x01020304u);
    EXPECT_EQ(bits_of("\x01\x02\x03\x04", false), 0x04030201u);
}

}  // namespace
}  // namespace umbra78::tools::test
