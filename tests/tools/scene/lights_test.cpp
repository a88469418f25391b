// The lights of a scene file: several, on an area, coloured; and what is wrong with them in a line.
#include "hw/sectors.hpp"
#include "tests/tools/scene/malformed.hpp"
#include "tools/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

using test::expect_messages;

const std::string one_ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
const std::string two = one_ball + "[[light]]\nazimuth = -100\n[[light]]\nkind = \"point\"\n"
                               "position = [0, 6, 8]\nlevel = [1, 0.5, 0]\n";

LoadedScene lit_by(const std::string& text, const std::vector<std::string>& set = {}) {
    return parse_scene(text, "a.toml", set);
}

std::string error_with(const std::string& text, const std::vector<std::string>& set) {
    return read_scene(text, "a.toml", set).error;
}

TEST(SceneLights, OneMayBeWrittenAsATableOrAsOneOfMany) {
    const LoadedScene table = lit_by(one_ball + "[light]\nazimuth = -100\n");
    const LoadedScene many = lit_by(one_ball + "[[light]]\nazimuth = -100\n");
    ASSERT_EQ(many.lights.size(), 1u);
    EXPECT_EQ(many.light().axes.back, table.light().axes.back);
    EXPECT_EQ(many.light().extent, table.light().extent);
    EXPECT_FALSE(many.is_coloured());
}

TEST(SceneLights, AreSourcesInTheFilesOrder) {
    const LoadedScene scene = lit_by(two);
    ASSERT_EQ(scene.lights.size(), 2u);
    const shadow::Scene view = scene.view();
    ASSERT_EQ(view.source_count, 2u);
    ASSERT_EQ(view.light_count, 2u);
    EXPECT_EQ(view.channels, 3u);  // the second light's levels are no grey
    EXPECT_EQ(view.sources[1].first_light, 1u);
    EXPECT_EQ(view.sources[0].level_q8, raster::Levels(256));
    EXPECT_EQ(view.sources[1].level_q8, raster::Levels(256, 128, 0));
    EXPECT_EQ(view.lights[0].projection, raster::Projection::orthographic);
    EXPECT_EQ(view.lights[1].distance, 10 << 16);
    EXPECT_TRUE(view.in_order());
}

TEST(SceneLights, AColouredMaterialMakesAColouredPicture) {
    const LoadedScene scene = lit_by("[[material]]\nname = \"red\"\ndiffuse = [200, 30, 20]\n" +
                                     one_ball + "material = \"red\"\n[light]\nazimuth = 0\n");
    EXPECT_EQ(scene.materials[0].diffuse, raster::Levels(200, 30, 20));
    EXPECT_EQ(scene.materials[0].specular, raster::Levels(55));
    EXPECT_EQ(scene.view().channels, 3u);
}

// The points of the area lie in a plane that faces the target, n x n of them, evenly.
TEST(SceneLights, AnAreaHasAViewForEachOfItsPoints) {
    const LoadedScene scene = lit_by(one_ball + "[light]\nkind = \"area\"\nposition = [0, 0, 8]\n"
                                            "target = [0, 0, 0]\nsize = 2\nsamples = 4\n");
    ASSERT_EQ(scene.lights.size(), 1u);
    const std::vector<raster::View>& views = scene.lights[0].parts;
    ASSERT_EQ(views.size(), 16u);
    for (std::size_t k = 0; k < views.size(); ++k) {
        const raster::View& v = views[k];
        const double x = -0.75 + 0.5 * static_cast<double>(k % 4);
        const double y = -0.75 + 0.5 * static_cast<double>(k / 4);
        EXPECT_NEAR(std::ldexp(v.distance, -16), std::sqrt(x * x + y * y + 64), 1e-5) << k;
        const double length = std::ldexp(v.distance, -16);
        EXPECT_NEAR(std::ldexp(v.axes.back[0], -30) * length, x, 1e-4) << k;
        EXPECT_NEAR(std::ldexp(v.axes.back[1], -30) * length, y, 1e-4) << k;
        EXPECT_EQ(v.projection, raster::Projection::perspective);
        EXPECT_GT(v.extent, 1 << 16);
        EXPECT_LT(v.near_depth, v.far_depth);
    }
    const shadow::Scene view = scene.view();
    EXPECT_EQ(view.light_count, 16u);
    EXPECT_EQ(view.sources[0].lights, 16u);
    EXPECT_EQ(view.sources[0].place.distance, 8 << 16);
}

