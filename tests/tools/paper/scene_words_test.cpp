// shadow/frame/paper_scene_words.hpp equals what tools/scenes/figures.toml yields.
#include "tools/paper/scene_words.hpp"

#include "tests/support/error_of.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

using test::error_of;

const std::string root = UMBRA78_SOURCE_DIR "/";

LoadedScene figures_file() { return load_scene(root + "tools/scenes/figures.toml", {}); }

TEST(PaperSceneWords, AreThoseOfTheSceneFile) {
    std::ifstream file(root + "shadow/frame/paper_scene_words.hpp");
    const std::string committed{std::istreambuf_iterator<char>(file), {}};
    ASSERT_GT(committed.size(), 500u);
    EXPECT_EQ(paper_scene_words(figures_file()), committed)
        << "run: umbra78 figures --words >shadow/frame/paper_scene_words.hpp";
}

// Whatever the header has no word for is refused, and not left out in silence.
TEST(PaperSceneWords, HoldTheFiguresSceneAlone) {
    const auto refused = [](auto&& change) {
        LoadedScene scene = figures_file();
        change(scene);
        return error_of([&] { paper_scene_words(scene); });
    };
    EXPECT_EQ(refused([](LoadedScene&) {}), "no error");
    EXPECT_EQ(refused([](LoadedScene& s) { s.facets.resize(1); }),
              "the figures' words hold spheres alone");
    EXPECT_EQ(refused([](LoadedScene& s) { s.free_patches = 1; }),
              "the figures' words hold spheres alone");
    EXPECT_EQ(refused([](LoadedScene& s) { s.spheres[2].material = 1; }),
              "the figures' words hold one material");
    EXPECT_EQ(refused([](LoadedScene& s) { s.light().extent += 1; }),
              "the figures' words hold two views of one cube");
    EXPECT_EQ(refused([](LoadedScene& s) { s.light().axes = raster::axes_from_angles(1, 0); }),
              "the figures' words hold azimuths of whole degrees at elevation 0");
    EXPECT_NE(refused([](LoadedScene& s) { s.settings.machine.z_bits = 15; }), "no error");
}

}  // namespace
}  // namespace umbra78::tools
