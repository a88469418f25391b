// Models at their place: every word is the exact value rounded once, half to even; normals.
#include "tools/models/place_model.hpp"

#include "fixed/rational.hpp"
#include "tests/tools/models/model_texts.hpp"

#include <random>

namespace umbra78::tools::test {
namespace {

using fixed::Rational;
using raster::Facet;

Rational power_of_two(int n) { return Rational(std::int64_t{1} << n); }

PlacedModel placed_or_fail(const ModelData& model, const ModelPlacing& how) {
    FirstError error;
    PlacedModel placed = place_model(model, how, "change it", error);
    EXPECT_EQ(error.line(), "");
    return placed;
}

ModelData one_point(const std::array<std::int64_t, 3>& word) {
    ModelData model;
    model.name = "a.tea";
    model.vertices = {{.word = word, .line = 7}};
    return model;
}

raster::World place_of(const std::array<std::int64_t, 3>& word, const ModelPlacing& how) {
    return placed_or_fail(one_point(word), how).vertices.at(0);
}

// Whether `word` is half_even(exact): |2 (word - exact)| <= 1, and a tie has an even word.
void expect_half_even(std::int64_t word, const Rational& exact) {
    const Rational twice = (exact - Rational(word)) * Rational(2);
    EXPECT_TRUE(twice <= Rational(1) && twice >= Rational(-1)) << word;
    if (twice == Rational(1) || twice == Rational(-1)) {
        EXPECT_EQ(word % 2, 0);
    }
}

TEST(PlaceModel, EveryWordIsTheExactValueRoundedOnce) {
    constexpr unsigned seed = 1978;
    std::mt19937_64 random(seed);
    const auto bits = [&](int n) { return static_cast<std::int64_t>(random() >> (64 - n)); };
    for (int n = 0; n < 1000; ++n) {
        const auto turn = [&] { return static_cast<std::int32_t>(bits(25)) - (1 << 24); };
        const auto place = [&] { return static_cast<std::int32_t>(bits(31)) - (1 << 30); };
        const auto word = [&] { return bits(46) - (std::int64_t{1} << 45); };  // -8192 .. 8192
        ModelPlacing how;
        how.placing = {{place(), place(), place()},
                       raster::rotation_of({turn(), turn(), turn()})};
        how.scale = 1 + bits(48);  // 2^-48 .. 1
        const std::array<std::int64_t, 3> p{word(), word(), word()};
        const raster::World world = place_of(p, how);
        const auto exact = [&](std::int32_t from, const raster::Axis& row) {
            Rational sum(0);
            for (std::size_t k = 0; k < 3; ++k) sum = sum + Rational(row[k]) * Rational(p[k]);
            return Rational(from) + sum * Rational(how.scale) / power_of_two(47) / power_of_two(47);
        };
        const auto& [x, y, z] = how.placing.rotation;
        expect_half_even(world.x, exact(how.placing.place.x, x));
        expect_half_even(world.y, exact(how.placing.place.y, y));
        expect_half_even(world.z, exact(how.placing.place.z, z));
        if (HasFailure()) FAIL() << "seed " << seed << ", case " << n;
    }
}

// At 2^-17 of a unit the world word is a tie.
TEST(PlaceModel, TiesGoToTheEvenWord) {
    const std::int64_t half = model_one >> 17;
    EXPECT_EQ(place_of({half, 3 * half, -half}, {}), (raster::World{0, 2, 0}));
    EXPECT_EQ(place_of({half + 1, 3 * half - 1, -half - 1}, {}), (raster::World{1, 1, -1}));
}

// Without a turn nothing is rounded but the last place; multiples of 90 degrees only exchange axes.
TEST(PlaceModel, RightAnglesAreExact) {
    const std::array<std::int64_t, 3> p{model_one, 2 * model_one, 3 * model_one};
    const auto turned = [&](std::int32_t x, std::int32_t y, std::int32_t z, bool z_up = false) {
        ModelPlacing how;
        how.placing.rotation = raster::rotation_of({x * 65536, y * 65536, z * 65536});
        how.z_up = z_up;
        const raster::World w = place_of(p, how);
        return std::array{w.x / 65536, w.y / 65536, w.z / 65536};
    };
    EXPECT_EQ(turned(0, 0, 0), (std::array{1, 2, 3}));
    EXPECT_EQ(turned(90, 0, 0), (std::array{1, -3, 2}));   // y to z
    EXPECT_EQ(turned(0, 90, 0), (std::array{3, 2, -1}));   // z to x
    EXPECT_EQ(turned(0, 0, 90), (std::array{-2, 1, 3}));   // x to y
    EXPECT_EQ(turned(90, 90, 0), (std::array{2, -3, -1}));  // about x first
    EXPECT_EQ(turned(0, 90, 90), (std::array{-2, 3, -1}));  // about y before z
    EXPECT_EQ(turned(0, 0, 0, true), (std::array{1, 3, -2}));
    EXPECT_EQ(turned(90, 0, 0, true), (std::array{1, 2, 3}));  // what z_up did is undone
    EXPECT_EQ(raster::rotation_of({0, 360 * 65536, -360 * 65536}), raster::rotation_of({}));
}

TEST(PlaceModel, APointOutsideTheWorldIsNamedByItsLine) {
    ModelPlacing how;
    how.placing.place = {0, 1 << 16, 0};
    FirstError error;
    place_model(one_point({0, 32766 * model_one, 0}), how, "change it", error);
    EXPECT_EQ(error.line(), "");
    place_model(one_point({max_model, 32767 * model_one, 0}), how, "change it", error);
    EXPECT_EQ(error.line(), "a.tea:7: this point lies at [1.04858e+06, 32768, 0] in the world, "
                            "which ends at -32767 and 32767; change it");
    how.scale = INT64_MAX;
    FirstError far;
    place_model(one_point({max_model, -max_model, max_model}), how, "change it", far);
    EXPECT_TRUE(far.any());
}

ModelData from_obj(const std::string& text) {
    ModelResult result = read_model(text, "a.obj");
    EXPECT_EQ(result.error, "");
    return std::move(result.model);
}

// The upper half of an octahedron: at the tip the sum of four normals, whose horizontal parts
// cancel; at the others two.
TEST(PlaceModel, NormalsOfVerticesAreSumsOfTheirFacets) {
    const ModelData tent = from_obj("v 1 0 0\nv 0 0 -1\nv -1 0 0\nv 0 0 1\nv 0 1 0\n"
                                "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    ModelPlacing how;
    const PlacedModel smooth = placed_or_fail(tent, how);
    ASSERT_EQ(smooth.normals.size(), 5u);
    EXPECT_EQ(smooth.normals[4], (raster::UnitVector{0, 16384, 0}));
    // (2, 2, 0) / |(2, 2, 0)|: 16384 / sqrt 2 = 11585.24
    EXPECT_EQ(smooth.normals[0], (raster::UnitVector{11585, 11585, 0}));
    EXPECT_EQ(smooth.facets[3].normal, (std::array<std::uint32_t, 3>{3, 0, 4}));
    how.placing.rotation = raster::rotation_of({0, 0, 90 * 65536});
    EXPECT_EQ(placed_or_fail(tent, how).normals[4], (raster::UnitVector{-16384, 0, 0}));
    how.smooth = false;
    const PlacedModel flat = placed_or_fail(tent, how);
    EXPECT_TRUE(flat.normals.empty());
    for (const Facet& facet : flat.facets) EXPECT_EQ(facet.normal[1], Facet::flat);
}

// Each facet counts as much as its area: a wall of 1 and a floor of 3 square units.
TEST(PlaceModel, NormalsOfVerticesAreWeightedByArea) {
    const PlacedModel edge = placed_or_fail(
        from_obj("v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 3\nf 1 2 3\nf 1 4 2\n"), {});
    // (0, 3, 1) / sqrt 10
    EXPECT_EQ(edge.normals[0], (raster::UnitVector{0, 15543, 5181}));
}

TEST(PlaceModel, NormalsOfTheFileAreTurnedAndMadeUnits) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 7\nvn 0 0.001 0.001\n"
                             "vn 0 0 0\nf 1//1 2//1 3//2\nf 1//1 2//1 3//3\nf 1 2 4\n";
    ModelPlacing how;
    how.z_up = true;
    const PlacedModel placed = placed_or_fail(from_obj(text), how);
    EXPECT_EQ(placed.normals[0], (raster::UnitVector{0, 16384, 0}));
    EXPECT_EQ(placed.normals[1], (raster::UnitVector{0, 11585, -11585}));
    EXPECT_EQ(placed.facets[0].normal, (std::array<std::uint32_t, 3>{0, 0, 1}));
    EXPECT_EQ(placed.facets[1].normal[0], Facet::flat);  // a normal of no length
    EXPECT_EQ(placed.facets[2].normal, (std::array<std::uint32_t, 3>{3, 4, 6}));  // its vertices'
}

// Two facets back to back: their sum is nothing, so they are flat.
TEST(PlaceModel, NormalsThatCancelLeaveTheFacetFlat) {
    const PlacedModel placed =
        placed_or_fail(from_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), {});
    for (const Facet& facet : placed.facets) EXPECT_EQ(facet.normal[0], Facet::flat);
}

}  // namespace
}  // namespace umbra78::tools::test
