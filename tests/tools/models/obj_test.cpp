// Wavefront OBJ: words of vertices, corners in every notation, polygons as triangles, errors.
#include "tests/tools/models/model_texts.hpp"

#include "tools/models/obj.hpp"
#include "tools/models/polygon.hpp"

namespace umbra78::tools::test {
namespace {

using Facets = std::vector<std::array<std::uint32_t, 3>>;

ModelData read(const std::string& text) {
    ModelResult result = read_model(text, "a.obj");
    EXPECT_EQ(result.error, "") << text;
    return std::move(result.model);
}

Facets vertices_of(const ModelData& model) {
    Facets facets;
    for (const raster::Facet& facet : model.facets) facets.push_back(facet.vertex);
    return facets;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, VerticesAreExactWordsAndFacesTriangles) {
    const ModelData model =
        read(square + "v .5 -2.5e-1 5. 0.7\nv 0 0 1 0.2 0.3 0.4\nf 1 2 3\nf 5 6 1\n");
    ASSERT_EQ(model.vertices.size(), 5u);  // the fourth is not used
    EXPECT_EQ(model.vertices[3].word,
              (std::array{model_one / 2, -model_one / 4, 5 * model_one}));
    EXPECT_EQ(model.vertices[4].word, (std::array<std::int64_t, 3>{0, 0, model_one}));
    EXPECT_EQ(model.vertices[4].line, 6);
    EXPECT_EQ(vertices_of(model), (Facets{{0, 1, 2}, {3, 4, 0}}));
    EXPECT_EQ(model.facets[0].normal[0], raster::Facet::flat);
    EXPECT_TRUE(model.patches.empty());
}

TEST(Obj, CornersInEveryNotation) {
    const std::string head = square + "vt 0 0\nvn 0 0 1\nvn 0 0 -1\n";
    for (const char* face : {"f 1 2 3", "f 1/1 2/1 3/1", "f -4 -3 -2", "f -4/-1 -3/1 -2/7"}) {
        const ModelData model = read(head + face);
        EXPECT_EQ(vertices_of(model), (Facets{{0, 1, 2}})) << face;
        EXPECT_EQ(model.facets[0].normal[2], raster::Facet::flat) << face;
        EXPECT_TRUE(model.normals.empty());
    }
    for (const char* face : {"f 1//2 2//2 3//2", "f 1/1/2 2/1/2 3/1/2", "f -4//-1 -3//-1 -2//-1"}) {
        const ModelData model = read(head + face);
        ASSERT_EQ(model.normals.size(), 1u) << face;  // the other is not used
        EXPECT_EQ(model.normals[0].word[2], -model_one);
        EXPECT_EQ(model.facets[0].normal, (std::array<std::uint32_t, 3>{0, 0, 0})) << face;
    }
    // A corner without a normal leaves the face without.
    EXPECT_EQ(read(head + "f 1//1 2//1 3").facets[0].normal[0], raster::Facet::flat);
    // Numbers may name what follows; those from -1 back count what stands before.
    EXPECT_EQ(vertices_of(read("f 1 2 3\n" + square)), (Facets{{0, 1, 2}}));
    EXPECT_EQ(vertices_of(read(square + "f -3 -2 -1\nv 9 9 9\nf 1 2 5\n")),
              (Facets{{1, 2, 3}, {0, 1, 4}}));
}

TEST(Obj, LinesMayEndWithCrlfGoOnAndHoldComments) {
    const std::string text = "mtllib a.mtl\no x\ng y z\ns 1\nusemtl\n" + square +
                             "# comment\nf 1 2 \\\n 3 \\\n4 # end\n";
    const Facets two{{3, 0, 1}, {3, 1, 2}};
    EXPECT_EQ(vertices_of(read(text)), two);
    EXPECT_EQ(vertices_of(read(with_crlf(text))), two);
    EXPECT_EQ(vertices_of(read(with_comments(square + "f 1 2 3 4"))), two);
    EXPECT_EQ(vertices_of(read("\xEF\xBB\xBF" + square + "f 1 2 3 4 \\")), two);
}

TEST(Obj, WhatIsNoSurfaceIsCounted) {
    const ModelData model = read(square + "l 1 2\np 1\np 2 3\nf 1 2 3\nf 1 1 2\nf 2 3 2\n");
    EXPECT_EQ(model.lines_and_points, 3u);
    EXPECT_EQ(model.no_area, 2u);
    EXPECT_EQ(model.facets.size(), 1u);
}

// Twice the area of the triangles, each turning the polygon's way.
std::int64_t doubled_area(const std::vector<ModelPoint>& p, const Facets& triangles) {
    std::int64_t sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const std::int64_t area = (p[b].word[0] - p[a].word[0]) * (p[c].word[1] - p[a].word[1]) -
                                  (p[b].word[1] - p[a].word[1]) * (p[c].word[0] - p[a].word[0]);
        EXPECT_GE(area, 0);
        sum += area;
    }
    return sum;
}

std::vector<ModelPoint> polygon(const std::vector<std::array<std::int64_t, 2>>& corners) {
    std::vector<ModelPoint> points;
    for (const auto& [x, y] : corners) points.push_back({.word = {x, y, 3 * x - 2 * y}});
    return points;
}

// All triangles turn the polygon's way and their areas add up to its own, so none overlaps another
// or leaves it.
TEST(Triangulation, ConcavePolygonsKeepTheirArea) {
    const std::vector<std::vector<std::array<std::int64_t, 2>>> polygons = {
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
        {{0, 0}, {4, 0}, {1, 1}, {0, 4}},                                    // a dart
        {{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}},    // a U
        {{0, 0}, {8, 0}, {8, 8}, {2, 8}, {2, 4}, {4, 4}, {4, 6}, {6, 6}, {6, 2}, {0, 2}},
        {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}},    // points on sides
        {{0, 0}, {10, 0}, {10, 9}, {9, 1}, {8, 9}, {7, 1}, {6, 9}, {5, 1}, {4, 9}, {3, 1}, {2, 9},
         {1, 1}, {0, 9}},
    };
    for (const auto& corners : polygons) {
        std::int64_t area = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto &p = corners[k], &q = corners[(k + 1) % corners.size()];
            area += p[0] * q[1] - p[1] * q[0];
        }
        for (std::size_t first = 0; first < corners.size(); ++first) {  // whichever corner is first
            auto turned = corners;
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                        turned.end());
            const auto points = polygon(turned);
            const Facets triangles = triangulate(points);
            EXPECT_EQ(triangles.size(), corners.size() - 2);
            EXPECT_EQ(doubled_area(points, triangles), area);
        }
    }
}

