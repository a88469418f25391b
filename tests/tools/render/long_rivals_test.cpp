// Rivals on scenes of the project's own: all exact ones have brute force's mask, on the teapot at
// full size and on the robot, diced half as finely to 27 968 facets.
#include "shadow/frame/rivals.hpp"
#include "tests/support/paths.hpp"
#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

std::vector<std::uint8_t> mask_of(const LoadedScene& scene, shadow::Form form) {
    shadow::Settings settings = scene.settings;
    settings.form = form;
    RenderJob job(scene.view(), settings);
    job.draw_light();
    job.draw_observer();
    job.cast_shadows();
    const auto mask = job.bytes(Plane::mask);
    return {mask.begin(), mask.end()};
}

class LongRivals : public ::testing::TestWithParam<const char*> {};

TEST_P(LongRivals, HaveOneMask) {
    const std::string name = GetParam();
    LoadedScene scene = load_scene(UMBRA78_SOURCE_DIR "/tools/scenes/" + name, {});
    if (name == "robot.toml") --scene.settings.dice_levels;
    const std::vector<std::uint8_t> right = mask_of(scene, shadow::Form::brute);
    EXPECT_GT(std::ranges::count(right, 255), 10'000);
    for (const shadow::RivalRow& row : shadow::rival_rows) {
        const std::vector<std::uint8_t> mask = mask_of(scene, row.form);
        std::size_t differ = 0;
        for (std::size_t at = 0; at < mask.size(); ++at) differ += mask[at] != right[at] ? 1 : 0;
        if (row.is_exact) {
            EXPECT_EQ(differ, 0u) << row.name;
        } else {
            EXPECT_LT(differ, 100u) << row.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, LongRivals, ::testing::Values("teapot.toml", "robot.toml"),
                         [](const auto& scene) {
                             const std::string name = scene.param;
                             return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace umbra78::tools
