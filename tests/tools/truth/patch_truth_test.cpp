// Embree's truth of patches, against the closed form of the spheres they are made of.
#include "tests/support/paths.hpp"
#include "tools/truth/patch_truth.hpp"
#include "tools/truth/scene_truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

const std::string scenes = UMBRA78_SOURCE_DIR "/tools/scenes/";

// The pixels with another surface, or another answer of the light, within one pixel.
Band near_an_edge(const Truth& truth) {
    Band band = edge_band(truth, 1);
    const int size = truth.size;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size + x;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size - 1); ++u)
                    band[at] |= truth.surface[at] !=
                                truth.surface[static_cast<std::size_t>(v) * size + u];
        }
    }
    return band;
}

TEST(PatchTruth, ManyPatchesGetFewerCells) {
    EXPECT_EQ(cells_within_budget(1, 64), 64);
    EXPECT_EQ(cells_within_budget(512, 64), 64);
    EXPECT_EQ(cells_within_budget(513, 64), 63);
    EXPECT_EQ(cells_within_budget(60000, 64), 5);
    EXPECT_EQ(cells_within_budget(60000, 4), 4);
    EXPECT_EQ(cells_within_budget(10'000'000, 64), 2);
    EXPECT_EQ(cells_within_budget(512, 64, max_patch_triangles / 2), 45);
    EXPECT_EQ(cells_within_budget(512, 64, 2 * max_patch_triangles), 2);
}

int count(const Band& band) { return static_cast<int>(std::count(band.begin(), band.end(), 1)); }

TEST(PatchTruth, AgreesWithTheClosedFormOfSpheres) {
    if (!traces_patches()) GTEST_SKIP() << "built without Embree (libembree-dev)";
    const std::vector<std::string> size{"xy_bits=9"};
    const LoadedScene scene = load_scene(scenes + "figures.toml", size);
    ASSERT_EQ(scene.spheres.size(), 4u);
    const SceneTruth exact = *trace(scene);
    const PatchTruth traced = *trace_patches(scene.patches, exact.observer, exact.light);
    const Band edge = near_an_edge(exact.truth);
    int differ = 0, differ_inside = 0, on_edge = 0;
    double depth = 0, cosine = 0;
    int dark = 0, other_caster = 0;  // at a caster's limb another surface may be the first
    for (std::size_t at = 0; at < edge.size(); ++at) {
        const bool same = exact.truth.visible[at] == traced.truth.visible[at] &&
                          exact.truth.lit[at] == traced.truth.lit[at];
        on_edge += edge[at];
        differ += !same;
        differ_inside += !same && !edge[at];
        if (edge[at] || !exact.truth.visible[at] || !traced.truth.visible[at]) continue;
        depth = std::max(depth, std::abs(exact.truth.depth[at] - traced.truth.depth[at]));
        if (!exact.truth.lit[at] && !traced.truth.lit[at]) {
            ++dark;
            other_caster += std::abs(exact.truth.behind[at] - traced.truth.behind[at]) > 1e-3;
        }
        cosine = std::max(cosine, std::abs(exact.truth.n_dot_l[at] - traced.truth.n_dot_l[at]));
    }
    const auto pixels = static_cast<double>(edge.size());
    std::printf("of %.0f pixels %d differ, %d of them not among the %d at an edge; estimated %.2e "
                "of all (%.0f); depth within %.1e, cosine within %.1e, "
                "%d of %d shadows of another caster, offset %.1e\n",
                pixels, differ, differ_inside, on_edge, traced.estimated_error,
                traced.estimated_error * pixels, depth, cosine, other_caster, dark,
                traced.shadow_offset);
    EXPECT_LE(differ_inside, traced.estimated_error * pixels);
    EXPECT_LT(differ, 0.002 * pixels);
    EXPECT_LT(traced.estimated_error, 0.002);
    EXPECT_LT(depth, 1e-4);
    EXPECT_LT(cosine, 1e-3);
    EXPECT_GT(dark, 1000);
    EXPECT_LT(other_caster, dark / 200);
}

