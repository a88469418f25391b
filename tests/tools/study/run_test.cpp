// umbra78 study as a user runs it: interrupted and resumed, in shards, verified.
#include "tests/support/effort.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/column_meanings.hpp"
#include "tools/study/csv.hpp"
#include "tools/truth/patch_truth.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <set>

namespace umbra78::tools {
namespace {

namespace fs = std::filesystem;
using test::Program;
using test::Ran;

// The study at 32 x 32 pixels: 16 cases in a moment.
const std::string small = "study error-time --quick --no-host-times --vary xy_bits=5 "
                          "--vary bias=0.5,1.5 --vary bias_unit=texels ";

struct Study : Program {
    std::map<std::string, std::string> contents(const std::string& of) const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::directory_iterator(folder / of))
            all[entry.path().filename().string()] = content(entry.path());
        return all;
    }
    void expect_same(const std::string& a, const std::string& b) const {
        const auto of_a = contents(a), of_b = contents(b);
        EXPECT_GE(of_a.size(), 3u);
        EXPECT_EQ(of_a.size(), of_b.size());
        for (const auto& [name, bytes] : of_a) {
            ASSERT_TRUE(of_b.contains(name)) << name;
            EXPECT_TRUE(of_b.at(name) == bytes) << a << '/' << name << " and " << b << " differ";
        }
    }
    void run_well(const std::string& arguments) const {
        const Ran ran = run(arguments);
        ASSERT_EQ(ran.exit_code, 0) << arguments << ": " << ran.err;
    }
    // The answer, then a plot, then the tables; no figure with more digits than are known.
    static void expect_answer_first(const std::string& page, bool has_plots) {
        const std::size_t answer = page.find("<h2>The answer</h2>\n<p>"),
                          plot = page.find("<figure>"), table = page.find("<table>");
        ASSERT_NE(answer, std::string::npos);
        ASSERT_NE(table, std::string::npos);
        EXPECT_LT(answer, table);
        if (has_plots) {
            ASSERT_NE(plot, std::string::npos);
            EXPECT_LT(answer, plot);
            EXPECT_LT(plot, table);
        }
        EXPECT_EQ(longest_fraction(page), "") << "more digits than are known";
    }
    // The first number with seven or more decimals outside the pictures; "" if there is none.
    static std::string longest_fraction(const std::string& page) {
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        for (std::size_t at = 1; at < page.size(); ++at) {
            if (page.compare(at, 5, "src=\"") == 0) at = page.find('"', at + 5);
            if (page[at] != '.' || !is_digit(page[at - 1])) continue;
            std::size_t end = at + 1;
            while (end < page.size() && is_digit(page[end])) ++end;
            if (end - at > 7) return page.substr(at - 1, end + 1 - at);
        }
        return "";
    }
    static void expect_columns_explained(const study::Study& study, const fs::path& csv) {
        for (const std::string& column : study::read_csv(csv).columns)
            EXPECT_TRUE(study::meaning_of(column, study)) << column << " is not explained";
        EXPECT_FALSE(study::meaning_of("no_such_column", study));
    }
    static bool there(const char* program) {
        return std::system(("command -v " + std::string(program) + " >/dev/null 2>&1").c_str()) ==
               0;
    }
};

TEST_F(Study, ALongFractionIsSeen) {
    EXPECT_EQ(longest_fraction("a 0.123456 b"), "");
    EXPECT_EQ(longest_fraction("a 0.1234567 b"), "0.1234567");
    EXPECT_EQ(longest_fraction("<img src=\"0.1234567\"> 12.3"), "");
}

TEST_F(Study, AloneItListsTheStudies) {
    const Ran ran = run("study");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.out.find("error-time"), 0u) << ran.out;
    for (const char* command : {"study error-time", "study merge", "study verify"}) {
        const Ran help = run(command + std::string(" --help"));
        EXPECT_EQ(help.exit_code, 0);
        EXPECT_NE(help.out.find("\nExample:\n  "), std::string::npos) << help.out;
    }
}

