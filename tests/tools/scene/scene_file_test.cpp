// Scene files: their words, what is fitted where nothing is given, and what is warned of.
#include "tools/scene/checks.hpp"
#include "tools/scene/scene_file.hpp"

#include "shadow/frame/paper_figures.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace umbra78::tools {
namespace {

using Texts = std::vector<std::string>;

LoadedScene parsed(std::string_view text, const Texts& set = {}) {
    return parse_scene(text, "a.toml", set);
}

const std::string figures_path = UMBRA78_SOURCE_DIR "/tools/scenes/figures.toml";

constexpr const char* unit_ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
const Texts as_written{"observer.recentre=off"};  // places stay where they are
constexpr const char* left_light = "[light]\nazimuth = -100\n";

bool same(const raster::View& a, const raster::View& b) {
    return a.projection == b.projection && a.axes.right == b.axes.right &&
           a.axes.up == b.axes.up && a.axes.back == b.axes.back && a.target == b.target &&
           a.extent == b.extent && a.distance == b.distance && a.near_depth == b.near_depth &&
           a.far_depth == b.far_depth;
}

TEST(SceneFile, TheFiguresFileSaysWhatThePaperFiguresSay) {
    const LoadedScene scene = load_scene(figures_path, {});
    ASSERT_EQ(scene.spheres.size(), shadow::figure_spheres.size());
    for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
        EXPECT_EQ(scene.spheres[k].centre, shadow::figure_spheres[k].centre) << k;
        EXPECT_EQ(scene.spheres[k].radius, shadow::figure_spheres[k].radius) << k;
        EXPECT_EQ(scene.spheres[k].material, 0) << k;
    }
    const shadow::FigurePatches patches = shadow::figure_patches();
    ASSERT_EQ(scene.patches.size(), patches.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
        EXPECT_EQ(scene.patches[k].control, patches[k].control) << k;
    EXPECT_EQ(scene.materials[0].diffuse, shadow::figure_material.diffuse);
    EXPECT_EQ(scene.materials[0].specular, shadow::figure_material.specular);
    EXPECT_EQ(scene.materials[0].shininess, shadow::figure_material.shininess);
    EXPECT_TRUE(same(scene.observer, shadow::figure_view(0)));
    EXPECT_TRUE(same(scene.light(), shadow::figure_view(shadow::figure_azimuth_q16)));
    for (const shadow::Setting& s : shadow::settings_table())
        EXPECT_EQ(s.get(scene.settings), s.get(shadow::figure_settings(6))) << s.key;
    EXPECT_EQ(scene.free_patches, 0u);
    EXPECT_EQ(lines_of(scene.warnings), Texts{});
}

// Half to even in the last place of 2^-16, at any length, in every notation TOML has for a
// decimal; the letters before it on its line are of two and more bytes.
TEST(SceneFile, DecimalsAreExact) {
    const struct {
        const char* text;
        std::int32_t word;
    } cases[] = {
        {"1.05", 68813},  // 68812.8
        {"-0.00000762939453125", 0},  // -1/2: to even
        {"0.00002288818359375", 2},   // 3/2: to even
        {"0.00002288818359374999999999999999999999999999999999999999999999999999", 1},
        {"0.00000762939453125000000000000000000000000000000000000000000000000001", 1},
        {"3_2.5e-1", 212992},
        {"+1E+2", 6553600},
        {"7", 458752},
        {"-32766", -2147352576},
        {"1234.5678901234567890123456789", 80908641},  // 80908641.246...
    };
    constexpr const char* two_and_three_bytes = "\xC3\xA9\xE2\x82\xAC";
    for (const auto& [text, word] : cases) {
        const std::string ball = std::string("sphere = [{ material = \"") + two_and_three_bytes +
                                 "\", radius = 0.5, centre = [" + text + ", 0, 0] }]\n";
        const std::string material =
            std::string("material = [{name = \"") + two_and_three_bytes + "\"}]\n";
        EXPECT_EQ(parsed(ball + material + left_light, as_written).spheres.at(0).centre.x, word)
            << text;
    }
}

TEST(SceneFile, AByteOrderMarkAndCarriageReturnsMoveNothing) {
    const LoadedScene scene = parsed("\xEF\xBB\xBF[light]\r\nazimuth = -12.5\r\n"
                                     "[[sphere]]\r\ncentre=[1.5, 0, 0]\r\nradius=0.25\r\n",
                                     as_written);
    EXPECT_EQ(scene.spheres.at(0).radius, 1 << 14);
    EXPECT_EQ(scene.spheres.at(0).centre.x, 3 << 15);
}

TEST(SceneFile, ViewsAreFittedToTheScene) {
    const std::string text = "[[sphere]]\ncentre = [3, 0, 0]\nradius = 1\n";
    const LoadedScene scene = parsed(text + left_light);
    EXPECT_EQ(scene.origin, (raster::World{3 << 16, 0, 0}));  // recentred
    EXPECT_EQ(scene.observer.target, raster::World{});
    EXPECT_EQ(scene.light().target, scene.observer.target);
    EXPECT_EQ(scene.observer.extent, 1 << 16);  // from the front a ball's control box is the ball
    EXPECT_GT(scene.light().extent, 1 << 16);
    EXPECT_LT(scene.light().extent, (1 << 16) * 107 / 100);  // control points stand 6.8 % off
    EXPECT_EQ(scene.observer.near_depth, -scene.observer.far_depth);
    EXPECT_EQ(lines_of(scene.warnings), Texts{});

    const LoadedScene given = parsed(text + left_light + "extent = 5\nfar = 7.5\n");
    EXPECT_EQ(given.light().extent, 5 << 16);
    EXPECT_EQ(given.light().far_depth, 15 << 15);
    EXPECT_EQ(given.light().near_depth, -5 << 16);  // fitted: the cube
}

TEST(SceneFile, APointLightLooksAtTheSceneFromItsPlace) {
    const LoadedScene scene =
        parsed(std::string(unit_ball) + "[light]\nkind = \"point\"\nposition = [0, 3, 4]\n");
    EXPECT_EQ(scene.light().projection, raster::Projection::perspective);
    EXPECT_EQ(scene.light().distance, 5 << 16);
    EXPECT_EQ(scene.light().axes.back, (raster::Axis{0, 644245094, 858993459}));
    EXPECT_GE(scene.light().extent, 66892);  // sin a = 1/5: the tangent cone is 1.0206 wide
    EXPECT_LT(scene.light().extent, (1 << 16) * 112 / 100);
    EXPECT_GT(scene.light().near_depth, 3 << 16);
    EXPECT_LT(scene.light().far_depth, 7 << 16);
    EXPECT_EQ(scene.settings.machine.coefficient_bits, 24);  // profile perspective24
    EXPECT_EQ(lines_of(scene.warnings), Texts{});
}

TEST(SceneFile, PerspectiveTakesItsProfileUnlessOneIsGiven) {
    const std::string text = std::string(unit_ball) + left_light +
                             "[observer]\nprojection = \"perspective\"\ndistance = 5\n";
    const auto bits = [&](const Texts& set) {
        return parsed(text, set).settings.machine.coefficient_bits;
    };
    EXPECT_EQ(bits({}), 24);
    EXPECT_EQ(bits({"coefficient_bits=16"}), 16);
    EXPECT_EQ(bits({"profile=affine16x1"}), 16);
    EXPECT_EQ(parsed(text, Texts{"multipliers=16"}).settings.machine.multipliers, 16);
    EXPECT_EQ(parsed(text, Texts{"coefficient_bits=20", "profile=affine16"})
                  .settings.machine.coefficient_bits, 20);  // a profile comes first
}

TEST(SceneFile, PlanesAndPatchesAreRead) {
    std::string rows, flat;
    for (int j = 0; j < 4; ++j) {
        rows += "[";
        for (int i = 0; i < 4; ++i) {
            const std::string point = "[" + std::to_string(i) + ", " + std::to_string(j) + ", 0],";
            rows += point;
            flat += point;
        }
        rows += "],\n";
    }
    const std::string plane = "[[plane]]\norigin=[0,-1,0]\nu=[3,0,0]\nv=[0,0,-3]\n";
    const LoadedScene by_rows =
        parsed(plane + "[[patch]]\ncontrol=[" + rows + "]\n" + left_light, as_written);
    const LoadedScene by_points =
        parsed(plane + "[[patch]]\ncontrol=[" + flat + "]\n" + left_light, as_written);
    ASSERT_EQ(by_rows.patches.size(), 2u);
    EXPECT_EQ(by_rows.free_patches, 1u);
    EXPECT_EQ(by_rows.planes.at(0).u, (raster::World{3 << 16, 0, 0}));
    EXPECT_EQ(by_rows.patches[1].control[4 * 2 + 3], (raster::World{3 << 16, 2 << 16, 0}));
    EXPECT_EQ(by_rows.patches[1].control, by_points.patches[1].control);
    EXPECT_EQ(by_rows.materials.size(), 1u);  // the default one
}

TEST(SceneFile, SetReachesEverySettingOfTheTable) {
    for (const shadow::Setting& s : shadow::settings_table()) {
        const std::int64_t before = s.get(shadow::figure_settings(6));
        const std::int64_t word = before != s.min ? s.min : s.max;
        std::string value = std::to_string(word >> s.fraction);
        if (s.kind == shadow::SettingKind::choice)
            value = std::string(s.names[static_cast<std::size_t>(word)]);
        const Texts set{std::string(s.key) + "=" + value};
        // A bias of 2^24 world units is refused later on, by the matrices; and a form on a ground,
        // for this scene has none.
        if (s.key == "bias_unit" || s.key == "bias" || s.key == "form") continue;
        EXPECT_EQ(s.get(load_scene(figures_path, set).settings), word) << set[0];
    }
    const Texts bias{"bias_unit=texels", "bias= 2.5 "};
    const LoadedScene scene = load_scene(figures_path, bias);
    EXPECT_EQ(scene.settings.bias_q16, 5 << 15);
    EXPECT_EQ(scene.settings.bias_unit, shadow::BiasUnit::texels);
    EXPECT_EQ(load_scene(figures_path, Texts{"form=correct"}).settings.form,
              shadow::Form::correct);
}

TEST(SceneFile, SetReachesTheViews) {
    const LoadedScene scene = load_scene(
        figures_path, Texts{"light.azimuth=-80", "light.extent=3", "observer.target=[0, 1, 0]",
                            "observer.projection=perspective", "observer.distance=8.5",
                            "light.azimuth=-79.5"});  // the later wins
    EXPECT_EQ(scene.light().axes.back,
              raster::axes_from_angles(-79 * 65536 - 32768, 0).back);
    EXPECT_EQ(scene.light().extent, 3 << 16);
    EXPECT_EQ(scene.observer.target, (raster::World{0, 1 << 16, 0}));  // the file is not recentred
    EXPECT_EQ(scene.observer.distance, 17 << 15);
    // Of a light that becomes a point the file's angles are left aside.
    EXPECT_EQ(load_scene(figures_path, Texts{"light.kind=point", "light.position=[0,0,9]"})
                  .light().distance, 9 << 16);
    // A table that the file does not have is made.
    EXPECT_EQ(parsed(unit_ball, Texts{"light.azimuth=1"}).light().axes.back,
              raster::axes_from_angles(1 << 16, 0).back);
}

TEST(SceneFile, WarnsOfWhatTheViewsDoNotHold) {
    const std::string text = std::string(unit_ball) + left_light;
    const auto warning = [&](const Texts& set) {
        const Texts all = lines_of(parsed(text, set).warnings);
        return all.empty() ? "" : all.front() + (all.size() > 1 ? " and more" : "");
    };
    EXPECT_EQ(warning({"light.extent=0.5"}),
              "a.toml: 32 of 32 patches reach out of the light's picture and may cast no shadow; "
              "light.extent = 1.03087 holds them, or leave it out");
    EXPECT_EQ(warning({"light.near=0"}),
              "a.toml: 20 of 32 patches are in the light's window from depth -0.9997 on, nearer "
              "than near = 0, and may cast no shadow; set light.near = -1.01, or leave near and "
              "far out");
    EXPECT_EQ(warning({"observer.far=0.5"}),
              "a.toml: 12 of 32 patches are in the observer's window to depth 1, farther than far "
              "= 0.5, and are cut off; set observer.far = 1.02, or leave near and far out");
    EXPECT_EQ(warning({"observer.target=[9, 0, 0]"}), "");  // fitted to hold it
    EXPECT_EQ(warning({"observer.extent=0.01"}),
              "a.toml: every surface reaches out of the picture; observer.extent = 1 shows the "
              "whole scene, or leave it out and more");  // object words are coarser than pixels
    EXPECT_EQ(warning({"light.kind=point", "light.position=[0.5, 0, 0]"}),
              "a.toml: 16 of 32 patches lie beside or behind the light and cast no shadow; move "
              "light.position out of the scene");
    EXPECT_EQ(lines_of(parsed(left_light).warnings),
              Texts{"a.toml: nothing is drawn: the scene has no [[sphere]] or other surface"});
}

}  // namespace
}  // namespace umbra78::tools
