// A scene's ground: the key that names it, where it lies among the patches, and what is refused.
#include "raster/scene.hpp"
#include "tools/scene/scene.hpp"
#include "tools/stream/hills.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace umbra78::tools {
namespace {

const std::string ground_lamp = "[light]\nazimuth = -60\nelevation = 40\n";
const std::string ground_ball = "[[sphere]]\ncentre = [0, 1, 0]\nradius = 0.5\n";

std::string plane_text(const std::string& more, int height = 0) {
    return "[[plane]]\norigin = [-1, " + std::to_string(height) +
           ", 1]\nu = [2, 0, 0]\nv = [0, 0, -2]\n" + more;
}

SceneResult read(const std::string& text, const std::string& set = "form=ground",
                 const StreamSource& streams = {}) {
    const std::string overrides[] = {set};
    return read_scene(text, "a.toml", overrides, {}, streams);
}

TEST(GroundScene, ThePlaneIsFoundAmongThePatches) {
    const SceneResult result = read(ground_lamp + ground_ball + plane_text("", 3) +
                                    plane_text("ground = \"on\"\n") + ground_ball +
                                    plane_text("ground = \"off\"\n", 5));
    ASSERT_EQ(result.error, "");
    EXPECT_EQ(result.scene.settings.form, shadow::Form::ground);
    const shadow::Scene scene = result.scene.view();
    EXPECT_EQ(scene.ground, 2u * raster::patches_per_sphere + 1);
    const raster::Plane& plane = result.scene.planes[1];
    EXPECT_EQ(scene.patches[scene.ground].control, raster::plane_patch(plane).control);
    EXPECT_EQ(read(ground_lamp + plane_text(""), "form=correct").scene.view().ground,
              shadow::Scene::no_ground);
}

TEST(GroundScene, WhatIsRefused) {
    const std::string flat = plane_text("ground = \"on\"\n");
    const std::string none = "a.toml: form = \"ground\" and \"blob\" cast shadows on one plane, "
                             "and the scene names none";
    const std::string remedy = "; write ground = \"on\" into a [[plane]], or set form = "
                               "\"post_process\"";
    EXPECT_EQ(read(ground_lamp + ground_ball).error,
              none + remedy);
    EXPECT_EQ(read(ground_lamp + plane_text("ground = \"off\"\n")).error,
              none + remedy);
    EXPECT_EQ(read(ground_lamp + flat + flat).error,
              "a.toml:13: a second [[plane]] is the ground; leave 'ground' out of one");
    EXPECT_EQ(read(ground_lamp + ground_ball + "ground = \"on\"\n").error,
              "a.toml:7: unknown key 'ground' in [[sphere]]; known here: centre, radius, material");
    EXPECT_EQ(read("[light]\nazimuth = -60\n" + flat).error,
              "a.toml: a light lies in the plane of the ground, where its shadows have no end; "
              "move it, or set form = \"post_process\"");
    EXPECT_EQ(read("[light]\nkind = \"point\"\nposition = [0, 0, 9]\n" + flat).error,
              "a.toml: a light lies in the plane of the ground, where its shadows have no end; "
              "move it, or set form = \"post_process\"");
    EXPECT_EQ(read(ground_lamp + flat + "[settings]\nform = \"ground\"\n", "receiver=plane").error,
              "--set receiver=plane: 'receiver' in [settings] is plane, which the machine cannot "
              "be built with (form = ground with arithmetic = fixed has receiver = point alone)");
    EXPECT_EQ(read(ground_lamp + flat + "[settings]\nform = \"ground\"\n", "arithmetic=ap120b")
                  .error,
              "--set arithmetic=ap120b: 'arithmetic' in [settings] is ap120b, which the machine "
              "cannot be built with (there is no form = ground with arithmetic = ap120b)");
    const auto hills = [](const std::string&) {
        return OpenedStream{std::make_unique<Hills>(HillsShape{.patches = 4, .side = 2}), ""};
    };
    EXPECT_EQ(read(ground_lamp + flat + "[stream]\nfile = \"-\"\n", "form=ground", hills).error,
              "a.toml: form = \"ground\" and \"blob\" draw the ground before what stands on it, "
              "and a [stream] is not held; set form = \"post_process\"");
}

// An ellipse for each surface of the file but the ground, in its order.
TEST(GroundScene, EachSurfaceHasABlob) {
    const std::string box = "[[box]]\ncentre = [3, 1, 0]\nsize = [2, 2, 1]\n";
    const std::string triangle = "[[triangle]]\na = [0, 1, 4]\nb = [2, 2, 4]\nc = [0, 1, 5]\n";
    const std::string here = "[observer]\nrecentre = \"off\"\n";
    const SceneResult result = read(here + ground_lamp + ground_ball + plane_text("", 3) +
                                        plane_text("ground = \"on\"\n") + box + triangle,
                                    "form=blob");
    ASSERT_EQ(result.error, "");
    using raster::Ellipse;
    const std::vector<Ellipse> expected{
        {{0, 0, 0}, {32768, 0, 0}, {0, 0, -32768}},
        {{0, 0, 0}, {65536, 0, 0}, {0, 0, -65536}},
        {{3 * 65536, 0, 0}, {65536, 0, 0}, {0, 0, -32768}},
        {{65536, 0, 4 * 65536 + 32768}, {65536, 0, 0}, {0, 0, -32768}}};
    EXPECT_EQ(result.scene.blobs, expected);
    EXPECT_TRUE(read(ground_lamp + ground_ball, "form=correct").scene.blobs.empty());
    // The box of what lies in the world may reach out of it on a plane that is askew.
    const std::string skew = "[[plane]]\norigin = [0, 0, 0]\nu = [1, 1, 0]\nv = [1, -1, 1]\n"
                             "ground = \"on\"\n[[triangle]]\na = [0, 0, 0]\n"
                             "b = [30000, 30000, 0]\nc = [30000, -30000, 30000]\n";
    EXPECT_EQ(read(ground_lamp + skew, "form=blob").error,
              "a.toml: a blob on the ground reaches out of the world, -32766 .. 32766; scale the "
              "scene");
    EXPECT_EQ(read(ground_lamp + skew, "form=ground").error, "");
}

// Its own view of the light is not drawn: nothing is warned of its window, depths or bias.
TEST(GroundScene, ThereAreNoWarningsOfALightsView) {
    const std::string narrow = "[light]\nazimuth = -60\nelevation = 40\nextent = 0.1\nnear = 0.5\n"
                               "far = 0.6\n";
    const std::string text = narrow + ground_ball + plane_text("ground = \"on\"\n");
    EXPECT_TRUE(read(text).scene.warnings.empty());
    EXPECT_FALSE(read(text, "form=post_process").scene.warnings.empty());
}

}  // namespace
}  // namespace umbra78::tools