// The greatest coordinates: the doubled area needs 108 bits.
TEST(Triangulation, IsExactAtTheEndsOfTheRange) {
    const auto corner = [](std::int64_t x, std::int64_t y) {
        return ModelPoint{.word = {x, y, max_model}};
    };
    const std::vector<ModelPoint> dart{corner(-max_model, -max_model),
                                       corner(max_model, -max_model), corner(-1, 0),
                                       corner(-max_model, max_model)};
    // (-1, 0) lies a hair inside the diagonal, so the quadrangle is cut there.
    EXPECT_EQ(triangulate(dart), (Facets{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_FALSE(without_area(dart[1], dart[2], dart[3]));
    EXPECT_TRUE(without_area(dart[1], corner(0, 0), dart[3]));
}

TEST(Triangulation, EndsForPolygonsWithoutEars) {
    const auto bow = polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    EXPECT_EQ(triangulate(bow).size(), 2u);
    const std::vector<ModelPoint> point(7);
    EXPECT_EQ(triangulate(point).size(), 5u);
}

TEST(ObjErrors, Statements) {
    expect_messages({
        {"a.obj", "", "a.obj:1: the file holds no faces; a surface needs f statements"},
        {"a.obj", square, "a.obj:4: the file holds no faces; a surface needs f statements"},
        {"a.obj", "v 1 2\n", "a.obj:1: 'v' has 2 coordinates; give three"},
        {"a.obj", "v 1 2 nan\n", "a.obj:1: 'nan' is no coordinate; write a decimal, such as -2.5"},
        {"a.obj", "\nvn 1 2 1e300\n",
         "a.obj:2: the coordinate '1e300' is beyond -1048576 .. 1048576; scale the file's points"},
        {"a.obj", "v 1 \\\r\n2 \\\r\n3,5\r\n",
         "a.obj:3: '3,5' is no coordinate; write a decimal, such as -2.5"},
        {"a.obj", square + "triangle 1 2 3\n",
         "a.obj:5: 'triangle' begins no statement of OBJ; remove the line, or begin it with #"},
        {"a.obj", std::string("\0v\0 1", 5),
         "a.obj:1: '?v?' begins no statement of OBJ; remove the line, or begin it with #"},
    });
}

TEST(ObjErrors, Faces) {
    const std::string no_corner = "' is no corner; write v, v/t, v//n or v/t/n, numbers from 1, or "
                                  "from -1 back";
    expect_messages({
        {"a.obj", square + "f 1 2\n", "a.obj:5: a face has 2 corners; give 3 .. 1024"},
        {"a.obj", square + "f\n", "a.obj:5: a face has 0 corners; give 3 .. 1024"},
        {"a.obj", square + "f 1 2 5\n",
         "a.obj:5: vertex 5 is named; there are 4: correct the number"},
        {"a.obj", square + "f 1 2 \\\n-5\n",
         "a.obj:6: '-5' goes back beyond the first; only 4 stand before it"},
        {"a.obj", square + "f 1 2 99999999999\n",
         "a.obj:5: vertex 99999999999 is named; there are 4: correct the number"},
        {"a.obj", square + "vn 0 0 1\nf 1//1 2//1 3//2\n",
         "a.obj:6: normal 2 is named; there are 1: correct the number"},
        {"a.obj", square + "vn 0 0 1\nf 1//1 2//1 3//-2\n",
         "a.obj:6: '3//-2' goes back beyond the first; only 1 stand before it"},
        {"a.obj", square + "f 1 2 0\n", "a.obj:5: '0" + no_corner},
        {"a.obj", square + "f 1 2 x\n", "a.obj:5: 'x" + no_corner},
        {"a.obj", square + "f 1 2 3.0\n", "a.obj:5: '3.0" + no_corner},
        {"a.obj", square + "f 1 2 3/\n" + "f 1 2 /3\n", "a.obj:6: '/3" + no_corner},
        {"a.obj", square + "f 1/1/1/1 2 3\n", "a.obj:5: '1/1/1/1" + no_corner},
        {"a.obj", square + "f 1 2 99999999999999999999\n",
         "a.obj:5: '99999999999999999999" + no_corner},
        {"a.obj", square + "f" + repeated(" \\\n1", 1'000'000) + "\n",
         "a.obj:5: a face has 1000000 corners; give 3 .. 1024"},
        {"a.obj", repeated("v 0 0 0\n", 1'000'000) + "f 1 2\n",
         "a.obj:1000001: a face has 2 corners; give 3 .. 1024"},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