// Each point stays in its cell, and no two seeds have the same places.
TEST(SceneLights, AnAreasPointsMayStandWhereNoisePutsThem) {
    const std::string area = one_ball + "[light]\nkind = \"area\"\nposition = [0, 0, 8]\n"
                                        "target = [0, 0, 0]\nsize = 2\nsamples = 4\n";
    const auto x_of = [](const raster::View& v) {
        return std::ldexp(v.axes.back[0], -30) * std::ldexp(v.distance, -16);
    };
    const LoadedScene grid = lit_by(area), noise = lit_by(area, {"light.places=noise"}),
                      other = lit_by(area, {"light.places=noise", "light.seed=3"});
    int moved = 0;
    for (std::size_t k = 0; k < 16; ++k) {
        const double middle = x_of(grid.lights[0].parts[k]);
        EXPECT_LT(std::abs(x_of(noise.lights[0].parts[k]) - middle), 0.2501) << k;
        moved += x_of(other.lights[0].parts[k]) != x_of(noise.lights[0].parts[k]) ? 1 : 0;
    }
    EXPECT_GT(moved, 12);
    EXPECT_EQ(lit_by(area, {"light.samples=1", "light.ramp=4"}).view().sources[0].ramp_px, 4);
}

TEST(SceneLights, SectorsAreSixViewsOfAQuarterTurn) {
    const LoadedScene scene = lit_by(one_ball + "[light]\nkind = \"sectors\"\n"
                                                "position = [3, 1, 2]\ntarget = [3, 1, 0]\n");
    const std::span<const raster::View> views = scene.lights[0].views();
    ASSERT_EQ(views.size(), 6u);
    EXPECT_TRUE(scene.view().sources[0].sectored);
    EXPECT_FALSE(scene.view().sources[0].has_area());
    for (std::size_t k = 0; k < views.size(); ++k) {
        const raster::View& v = views[k];
        EXPECT_EQ(v.projection, raster::Projection::perspective);
        EXPECT_EQ(v.extent, v.distance);  // a right angle
        EXPECT_EQ(v.distance, 2 << 16);
        EXPECT_LT(v.near_depth, v.far_depth);
        const std::int32_t sign = k % 2 == 0 ? -1 : 1;  // back is toward the viewer
        raster::Axis back{0, 0, 0};
        back[k / 2] = sign * (1 << 30);
        EXPECT_EQ(v.axes.back, back) << k;
        const std::array<std::int32_t, 3> target{v.target.x, v.target.y, v.target.z};
        const std::array<std::int32_t, 3> from{3 << 16, 1 << 16, 2 << 16};
        for (std::size_t a = 0; a < 3; ++a)
            EXPECT_EQ(target[a], from[a] - (a == k / 2 ? 2 * sign * 65536 : 0)) << k;
    }
    // Each row of hw::faces is a view's right, down and forward.
    for (std::size_t k = 0; k < views.size(); ++k)
        for (std::size_t a = 0; a < 3; ++a) {
            const hw::Face& face = hw::faces[k];
            const auto part = [&](const hw::FaceAxis& axis) {
                return axis.of != a ? 0 : axis.negated ? -(1 << 30) : 1 << 30;
            };
            EXPECT_EQ(part(face.x), views[k].axes.right[a]) << k;
            EXPECT_EQ(part(face.y), -views[k].axes.up[a]) << k;
            EXPECT_EQ(part(face.w), -views[k].axes.back[a]) << k;
        }
}

// No direction lies beside a light that shines in all of them.
TEST(SceneLights, SectorsWarnOfNoWindow) {
    const std::string among = "[[sphere]]\ncentre = [3, 0, 0]\nradius = 1\n" + one_ball +
                              "[light]\nposition = [1.5, 0, 0]\ntarget = [0, 0, 0]\n"
                              "near = 0.25\nfar = 8\nkind = ";
    const auto keys = [](const LoadedScene& scene) {
        std::string all;
        for (const Warning& w : scene.warnings) all += w.line + "\n";
        return all;
    };
    EXPECT_NE(keys(lit_by(among + "\"point\"\n")).find("lie beside or behind the light"),
              std::string::npos);
    EXPECT_EQ(keys(lit_by(among + "\"sectors\"\n[settings]\ncoefficient_bits = 24\n")), "");
    EXPECT_NE(keys(lit_by(among + "\"sectors\"\n", {"light.near=0.75"}))
                  .find("nearer than near = 0.75"),
              std::string::npos);
}

TEST(SceneLights, AnOverrideNamesOneOfSeveral) {
    const LoadedScene scene = lit_by(two, {"light2.level=0.25", "light1.azimuth=-60"});
    EXPECT_EQ(scene.lights[1].level_q8, raster::Levels(64));
    EXPECT_EQ(scene.lights[0].view.axes.back, raster::axes_from_angles(-60 << 16, 0).back);
    EXPECT_EQ(error_with(two, {"light.azimuth=3"}),
              "--set light.azimuth=3: the scene has 2 lights; set light1.KEY .. light2.KEY");
    EXPECT_EQ(error_with(two, {"light3.azimuth=3"}),
              "--set light3.azimuth=3: there is no light3; the scene has 2 lights");
    const std::string one = one_ball + "[light]\nazimuth = -100\n";
    EXPECT_EQ(error_with(one, {"light2.azimuth=3"}),
              "--set light2.azimuth=3: there is no light2; the scene has 1 light: set light.KEY");
    EXPECT_EQ(lit_by(one, {"light1.azimuth=-60"}).light().axes.back,
              raster::axes_from_angles(-60 << 16, 0).back);
}

