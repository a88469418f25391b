// The program as a user runs it: its output, messages and exit codes, and the files it writes.
#include "shadow/frame/profiles.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/io/buffer_files.hpp"
#include "tools/paper/figure_set.hpp"
#include "tools/truth/patch_truth.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;
using test::Program;
using test::Ran;

TEST_F(Program, WrongUsageIsOneLineAndExitCode2) {
    const struct {
        const char *arguments, *message;
    } cases[] = {
        {"", "A subcommand is required; see umbra78 --help"},
        {"frobnicate", "unknown argument 'frobnicate'; known here: figures, render, plan, "
                       "animate, cycles, trace, bands, bias, shadow, study, model, pack, settings, "
                       "--help, --version, --manual, --completion; see umbra78 --help"},
        {"figurs", "unknown argument 'figurs'; did you mean 'figures'?; see umbra78 --help"},
        {"--verbose", "unknown argument '--verbose'; known here: figures, render, plan, "
                      "animate, cycles, trace, bands, bias, shadow, study, model, pack, settings, "
                      "--help, --version, --manual, --completion; see umbra78 --help"},
        {"figures --chek", "unknown argument '--chek'; did you mean '--check'?; see umbra78 "
                           "figures --help"},
        {"figures --check --bless", "--check excludes --bless; see umbra78 figures --help"},
        {"figures --out", "--out: 1 required DIR missing; see umbra78 figures --help"},
        {"figures here", "unknown argument 'here'; known here: --help, --out, --goldens, "
                         "--check, --bless, --no-scenes, --json, --words; see umbra78 figures "
                          "--help"},
        {"render", "scene is required; see umbra78 render --help"},
        {"render a.toml b.toml",
         "unknown argument 'b.toml'; known here: --help, scene, --out, --buffers, --error, --set, "
         "--no-truth, --spool, --threads, --json; see umbra78 render --help"},
        {"render a.toml --set", "--set: 1 required KEY=VALUE missing; see umbra78 render --help"},
        {"render a.toml --jsn", "unknown argument '--jsn'; did you mean '--json'?; see umbra78 "
                                "render --help"},
        {"bands --bias many",
         "--bias: 'many' is not a whole number, written in decimal digits without leading zeros; "
         "see umbra78 bands --help"},
        {"bands --bias 65537",
         "--bias: Value 65537 not in range 0 to 65536; see umbra78 bands --help"},
        // Not eight, not 16, not 2^32 + 1 in 32 bits.
        {"bands --bias 010", "--bias: '010' is not a whole number, written in decimal digits "
                             "without leading zeros; see umbra78 bands --help"},
        {"bands --bias 0x10", "--bias: '0x10' is not a whole number, written in decimal digits "
                              "without leading zeros; see umbra78 bands --help"},
        {"animate a.toml --frames 4294967297",
         "--frames: '4294967297' is not a whole number up to 2147483647; see umbra78 animate "
         "--help"},
        {"trace a.toml --pixel 1,2 --cycles 18446744073709551617",
         "--cycles: '18446744073709551617' is not a whole number up to 18446744073709551615; see "
         "umbra78 trace --help"},
        {"study verify a.csv --sample -1",
         "--sample: '-1' is not a whole number, written in decimal digits without leading zeros; "
         "see umbra78 study verify --help"},
        {"study error-time --jobs 1e3", "--jobs: '1e3' is not a whole number, written in decimal "
                                        "digits without leading zeros; see umbra78 study "
                                        "error-time --help"},
        {"trace a.toml --pixel 4294967297,0",
         "--pixel: '4294967297,0' is not a pixel; write x,y as in 80,180; see umbra78 trace "
         "--help"},
        {"trace a.toml", "--pixel is required; see umbra78 trace --help"},
        {"trace a.toml --pixel 1:2", "--pixel: '1:2' is not a pixel; write x,y as in 80,180; see "
                                     "umbra78 trace --help"},
        {"trace a.toml --pixel 1,2 --json --waterfall",
         "--waterfall excludes --json; see umbra78 trace --help"},
        {"settings --markdown",
         "unknown argument '--markdown'; known here: --help, --scene, --json; see "
         "umbra78 settings --help"},
    };
    for (const auto& [arguments, message] : cases) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 2) << arguments;
        EXPECT_EQ(ran.err, std::string("umbra78: ") + message + "\n");
        EXPECT_EQ(ran.out, "");
    }
    EXPECT_EQ(files().size(), 0u);
}

