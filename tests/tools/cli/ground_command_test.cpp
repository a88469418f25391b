// form = ground at the program's mouth: what render, plan and cycles say of it, beside the form
// with a depth map.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/truth/patch_truth.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

json report_of(const Ran& ran) {
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return parse_json(ran.out);
}

TEST_F(Program, RenderOnAGroundIsRightThereAndNowhereElse) {
    // The scene's ring is made of free patches, whose truth is Embree's.
    if (!traces_patches()) GTEST_SKIP() << "built without Embree (libembree-dev)";
    const json flat =
        report_of(run("render " + scenes + "ground.toml --set form=ground --out a.png --json"));
    const json map = report_of(run("render " + scenes + "ground.toml --out b.png --json"));
    const auto rate = [](const json& report, const char* of, const char* key) {
        return report.at(of).at(key).get<double>();
    };
    EXPECT_LT(rate(flat, "error_on_ground", "false_shadow"), 0.001);
    EXPECT_LT(rate(flat, "error_on_ground", "false_light"), 0.001);
    EXPECT_GT(rate(flat, "error", "false_light"), 0.1) << "no object is shadowed";
    EXPECT_LT(rate(map, "error", "false_light"), 0.05);
    for (const char* plane : {"observer_z", "intensity", "direct"})
        EXPECT_EQ(flat["hashes"][plane], map["hashes"][plane]) << plane;
    EXPECT_FALSE(flat["hashes"].contains("light_z"));
    EXPECT_FALSE(flat.contains("bias"));
    EXPECT_EQ(map["frame_bytes"].get<int>() - flat["frame_bytes"].get<int>(), 2 * 512 * 512);
    EXPECT_FALSE(flat["machine"].contains("transformation"));
    EXPECT_GT(flat["machine"]["masks"]["store"], 0);
}

TEST_F(Program, PlanOfAGround) {
    const json report = report_of(run("plan " + scenes + "ground.toml --set form=ground --json"));
    std::uint64_t saved = 0, cycles = 0;
    for (const json& row : report["omissions"]) {
        saved += row["saved_cycles"].get<std::uint64_t>();
        if (row["omission"] == "noise" || row["omission"] == "light_shading") {
            EXPECT_EQ(row["why"], "on a ground the shadow is drawn, and no pixel is tested");
            EXPECT_EQ(row["saved_cycles"], 0) << "it never was there";
        }
    }
    for (const json& stage : report["stages"]) cycles += stage["cycles"].get<std::uint64_t>();
    EXPECT_EQ(report["cycles_of_everything"], cycles + saved);
    EXPECT_EQ(report["stages"][2]["transform"], 0);
    EXPECT_GT(report["stages"][2]["operations"], 0);
    const Ran text = run("plan " + scenes + "ground.toml --set form=ground");
    EXPECT_NE(text.out.find("shadow, flat "), text.out.npos);
    EXPECT_EQ(text.out.find("light's view"), text.out.npos) << text.out;
}

TEST_F(Program, CyclesAndTraceOfAGround) {
    const Ran ran = run("cycles " + scenes + "ground.toml --set form=ground");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("shadow, flat "), ran.out.npos);
    EXPECT_EQ(ran.out.find("latency"), ran.out.npos);
    EXPECT_EQ(ran.out.find("see below"), ran.out.npos);
    const Ran trace = run("trace " + scenes + "ground.toml --set form=ground --pixel 80,80");
    EXPECT_EQ(trace.exit_code, 1);
    EXPECT_EQ(trace.err, "umbra78: a shadow on the ground is drawn, and no pixel is tested; give "
                         "--set form=post_process\n");
}

}  // namespace
}  // namespace umbra78::tools