TEST_F(Study, LeavesItsFilesAndNoOthers) {
    run_well(small + "--out a");
    const auto files = contents("a");
    EXPECT_TRUE(files.contains("error-time.csv") && files.contains("error-time.json") &&
                files.contains("index.html"));
    EXPECT_FALSE(files.contains("error-time.partial.jsonl"));
    const std::string& csv = files.at("error-time.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 17);
    EXPECT_EQ(csv.find("_host_ms"), std::string::npos);
    const auto json = parse_json(files.at("error-time.json"));
    EXPECT_EQ(json["cases"], 16);
    EXPECT_EQ(json["failed_cases"], 0);
    EXPECT_FALSE(json["answers"].empty());
    if (!there("gnuplot")) GTEST_SKIP() << "no gnuplot here: plots are not tested";
    EXPECT_EQ(files.at("front-machine-overall.png").substr(1, 3), "PNG");
    EXPECT_NE(files.at("index.html").find("src=\"data:image/svg+xml;base64,"), std::string::npos);
    EXPECT_EQ(files.at("index.html").find("http"), std::string::npos);
}

// Contours need an edge: with cast shadows alone they are chosen by those, and without any shadow
// the page says so.
TEST_F(Study, ContoursOfScenesWithoutAShadowLine) {
    const std::string wall = "[light]\nazimuth = -30\n\n[[plane]]\norigin = [-2, -2, 0]\n"
                             "u = [4, 0, 0]\nv = [0, 4, 0]\n";
    write("bare.toml", wall);
    write("shaded.toml", "[observer]\nextent = 1.5\ntarget = [0, 0, 0]\n" + wall +
                             "[[plane]]\norigin = [-4, -0.5, 4]\nu = [1, 0, 0]\nv = [0, 1, 0]\n");
    for (const char* name : {"bare", "shaded"}) {
        const Ran ran = run("study contours " + std::string(name) +
                            ".toml --quick --vary xy_bits=7 --out " + name);
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
    }
    EXPECT_NE(content(folder / "bare/contours.json").find("sees no edge of a shadow"),
              std::string::npos);
    const std::string shaded = content(folder / "shaded/contours.json");
    EXPECT_NE(shaded.find("the contour of cast shadows' edges is then"), std::string::npos)
        << shaded.substr(0, 2000);
}

TEST_F(Study, WithoutGnuplotThereIsTheRest) {
    fs::create_directory(folder / "empty");
    const Ran ran = run("study >/dev/null; PATH=empty " UMBRA78_PROGRAM " " + small + "--out a");
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "umbra78: warning: there are no plots, because gnuplot is missing; install "
                       "it with: sudo apt-get install gnuplot-nox\n");
    EXPECT_TRUE(contents("a").contains("error-time.csv"));
    EXPECT_TRUE(contents("a").contains("front-machine-overall.gnuplot"));
    EXPECT_FALSE(contents("a").contains("front-machine-overall.svg"));
}

TEST_F(Study, ResumedAfterAKillItEndsInTheSameFiles) {
    run_well(small + "--out whole --jobs 1");
    run_well(small + "--out cut --shard 1/1");  // every row, as a log
    const std::string log = content(folder / "cut/error-time.part-1-of-1.jsonl");
    fs::remove_all(folder / "cut");
    fs::create_directory(folder / "cut");
    // Some rows in another order, and one torn in the middle.
    std::vector<std::string> lines;
    for (std::size_t from = 0, to; (to = log.find('\n', from)) != std::string::npos; from = to + 1)
        lines.push_back(log.substr(from, to + 1 - from));
    ASSERT_EQ(lines.size(), 17u);
    std::string head = lines[0];
    write("cut/error-time.partial.jsonl",
          head + lines[9] + lines[2] + lines[5] + lines[7].substr(0, 100));
    run_well(small + "--out cut --jobs 3");
    expect_same("whole", "cut");
    // Killed before its head was written.
    write("cut/error-time.partial.jsonl", head.substr(0, 40));
    run_well(small + "--out cut");
    expect_same("whole", "cut");
}

