// The lights of a scene file: several, on an area, coloured; and what is wrong with them in a line.
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
    const std::vector<raster::View>& views = scene.lights[0].area;
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
        {lamp + "size = 0\n", "a.toml:7: 'size' in [light] is 0; its range is 2^-16 .. 32767"},
        {lamp + "size = 1\nsamples = 9\n",
         "a.toml:8: 'samples' in [light] is 9; its range is 2 .. 8"},
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
         "a.toml: the correct form shades by a light or not, and has no light with an area; set "
         "form = \"post_process\", or kind = \"point\""},
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
