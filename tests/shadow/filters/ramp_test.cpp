// Crow's ramp against its definition: the nearest pixel in shadow, found by looking at all.
#include "shadow/filters/ramp.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/support/buffers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbra78::shadow {
namespace {

constexpr int side = 32;
constexpr hw::Depth16 nothing = 65535;

struct RampFrame {
    test::OwnedStore<hw::Depth16> observer{5};
    std::vector<hw::Depth16>& depth = observer.depth;
    std::vector<std::uint8_t> mask = std::vector<std::uint8_t>(side * side, 0);

    RampFrame() { std::ranges::fill(depth, hw::Depth16{1}); }
    RampFrame(const RampFrame&) = delete;
    std::vector<std::uint8_t> ramped(int width) const {
        std::vector<std::uint8_t> rows(mask.size(), 7), out(mask.size(), 7);
        ramp<hw::Depth16>(mask, observer.store, nothing, width, rows, out);
        return out;
    }
    std::vector<std::uint8_t> by_definition(int width) const {
        std::vector<std::uint8_t> out(mask.size(), 0);
        for (int a = 0; a < side * side; ++a) {
            const auto at = static_cast<std::size_t>(a);
            if (depth[at] == nothing) continue;
            int least = 1 << 20;
            for (int b = 0; b < side * side; ++b) {
                const int dx = a % side - b % side, dy = a / side - b / side;
                if (mask[static_cast<std::size_t>(b)] >= 128)
                    least = std::min(least, dx * dx + dy * dy);
            }
            out[at] = std::max(mask[at], ramp_darkness(least, width));
        }
        return out;
    }
};

TEST(Ramp, IsTheTextsExample) {
    const std::pair<int, int> levels[] = {{0, 255}, {1, 191}, {2, 165},  {4, 128}, {5, 113},
                                          {9, 64},  {10, 54}, {15, 8}, {16, 0}};
    for (const auto& [squares, level] : levels) EXPECT_EQ(ramp_darkness(squares, 4), level);
}

TEST(Ramp, FallsOffLinearlyToNothing) {
    for (int width = 1; width <= max_ramp_px; ++width)
        for (int squares = 0; squares <= width * width; ++squares)
            EXPECT_NEAR(ramp_darkness(squares, width), 255 * (1 - std::sqrt(squares) / width), 1)
                << squares << " of " << width;
}

// Random shadows, few and many, with background and grey levels among them; every width.
TEST(Ramp, IsTheDefinition) {
    test::Random random;
    int graded = 0;
    for (int turn = 0; turn < 48; ++turn) {
        RampFrame f;
        const std::uint64_t rare = std::uint64_t{1} << random.between(1, 10);
        for (std::size_t a = 0; a < f.mask.size(); ++a) {
            if (random.bits() % 7 == 0) f.depth[a] = nothing;
            if (random.bits() % rare == 0)
                f.mask[a] = static_cast<std::uint8_t>(random.between(1, 255));
            if (f.depth[a] == nothing) f.mask[a] = 0;
        }
        const int width = turn % max_ramp_px + 1;
        const std::vector<std::uint8_t> expected = f.by_definition(width);
        const std::vector<std::uint8_t> made = f.ramped(width);
        umbra78::test::expect_equal_buffers("ramp", side, std::span(expected), std::span(made),
                                            umbra78::test::Constant::expected);
        graded += static_cast<int>(
            std::ranges::count_if(expected, [](auto d) { return d > 0 && d < 255; }));
    }
    EXPECT_GT(graded, 5000);
}

TEST(RampDeathTest, WidthsAndOverlaps) {
    const RampFrame f;
    EXPECT_DEATH(f.ramped(0), "ramp: a width of 1 to 32 pixels");
    EXPECT_DEATH(f.ramped(33), "ramp: a width of 1 to 32 pixels");
}

}  // namespace
}  // namespace umbra78::shadow
