// Filters on the lines near a shadow alone: the same bits as on the whole frame.
#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/lines.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::test::Random;

TEST(LineSet, HoldsLines) {
    for (const int size : {16, 64, 512, 4096}) {
        LineSet set(size);
        std::set<int> expected;
        EXPECT_EQ(set.count(), 0u);
        for (const int y : {0, 1, size / 2, size - 1}) {
            set.add(y);
            expected.insert(y);
        }
        const LineSet grown = set.with_neighbours();
        std::uint64_t count = 0;
        for (int y = 0; y < size; ++y) {
            EXPECT_EQ(set.has(y), expected.contains(y)) << y;
            const bool near =
                expected.contains(y - 1) || expected.contains(y) || expected.contains(y + 1);
            EXPECT_EQ(grown.has(y), near) << y;
            count += near;
        }
        EXPECT_EQ(set.count(), 4u);
        EXPECT_EQ(grown.count(), count);
        EXPECT_EQ(LineSet::all(size).count(), static_cast<std::uint64_t>(size));
    }
}

// Blots of shadow of any darkness, often one pixel or at the frame's edge, on lines apart.
std::vector<std::uint8_t> random_mask(Random& random, int size) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(size * size), 0);
    const auto blots = random.between(0, 5);
    for (std::int64_t k = 0; k < blots; ++k) {
        const auto x0 = random.between(-2, size), y0 = random.between(-2, size);
        const auto x1 = x0 + random.between(0, 9), y1 = y0 + random.between(0, 3);
        for (auto y = std::max<std::int64_t>(y0, 0); y <= std::min<std::int64_t>(y1, size - 1); ++y)
            for (auto x = std::max<std::int64_t>(x0, 0); x <= std::min<std::int64_t>(x1, size - 1);
                 ++x)
                if (random.between(0, 3) != 0)
                    mask[static_cast<std::size_t>(y * size + x)] =
                        random.between(0, 3) != 0
                            ? std::uint8_t{255}
                            : static_cast<std::uint8_t>(random.between(0, 255));
    }
    return mask;
}

TEST(Lines, AFrameThatNoMachineHasHasNone) {
    EXPECT_EQ(LineSet::of_frame(4).count(), 16u);
    EXPECT_EQ(LineSet::of_frame(12).count(), 4096u);
    for (const int bits : {-1, 13, 31, 40, 1 << 30}) EXPECT_EQ(LineSet::of_frame(bits).size(), 0);
}

TEST(FilteredLines, AreTheWholeFrames) {
    Random random;
    int lines = 0, all = 0;
    for (int round = 0; round < (umbra78::test::sanitized ? 300 : 3000) && !HasFailure(); ++round) {
        const int xy_bits = static_cast<int>(random.between(4, 6)), size = 1 << xy_bits;
        const auto pixels = static_cast<std::size_t>(size * size);
        std::vector<hw::Depth16> depth(pixels);
        for (hw::Depth16& z : depth) z = random.between(0, 9) == 0 ? 65535 : 100;
        const hw::FrameStore<const hw::Depth16> observer{xy_bits, depth};
        const std::vector<std::uint8_t> mask = random_mask(random, size);
        // As a frame holds them: what was there before is the mask.
        std::vector<std::uint8_t> some(mask), whole(mask);
        std::vector<std::uint32_t> visited(edge_visited_words(xy_bits), 0x5a5a5a5a);
        std::vector<std::int16_t> coverage(edge_coverage_words(xy_bits), 77);
        const int passes = static_cast<int>(random.between(0, max_dequantize_passes));
        const LineSet near = lines_with_shadow(mask, size);
        const auto steps = dequantize<hw::Depth16>(mask, observer, 65535, passes,
                                                   {visited, coverage}, some, near);
        EXPECT_EQ(steps, dequantize<hw::Depth16>(mask, observer, 65535, passes,
                                                 {visited, coverage}, whole));
        EXPECT_EQ(some, whole) << "dequantized, round " << round;
        std::vector<std::uint8_t> low(whole), low_whole(whole);
        const LineSet wider = near.with_neighbours();
        low_pass<hw::Depth16>(whole, observer, 65535, low, wider);
        low_pass<hw::Depth16>(whole, observer, 65535, low_whole);
        EXPECT_EQ(low, low_whole) << "low-passed, round " << round;
        lines += static_cast<int>(near.count());
        all += size;
    }
    std::printf("%d of %d lines filtered\n", lines, all);
    EXPECT_GT(lines, all / 10);
    EXPECT_LT(lines, all / 2);
}

}  // namespace
}  // namespace umbra78::shadow
