// The rivals at the program's mouth: what render, plan, cycles and trace say of them.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

const std::string rivals_small = " --set xy_bits=6 ";

TEST_F(Program, RendersOfRivalsHaveOneMask) {
    std::string mask;
    for (const char* form :
         {"brute", "volumes", "ordered_volumes", "stencil_pass", "stencil_fail",
          "bouknight_kelley", "appel", "splitting", "perimeters", "atherton",
          "irregular"}) {
        const Ran ran = run("render " + scenes + "figures.toml" + rivals_small +
                            "--set form=" + form + " --out a.png --json");
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        const json report = parse_json(ran.out);
        const auto its = report.at("hashes").at("mask").get<std::string>();
        if (mask.empty()) mask = its;
        EXPECT_EQ(its, mask) << form;
        EXPECT_FALSE(report.at("hashes").contains("light_z")) << form;
        EXPECT_FALSE(report.contains("bias")) << form;
        EXPECT_GT(report.at("machine").at("transformation").at("cycles"), 0) << form;
        EXPECT_GT(report.at("machine").at("transformation").at("cycles_once"), 0) << form;
    }
}

TEST_F(Program, PlanAndCyclesOfARival) {
    const std::string scene =
        scenes + "figures.toml" + rivals_small + "--set form=volumes";
    const Ran plan = run("plan " + scene);
    EXPECT_EQ(plan.exit_code, 0) << plan.err;
    EXPECT_NE(plan.out.find("the method keeps no depth map"), plan.out.npos);
    const json report = parse_json(run("plan " + scene + " --json").out);
    std::uint64_t saved = 0, cycles = 0;
    for (const json& row : report.at("omissions"))
        saved += row.at("saved_cycles").get<std::uint64_t>();
    for (const json& stage : report.at("stages"))
        cycles += stage.at("cycles").get<std::uint64_t>();
    EXPECT_EQ(report.at("cycles_of_everything"), cycles + saved);
    const Ran ran = run("cycles " + scene);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("Once for the scene and the light"), ran.out.npos) << ran.out;
    const Ran trace = run("trace " + scene + " --pixel 20,20 --waterfall");
    EXPECT_EQ(trace.exit_code, 1);
    EXPECT_EQ(trace.err, "umbra78: a rival of the depth map looks nothing up; give --set "
                         "form=post_process\n");
}

// What is told of a pixel is what its mask says, and the sides add up to the facets.
TEST_F(Program, TraceOfARivalSaysWhatDecided) {
    const std::string scene = scenes + "figures.toml" + rivals_small + "--set form=volumes";
    std::set<std::string> states;
    for (const char* pixel : {"0,0", "7,22", "50,40", "39,13", "38,16", "44,13", "40,40"}) {
        const Ran ran = run("trace " + scene + " --pixel " + pixel + " --json");
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        const json trace = parse_json(ran.out);
        states.insert(trace.at("state").get<std::string>());
        if (!trace.contains("casters")) continue;
        std::int64_t sum = trace.at("volumes_at_eye").get<std::int64_t>();
        EXPECT_EQ(sum, 0) << "an eye at infinity is in no volume";
        for (const json& side : trace.at("sides_crossed"))
            sum += side.at("change").get<std::int64_t>();
        EXPECT_EQ(sum, static_cast<std::int64_t>(trace.at("casters").size())) << pixel;
    }
    EXPECT_EQ(states, (std::set<std::string>{"nothing seen", "lit", "attached shadow",
                                             "cast shadow"}));
    const Ran outside = run("trace " + scene + " --pixel 64,0");
    EXPECT_EQ(outside.exit_code, 1);
    EXPECT_EQ(outside.err, "umbra78: pixel 64,0 lies outside the picture, 0..63\n");
}

TEST_F(Program, ARivalRefusesInALine) {
    const Ran sectors = run("render " + scenes + "sectors.toml --set form=volumes");
    EXPECT_EQ(sectors.exit_code, 1);
    EXPECT_NE(sectors.err.find("kind = \"point\""), sectors.err.npos) << sectors.err;
    write("wide.toml", "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                       "[[sphere]]\ncentre = [30000, 0, 0]\nradius = 1\n"
                       "[observer]\nextent = 0.001\n[light]\nazimuth = 40\n");
    const Ran wide = run("render wide.toml --set form=volumes");
    EXPECT_EQ(wide.exit_code, 1);
    EXPECT_NE(wide.err.find("raise observer.extent"), wide.err.npos) << wide.err;
    EXPECT_EQ(files(), (std::vector<std::string>{"wide.toml"}));
}

}  // namespace
}  // namespace umbra78::tools
