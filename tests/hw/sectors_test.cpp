// Sectors: every direction lies in one cone, the one it is sorted into; and a sector's unit is the
// unit of a view along its axis.
#include "hw/sectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <tuple>

namespace umbra78::hw {
namespace {

int cones(const Direction& d) {
    int n = 0;
    for (int k = 0; k < sector_count; ++k) n += in_cone(k, d) ? 1 : 0;
    return n;
}

// Every tie of three small numbers, and the directions of the cube's faces, edges and corners.
TEST(Sectors, EveryDirectionIsInTheOneConeItIsSortedInto) {
    std::array<int, sector_count> in{};
    for (std::int64_t x = -9; x <= 9; ++x)
        for (std::int64_t y = -9; y <= 9; ++y)
            for (std::int64_t z = -9; z <= 9; ++z) {
                const Direction d{x, y, z};
                const int k = sector_of(d);
                if (x == 0 && y == 0 && z == 0) {
                    EXPECT_EQ(k, no_sector);
                    EXPECT_EQ(cones(d), 0);
                    continue;
                }
                ASSERT_EQ(cones(d), 1) << x << ' ' << y << ' ' << z;
                ASSERT_TRUE(in_cone(k, d)) << x << ' ' << y << ' ' << z;
                ++in[static_cast<std::size_t>(k)];
            }
    for (std::size_t k = 0; k < in.size(); k += 2) EXPECT_EQ(in[k], in[k + 1]);
    EXPECT_GT(in[0], in[2]);  // ties go to x, then to y
    EXPECT_GT(in[2], in[4]);
}

TEST(Sectors, TheLargestSumsAreNoExceptions) {
    constexpr std::int64_t huge = std::int64_t{1} << 61;
    std::mt19937_64 random(78);
    for (int turn = 0; turn < 20000; ++turn) {
        Direction d;
        for (std::int64_t& v : d) {
            const std::int64_t near_tie = huge + static_cast<std::int64_t>(random() % 3) - 1;
            v = random() % 2 == 0 ? near_tie : -near_tie;
        }
        ASSERT_EQ(cones(d), 1);
        ASSERT_TRUE(in_cone(sector_of(d), d));
    }
}

// X and Y on a face are at most half the frame, which |D| <= W says; W is the largest.
TEST(Sectors, AFacesAxesAreTheThreeSumsOnceEach) {
    for (int k = 0; k < sector_count; ++k) {
        const Face& face = faces[static_cast<std::size_t>(k)];
        std::array<std::size_t, 3> used{face.x.of, face.y.of, face.w.of};
        EXPECT_EQ(face.w.of, axis_of(k));
        EXPECT_EQ(face.w.negated, looks_back(k));
        std::ranges::sort(used);
        EXPECT_EQ(used, (std::array<std::size_t, 3>{0, 1, 2}));
        // Right, down and forward are right-handed.
        const auto column = [](const FaceAxis& a) {
            Direction d{0, 0, 0};
            d[a.of] = a.negated ? -1 : 1;
            return d;
        };
        const Direction r = column(face.x), b = column(face.y), w = column(face.w);
        EXPECT_EQ(r[1] * b[2] - r[2] * b[1], w[0]) << k;
        EXPECT_EQ(r[2] * b[0] - r[0] * b[2], w[1]) << k;
        EXPECT_EQ(r[0] * b[1] - r[1] * b[0], w[2]) << k;
    }
}

MachineSpec wide_spec() {
    MachineSpec spec;
    spec.coefficient_bits = 24;
    return spec;
}

std::array<ExactRow, 3> some_directions() {
    return {ExactRow{Rational(3, 7), Rational(-1, 9), Rational(5, 11), Rational(40, 3)},
            ExactRow{Rational(1, 700), Rational(1, 5), Rational(-2, 13), Rational(-17, 5)},
            ExactRow{Rational(-2, 3), Rational(1, 19), Rational(1, 23), Rational(6, 7)}};
}

// One exponent for the three rows: the greatest that any of them needs.
TEST(LoadSector, GivesTheDirectionsOneExponent) {
    const MachineSpec spec = wide_spec();
    MatrixWords loaded;
    const ExactRow z{Rational(1, 4), Rational(2, 5), Rational(-1, 3), Rational(100, 7)};
    ASSERT_EQ(load_sector(some_directions(), z, spec, screen_words(spec), loaded), LoadStatus::ok);
    EXPECT_FALSE(loaded.affine);
    EXPECT_EQ(loaded.exponent[0], loaded.exponent[3] + spec.xy_bits - 1);
    EXPECT_EQ(loaded.exponent[1], loaded.exponent[0]);
    std::int32_t largest = 0;
    for (const std::size_t r : {0u, 1u, 3u})
        for (const std::int32_t word : loaded.word[r]) largest = std::max(largest, std::abs(word));
    EXPECT_GE(largest, 1 << 21);  // a smaller exponent would not hold it
    EXPECT_LT(largest, 1 << 23);
    const ExactRow huge{Rational(std::int64_t{1} << 40), Rational(0), Rational(0), Rational(0)};
    EXPECT_EQ(load_sector(some_directions(), huge, spec, screen_words(spec), loaded),
              LoadStatus::exponent_out_of_range);
}

// The unit that exchanges and negates sums gives what a unit with those rows gives.
TEST(SectorUnit, IsTheUnitOfItsFacesMatrix) {
    std::mt19937 random(1978);
    for (const DivideOrder order : {DivideOrder::exact, DivideOrder::round_first}) {
        MachineSpec spec = wide_spec();
        spec.divide_order = order;
        MatrixWords loaded;
        const ExactRow z{Rational(1, 4), Rational(2, 5), Rational(-1, 3), Rational(100, 7)};
        ASSERT_EQ(load_sector(some_directions(), z, spec, screen_words(spec), loaded),
                  LoadStatus::ok);
        std::array<int, sector_count> held{};
        for (int turn = 0; turn < 3000; ++turn) {
            const auto word = [&] { return static_cast<std::int32_t>(random() % 65536) - 32768; };
            const Words v{word(), word(), word()};
            for (int k = 0; k < sector_count; ++k) {
                const SectorUnit unit(spec, loaded, k);
                const Point p = unit(v), q = TransformUnit(spec, face_matrix(loaded, k))(v);
                ASSERT_EQ(p.status, q.status);
                ASSERT_EQ(std::make_tuple(p.x, p.y, p.z), std::make_tuple(q.x, q.y, q.z));
                if (!unit.holds(unit.direction(v))) continue;
                ++held[static_cast<std::size_t>(k)];
                const std::int64_t edge = std::int64_t{spec.half_px()} << spec.fraction_bits;
                EXPECT_TRUE(std::abs(p.x) <= edge && std::abs(p.y) <= edge);
            }
        }
        for (const int n : held) EXPECT_GT(n, 0);
    }
}

}  // namespace
}  // namespace umbra78::hw
