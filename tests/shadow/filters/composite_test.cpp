// The composite: levels, shares, masks and densities against the exact quotient.
#include "shadow/filters/composite.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace umbra78::shadow {
namespace {

int composed(int level, int share, int mask, int density) {
    return composite(static_cast<std::uint8_t>(level), static_cast<std::uint8_t>(share),
                     static_cast<std::uint8_t>(mask), density);
}

// out is the half-up rounding of level - share m/255 d/256 iff -1/2 < out - exact <= 1/2; both
// sides times 2 x 255 x 256. All 16.8 million shares, masks and densities, each at its least
// level, at the greatest and at one between.
TEST(Composite, IsTheExactQuotientRoundedHalfUp) {
    constexpr std::int64_t whole = 255 * 256;
    for (int density = 0; density <= 256; ++density)
        for (int share = 0; share < 256; ++share)
            for (int mask = 0; mask < 256; ++mask)
                for (const int level : {share, (share + 256) / 2, 255}) {
                    const std::int64_t exact = level * whole - share * mask * density;
                    const int out = composed(level, share, mask, density);
                    const std::int64_t twice_error = 2 * (out * whole - exact);
                    if (twice_error <= -whole || twice_error > whole) {
                        FAIL() << "level " << level << " share " << share << " mask " << mask
                               << " density " << density << " gives " << out;
                    }
                }
}

TEST(Composite, Ends) {
    for (int level = 0; level < 256; ++level)
        for (int share = 0; share <= level; ++share) {
            ASSERT_EQ(composed(level, share, 0, 256), level) << "no shadow";
            ASSERT_EQ(composed(level, share, 255, 0), level) << "an invisible shadow";
            ASSERT_EQ(composed(level, share, 255, 256), level - share) << "the ambient term alone";
            ASSERT_EQ(composed(level, 0, 255, 256), level) << "no light to take away";
        }
    for (int i = 0; i < 256; ++i) ASSERT_EQ(composed(i, i, 255, 128), (i + 1) / 2) << "half";
}

// More shadow, or a denser one, never makes a pixel brighter, and never darker than without the
// light.
TEST(Composite, IsMonotone) {
    for (const int density : {1, 77, 218, 255, 256})
        for (int share = 0; share < 256; ++share)
            for (int m = 0; m < 255; ++m) {
                const int level = (share + 255) / 2;
                if (level < share) continue;
                const int out = composed(level, share, m, density);
                const int darker = composed(level, share, m + 1, density);
                ASSERT_GE(out, darker);
                ASSERT_GE(composed(level, share, m, density - 1), out);
                ASSERT_GE(darker, level - share);
            }
}

TEST(Composite, OfAPictureIsThatOfItsPixels) {
    std::vector<std::uint8_t> level(65536), share(65536), mask(65536), out(65536);
    for (std::size_t k = 0; k < out.size(); ++k) {
        level[k] = static_cast<std::uint8_t>(k);
        share[k] = static_cast<std::uint8_t>((k % 256) * ((k >> 3) % 5) / 4);
        mask[k] = static_cast<std::uint8_t>(k >> 8);
    }
    composite(level, share, mask, 141, out);
    for (std::size_t k = 0; k < out.size(); ++k)
        ASSERT_EQ(out[k], composite(level[k], share[k], mask[k], 141)) << k;
}

}  // namespace
}  // namespace umbra78::shadow