TEST(SceneLights, WhatIsWrongIsSaidInALine) {
    const std::string lamp = one_ball + "[light]\nkind = \"area\"\nposition = [0, 0, 8]\n";
    std::string nine = one_ball;
    for (int k = 0; k < 9; ++k) nine += "[[light]]\nazimuth = " + std::to_string(k) + "\n";
    expect_messages({
        {one_ball + "[light]\nazimuth = 0\nsize = 2\n",
         "a.toml:6: 'size' in [light] needs kind = \"area\""},
        {one_ball + "[light]\nazimuth = 0\nsamples = 2\n",
         "a.toml:6: 'samples' in [light] needs kind = \"area\""},
        {lamp, "a.toml:4: [light] has no 'size'; add size = 1"},
        {one_ball + "[light]\nkind = \"sectors\"\nposition = [0, 0, 8]\nextent = 3\n",
         "a.toml:7: 'extent' in [light] is a quarter turn of each sector; leave it out, or set "
         "kind = \"point\""},
        {one_ball + "[light]\nkind = \"sectors\"\nposition = [0, 0, 30000]\n",
         "a.toml:6: 'position' in [light] lies so far out that its sectors look beyond 32766; "
         "bring its target nearer to it"},
        {one_ball + "[light]\nkind = \"sectors\"\nposition = [0, 0, 0]\n",
         "a.toml:6: 'position' in [light] is its target, the middle of the scene; move one of "
         "them"},
        {one_ball + "[light]\nkind = \"sectors\"\nposition = [0, 0, 8]\n[settings]\n"
                    "form = \"correct\"\n",
         "a.toml: only the post-process on the fixed-point machine sorts into sectors; set "
         "form = \"post_process\" and arithmetic = \"fixed\", or kind = \"point\""},
        {lamp + "size = 0\n", "a.toml:7: 'size' in [light] is 0; its range is 2^-16 .. 32767"},
        {lamp + "size = 1\nsamples = 9\n",
         "a.toml:8: 'samples' in [light] is 9; its range is 1 .. 8"},
        {lamp + "size = 1\nramp = 3\n",
         "a.toml:8: 'ramp' in [light] is for one hard shadow; set samples = 1, or leave it out"},
        {lamp + "size = 1\nramp = 33\n", "a.toml:8: 'ramp' in [light] is 33; its range is 0 .. 32"},
        {one_ball + "[light]\nazimuth = 0\nplaces = \"noise\"\n",
         "a.toml:6: 'places' in [light] needs kind = \"area\""},
        {lamp + "size = 1\nlevel = 1.5\n",
         "a.toml:8: 'level' in [light] is 1.5; its range is 0 .. 1"},
        {lamp + "size = 1\nlevel = [1, 2, 0]\n",
         "a.toml:8: green of 'level' in [light] is 2; its range is 0 .. 1"},
        {lamp + "size = 1\nlevel = [1, 1]\n",
         "a.toml:8: 'level' in [light] is an array of 2; write a number, or [red, green, blue]"},
        {lamp + "size = 1\nlevel = \"red\"\n",
         "a.toml:8: 'level' in [light] is the text 'red'; write a number"},
        {two + "[[light]]\nazimut = 3\n",
         "a.toml:11: unknown key 'azimut' in [[light]]; did you mean 'azimuth'?"},
        {two + "[[light]]\nelevation = 3\n",
         "a.toml:10: [[light]] has no 'azimuth'; add azimuth = -100"},
        {nine, "a.toml:20: there are more than 8 lights; leave some out"},
        {one_ball + "[[light]]\nazimuth = 0\n[[light]]\nkind = \"area\"\nposition = [0, 0, 8]\n"
                "size = 1\nsamples = 8\n",
         "a.toml:6: the lights have 65 depth maps up to this one, and 64 are possible; lower "
         "'samples'"},
        {lamp + "size = 1\n[settings]\nform = \"correct\"\n",
         "a.toml: the correct form shades by a light or not, and has no light with an area or a "
         "ramp; set form = \"post_process\", or kind = \"point\" and no ramp"},
    });
}

TEST(SceneLights, WarningsNameTheLight) {
    const Warnings warnings = lit_by(two, {"light2.extent=0.25"}).warnings;
    ASSERT_FALSE(warnings.empty());
    EXPECT_NE(warnings[0].line.find("reach out of the light2's picture"), std::string::npos)
        << warnings[0].line;
    EXPECT_NE(warnings[0].line.find("light2.extent = "), std::string::npos);
}

TEST(SceneLights, WhatLooksAtOneLightRefusesMore) {
    EXPECT_THROW(require_one_light(lit_by(two), "a study"), SceneError);
    EXPECT_NO_THROW(require_one_light(lit_by(one_ball + "[light]\nazimuth = 3\n"), "a study"));
}

}  // namespace
}  // namespace umbra78::tools