TEST_F(Study, ATerminatedRunKeepsItsRowsAndGoesOn) {
    const std::string more = "study error-time --quick --vary bias_unit=texels "
                             "--vary bias=1:9:1 --vary xy_bits=6 --out a ";
    // Stopped as soon as it has written a row below its head, however busy the machine is.
    const Ran cut = run("study >/dev/null; { " UMBRA78_PROGRAM " " + more + "--jobs 1 & study=$!; "
                        "until [ \"$(cat a/*.partial.jsonl | wc -l)\" -ge 2 ]; do "
                        "kill -0 $study || break; sleep 0.01; done 2>/dev/null; "
                        "kill -TERM $study; wait $study; }");
    if (cut.exit_code == 0) GTEST_SKIP() << "the study was done before it could be stopped";
    EXPECT_NE(cut.err.find("run the same command again to go on"), std::string::npos) << cut.err;
    EXPECT_EQ(contents("a").size(), 1u);
    const Ran other = run("study error-time --quick --out a");
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_EQ(other.err, "umbra78: a/error-time.partial.jsonl: it holds rows of other inputs "
                         "(scene, settings, grid or version); remove it to begin anew, or give "
                         "another folder with --out\n");
    run_well(more);
    EXPECT_FALSE(contents("a").contains("error-time.partial.jsonl"));
}

TEST_F(Study, ShardsMergedAreTheUnshardedRun) {
    if (!there("parallel")) GTEST_SKIP() << "no GNU parallel here; install the package parallel";
    run_well(small + "--out whole");
    const Ran ran = run("study >/dev/null; parallel -j 2 --will-cite " UMBRA78_PROGRAM " " + small +
                        "--out parts --shard {}/3 ::: 1 2 3");
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    run_well("study merge merged parts/error-time.part-*.jsonl");
    expect_same("whole", "merged");
}

TEST_F(Study, PartsMustBeAllThereAndBelongTogether) {
    run_well(small + "--out whole");
    for (const char* i : {"1", "2", "3"}) run_well(small + "--out p --shard " + i + "/3");
    EXPECT_EQ(contents("p").size(), 3u);
    const std::string part = "p/error-time.part-";
    run_well("study merge merged " + part + "3-of-3.jsonl " + part + "1-of-3.jsonl " + part +
             "2-of-3.jsonl");
    expect_same("whole", "merged");
    run_well("study error-time --quick --vary xy_bits=5 --out q --shard 2/3");
    const std::string one = part + "1-of-3.jsonl ", two = part + "2-of-3.jsonl ";
    const std::pair<std::string, std::string> cases[] = {
        {one + two, "part 3 of 3 is missing; run it with --shard 3/3"},
        {one + one + two, one.substr(0, one.size() - 1) + ": it is part 1 of 3, as is " +
                              one.substr(0, one.size() - 1) + "; give each part once"},
        {one + "q/error-time.part-2-of-3.jsonl",
         "q/error-time.part-2-of-3.jsonl: it is of another run than " +
             one.substr(0, one.size() - 1) + "; merge the parts of one run"},
        {one + "whole/error-time.csv",
         "whole/error-time.csv: line 1 is not one of a study's; give a file that umbra78 study "
         "wrote, or run that part again"},
    };
    for (const auto& [parts, message] : cases) {
        const Ran ran = run("study merge none " + parts);
        EXPECT_EQ(ran.exit_code, 1);
        EXPECT_EQ(ran.err, "umbra78: " + message + "\n");
        EXPECT_FALSE(fs::exists(folder / "none"));
    }
}

TEST_F(Study, VerifyFindsAPlantedFigure) {
    run_well(small + "--out a");
    const Ran right = run("study verify a/error-time.csv --sample 100");
    EXPECT_EQ(right.exit_code, 0);
    EXPECT_EQ(right.out, "a/error-time.csv: 16 of 16 rows rendered again, no difference\n");
    std::string csv = content(folder / "a/error-time.csv");
    const std::size_t row = csv.find("\n5,"), hash = csv.find("fnv1a64:", row) + 8;
    csv[hash] = csv[hash] == '0' ? '1' : '0';
    write("a/error-time.csv", csv);
    const Ran wrong = run("study verify a/error-time.csv --sample 100");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.out.find("a/error-time.csv: case 5: mask_hash is u8:32x32:fnv1a64:"), 0u);
    EXPECT_EQ(std::count(wrong.out.begin(), wrong.out.end(), '\n'), 1) << wrong.out;
}

