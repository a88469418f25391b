// Studies before they run: --vary, the grid, the rows, the front.
#include "tools/json_text.hpp"
#include "tools/study/csv.hpp"
#include "tools/study/inputs.hpp"
#include "tools/study/pareto.hpp"
#include "tools/study/row_text.hpp"
#include "tools/study/vary.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace umbra78::tools::study {
namespace {

using Texts = std::vector<std::string>;

std::string error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return error.what();
    }
    return "";
}

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

}  // namespace
}  // namespace umbra78::tools::study
