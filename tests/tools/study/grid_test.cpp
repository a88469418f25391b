// Studies before they run: --vary, the grid, rows, the Pareto front, sections of a report.
#include "tests/support/error_of.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/study/column_meanings.hpp"
#include "tools/study/csv.hpp"
#include "tools/study/grid.hpp"
#include "tools/study/inputs.hpp"
#include "tools/study/measures.hpp"
#include "tools/study/pareto.hpp"
#include "tools/study/report_sections.hpp"
#include "tools/study/runner.hpp"
#include "tools/study/vary.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

namespace umbra78::tools::study {
namespace {

using Texts = std::vector<std::string>;
using tools::test::error_of;

TEST(Vary, RangesAreExactAndHoldBothEnds) {
    const struct {
        const char* text;
        Texts values;
    } cases[] = {
        {"bias=0:1:0.25", {"0", "0.25", "0.5", "0.75", "1"}},
        {"bias=0:0.3:0.1", {"0", "0.1", "0.2", "0.3"}},
        {"bias=0:10:4", {"0", "4", "8"}},
        {"xy_bits=10:8:-1", {"10", "9", "8"}},
        {"light.azimuth=-100.5:-99.5:0.5", {"-100.5", "-100", "-99.5"}},
        {"bias=-0.5:0.5:0.5", {"-0.5", "0", "0.5"}},
        {"bias=7:7:1", {"7"}},
        {"bias=100:300:100", {"100", "200", "300"}},
        {"lookup=nearest,bilinear", {"nearest", "bilinear"}},
        {"light.target=[0,0,0],[0,1,0]", {"[0,0,0]", "[0,1,0]"}},
        {"form=correct", {"correct"}},
        // 0.1 + 0.2 is 0.3, and 12 decimals are exact.
        {"bias=0.1:0.3:0.2", {"0.1", "0.3"}},
        {"bias=-0.000000000001:0.000000000001:0.000000000001",
         {"-0.000000000001", "0", "0.000000000001"}},
        {"bias=1000000:1000001:0.5", {"1000000", "1000000.5", "1000001"}},
    };
    for (const auto& [text, values] : cases) EXPECT_EQ(parse_vary(text).second, values) << text;
    EXPECT_EQ(parse_vary("light.azimuth=1").first, "light.azimuth");
}

TEST(Vary, WhatIsWrongIsOneLineWithTheRemedy) {
    for (const char* text : {"bias", "=1", "bias=0:1", "bias=0:1:0", "bias=0:1:-1", "bias=1:0:1",
                             "bias=a:2:1", "bias=0:1:1:1", "bias=1,,2", "bias=", "bias=1,1",
                             "bias=0:9999999:1", "bias=0:1e3:1", "bias=0:1:.5",
                             "bias=0:1:0.0000000000001", "bias=-:1:1", "bias=0:1 :1",
                             "bias=9000000000000000000:9000000000000000000:0.0001"}) {
        const std::string error = error_of([&] { parse_vary(text); });
        EXPECT_EQ(error.find("--vary " + std::string(text) + ": "), 0u) << error;
        EXPECT_NE(error.find("; write key=first:last:step"), std::string::npos) << error;
    }
}

TEST(Vary, ValuesAreHeldToTheScene) {
    const auto asked_with = [](const char* text) {
        Request request;
        request.vary = {parse_vary(text)};
        return error_of([&] { ask(*studies().front(), request); });
    };
    EXPECT_EQ(asked_with("xy_bits=8,99"),
              "--vary xy_bits=99: 'xy_bits' in [settings] is 99; its range is 4 .. 12");
    EXPECT_NE(asked_with("lokup=nearest").find("did you mean 'lookup'?"), std::string::npos);
    Request twice;
    twice.vary = {{"bias", {"1"}}, {"bias", {"2"}}};
    EXPECT_NE(error_of([&] { ask(*studies().front(), twice); }).find("given twice"),
              std::string::npos);
}

TEST(Grid, VariedValuesReplaceTheStudysAndNewKeysComeLast) {
    Request request;
    request.vary = {{"bias", {"1", "2"}}, {"lookup", {"bilinear"}}};
    const std::vector<Case> cases =
        grid(request, {{"lookup", {"nearest", "bilinear"}}, {"dither", {"none", "normal"}}});
    ASSERT_EQ(cases.size(), 4u);
    EXPECT_EQ(cases[0].set, (Texts{"lookup=bilinear", "dither=none", "bias=1"}));
    EXPECT_EQ(cases[1].name, "lookup=bilinear dither=none bias=2");
    EXPECT_EQ(cases[3].name, "lookup=bilinear dither=normal bias=2");
    EXPECT_EQ(joined(cases, cases).size(), 4u);
    std::vector<Case> other{cases[2], cases[0]};
    other[0].extra = {{"find", "least"}};  // another case, though its settings are the same
    const std::vector<Case> both = joined(cases, other);
    ASSERT_EQ(both.size(), 5u);
    EXPECT_EQ(both[4].extra, other[0].extra);
    EXPECT_EQ(scene_of(request, cases[3]).settings.bias_q16, 2 << 16);
}

// 100 000 cases joined with as many: if the time were quadratic it would be minutes.
TEST(Grid, JoiningIsLinear) {
    Request request;
    const GridKey many = parse_vary("bias=1:50000:1");
    const std::vector<Case> first = grid(request, {many, {"low_pass", {"0", "1"}}});
    const std::vector<Case> more = grid(request, {many, {"low_pass", {"1", "2"}}});
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(joined(first, more).size(), 150'000u);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(Report, FiguresAreRoundedToWhatIsKnown) {
    EXPECT_EQ(rounded(0.123456789), "0.123");
    EXPECT_EQ(rounded(1234567.8), "1234568");
    EXPECT_EQ(rounded(2.0), "2");
    EXPECT_EQ(rounded(999.7), "1000");
    EXPECT_EQ(rounded(std::nan("")), "");
    EXPECT_EQ(rounded(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(percent(0.23873), "23.9 %");
    EXPECT_EQ(percent(0.000531), "0.053 %");
    EXPECT_EQ(percent(0), "0 %");
    EXPECT_EQ(percent(std::nan("")), "");
}

TEST(Csv, LinesOfOtherProgramsAreRead) {
    const Path path = std::filesystem::temp_directory_path() /
                      fmt::format("umbra78-csv-{}.csv", getpid());
    const std::string text = "\xEF\xBB\xBF" "a,b\r\n1,\"x\r\ny\"\r\n,2\r\n";
    write_file(path, std::as_bytes(std::span(text)));
    const Csv csv = read_csv(path);
    std::filesystem::remove(path);
    EXPECT_EQ(csv.columns, (Texts{"a", "b"}));
    ASSERT_EQ(csv.rows.size(), 2u);
    EXPECT_EQ(csv.rows[0], (Texts{"1", "x\r\ny"}));
    EXPECT_EQ(csv.at(1, "b"), "2");
    EXPECT_EQ(csv.at(1, "c"), std::nullopt);
}

TEST(Rows, ReadBackAsTheyWereWritten) {
    Row row;
    row.set("whole", std::int64_t{-7});
    row.set("real", 0.1);
    row.set("round", 3.0);
    row.set("text", std::string("a, \"b\"\nc"));
    row.set("nan", std::nan(""));
    row.set("least", -std::numeric_limits<double>::infinity());
    const Row again = row_of(parse_json(print_line(to_json(row))));
    ASSERT_EQ(again.cells().size(), row.cells().size());
    for (const auto& [column, value] : row.cells()) EXPECT_EQ(again.at(column), value) << column;
    EXPECT_EQ(row.text("real"), "0.1");
    EXPECT_EQ(row.text("nan"), "");
    EXPECT_TRUE(std::isnan(row.number("nan")));
    EXPECT_EQ(row.number("least"), -std::numeric_limits<double>::infinity());
    EXPECT_THROW(row.at("none"), std::out_of_range);
    EXPECT_EQ(to_csv(std::vector<Row>{row}),
              "whole,real,round,text,nan,least\n-7,0.1,3,\"a, \"\"b\"\"\nc\",,-inf\n");
}

TEST(Rows, AFailedCaseHasTheColumnsOfTheOthersInTheirPlace) {
    Row whole, failed;
    for (const char* column : {"case", "profile", "status", "error"})
        whole.set(column, std::int64_t{1});
    for (const char* column : {"case", "status"}) failed.set(column, std::int64_t{0});
    const std::vector<Row> rows = aligned(std::vector<Row>{failed, whole});
    EXPECT_EQ(to_csv(rows), "case,profile,status,error\n0,,0,\n1,1,1,1\n");
}

TEST(Pareto, TheFrontHoldsWhatNothingBeats) {
    const double nan = std::nan("");
    const std::vector<CostAndError> points{{1, 9}, {2, 9}, {2, 4}, {3, 5}, {nan, 0},
                                           {4, 1}, {1, 9}, {9, 1}, {5, 0}, {1, nan}};
    const std::vector<std::size_t> front = pareto_front(points);
    EXPECT_EQ(front, (std::vector<std::size_t>{0, 2, 5, 8}));
    EXPECT_EQ(knee_of(points, front, 0.5), 0u);  // it bends outward
    const std::vector<CostAndError> bent{{1, 100}, {2, 4}, {3, 3}, {10, 0}};
    EXPECT_EQ(knee_of(bent, pareto_front(bent), 1), 1u);
    EXPECT_TRUE(pareto_front({}).empty());
    EXPECT_EQ(knee_of(points, {}, 0.5), 0u);
}

constexpr std::array<std::string_view, 2> own{"xy_bits", "z_bits"};

// Each of three settings is as fast as its neighbour, within 4 %, but not as the next but one.
TEST(Pareto, CostsWithinTheNoiseAreEqual) {
    const std::vector<CostAndError> points{{100, 4}, {103, 3}, {106, 2}, {109, 1}};
    EXPECT_EQ(pareto_front(points).size(), 4u);
    EXPECT_EQ(pareto_front(points, 0.02), (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(pareto_front(points, 0.04), (std::vector<std::size_t>{1, 3}));
    EXPECT_EQ(pareto_front(points, 0.1), (std::vector<std::size_t>{3}));
}

TEST(ForSweep, AKeyOfItsOwnIsNotCrossedWithTheOthers) {
    Request request;
    request.vary = {{"xy_bits", {"7", "8"}}, {"z_bits", {"12"}}, {"light.azimuth", {"0", "9"}}};
    const auto keys = [](const Request& r) {
        std::string text;
        for (const GridKey& axis : r.vary) text += axis.first + ' ';
        return text;
    };
    EXPECT_EQ(keys(for_sweep(request, own, std::array<std::string_view, 1>{"xy_bits"})),
              "xy_bits z_bits light.azimuth ");
    EXPECT_EQ(keys(for_sweep(request, own, std::array<std::string_view, 1>{"z_bits"})),
              "z_bits light.azimuth ");
    EXPECT_EQ(keys(for_sweep(request, own, {})), "z_bits light.azimuth ");
}

// What was reported, as text.
struct TextReport final : Report {
    std::string text;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();

    void answer(std::string_view words) override { text += "! " + std::string(words) + '\n'; }
    void heading(std::string_view words) override { text += "# " + std::string(words) + '\n'; }
    void paragraph(std::string_view words) override { text += std::string(words) + '\n'; }
    void plot(const Plot& plot, std::string_view) override {
        text += plot.name + ": " + plot.title + '\n';
    }
    void heat_map(const HeatMap& map, std::string_view) override { text += map.name + '\n'; }
    void picture(std::string_view name, int, int, std::span<const std::uint8_t>,
                 std::string_view) override {
        text += std::string(name) + '\n';
    }
    void table(const TableCells& rows, std::string_view) override {
        text += std::to_string(rows.size()) + " rows\n";
    }
    nlohmann::ordered_json& summary() override { return json; }
};

TEST(ReportSections, OneForEachCombination) {
    Request request;
    request.vary = {{"xy_bits", {"7", "8"}}, {"light.azimuth", {"0", "9"}}, {"bias", {"1"}}};
    std::vector<Row> rows;
    for (const char* azimuth : {"0", "9", "0"}) {
        Row row;
        row.set("light.azimuth", std::string(azimuth));
        rows.push_back(row);
    }
    const WriteSection write = [](std::span<const Row> some, Report& to) {
        Plot plot{"p", "Title", "", "", false, false, {}};
        to.answer("yes");
        to.heading("head");
        to.plot(plot, "");
        to.summary()["rows"] = some.size();
    };
    TextReport told;
    write_sections(request, own, rows, told, write);
    EXPECT_EQ(told.text,
              "! With light.azimuth = 0: yes\n# head (with light.azimuth = 0)\n"
              "p-1: Title (light.azimuth = 0)\n"
              "! With light.azimuth = 9: yes\n# head (with light.azimuth = 9)\n"
              "p-2: Title (light.azimuth = 9)\n");
    EXPECT_EQ(told.json["combinations"]["light.azimuth = 0"]["rows"], 2);
    request.vary = {{"xy_bits", {"7", "8"}}};
    TextReport whole;
    write_sections(request, own, rows, whole, write);
    EXPECT_EQ(whole.text, "! yes\n# head\np: Title\n");
    EXPECT_EQ(whole.json["rows"], 3);
}

// Its one case draws the paper's scene with 8 bits of Z, whatever the request says.
struct OneCase final : Study {
    mutable int parsed = 0;
    std::string_view name() const override { return "one"; }
    std::string_view meaning() const override { return "one case"; }
    std::vector<Case> cases(const Request&) const override { return {{"it", {}, {}}}; }
    std::optional<LoadedScene> scene(const Request& request, const Case&) const override {
        ++parsed;
        return scene_of(request, {"", {"z_bits=8"}, {}});
    }
    Row run(const Request&, const Case&, const LoadedScene* drawn) const override {
        Row row;
        row.set("drawn_bits", std::int64_t{drawn->settings.machine.z_bits});
        return row;
    }
    void report(const Request&, std::span<const Row>, Report&) const override {}
    std::vector<ColumnMeaning> columns() const override { return {{"drawn_*", "bits of Z"}}; }
};

TEST(RunCase, ParsesTheSceneOnceAndItsRowHasTheSettingsOfWhatIsDrawn) {
    const OneCase study;
    const Asked asked = ask(study, {});
    const Row row = run_case(asked, 3, asked.cases.front());
    EXPECT_EQ(study.parsed, 1);
    EXPECT_EQ(row.text("status"), "ok");
    EXPECT_EQ(row.number("case"), 3);
    EXPECT_EQ(row.number("drawn_bits"), 8);
    EXPECT_EQ(row.number("z_bits"), 8);
    EXPECT_EQ(meaning_of("drawn_bits", study), "bits of Z");
    EXPECT_EQ(meaning_of("z_bits", study), "a setting: see umbra78 settings");
    EXPECT_EQ(meaning_of("drawn", study), std::nullopt);
}

// Rates are of what both see: rows of frames that lack pixels are named before any answer.
TEST(Coverage, OfRowsIsInWords) {
    const auto row = [](int number, int missing, int extra) {
        return row_with({{"case", std::int64_t{number}},
                         {"missing_pixels", std::int64_t{missing}},
                         {"extra_pixels", std::int64_t{extra}},
                         {"misplaced_pixels", std::int64_t{0}}});
    };
    const Row none = row_with({{"case", std::int64_t{9}}});
    EXPECT_EQ(words_of_coverage(std::vector{row(0, 0, 0), none}), "");
    const std::string words =
        words_of_coverage(std::vector{row(0, 0, 0), row(1, 5, 2), row(2, 6, 0), none});
    EXPECT_TRUE(words.starts_with("2 of 4 frames are not what exact truth sees")) << words;
    EXPECT_NE(words.find("at most 7 in case 1."), std::string::npos) << words;
}

// The same scene under another path is the same study: its shards belong together.
TEST(Asked, TheScenesPathIsNotInTheHash) {
    Request one, other;
    one.quick = other.quick = true;
    one.scene_text = other.scene_text =
        "[light]\nazimuth = -100\n\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
    one.scene_file = "a.toml";
    other.scene_file = "./b.toml";
    EXPECT_EQ(ask(*studies().front(), one).hash, ask(*studies().front(), other).hash);
    other.scene_text += "# other\n";
    EXPECT_NE(ask(*studies().front(), one).hash, ask(*studies().front(), other).hash);
}

}  // namespace
}  // namespace umbra78::tools::study