// As Python's csv and a spreadsheet write it.
TEST_F(Study, VerifyReadsTheCsvOfOtherPrograms) {
    run_well(small + "--out a");
    std::string other = "\xEF\xBB\xBF";
    for (const char letter : content(folder / "a/error-time.csv"))
        other += letter == '\n' ? "\r\n" : std::string(1, letter);
    write("a/error-time.csv", other);
    const Ran ran = run("study verify a/error-time.csv --sample 4");
    EXPECT_EQ(ran.exit_code, 0) << ran.out;
    EXPECT_EQ(ran.out, "a/error-time.csv: 4 of 16 rows rendered again, no difference; --sample 16 "
                       "for all\n");
}

TEST_F(Study, AFinishedOneOfOtherInputsIsNotOverwritten) {
    run_well(small + "--out a");
    for (const char* i : {"1", "2"}) run_well(small + "--out p --shard " + i + "/2");
    const auto before = contents("a"), parts = contents("p");
    run_well(small + "--out a");  // the same again
    EXPECT_EQ(contents("a"), before);
    const std::string other = small + "--vary dither=none ";
    const auto expect_refused = [&](const std::string& arguments, const std::string& file) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 1) << arguments;
        EXPECT_EQ(ran.err, "umbra78: " + file + ": it is of other inputs (scene, settings, grid or "
                           "version) and would be overwritten; give another folder with --out, or "
                           "--replace it\n");
    };
    expect_refused(other + "--out a", "a/error-time.json");
    expect_refused(other + "--out p --shard 2/2", "p/error-time.part-2-of-2.jsonl");
    EXPECT_EQ(contents("a"), before);
    EXPECT_EQ(contents("p"), parts);
    run_well(other + "--out b");
    const std::string merge = "study merge b p/error-time.part-1-of-2.jsonl "
                              "p/error-time.part-2-of-2.jsonl ";
    expect_refused(merge, "b/error-time.json");
    run_well(merge + "--replace");
    EXPECT_EQ(contents("b").at("error-time.csv"), before.at("error-time.csv"));
    run_well(other + "--out a --replace");
    EXPECT_NE(contents("a").at("error-time.csv"), before.at("error-time.csv"));
}

TEST_F(Study, TwoDoNotRunInOneFolder) {
    fs::create_directory(folder / "a");
    write("a/error-time.partial.jsonl", "");
    const Ran ran = run("--version >/dev/null; flock a/error-time.partial.jsonl " UMBRA78_PROGRAM
                        " " + small + "--out a");
    if (ran.exit_code == 127) GTEST_SKIP() << "no flock here; install the package util-linux";
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_EQ(ran.err, "umbra78: a/error-time.partial.jsonl: another umbra78 is writing to it; "
                       "wait until it ends, or give another folder with --out\n");
    run_well(small + "--out a");
}

// Every study, small, from its cases to its page; and some of its rows once more. Those with a
// picture's size to set are drawn smaller still; long_quick_test.cpp runs all at their own sizes.
TEST_F(Study, EachQuickRunEndsInItsPageAndIsVerified) {
    if (umbra78::test::sanitized) GTEST_SKIP() << "minutes; their parts are tested alone";
    EXPECT_GE(study::studies().size(), 6u);
    const std::set<std::string> smaller{"bias", "moire", "motion", "lights"};
    for (const auto& each : study::studies()) {
        const std::string name(each->name());
        SCOPED_TRACE(name);
        run_well("study " + name + " --quick --out " + name +
                 (smaller.contains(name) ? " --vary xy_bits=7" : ""));
        const auto made = contents(name);
        EXPECT_TRUE(made.contains(name + ".csv") && made.contains("index.html"));
        EXPECT_EQ(parse_json(made.at(name + ".json"))["failed_cases"], 0);
        expect_answer_first(made.at("index.html"), there("gnuplot"));
        expect_columns_explained(*each, folder / name / (name + ".csv"));
        const Ran ran = run("study verify " + name + "/" + name + ".csv --sample 2");
        EXPECT_EQ(ran.exit_code, 0) << ran.out;
        EXPECT_NE(ran.out.find("2 of "), std::string::npos) << ran.out;
    }
}

