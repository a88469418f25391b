// Exact edges against curves that geometry gives, and the nearest place of an edge.
#include "tools/truth/shadow_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra78::tools {
namespace {

constexpr int edge_size = 128;

// Looked at along z, two world units from the middle to the picture's edge.
SceneTruth traced_scene(TruthScene scene, TruthLight light) {
    SceneTruth t;
    t.scene = std::move(scene);
    t.observer = {false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 2, 0, -100, 100, edge_size};
    t.light_view = t.observer;
    t.light = light;
    t.truth = trace(t.scene, t.observer, t.light);
    t.unlit_side.assign(t.truth.lit.size(), 0);
    return t;
}

std::vector<ShadowEdge> edges_of(const SceneTruth& t) {
    return shadow_edges(t, cells_of_one_surface(t.truth, {}));
}

TEST(ShadowEdge, OfASphereIsItsTerminator) {
    const double x = std::sin(0.3), z = std::cos(0.3);
    const auto edges = edges_of(traced_scene({{{{0, 0, 0}, 1.0}}, {}}, {false, {-z, 0, x}, {}}));
    ASSERT_EQ(edges.size(), 1u);
    EXPECT_EQ(edges[0].kind, EdgeKind::self);
    const double pixel = 4.0 / edge_size;
    // The circle at right angles to the light is seen as an ellipse with the half axes x and 1.
    for (const ImagePoint& p : edges[0].line) {
        const double u = (p.column - edge_size / 2) * pixel, v = (edge_size / 2 - p.row) * pixel;
        const double half_width = std::sqrt(1 - v * v);
        EXPECT_NEAR(u, x * half_width, 0.002 * pixel / std::max(half_width, 0.1));
    }
    EXPECT_GT(length(edges[0].line), 62);
    const NearestEdge nearest(edges, edge_size, 8);
    const auto dark = nearest({edge_size / 2 + x / pixel + 3, edge_size / 2});
    ASSERT_TRUE(dark);
    EXPECT_NEAR(dark->distance, -3, 0.01) << "the light comes from the left";
    EXPECT_FALSE(nearest({edge_size / 2 + x / pixel + 9, edge_size / 2}));
}

TEST(ShadowEdge, OfASphereOverAPlaneIsAnEllipse) {
    const double s = std::sqrt(0.5);
    const TruthPlane wall{{-2, -2, -2}, {4, 0, 0}, {0, 4, 0}};
    const auto t = traced_scene({{{{-1, 0, 0}, 0.5}}, {wall}}, {false, {-s, 0, s}, {}});
    double cast = 0;
    for (const ShadowEdge& edge : edges_of(t)) {
        if (edge.kind == EdgeKind::self) continue;
        cast += length(edge.line);
        for (const ImagePoint& p : edge.line) {
            const double u = (p.column - edge_size / 2) * 4.0 / edge_size;
            const double v = (edge_size / 2 - p.row) * 4.0 / edge_size;
            EXPECT_NEAR(std::hypot((u - 1) * s, v), 0.5, 1e-4);
        }
    }
    EXPECT_NEAR(cast * 4.0 / edge_size, 3.82, 0.01);  // the ellipse's half axes are 1/sqrt 2, 1/2
}

TEST(ShadowEdge, NoneWhereTwoSurfacesMeetOrNothingIsDrawn) {
    const auto t = traced_scene({{{{0, 0, 0}, 1.0}}, {}}, {false, {-1, 0, 0}, {}});
    const auto cells = cells_of_one_surface(t.truth, {});
    int whole = 0;
    for (std::size_t at = 0; at < cells.size(); ++at) {
        if (!cells[at]) continue;
        ++whole;
        EXPECT_TRUE(t.truth.visible[at] && t.truth.visible[at + edge_size + 1]);
    }
    EXPECT_GT(whole, 3000);
    const std::vector<std::uint8_t> nothing(cells.size());
    EXPECT_TRUE(shadow_edges(t, cells_of_one_surface(t.truth, nothing)).empty());
}

}  // namespace
}  // namespace umbra78::tools
