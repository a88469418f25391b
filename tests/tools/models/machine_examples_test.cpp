// The worked examples of hw/MACHINE.md, section 20.
#include "raster/solids.hpp"
#include "tests/support/machine_text.hpp"
#include "tools/models/place_model.hpp"
#include "tools/models/polygon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace umbra78::tools::test {
namespace {

constexpr std::int32_t one = 1 << 16;
const raster::Placing placing{{one, 2 * one, 3 * one},
                              raster::rotation_of({30 * one, 45 * one, 60 * one})};

std::string words(const raster::World& w) { return fmt::format("{} {} {}", w.x, w.y, w.z); }

// The row of the examples' table that begins with `what`.
std::string published(const std::string& what) {
    const auto rows = umbra78::test::machine_table("| what | words |");
    for (const auto& row : rows)
        if (row.at(0) == what) return row.at(1);
    return "not published";
}

TEST(MachineExamples, ATurn) {
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(published(fmt::format("rotation, row {}", "xyz"[k])),
                  fmt::format("{}", fmt::join(placing.rotation[k], " ")));
}

TEST(MachineExamples, AModelsPoint) {
    ModelResult result = read_model("v 1.4 -0.784 2.4\nv 0 0 0\nv 0.1 0 0\nf 1 2 3\n", "a.obj");
    ASSERT_TRUE(result.ok());
    const ModelPlacing how{.placing = placing, .scale = std::int64_t{3} << 45, .z_up = true};
    FirstError error;
    const PlacedModel placed = place_model(result.model, how, "", error);
    EXPECT_EQ(published("point (1.4, -0.784, 2.4) of a model, z up, scale 0.375"),
              words(placed.vertices[0]));
    EXPECT_EQ(published("normal at the facet of it, (0, 0, 0), (0.1, 0, 0)"),
              fmt::format("{}", fmt::join(placed.normals[0], " ")));
}

TEST(MachineExamples, TrianglesOfAPolygon) {
    std::vector<ModelPoint> star;
    std::string what = "triangles of";
    for (const auto& [y, z] : {std::pair{0, 0}, {9, 1}, {4, 4}, {5, 9}, {3, 5}, {0, 6}, {2, 3}}) {
        what += fmt::format("{} (0, {}, {})", star.empty() ? "" : ",", y, z);
        star.push_back({.word = {0, y, z}});
    }
    std::string numbers;
    for (const auto& triangle : triangulate(star))
        numbers += fmt::format(" {}", fmt::join(triangle, " "));
    EXPECT_EQ(" " + published(what), numbers);
}

TEST(MachineExamples, Solids) {
    std::array<raster::Patch, raster::patches_per_torus> torus;
    ASSERT_TRUE(raster::torus_patches(2 * one, one / 2, placing, torus));
    EXPECT_EQ(published("torus r = 2, t = 1/2, patch 8 x 1 + 3, point (1, 2)"),
              words(torus[11].control[9]));
    std::array<raster::Patch, raster::patches_round> wall;
    ASSERT_TRUE(raster::wall_patches(one, one / 4, 2 * one, placing, wall));
    EXPECT_EQ(published("cone r = 1, top = 1/4, h = 2, patch 5, point (2, 1)"),
              words(wall[5].control[6]));
    std::array<raster::Patch, raster::patches_per_box> box;
    ASSERT_TRUE(raster::box_patches({one, 2 * one, 3 * one}, placing, box));
    EXPECT_EQ(published("box (1, 2, 3), face 3, point (1, 2)"), words(box[3].control[9]));
}

}  // namespace
}  // namespace umbra78::tools::test
