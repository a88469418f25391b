// A profile on the command line: the machine is the profile's, whatever profile the file gives.
#include "shadow/frame/profiles.hpp"
#include "tests/support/program.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

using json = nlohmann::ordered_json;
using test::Ran;

constexpr const char* plain = "[light]\nazimuth = -100\n[[sphere]]\ncentre = [0, 0, 0]\n"
                              "radius = 1\n[settings]\nxy_bits = 5\nlookup = \"bilinear\"\n"
                              "dither = \"normal\"\n";

struct Profiles : test::Program {
    void SetUp() override {
        Program::SetUp();
        write("plain.toml", plain);
        for (const shadow::Profile& p : shadow::profiles())
            write((std::string(p.name) + ".toml").c_str(),
                  plain + ("profile = \"" + std::string(p.name) + "\"\n"));
    }
    // What is printed of a scene, without the scene's name.
    json printed(const std::string& arguments) const {
        const Ran ran = run(arguments + " --json");
        EXPECT_EQ(ran.exit_code, 0) << arguments << ": " << ran.err;
        json report = parse_json(ran.out);
        report.erase("scene");
        return report;
    }
    json settings(const std::string& arguments) const {
        return printed("render --no-truth --out a.png " + arguments)["settings"];
    }
};

// What the clocked machine has no stage for has cycles all the same, and no waterfall.
TEST_F(Profiles, CyclesOfAReceiversPlaneAndNormal) {
    for (const std::string receiver :
         {"point", "plane", "normal", "plane --set slope_source=normals"}) {
        const bool replayed = receiver == "point" || receiver == "plane";
        const Ran ran = run("cycles plain.toml --set receiver=" + receiver);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        const auto says = [&](const char* what) { return ran.out.find(what) != ran.out.npos; };
        EXPECT_EQ(says("the paper's"), true) << receiver;
        EXPECT_EQ(says("no pixel is timed"), receiver != "point");
        EXPECT_EQ(says("and no memory replayed"), !replayed);
        const json cycles = printed("cycles plain.toml --set receiver=" + receiver);
        EXPECT_EQ(cycles.contains("memory"), replayed);
    }
}

TEST_F(Profiles, CyclesAreTheProfilesWhateverTheFileSays) {
    const json all = printed("cycles plain.toml --all");
    ASSERT_EQ(all["profiles"].size(), shadow::profiles_of_1978().size());
    for (const json& row : all["profiles"]) EXPECT_FALSE(row.contains("refused")) << row;
    for (const char* file : {"ap120b", "affine16x16"}) {
        const std::string scene = std::string("cycles ") + file + ".toml ";
        EXPECT_EQ(printed(scene + "--all"), all) << file;
        for (const char* profile : {"affine16", "affine16x16", "perspective24", "ap120b_fast"})
            EXPECT_EQ(printed(scene + "--profile " + profile),
                      printed(std::string("cycles plain.toml --profile ") + profile))
                << profile << " after " << file;
    }
}

TEST_F(Profiles, TheLastOfSeveralCountsAndLeavesNothingOfTheOthers) {
    const json alone = settings("plain.toml --set profile=affine16");
    EXPECT_EQ(alone["arithmetic"], "fixed");
    EXPECT_EQ(settings("plain.toml --set profile=ap120b --set profile=affine16"), alone);
    EXPECT_EQ(settings("plain.toml --set profile=affine16x16 --set profile=affine16"), alone);
    EXPECT_EQ(settings("ap120b.toml --set profile=affine16"), alone);
}

// The file's profile, the file's keys, the profile of --set, the keys of --set.
TEST_F(Profiles, ComeBeforeTheKeysBesideThemAndReplaceThoseBefore) {
    write("keys.toml", plain + std::string("light_banks = 4\nclock_ns = 400\nprofile = \"ap120b\"\n"
                                           "bias = 7\n"));
    const json file = settings("keys.toml");
    EXPECT_EQ(file["light_banks"], 4);
    EXPECT_EQ(file["clock_ns"], 400);
    EXPECT_EQ(file["arithmetic"], "ap120b");
    const json both = settings("keys.toml --set multipliers=16 --set profile=affine16x1");
    EXPECT_EQ(both["light_banks"], 1);  // of the profile, which replaces the file's machine
    EXPECT_EQ(both["clock_ns"], 200);
    EXPECT_EQ(both["arithmetic"], "fixed");
    EXPECT_EQ(both["multipliers"], 16);
    EXPECT_EQ(both["bias"], 7);  // of no profile
}

TEST_F(Profiles, AllAndOneAgreeOnWhatSetSays) {
    const std::string set = " --set light_banks=4 --set clock_ns=300";
    const json all = printed("cycles ap120b.toml --all" + set)["profiles"];
    const json one = printed("cycles ap120b.toml --profile affine16" + set);
    EXPECT_EQ(one["settings"]["light_banks"], 4);
    const double ms =
        one["ledger"]["transformation"]["cycles"].get<double>() * 300e-6;
    EXPECT_EQ(all[0]["profile"], "affine16");
    EXPECT_NEAR(all[0]["transformation_ms"].get<double>(), ms, 1e-9);
    EXPECT_EQ(run("cycles plain.toml --profile afine16").err,
              "umbra78: --profile afine16: there is no such profile; did you mean 'affine16'?\n");
    for (const char* how : {"--all", "--profile affine16"}) {
        const Ran twice = run(std::string("cycles plain.toml --set profile=ap120b ") + how);
        EXPECT_EQ(twice.exit_code, 1);
        EXPECT_EQ(twice.err, "umbra78: --set profile=ap120b: " +
                                 std::string(how).substr(0, std::string(how).find(' ')) +
                                 " gives the machine, too; leave one out\n");
    }
}

TEST_F(Profiles, AStudyOfProfilesHasTheirRows) {
    const auto rows = [&](const std::string& scene) {
        const std::string out = scene.substr(0, scene.find('.'));
        const Ran ran = run("study error-time " + scene + " --quick --no-host-times --vary "
                            "profile=affine16,ap120b --vary lookup=nearest --vary dither=none "
                            "--vary bias=64 --out " + out);
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return content(folder / out / "error-time.csv");
    };
    const std::string expected = rows("plain.toml");
    EXPECT_NE(expected.find("affine16"), std::string::npos);
    EXPECT_EQ(rows("ap120b.toml"), expected);
}

}  // namespace
}  // namespace umbra78::tools