TEST_F(Program, AFailureIsOneLineExitCode1AndLeavesNoFile) {
    write("bad.toml", "[light]\nazimuth = -100\n[[sphere]]\ncentre = [0, 0, 0]\nradios = 1\n");
    write("good.toml", "[light]\nazimuth = -100\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    write("file", "");
    const struct {
        const char *arguments, *message;
    } cases[] = {
        {"render none.toml --out a.png",
         "cannot read 'none.toml': No such file or directory; give the path of a scene file"},
        {"render . --out a.png", "cannot read '.': Is a directory; give the path of a scene file"},
        {"render bad.toml --out a.png --buffers b",
         "bad.toml:5: unknown key 'radios' in [[sphere]]; did you mean 'radius'?"},
        {"render good.toml --set xy_bits=64",
         "--set xy_bits=64: 'xy_bits' in [settings] is 64; its range is 4 .. 12"},
        {"render good.toml --set 'bias=1\n2'", "--set bias=1 2: 'bias' in [settings] is the text "
                                               "'1 2'; write a number"},
        {"render good.toml --set xy_bits=5 --out none/a.png --buffers b",
         "cannot write 'none/a.png': No such file or directory; create its folder first"},
        {"render good.toml --set xy_bits=5 --out a.png --buffers file",
         "cannot make the folder 'file': Not a directory; name a place that can be written to"},
        {"render good.toml --set xy_bits=5 --out a.png --buffers file/b",
         "cannot make the folder 'file/b': Not a directory; name a place that can be written to"},
        {"render good.toml --set xy_bits=5 --out .",
         "cannot write '.': Is a directory; name a file, not a folder"},
        {"figures --out file",
         "cannot make the folder 'file': Not a directory; name a place that can be written to"},
        {"figures --out a --check --goldens none",
         "there are no goldens in 'none'; name their folder with --goldens, or make them with "
         "--bless"},
    };
    for (const auto& [arguments, message] : cases) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 1) << arguments;
        EXPECT_EQ(ran.err, std::string("umbra78: ") + message + "\n");
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(files(), (std::vector<std::string>{"bad.toml", "file", "good.toml"}));
    }
    EXPECT_FALSE(fs::exists(folder / "a") || fs::exists(folder / "b"));  // no empty folder either
}

TEST_F(Program, AFullDiskIsAFailureToo) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_EQ(run("settings --json >/dev/full #").exit_code, 1);
}

TEST_F(Program, EveryHelpHasAnExample) {
    for (const char* command : {"", "figures ", "render ", "plan ", "animate ", "cycles ",
                                "trace ", "bands ", "bias ", "study ", "study error-time ",
                                "study precision ", "study merge ", "study verify ",
                                "model ", "settings "}) {
        const Ran ran = run(std::string(command) + "--help");
        EXPECT_EQ(ran.exit_code, 0);
        EXPECT_EQ(ran.err, "");
        const std::size_t example = ran.out.find("\nExample:\n  ");
        ASSERT_NE(example, std::string::npos) << ran.out;
        EXPECT_NE(ran.out.find("umbra78 " + std::string(command), example), std::string::npos)
            << ran.out;
    }
    const std::string help = run("render --help").out;
    for (const shadow::Setting& s : shadow::settings_table())
        EXPECT_NE(help.find("\n  " + std::string(s.key) + " "), std::string::npos) << s.key;
}

// umbra78.h has the one copy of the version.
TEST_F(Program, VersionIsTheProjects) {
    const std::string header = content(UMBRA78_SOURCE_DIR "/shadow/c/umbra78.h");
    const std::string before = "#define UMBRA78_VERSION_TEXT \"";
    const std::size_t at = header.find(before) + before.size();
    const std::string version = header.substr(at, header.find('"', at) - at);
    EXPECT_GE(std::count(version.begin(), version.end(), '.'), 2) << version;
    const Ran ran = run("--version");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out, "umbra78 " + version + "\n");
}

// Every command whose numbers a program would read prints JSON.
TEST_F(Program, StudyListsItselfAsJsonToo) {
    const json list = parse_json(run("study --json").out);
    const std::string text = run("study").out;
    ASSERT_EQ(list.size(), 11u);
    for (const json& row : list)
        EXPECT_NE(text.find(row["study"].get<std::string>()), std::string::npos) << row;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
}

