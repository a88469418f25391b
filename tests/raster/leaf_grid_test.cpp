// The 17 x 17 corners at once are, bit for bit, what repeated splitting gives: four times in u
// everywhere, then four times in v, in 32 and in 64 bits.
#include "raster/leaf_grid.hpp"

#include "tests/raster/exact_surface.hpp"

#include <gtest/gtest.h>

namespace umbra78::raster {
namespace {

using namespace test;

// Splits c down to single leaves along u or along v and hands each to `leaf`, in order.
template <class Leaf>
void split_all(const Component& c, bool along_u, int level, const Leaf& leaf) {
    if (level == 0) return leaf(c);
    Component low, high;
    along_u ? split_u(c, low, high) : split_v(c, low, high);
    split_all(low, along_u, level - 1, leaf);
    split_all(high, along_u, level - 1, leaf);
}

CornerGrid<std::int64_t> by_splitting(const Component& c) {
    CornerGrid<std::int64_t> grid{};
    std::size_t i = 0;
    split_all(c, true, leaf_levels, [&](const Component& column) {
        std::size_t j = 0;
        split_all(column, false, leaf_levels, [&](const Component& leaf) {
            for (std::size_t k = 0; k < 4; ++k) grid[j + k / 2][i + k % 2] = leaf.f[k];
            ++j;
        });
        ++i;
    });
    return grid;
}

template <class Int>
void compare(const std::array<Component, 3>& block, const char* name, int trial) {
    std::array<CornerGrid<Int>, 3> grid;
    expand<Int, 3>(block, grid);
    for (std::size_t c = 0; c < 3; ++c) {
        const auto expected = by_splitting(block[c]);
        for (std::size_t j = 0; j < corners; ++j)
            for (std::size_t i = 0; i < corners; ++i)
                ASSERT_EQ(grid[c][j][i], expected[j][i])
                    << name << ", trial " << trial << ", component " << c << ", corner " << i
                    << ", " << j;
    }
}

TEST(LeafGrid, IsRepeatedSplitting) {
    Random random;
    for (int trial = 0; trial < 2000; ++trial) {
        // As large as a drawn block may be: bounds below 2^29, and any bend that fits.
        std::array<Component, 3> block{};
        for (Component& c : block) {
            const std::int64_t bend = std::int64_t{1} << random.between(0, 25);
            for (std::size_t k = 0; k < 4; ++k) {
                c.f[k] = random.between(-(1 << 28), 1 << 28);
                c.gu[k] = random.between(-bend, bend);
                c.gv[k] = random.between(-bend, bend);
                c.guv[k] = random.between(-bend, bend);
            }
        }
        compare<std::int32_t>(block, "32 bits", trial);
        compare<std::int64_t>(block, "64 bits", trial);
        // Perspective's words: 44 bits and 9 times that in guv.
        for (Component& c : block)
            for (auto* field : {&c.f, &c.gu, &c.gv, &c.guv})
                for (std::int64_t& word : *field) word *= (1 << 16) + 1;
        compare<std::int64_t>(block, "44 bits", trial);
        if (testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace umbra78::raster