TEST_F(Study, OfAPatchOfOnesOwnNeedsEmbree) {
    const Ran ran = run("study bias --quick --auto --vary xy_bits=7 " UMBRA78_SOURCE_DIR
                        "/tools/scenes/lamp.toml --out a");
    if (traces_patches()) {
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_EQ(ran.out.find("Least bias with under 0.1 % false shadow"), 0u) << ran.out;
    } else {
        EXPECT_NE(ran.err.find("install libembree-dev"), std::string::npos) << ran.err;
    }
}

// A study keeps the models that its scene names, so it can be verified without their files.
TEST_F(Study, OfASceneWithModelsCanBeVerifiedWithoutThem) {
    if (!traces_patches()) GTEST_SKIP() << "built without Embree (libembree-dev)";
    std::string bump = "1\n3 3\n# \xE9t\xE9\n";
    for (int n = 0; n < 16; ++n)
        bump += std::to_string(n % 4) + " " + std::to_string(n / 4) + (n == 5 ? " 2\n" : " 0\n");
    write("bump.bpt", bump);
    write("a.toml", "[[model]]\nfile = \"bump.bpt\"\n[light]\nazimuth = 40\nelevation = 20\n");
    const Ran ran = run(small + "a.toml --out a");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    fs::remove(folder / "bump.bpt");
    fs::remove(folder / "a.toml");
    const Ran verified = run("study verify a/error-time.csv --sample 2");
    EXPECT_EQ(verified.exit_code, 0) << verified.err;
    EXPECT_NE(verified.out.find("2 of "), std::string::npos) << verified.out;
}

TEST_F(Study, ErrorsAreOneLine) {
    const struct {
        const char *arguments, *message;
        int exit_code;
    } cases[] = {
        {"study error-tim", "unknown argument 'error-tim'; did you mean 'error-time'?; see umbra78 "
                            "study --help", 2},
        {"study error-time --qick", "unknown argument '--qick'; did you mean '--quick'?; see "
                                    "umbra78 study error-time --help", 2},
        {"study error-time none.toml", "cannot read 'none.toml': No such file or directory; give "
                                       "the path of a scene file", 1},
        {"study error-time --shard 4/3", "--shard 4/3: it is not a part of a whole; write i/n as "
                                         "in 1/3, 2/3, 3/3, n up to 2147483647", 1},
        // 2^32 + 1 in 32 bits would be 1.
        {"study error-time --shard 1/4294967297",
         "--shard 1/4294967297: it is not a part of a whole; write i/n as in 1/3, 2/3, 3/3, n up "
         "to 2147483647", 1},
        {"study error-time --shard 1/2x", "--shard 1/2x: it is not a part of a whole; write i/n as "
                                          "in 1/3, 2/3, 3/3, n up to 2147483647", 1},
        {"study precision --vary z_bits=12",
         "unknown argument '--vary'; known here: --help, --out, --quick, --jobs, --shard, "
         "--no-host-times, --replace, --json; see umbra78 study precision --help", 2},
        {"study verify none.csv",
         "cannot read 'none.csv': No such file or directory; give a CSV that umbra78 study wrote",
         1},
        {"study verify .", "cannot read '.': Is a directory; give a CSV that umbra78 study wrote",
         1},
        {"study merge a .", ".: Is a directory; give a file that umbra78 study wrote, or run that "
                            "part again", 1},
        {"study merge a none.jsonl", "none.jsonl: No such file or directory; give a file that "
                                     "umbra78 study wrote, or run that part again", 1},
        {"study error-time --vary bias", "--vary bias: there is no '='; write key=first:last:step "
                                         "as in bias=0:256:32, or key=value,value as in "
                                         "lookup=nearest,bilinear", 1},
    };
    for (const auto& [arguments, message, exit_code] : cases) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, exit_code) << arguments;
        EXPECT_EQ(ran.err, std::string("umbra78: ") + message + "\n");
    }
    EXPECT_EQ(files().size(), 0u);
}

}  // namespace
}  // namespace umbra78::tools