TEST_F(Program, RenderWritesThePictureAndTheBuffers) {
    const Ran ran =
        run("render --set density=0.85 " + figures_scene + " --out a.png --buffers b --json");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    const json report = parse_json(ran.out);
    const FigureSet figures;
    EXPECT_EQ(report["hashes"]["picture"], figures.figures()[5].hash);
    EXPECT_EQ(report["hashes"]["mask"], figures.figures()[3].hash);
    for (const char* key : {"scene", "picture", "size_px", "patches", "frame_bytes", "hashes",
                            "error", "bias", "machine", "host_ms", "settings", "warnings"})
        EXPECT_TRUE(report.contains(key)) << key;
    for (const shadow::Setting& s : shadow::settings_table())
        EXPECT_TRUE(report["settings"].contains(s.key)) << s.key;
    EXPECT_EQ(report["bias"]["quanta"], 192);
    EXPECT_EQ(report["bias"]["texels"], 1.5);
    EXPECT_FALSE(report["error"].contains("false_shadow")) << "a low-passed mask has no such rate";
    EXPECT_LT(report["error"]["at_threshold"]["false_shadow"], 0.01);
    EXPECT_GT(report["error"]["graded"]["rms"], report["error"]["graded"]["mean_absolute"]);

    std::vector<std::string> expected{"a.png"};
    for (const PlaneOf plane : {Plane::observer_z, Plane::light_z, Plane::intensity, Plane::direct,
                                Plane::mask, Plane::edges, Plane::filtered, Plane::picture})
        for (const char* end : {".pgm", ".npy"})
            expected.push_back(std::string("b/") + name_of(plane) + end);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(files(), expected);
    for (const Buffer& buffer : figures.buffers()) {
        if (buffer.maxval == 255) continue;
        const Pgm read = read_pgm(folder / "b" / (buffer.name + ".pgm"));
        EXPECT_EQ(read.maxval, 65535);
        EXPECT_FALSE(compare(read, buffer)) << buffer.name;
        EXPECT_EQ(fs::file_size(folder / "b" / (buffer.name + ".npy")), 128u + 2 * 512 * 512);
    }
    EXPECT_EQ(fs::file_size(folder / "b/mask.npy"), 128u + 512 * 512);
}

TEST_F(Program, RenderNamesThePictureAfterTheScene) {
    write("one.toml", "[light]\nazimuth = 30\nextent = 0.5\n"
                      "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    const Ran ran = run("render one.toml --set xy_bits=6 --set z_bits=20");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "umbra78: warning: one.toml: 32 of 32 patches reach out of the light's "
                       "picture and may cast no shadow; light.extent = 1.03458 holds them, or "
                       "leave it out\n");
    EXPECT_NE(ran.out.find("u32be:64x64:fnv1a64:"), std::string::npos);
    EXPECT_EQ(files(), (std::vector<std::string>{"one.png", "one.toml"}));
}

TEST_F(Program, ASceneWithFreePatchesHasErrorsIfBuiltWithEmbree) {
    const Ran ran = run("render " UMBRA78_SOURCE_DIR "/tools/scenes/lamp.toml --set xy_bits=7");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "");
    EXPECT_NE(ran.out.find(traces_patches() ? "error       of the light that truth sees: "
                                            : "error       n/a (free patches: built without "
                                              "Embree; install libembree-dev and build again)\n"),
              std::string::npos) << ran.out;
}

// Ranges and defaults, from hw/MACHINE.md and the README rather than from the table itself.
TEST_F(Program, HelpHasTheRangesOfTheManual) {
    const std::string help = run("render --help").out;
    const struct {
        const char *key, *range;
    } expected[] = {
        {"xy_bits", "4 .. 12 bits; default 9"},
        {"z_bits", "4 .. 26 bits; default 16"},
        {"coefficient_bits", "8 .. 32 bits; default 16"},
        {"fraction_bits", "0 .. 12 bits; default 7"},
        {"multipliers", "1 .. 16 multipliers; default 4"},
        {"lookup", "nearest, bilinear, percentage, filtered_depth; default nearest"},
        {"taps", "2 .. 5 taps; default 3"},
        {"tap_places", "grid, jittered; default grid"},
        {"registration", "centre, index; default centre"},
        {"bias", "-16777216 .. 16777216 bias_unit; default 2"},
        {"bias_unit", "quanta, texels, world; default texels"},
        {"dither", "none, uniform, triangular, normal4, normal; default none"},
        {"dequantize", "0 .. 6 passes; default 0"},
    };
    for (const auto& [key, range] : expected) {
        const std::size_t at = help.find("\n  " + std::string(key) + " ");
        ASSERT_NE(at, std::string::npos) << key;
        const std::size_t next = help.find('\n', at + 1) + 1;
        const std::string line = help.substr(next, help.find('\n', next) - next);
        EXPECT_EQ(line.substr(line.find_first_not_of(' ')), range) << key;
    }
}

