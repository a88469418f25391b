// Contours of images whose lines are known, and of random ones by what every contour must keep.
#include "tools/truth/contour.hpp"

#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace umbra78::tools {
namespace {

using Bytes = std::vector<std::uint8_t>;

bool closed(const Contour& line) {
    return line.front().column == line.back().column && line.front().row == line.back().row;
}

// Positive if the inside is on the right hand: rows go down.
double area(const Contour& line) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k)
        sum += line[k - 1].column * line[k].row - line[k].column * line[k - 1].row;
    return sum / 2;
}

Bytes picture(int size, std::initializer_list<std::pair<int, int>> dark) {
    Bytes mask(static_cast<std::size_t>(size) * size);
    for (const auto& [x, y] : dark) mask[static_cast<std::size_t>(y) * size + x] = 255;
    return mask;
}

TEST(Contour, GoesRoundOnePixelWithTheInsideOnItsRight) {
    const auto lines = mask_contours(5, picture(5, {{2, 2}}), Bytes(25, 1));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(closed(lines[0]));
    EXPECT_EQ(lines[0].size(), 5u);
    EXPECT_DOUBLE_EQ(area(lines[0]), 0.5);
    EXPECT_DOUBLE_EQ(length(lines[0]), 4 * std::sqrt(0.5));
}

TEST(Contour, PixelsThatTouchAtACornerAreKeptApart) {
    EXPECT_EQ(mask_contours(6, picture(6, {{2, 2}, {3, 3}}), Bytes(36, 1)).size(), 2u);
    EXPECT_EQ(mask_contours(6, picture(6, {{3, 2}, {2, 3}}), Bytes(36, 1)).size(), 2u);
    EXPECT_EQ(mask_contours(6, picture(6, {{2, 2}, {3, 2}, {3, 3}}), Bytes(36, 1)).size(), 1u);
}

TEST(Contour, EndsWhereCellsMayNotBeCrossed) {
    const int size = 8;
    Bytes mask(64), cells(64, 1);
    for (int at = 0; at < 64; ++at) mask[at] = at % size < 4 ? 255 : 0;
    for (int x = 0; x < size; ++x) cells[4 * size + x] = 0;
    const auto lines = mask_contours(size, mask, cells);
    ASSERT_EQ(lines.size(), 2u);  // above and below row 4's cells
    for (const Contour& line : lines) {
        EXPECT_FALSE(closed(line));
        for (const ImagePoint& p : line) EXPECT_DOUBLE_EQ(p.column, 4);
    }
    EXPECT_DOUBLE_EQ(length(lines[0]) + length(lines[1]), 6);
}

TEST(Contour, LiesBetweenGreyLevelsInProportion) {
    Bytes mask(16);
    for (int at = 0; at < 16; ++at) mask[at] = at % 4 < 2 ? 200 : 100;
    const auto lines = mask_contours(4, mask, Bytes(16, 1));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(lines[0][0].column, 1.5 + 0.725, 1e-12);
}

TEST(Contour, OfASmoothDiscIsACircle) {
    const int size = 64;
    const double radius = 20;
    Bytes mask(size * size);
    for (int at = 0; at < size * size; ++at) {
        const auto [x, y] = pixel_centre(at, size);
        const double away = radius - std::hypot(x - 32, y - 32);
        mask[at] = static_cast<std::uint8_t>(std::clamp(127.5 + 64 * away, 0.0, 255.0));
    }
    const auto lines = mask_contours(size, mask, Bytes(mask.size(), 1));
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(length(lines[0]), 2 * std::numbers::pi * radius, 0.1);
    for (const ImagePoint& p : lines[0])
        EXPECT_NEAR(std::hypot(p.column - 32, p.row - 32), radius, 0.02);
}

// Every pair of neighbours that differ is crossed exactly once, and every line is closed.
TEST(Contour, OfRandomImagesCrossesEachPairOnce) {
    std::mt19937 random(1978);
    for (int round = 0; round < umbra78::test::effort(400); ++round) {
        const int size = 4 + static_cast<int>(random() % 20);
        Bytes inside(size * size);
        for (int y = 1; y + 1 < size; ++y)
            for (int x = 1; x + 1 < size; ++x) inside[y * size + x] = random() % 3 != 0;
        int pairs = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const int at = y * size + x;
                pairs += x + 1 < size && inside[at] != inside[at + 1];
                pairs += y + 1 < size && inside[at] != inside[at + size];
            }
        std::size_t points = 0;
        const auto lines = contours(size, inside, Bytes(inside.size(), 1),
                                    [&](std::size_t in, std::size_t out) {
                                        EXPECT_TRUE(inside[in] && !inside[out]);
                                        return between(pixel_centre(in, size),
                                                       pixel_centre(out, size), 0.5);
                                    });
        for (const Contour& line : lines) {
            EXPECT_TRUE(closed(line));
            points += line.size() - 1;
        }
        ASSERT_EQ(points, static_cast<std::size_t>(pairs)) << "round " << round;
    }
}

}  // namespace
}  // namespace umbra78::tools
