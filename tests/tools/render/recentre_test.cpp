// Recentring is exact: a scene that is moved by whole world words has the same frame, bit for bit.
#include "tests/tools/render/case_scenes.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

using test::DrawnCase;
using Texts = std::vector<std::string>;

const Texts small_scene{"xy_bits=7"};

// Two balls and a floor, `by` off in each direction; what is left out is fitted.
std::string moved(double by, const char* views) {
    return fmt::format("{}\n[[sphere]]\ncentre = [{:.16f}, {:.16f}, {:.16f}]\nradius = 0.5\n"
                       "[[sphere]]\ncentre = [{:.16f}, {:.16f}, {:.16f}]\nradius = 0.3\n"
                       "[[plane]]\norigin = [{:.16f}, {:.16f}, {:.16f}]\nu = [4, 0, 0]\n"
                       "v = [0, 0, -4]\n",
                       views, by, by + 0.75, by, by + 0.875, by + 0.3125, by + 0.25, by - 2, by,
                       by + 2);
}

constexpr const char* fitted =
    "[observer]\nazimuth = 15\nelevation = 30\n[light]\nazimuth = -100\nelevation = 20\n";

TEST(Recentre, AMovedSceneHasTheSameHashes) {
    const DrawnCase here(moved(0, fitted), small_scene);
    EXPECT_EQ(here.scene.origin, here.scene.observer.target.x == 0 ? here.scene.origin
                                                                   : raster::World{});
    for (const double by : {100.0, 30000.0, -12345.0, 1.0 / 65536, 77.0 + 3.0 / 65536}) {
        const DrawnCase there(moved(by, fitted), small_scene);
        EXPECT_EQ(there.hashes(), here.hashes()) << by;
        EXPECT_EQ(there.keys(), Texts{}) << by;
        const auto words = static_cast<std::int32_t>(by * 65536);
        EXPECT_EQ(there.scene.origin.x - here.scene.origin.x, words) << by;
    }
    const DrawnCase off(moved(100, fitted), {"xy_bits=7", "observer.recentre=off"});
    EXPECT_NE(off.hashes(), here.hashes());
}

TEST(Recentre, PlacesThatAreGivenMoveToo) {
    const auto lamp = [](double by) {
        return moved(by, fmt::format("[observer]\nprojection = \"perspective\"\nazimuth = 20\n"
                                     "elevation = 25\ndistance = 8\ntarget = [{0}, {0}.5, {0}]\n"
                                     "[light]\nkind = \"point\"\nposition = [{0}, {1}.5, {1}]\n"
                                     "target = [{0}, {0}, {0}]\n", by, by + 3).c_str());
    };
    const DrawnCase here(lamp(0), small_scene), there(lamp(20000), small_scene);
    EXPECT_EQ(there.hashes(), here.hashes());
    EXPECT_EQ(there.scene.light().target, here.scene.light().target);
    EXPECT_EQ(there.report->all.false_shadow, here.report->all.false_shadow);
}

// Words that would not fit stay where they are.
TEST(Recentre, IsWithoutEffectWhereWordsWouldNotFit) {
    const std::string far_target = "[observer]\ntarget = [20000, 0, 0]\nextent = 32000\n"
                                   "[light]\nazimuth = 0\n"
                                   "[[sphere]]\ncentre = [-20000, 0, 0]\nradius = 1\n";
    const LoadedScene scene = parse_scene(far_target, "a.toml", {});
    EXPECT_EQ(scene.origin, raster::World{});
    EXPECT_EQ(scene.observer.target.x, 20000 << 16);
    const LoadedScene near = parse_scene(far_target, "a.toml",
                                         std::vector<std::string>{"observer.target=[5000, 0, 0]"});
    EXPECT_EQ(near.origin, (raster::World{5000 << 16, 0, 0}));
    EXPECT_EQ(near.spheres.at(0).centre.x, -25000 << 16);
    EXPECT_EQ(near.observer.target, raster::World{});
}

}  // namespace
}  // namespace umbra78::tools
