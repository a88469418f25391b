// umbra78 plan: every omission has its reason, the savings add up, and errors are one line.
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/render/plan_text.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

const json& omission(const json& report, const std::string& key) {
    for (const json& row : report["omissions"])
        if (row["omission"] == key) return row;
    ADD_FAILURE() << "no omission " << key;
    return report;
}

TEST_F(Program, PlanSaysWhatIsLeftOutAndWhy) {
    const Ran ran =
        run("plan " + scenes + "figures.toml --set dither=none --set low_pass=0 --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const json report = parse_json(ran.out);
    ASSERT_EQ(report["omissions"].size(), shadow::omission_count);
    EXPECT_EQ(report["visible_pixels"], 106772);
    EXPECT_EQ(report["surfaces_outside_light"], 0);
    std::uint64_t saved = 0, cycles = 0;
    for (const json& row : report["omissions"])
        saved += row["saved_cycles"].get<std::uint64_t>();
    for (const json& stage : report["stages"]) cycles += stage["cycles"].get<std::uint64_t>();
    EXPECT_EQ(report["saved_cycles"], saved);
    EXPECT_EQ(report["cycles"], cycles);
    EXPECT_EQ(report["cycles_of_everything"], cycles + saved);
    EXPECT_TRUE(omission(report, "divide")["left_out"]);
    EXPECT_EQ(omission(report, "noise")["why"], "dither is none");
    EXPECT_EQ(omission(report, "noise")["saved_cycles"], 512 * 512);
    EXPECT_EQ(omission(report, "low_pass")["why"], "it is set to 0 passes");
    EXPECT_FALSE(omission(report, "dequantize")["left_out"]);
    EXPECT_EQ(omission(report, "background_pixels")["after_drawing"], true);
    EXPECT_GT(report["shadow_lines"], 100);
    EXPECT_LE(report["shadow_lines"], report["visible_lines"]);
    EXPECT_LT(report["visible_lines"], 512);
    EXPECT_EQ(omission(report, "empty_lines")["saved_cycles"],
              (512 - report["visible_lines"].get<int>()) * (512 - 1))
        << "the read, less a cycle for each line";
    EXPECT_GT(omission(report, "lit_lines")["saved_cycles"], 0);
    EXPECT_EQ(omission(report, "lit_lines")["after_drawing"], true);
    EXPECT_EQ(omission(report, "outside_surfaces")["left_out"], false);
    EXPECT_GT(omission(report, "light_shading")["saved_cycles"], 20'000'000)
        << "shading is most of a view";
    EXPECT_TRUE(files().empty()) << "a plan leaves no file";
}

TEST_F(Program, PlanPrintsATable) {
    const Ran ran = run("plan " + scenes + "lamp.toml --set xy_bits=6 --set density=0");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* line :
         {"64 x 64 pixels, ", "\ncycles of  ", "\nlight's view  ", "\nleft out  ", "\nneeded  ",
          "\nthe composite ", "  density is 0\n", "both views are in perspective: W varies",
          "unit cycles instead of "})
        EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out;
}

// A light at the observer's place draws nothing of its own, and half a scene is not sent.
TEST_F(Program, PlanOfALightThatSeesTheSame) {
    const json same =
        parse_json(run("plan " + scenes + "figures.toml --set light.azimuth=0 --json").out);
    EXPECT_EQ(omission(same, "light_drawing")["why"],
              "the light sees what the observer sees: its map is a copy");
    EXPECT_GT(omission(same, "light_drawing")["saved_cycles"], 10'000'000);
    EXPECT_EQ(same["stages"][0]["cycles"], 2 * 512 * 512);
    const json half = parse_json(
        run("plan " + scenes + "figures.toml --set observer.target=[1.5,0,0] --json").out);
    EXPECT_GT(half["surfaces_outside_observer"], 30);
    EXPECT_EQ(omission(half, "outside_surfaces")["left_out"], true);
    EXPECT_EQ(omission(half, "outside_surfaces")["after_drawing"], false);
    EXPECT_GT(omission(half, "outside_surfaces")["saved_cycles"],
              half["surfaces_outside_observer"].get<int>() * 100);
}

// A light that looks past the scene: no light map, no post-process, no filters.
TEST_F(Program, PlanOfALightThatMeetsNothing) {
    const json report = parse_json(
        run("plan " + scenes + "figures.toml --set light.target=[20,0,0] --json").out);
    EXPECT_EQ(report["surfaces_outside_light"], 128);
    for (const char* key : {"light_map", "post_process", "dequantize", "low_pass", "composite"})
        EXPECT_TRUE(omission(report, key)["left_out"]) << key;
    EXPECT_EQ(omission(report, "light_map")["why"], "every surface lies outside the light's view");
    ASSERT_EQ(report["warnings"].size(), 2u);
    EXPECT_EQ(report["warnings"][0]["key"], "light_window");
    EXPECT_EQ(report["warnings"][1]["key"], "bias");
}

TEST_F(Program, PlanFailsInOneLine) {
    for (const char* arguments : {"plan none.toml", "plan . --set bias=1"}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 1);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.err.find("umbra78: cannot read '"), 0u) << ran.err;
        EXPECT_EQ(ran.err.find('\n'), ran.err.size() - 1);
    }
    EXPECT_EQ(run("plan").err, "umbra78: scene is required; see umbra78 plan --help\n");
}

TEST(PlanText, EachHasItsOwn) {
    std::set<std::string_view> keys, names, reasons;
    for (std::size_t k = 0; k < shadow::omission_count; ++k) {
        keys.insert(key_of(static_cast<shadow::Omission>(k)));
        names.insert(name_of(static_cast<shadow::Omission>(k)));
    }
    const auto last = static_cast<int>(shadow::Reason::none);
    for (int k = 0; k <= last; ++k) reasons.insert(explain(static_cast<shadow::Reason>(k)));
    EXPECT_EQ(keys.size(), shadow::omission_count);
    EXPECT_EQ(names.size(), shadow::omission_count);
    EXPECT_EQ(reasons.size(), static_cast<std::size_t>(last) + 1);
    EXPECT_FALSE(keys.contains("") || names.contains("") || reasons.contains(""));
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1 000");
    EXPECT_EQ(grouped(12345678), "12 345 678");
}

// The second light shines on a sphere that is out of the picture.
TEST_F(Program, PlanLeavesOutALightThatNothingVisibleSees) {
    write("two.toml", R"([observer]
azimuth = 0
extent = 1
target = [0, 0, 0]
[[light]]
kind = "directional"
azimuth = -50
[[light]]
kind = "directional"
azimuth = 30
target = [30, 0, 0]
extent = 2
[[sphere]]
centre = [0, 0, 0]
radius = 0.6
[[sphere]]
centre = [30, 0, 0]
radius = 0.6
[settings]
xy_bits = 6
)");
    const Ran ran = run("plan two.toml --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json report = parse_json(ran.out);
    int left_out = 0;
    for (const json& row : report["omissions"]) {
        if (row["omission"] != "light_map" && row["omission"] != "post_process") continue;
        EXPECT_EQ(row.at("left_out"), row.at("lights") == json{"light2"}) << row;
        if (!row["left_out"]) continue;
        EXPECT_EQ(row["why"], "nothing visible lies in the light's volume");
        ++left_out;
    }
    EXPECT_EQ(left_out, 2);
}

}  // namespace
}  // namespace umbra78::tools
