// Studies before they run: --vary, the grid, the rows, the front.
#include "tests/support/error_of.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/study/csv.hpp"
#include "tools/study/error_time/pareto.hpp"
#include "tools/study/inputs.hpp"
#include "tools/study/row_text.hpp"
#include "tools/study/vary.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
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
    };
    for (const auto& [text, values] : cases) EXPECT_EQ(parse_vary(text).second, values) << text;
    EXPECT_EQ(parse_vary("light.azimuth=1").first, "light.azimuth");
}

TEST(Vary, WhatIsWrongIsOneLineWithTheRemedy) {
    for (const char* text : {"bias", "=1", "bias=0:1", "bias=0:1:0", "bias=0:1:-1", "bias=1:0:1",
                             "bias=a:2:1", "bias=0:1:1:1", "bias=1,,2", "bias=", "bias=1,1",
                             "bias=0:9999999:1", "bias=0:1e3:1",
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
    EXPECT_EQ(scene_of(request, cases[3]).settings.bias_q16, 2 << 16);
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

// What was told, as text.
struct ToldReport final : Report {
    std::string text;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();

    void paragraph(std::string_view words) override { text += std::string(words) + '\n'; }
    void plot(const Plot& plot, std::string_view) override {
        text += plot.name + ": " + plot.title + '\n';
    }
    void heat_map(const HeatMap& map, std::string_view) override { text += map.name + '\n'; }
    void picture(std::string_view name, int, int, std::span<const std::uint8_t>,
                 std::string_view) override {
        text += std::string(name) + '\n';
    }
    void table(const std::vector<std::vector<std::string>>& rows, std::string_view) override {
        text += std::to_string(rows.size()) + " rows\n";
    }
    nlohmann::ordered_json& summary() override { return json; }
};

TEST(ForCombinations, TellsEachApart) {
    Request request;
    request.vary = {{"xy_bits", {"7", "8"}}, {"light.azimuth", {"0", "9"}}, {"bias", {"1"}}};
    std::vector<Row> rows;
    for (const char* azimuth : {"0", "9", "0"}) {
        Row row;
        row.set("light.azimuth", std::string(azimuth));
        rows.push_back(row);
    }
    const Tell tell = [](std::span<const Row> some, Report& to) {
        Plot plot{"p", "Title", "", "", false, false, {}};
        to.plot(plot, "");
        to.summary()["rows"] = some.size();
    };
    ToldReport told;
    for_combinations(request, own, rows, told, tell);
    EXPECT_EQ(told.text, "With light.azimuth = 0:\np-1: Title (light.azimuth = 0)\n"
                         "With light.azimuth = 9:\np-2: Title (light.azimuth = 9)\n");
    EXPECT_EQ(told.json["combinations"]["light.azimuth = 0"]["rows"], 2);
    request.vary = {{"xy_bits", {"7", "8"}}};
    ToldReport whole;
    for_combinations(request, own, rows, whole, tell);
    EXPECT_EQ(whole.text, "p: Title\n");
    EXPECT_EQ(whole.json["rows"], 3);
}

// The same scene by another path is the same study: shards of it belong together.
TEST(Asked, TheScenesPathIsNotOfTheHash) {
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
