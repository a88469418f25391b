// umbra78 bias as a user runs it: a map, a scene, and what it refuses.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using test::Program;
using test::Ran;

const std::string map_of = "bias --map 2048 --extent 20 --range 50 --filter pcf3 --slope 60";

TEST_F(Program, BiasPrintsTheSameAsTextAndAsJson) {
    const Ran text = run(map_of + " --azimuth 0"), json = run(map_of + " --azimuth 0 --json");
    ASSERT_EQ(text.exit_code, 0) << text.err;
    ASSERT_EQ(json.exit_code, 0) << json.err;
    const nlohmann::ordered_json parsed = parse_json(json.out);
    // The worked example's 33.25 steps and one for the rounding.
    for (const auto& row : parsed.at("units"))
        if (row.at("for") == "Direct3D" && row.at("kind") == "constant") {
            EXPECT_EQ(row.at("value"), 35);
        }
    EXPECT_NE(text.out.find("| Direct3D"), std::string::npos);
    EXPECT_NE(text.out.find("| 35 "), std::string::npos);
    EXPECT_NE(text.out.find("0.0126859"), std::string::npos);
}

TEST_F(Program, BiasOfASceneIsSearchedByTheMachine) {
    write("a.toml", "[light]\nazimuth = -100\nextent = 2\n[observer]\nextent = 2\n"
                    "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1.5\n[settings]\nxy_bits = 7\n");
    const Ran ran = run("bias a.toml --set lookup=nearest --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const nlohmann::ordered_json constant = parse_json(ran.out).at("least").at("constant");
    EXPECT_GT(constant.at("experiment").at("texels"), 0.5);
    EXPECT_LT(constant.at("experiment").at("texels"), constant.at("bound").at("texels"));
}

TEST_F(Program, BiasRefusesInOneLine) {
    const struct {
        std::string arguments;
        const char* message;
        int exit_code;
    } cases[] = {
        {"bias", "a depth map is given by --map, --extent, --range and --slope; give all four, or "
                 "a scene", 1},
        {"bias --map 2048 --extent 20", "a depth map is given by --map, --extent, --range and "
                                        "--slope; give all four, or a scene", 1},
        {"bias a.toml --map 64", "a scene has its own map; give a scene and --set, or the map's "
                                 "options", 1},
        {"bias a.toml --depth d24", "a scene has its own map; give a scene and --set, or the "
                                    "map's options", 1},
        {map_of + " --set bias=3", "--set changes a scene's settings; give a scene", 1},
        {"bias --map 2048 --extent 20 --range 50 --slope 90", "--slope 90: its range is 0 .. 89",
         1},
        {"bias --map 64 --extent 20 --range 5 --slope 89",
         "such a slope leaves the depth range within 16 texels of --z 0.75; give more --map, more "
         "--range or less --extent", 1},
        {map_of + " --depth d15", "--depth: 'd15' is no depth format; give d16, d24 or d32f; see "
                                  "umbra78 bias --help", 2},
        {map_of + " --filter soft", "--filter: 'soft' is no filter; give nearest, bilinear, pcf3 "
                                    "or pcf5; see umbra78 bias --help", 2},
        {map_of + " --pixel inf", "--pixel: 'inf' is not a number; write it as in 0.5; see umbra78 "
                                  "bias --help", 2},
        {"bias none.toml", "cannot read 'none.toml': No such file or directory; give the path of "
                           "a scene file", 1},
    };
    for (const auto& [arguments, message, exit_code] : cases) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, exit_code) << arguments;
        EXPECT_EQ(ran.err, std::string("umbra78: ") + message + "\n");
        EXPECT_EQ(ran.out, "");
    }
}

}  // namespace
}  // namespace umbra78::tools
