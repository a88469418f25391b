// The study of rivals: its own scenes, its looks into the first class, the law that is fitted.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/rivals/rivals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace umbra78::tools::study {
namespace {

Request quick_spheres() {
    Request request = small_sphere();
    request.quick = true;
    request.host_times = false;
    return request;
}

std::string column_of(const Case& c, std::string_view column) {
    return std::string(extra_of(c, column));
}

TEST(RivalsStudy, FitsAPowerLaw) {
    const std::pair<double, double> square[] = {{1, 3}, {2, 12}, {8, 192}, {0, 5}};
    const PowerLaw law = power_law(square);
    EXPECT_NEAR(law.exponent, 2, 1e-12);
    EXPECT_NEAR(law.factor, 3, 1e-12);
    EXPECT_EQ(law.from, 1);
    EXPECT_EQ(law.to, 8);
    const std::pair<double, double> one[] = {{4, 3}, {4, 5}};
    EXPECT_TRUE(std::isnan(power_law(one).exponent)) << "one x has no slope";
}

TEST(RivalsStudy, BoxesCoverWhatTheyDidHoweverManyTheyAre) {
    std::map<int, std::int64_t> seen;
    for (const int side : {1, 4}) {
        const LoadedScene scene = parse_scene(boxes_scene(side, 2), "boxes", {});
        EXPECT_EQ(scene.view().light_count, 2u);
        RenderJob job(scene.view(), scene.settings);
        draw_mask(job);
        std::int64_t dark = 0;
        for (const std::uint8_t value : job.bytes(Plane::mask)) dark += value != 0 ? 1 : 0;
        seen[side] = dark;
    }
    EXPECT_GT(seen[1], 10'000);
    EXPECT_NEAR(static_cast<double>(seen[4]) / static_cast<double>(seen[1]), 1, 0.2);
}

TEST(RivalsStudy, SheetsLieAboveTheFloorAndShadeIt) {
    for (const int sheets : {1, 3}) {
        const LoadedScene scene =
            parse_scene(layers_scene(sheets), "sheets", std::vector<std::string>{"xy_bits=6"});
        EXPECT_EQ(scene.view().patches.size(), static_cast<std::size_t>(sheets) + 1);
    }
}

// The light is the same, as a place far away: what is shadowed is the same but for its ramp.
TEST(RivalsStudy, TheRampsLampShinesAsItsScenesLight) {
    const std::vector<std::string> set{"xy_bits=7", "bias=1.5", "bias_unit=texels"};
    const auto masks = [&](double ramp) {
        const LoadedScene scene = parse_scene(textbook_scene(ramp), "things", set);
        RenderJob job(scene.view(), scene.settings);
        draw_mask(job);
        const auto mask = job.bytes(Plane::mask);
        return std::vector<std::uint8_t>(mask.begin(), mask.end());
    };
    const std::vector<std::uint8_t> hard = masks(0), ramp = masks(4);
    std::size_t differ = 0, dark = 0;
    for (std::size_t at = 0; at < hard.size(); ++at) {
        dark += hard[at] != 0 ? 1 : 0;
        differ += (hard[at] != 0) != (ramp[at] == 255) ? 1 : 0;
    }
    EXPECT_GT(dark, 1000u);
    EXPECT_LT(differ, dark / 20);
}

// Sectors, edges and stopping change what it takes and not what it draws.
TEST(RivalsStudy, LooksIntoTheFirstClassDrawOneMask) {
    const auto study = make_rivals_study();
    const Request request = quick_spheres();
    std::map<std::string, std::set<std::string>> masks;
    std::map<std::string, double> tests;
    std::set<double> links;
    for (const Case& c : study->cases(request)) {
        if (column_of(c, "cells").empty()) continue;
        const Row row = figures_of(*study, request, c);
        const std::string question = column_of(c, "question");
        const bool sheets = question == question::layers;
        std::string drawn = sheets ? "sheets " + column_of(c, "at") : "spheres";
        for (const std::string& set : c.set)
            if (!sheets && set.starts_with("dice_levels")) drawn += " " + set;
        masks[drawn].insert(row.text("mask_hash"));
        if (question != question::sectors) continue;
        tests[column_of(c, "cells")] = row.number("link_tests");
        links.insert(row.number("links"));
    }
    EXPECT_GE(masks.size(), 6u);
    for (const auto& [drawn, hashes] : masks) EXPECT_EQ(hashes.size(), 1u) << drawn;
    EXPECT_EQ(links.size(), 1u) << "sectors lose no link and make none twice";
    EXPECT_LT(tests["8"], tests["1"] / 3);
    EXPECT_GT(tests["256"], tests["8"]) << "a facet is in many cells";
}

TEST(RivalsStudy, EveryQuestionIsAskedOfEveryMethod) {
    const auto study = make_rivals_study();
    std::map<std::string, std::set<std::string>> methods;
    for (const Case& c : study->cases(quick_spheres()))
        methods[column_of(c, "question")].insert(column_of(c, "method"));
    for (const std::string_view asked :
         {question::dicing, question::resolution, question::objects, question::lights})
        EXPECT_EQ(methods[std::string(asked)], methods["dicing"]) << asked;
    EXPECT_GE(methods["dicing"].size(), 8u);
    EXPECT_GE(methods["textbook"].size(), 13u);
    EXPECT_TRUE(is_exact("volumes"));
    EXPECT_FALSE(is_exact(map_on_facets));
}

}  // namespace
}  // namespace umbra78::tools::study
