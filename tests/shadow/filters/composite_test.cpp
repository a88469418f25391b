// The composite: every intensity, mask and density against the exact quotient.
#include "shadow/filters/composite.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace umbra78::shadow {
namespace {

// out is the half-up rounding of I (1 - m/255 d/256) iff -1/2 < out - exact <= 1/2; both sides
// times 2 x 255 x 256. All 16.8 million cases.
TEST(Composite, IsTheExactQuotientRoundedHalfUp) {
    constexpr std::int64_t whole = 255 * 256;
    for (int density = 0; density <= 256; ++density)
        for (int intensity = 0; intensity < 256; ++intensity)
            for (int mask = 0; mask < 256; ++mask) {
                const std::int64_t exact = intensity * (whole - mask * density);  // of 255 256
                const int out = composite(static_cast<std::uint8_t>(intensity),
                                          static_cast<std::uint8_t>(mask), density);
                const std::int64_t twice_error = 2 * (out * whole - exact);
                if (twice_error <= -whole || twice_error > whole) {
                    FAIL() << "intensity " << intensity << " mask " << mask << " density "
                           << density << " gives " << out;
                }
            }
}

TEST(Composite, Ends) {
    for (int i = 0; i < 256; ++i) {
        const auto level = static_cast<std::uint8_t>(i);
        EXPECT_EQ(composite(level, 0, 256), i) << "no shadow";
        EXPECT_EQ(composite(level, 255, 0), i) << "an invisible shadow";
        EXPECT_EQ(composite(level, 255, 256), 0) << "a black one";
        EXPECT_EQ(composite(level, 255, 128), (i + 1) / 2) << "half";
    }
}

// More shadow, or a denser one, never makes a pixel brighter; a brighter one stays brighter.
TEST(Composite, IsMonotone) {
    for (const int density : {1, 77, 141, 255, 256})
        for (int i = 0; i < 255; ++i)
            for (int m = 0; m < 255; ++m) {
                const auto at = [&](int intensity, int mask, int d) {
                    return composite(static_cast<std::uint8_t>(intensity),
                                     static_cast<std::uint8_t>(mask), d);
                };
                ASSERT_GE(at(i, m, density), at(i, m + 1, density));
                ASSERT_GE(at(i, m, density - 1), at(i, m, density));
                ASSERT_LE(at(i, m, density), at(i + 1, m, density));
            }
}

TEST(Composite, OfAPictureIsThatOfItsPixels) {
    std::vector<std::uint8_t> intensity(65536), mask(65536), out(65536);
    for (std::size_t k = 0; k < out.size(); ++k) {
        intensity[k] = static_cast<std::uint8_t>(k);
        mask[k] = static_cast<std::uint8_t>(k >> 8);
    }
    composite(intensity, mask, 141, out);
    for (std::size_t k = 0; k < out.size(); ++k)
        ASSERT_EQ(out[k], composite(intensity[k], mask[k], 141)) << k;
}

}  // namespace
}  // namespace umbra78::shadow