// A plane over a plane, once as planes and once as facets: the closed form's answer.
TEST(PatchTruth, AgreesWithTheClosedFormOfFacets) {
    if (!traces_patches()) GTEST_SKIP() << "built without Embree (libembree-dev)";
    const std::string planes = R"(
[observer]
elevation = 35
[light]
kind = "point"
position = [-2, 5, 3]
[[plane]]
origin = [-3, 0, 3]
u = [6, 0, 0]
v = [0, 0, -6]
[[plane]]
origin = [-1, 1, 1]
u = [2, 0.4, 0]
v = [0, 0.3, -2]
[settings]
xy_bits = 7
)";
    const LoadedScene scene = parse_scene(planes, "planes.toml", {});
    const SceneTruth exact = *trace(scene);
    ASSERT_TRUE(exact.closed_form);
    LoadedScene mesh = scene;
    for (const raster::Plane& p : scene.planes) {
        const auto at = [&](int s, int t) {
            return raster::World{p.origin.x + s * p.u.x + t * p.v.x,
                                 p.origin.y + s * p.u.y + t * p.v.y,
                                 p.origin.z + s * p.u.z + t * p.v.z};
        };
        const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
        mesh.facets.push_back({{n, n + 1, n + 2}});
        mesh.facets.push_back({{n, n + 2, n + 3}});
    }
    mesh.planes.clear();
    mesh.patches.clear();
    EXPECT_FALSE(mesh.has_closed_form());
    const SceneTruth traced = *trace(mesh);
    EXPECT_FALSE(traced.closed_form);
    EXPECT_EQ(traced.tessellation_error, 0);  // facets are not cut up
    const Band edge = near_an_edge(exact.truth);
    int lit = 0, dark = 0;
    for (std::size_t at = 0; at < edge.size(); ++at) {
        if (edge[at]) continue;
        EXPECT_EQ(exact.truth.visible[at], traced.truth.visible[at]) << at;
        EXPECT_EQ(exact.truth.lit[at], traced.truth.lit[at]) << at;
        if (!exact.truth.visible[at]) continue;
        EXPECT_NEAR(exact.truth.depth[at], traced.truth.depth[at], 1e-9) << at;
        EXPECT_EQ(traced.truth.surface[at] / 2, exact.truth.surface[at]) << at;
        lit += exact.truth.lit[at];
        dark += !exact.truth.lit[at];
    }
    EXPECT_GT(lit, 1000);
    EXPECT_GT(dark, 300);
}

TEST(PatchTruth, ASceneWithFreePatchesHasItsTruth) {
    const std::vector<std::string> size{"xy_bits=7"};
    const LoadedScene scene = load_scene(scenes + "lamp.toml", size);
    ASSERT_GT(scene.free_patches, 0u);
    const auto truth = trace(scene);
    ASSERT_EQ(truth.has_value(), traces_patches());
    if (!truth) GTEST_SKIP() << "built without Embree (libembree-dev)";
    EXPECT_FALSE(truth->closed_form);
    EXPECT_LT(truth->tessellation_error, 0.01);
    EXPECT_GT(count(light_texel_band(*truth)), count(edge_band(truth->truth, 1)));
    const auto surfaces =
        static_cast<int>(scene.spheres.size() + scene.planes.size() + scene.free_patches);
    int lit = 0, dark = 0;
    for (std::size_t at = 0; at < truth->truth.visible.size(); ++at) {
        EXPECT_LT(truth->truth.surface[at], surfaces);
        lit += truth->truth.lit[at];
        dark += truth->truth.visible[at] && !truth->truth.lit[at];
    }
    EXPECT_GT(lit, 0);
    EXPECT_GT(dark, 0);
}

}  // namespace
}  // namespace umbra78::tools