// The printed defaults are those of a scene that sets nothing.
TEST_F(Program, PrintedDefaultsAreWhatAPlainSceneHas) {
    write("s.toml", "[light]\nazimuth = -100\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    const Ran ran = run("render s.toml --no-truth --json --set xy_bits=5");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const json used = parse_json(ran.out)["settings"];
    int compared = 0;
    const json printed = parse_json(run("settings --json").out)["settings"];
    for (const json& row : printed) {
        const std::string key = row["key"];
        if (key == "xy_bits") continue;
        EXPECT_EQ(used[key], row["default"]) << key;
        ++compared;
    }
    EXPECT_GT(compared, 30);
}

TEST_F(Program, SettingsListsTheWholeTable) {
    const std::string markdown = run("settings").out;
    const json table = parse_json(run("settings --json").out);
    ASSERT_EQ(table["settings"].size(), shadow::settings_table().size());
    for (std::size_t k = 0; k < table["settings"].size(); ++k) {
        const shadow::Setting& s = shadow::settings_table()[k];
        const json& row = table["settings"][k];
        EXPECT_EQ(row["key"], s.key);
        EXPECT_EQ(row["meaning"], s.meaning);
        EXPECT_EQ(row.contains("choices"), s.kind == shadow::SettingKind::choice);
        EXPECT_NE(markdown.find("| `" + std::string(s.key) + "` "), std::string::npos);
    }
    EXPECT_EQ(table["profiles"].size(), shadow::profiles().size());
}

TEST_F(Program, CyclesOfASceneAndOfEveryProfile) {
    const json one = parse_json(run("cycles " + figures_scene + " --json").out)["ledger"];
    EXPECT_EQ(one["transformation"]["cycles"], 580249);
    EXPECT_EQ(one["transformation"]["bottleneck"], "fetch");
    EXPECT_EQ(one["phases"].size(), 5u);
    const json single =
        parse_json(run("cycles " + figures_scene + " --profile affine16x1 --json").out)["ledger"];
    EXPECT_EQ(single["transformation"]["bottleneck"], "multiply");
    EXPECT_GT(single["frame_cycles"]["side_by_side"], one["frame_cycles"]["side_by_side"]);
    const json all = parse_json(run("cycles " + figures_scene + " --all --json").out)["profiles"];
    EXPECT_EQ(all.size(), shadow::profiles_of_1978().size());
    EXPECT_NE(run("cycles " + figures_scene).out.find("roughly twice"), std::string::npos);
    const auto both = run("cycles " + figures_scene + " --all --profile affine16");
    EXPECT_EQ(both.exit_code, 2);
}

TEST_F(Program, TracePrintsAPixelsWords) {
    const std::string pixel = "trace " + figures_scene + " --pixel 115,180 ";
    const Ran ran = run(pixel + "--vcd a.vcd --cycles 20 --waterfall");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find(": pixel (115, 180): in shadow, cycles "), std::string::npos);
    EXPECT_NE(ran.out.find("  482146860   114.95276927947998046875  Q12.22  "), std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("\n1  pixel (115, 180): leaves the reader"), std::string::npos);
    EXPECT_EQ(files(), (std::vector<std::string>{"a.vcd"}));
    const json words = parse_json(run(pixel + "--json").out)["words"];
    EXPECT_GT(words.size(), 80u);
    const Ran outside = run("trace " + figures_scene + " --pixel 0,512");
    EXPECT_EQ(outside.exit_code, 1);
    EXPECT_EQ(outside.err, "umbra78: pixel 0,512 is not in the frame of 512 x 512 pixels; give x "
                           "and y of 0 .. 511\n");
}

TEST_F(Program, BandsHasARowForEachReading) {
    const json rows = parse_json(run("bands --json").out);
    ASSERT_EQ(rows.size(), 16u);
    for (const json& row : rows) {
        EXPECT_EQ(row["right_edge_lit"], row["azimuth"] > 0);
        EXPECT_EQ(row["false_shadow_limb_to_line"].size(), 4u);
        EXPECT_FALSE(row["band_left_of_line"]);  // no reading fits the whole sentence
    }
    EXPECT_TRUE(rows[0]["greatest_at_line"]);
}

}  // namespace
}  // namespace umbra78::tools
