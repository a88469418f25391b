// The program on scenes with several lights, with an area, and in colour.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

const std::string lights_small = " --set xy_bits=6 --set z_bits=13 ";

TEST_F(Program, RenderReportsEachLight) {
    const Ran ran = run("render " + scenes + "three_lights.toml" + lights_small +
                        "--json --out a.png");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    for (const char* buffer : {"light_z3", "mask2", "filtered3", "direct2_green", "picture_blue"})
        EXPECT_TRUE(report["hashes"].contains(buffer)) << buffer;
    const json& lights = report["lights"]["lights"];
    ASSERT_EQ(lights.size(), 3u);
    std::uint64_t cycles = 0;
    for (const json& light : lights) {
        EXPECT_EQ(light["depth_maps"], 1);
        EXPECT_NEAR(light["bias"]["texels"].get<double>(), 2, 1e-6);
        cycles += light["cycles"].get<std::uint64_t>();
    }
    EXPECT_GT(report["lights"]["frame_cycles"], cycles);  // and the observer's view
    const std::string png = content(folder / "a.png");
    ASSERT_GT(png.size(), 26u);
    EXPECT_EQ(png[25], 2);  // its colour type: red, green, blue
}

TEST_F(Program, RenderOfAnAreaHasItsMapsAndItsPenumbra) {
    const Ran ran = run("render " + scenes + "penumbra.toml" + lights_small +
                        "--set light.samples=3 --json --out a.png");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    EXPECT_TRUE(report["hashes"].contains("mask9"));
    EXPECT_TRUE(report["hashes"].contains("darkness"));
    EXPECT_EQ(report["lights"]["lights"][0]["depth_maps"], 9);
    EXPECT_EQ(content(folder / "a.png")[25], 0);  // gray
}

// The ramp's cost is a phase of its own, after the transformation.
TEST_F(Program, CyclesOfARampHaveItsPhase) {
    std::vector<std::string> names;
    std::uint64_t cycles = 0;
    const Ran ran = run("cycles " + figures_scene + lights_small + "--set light.ramp=4 --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    for (const json& phase : report["ledger"]["phases"]) {
        names.push_back(phase["phase"]);
        if (phase["phase"] == "darkness") cycles = phase["store"].get<std::uint64_t>();
    }
    EXPECT_EQ(names, (std::vector<std::string>{"light's view", "observer's view", "darkness",
                                               "dequantize", "low-pass", "composite"}));
    EXPECT_EQ(cycles, 64u * 64 * (2 * 4 + 5));
}

// Both of the paper's ways: one mask, and one pass against six.
TEST_F(Program, SectorsHaveSixMapsAndOneMask) {
    std::vector<json> reports;
    for (const std::string way : {"classified", "every"}) {
        const Ran ran = run("render " + scenes + "sectors.toml --set xy_bits=7 --set sector_test=" +
                            way + " --json --out " + way + ".png");
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ran.err, "");
        reports.push_back(parse_json(ran.out));
        const json& hashes = reports.back()["hashes"];
        EXPECT_TRUE(hashes.contains("light_z6"));
        EXPECT_TRUE(hashes.contains("mask"));
        EXPECT_FALSE(hashes.contains("mask2"));
        EXPECT_EQ(reports.back()["lights"]["lights"][0]["depth_maps"], 6);
    }
    EXPECT_EQ(reports[0]["hashes"], reports[1]["hashes"]);
    const auto transformation = [&](std::size_t k) {
        return reports[k]["lights"]["lights"][0]["transformation_cycles"].get<std::uint64_t>();
    };
    EXPECT_EQ(transformation(1), 6 * transformation(0));
    // Truth knows one lamp, and the machine finds its shadows.
    const json& error = reports[0]["error"];
    EXPECT_LT(error["false_shadow"].get<double>(), 0.03) << error.dump();
}

TEST_F(Program, PlanGivesTheReasonOfEachLight) {
    const Ran ran = run("plan " + scenes + "three_lights.toml" + lights_small +
                        "--set light2.target=[0,300,0] --set light2.extent=2 --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    std::vector<std::string> left_out, needed;
    std::uint64_t saved = 0;
    const json report = parse_json(ran.out);
    for (const json& row : report["omissions"]) {
        saved += row["saved_cycles"].get<std::uint64_t>();
        if (row["omission"] == "light_map")
            for (const json& light : row["lights"])
                (row["left_out"].get<bool>() ? left_out : needed).push_back(light);
    }
    EXPECT_EQ(left_out, std::vector<std::string>{"light2"});
    EXPECT_EQ(needed, (std::vector<std::string>{"light1", "light3"}));
    EXPECT_EQ(report["saved_cycles"], saved);
}

// What looks at one light, or at grey, says so in a line and leaves nothing.
TEST_F(Program, WhatTakesOneGreyLightRefusesOthers) {
    const auto refuses = [&](const std::string& command, const std::string& what) {
        const Ran ran = run(command);
        EXPECT_EQ(ran.exit_code, 1) << command;
        EXPECT_NE(ran.err.find(what), std::string::npos) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        EXPECT_TRUE(files().empty()) << command;
    };
    const std::string lights = scenes + "three_lights.toml", area = scenes + "penumbra.toml";
    refuses("trace " + lights + " --pixel 3,4", "looks at one light with one depth map");
    refuses("study error-time " + area + " --quick", "looks at one light with one depth map");
    refuses("trace " + scenes + "lamp.toml --set light.ramp=3 --pixel 3,4", "has a ramp");
    refuses("trace " + scenes + "sectors.toml --pixel 3,4",
            "looks at one light with one depth map");
    refuses("cycles " + area + " --all", "looks at one light with one depth map");
    refuses("animate " + lights + " --observer 0:10 --frames 2", "an animation is grey");
    refuses("pack " + scenes + "figures.toml --set light2.level=1 --out a.u78p",
            "there is no light2; the scene has 1 light");
}

}  // namespace
}  // namespace umbra78::tools
