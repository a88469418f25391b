// The widths study: its bias is in the unit it says, its rows hold the machine's sizes, its powers
// are right.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/widths/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

Row run(const Request& request, const Study& study, std::vector<std::string> set) {
    const auto cases = study.cases(request);
    const auto found = std::find_if(cases.begin(), cases.end(), [&](const Case& c) {
        return std::all_of(set.begin(), set.end(), [&](const std::string& s) {
            return std::find(c.set.begin(), c.set.end(), s) != c.set.end();
        });
    });
    if (found == cases.end()) throw std::logic_error("the study has no such case");
    return figures_of(study, request, *found);
}

TEST(WidthsStudy, KeepsTheBiasInTheUnitItSays) {
    Request request = small_sphere();
    request.quick = true;
    const auto study = make_widths_study();
    const Row fine = run(request, *study, {"bias_unit=world", "xy_bits=8", "lookup=nearest"});
    const Row coarse = run(request, *study, {"bias_unit=world", "xy_bits=7", "lookup=nearest"});
    const Row texels = run(request, *study, {"bias_unit=texels", "xy_bits=8", "lookup=nearest"});
    // Half a texel of the scene's own 128: 4 / 128 / 2.
    EXPECT_NEAR(fine.number("bias_world"), 0.015625, 1e-9);
    EXPECT_NEAR(coarse.number("bias_world"), 0.015625, 1e-9);
    EXPECT_NEAR(coarse.number("bias_texels"), 0.5, 1e-9);
    EXPECT_NEAR(fine.number("bias_texels"), 1, 1e-9);
    EXPECT_NEAR(texels.number("bias_texels"), 0.5, 1e-9);
    EXPECT_LT(fine.number("false_shadow"), coarse.number("false_shadow"));

    EXPECT_EQ(coarse.number("light_map_bytes"), 128 * 128 * 2);
    EXPECT_EQ(fine.number("light_map_bytes"), 256 * 256 * 2);
    const double cycles =
        fine.number("transformation_cycles") / coarse.number("transformation_cycles");
    EXPECT_NEAR(cycles, 4, 0.2) << "four times the points";
    const Row thin = run(request, *study, {"z_bits=12", "lookup=nearest", "bias_unit=world"});
    EXPECT_NEAR(thin.number("bias_quanta"), coarse.number("bias_quanta") / 16, 0.01);
}

TEST(WidthsStudy, AccumulatorFollowsFromTheOtherWidths) {
    Request request = request_of(
        "[light]\nazimuth = -100\n\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    request.quick = true;
    const Row row = run(request, *make_widths_study(), {"fraction_bits=7", "lookup=nearest"});
    EXPECT_EQ(row.number("built_accumulator_bits"), 35);
    EXPECT_EQ(row.number("word_bits"), 16);
}

TEST(WidthsStudy, AVariedWidthHasItsSweepAndNoOther) {
    Request request = small_sphere();
    request.quick = true;
    const auto study = make_widths_study();
    const std::size_t before = study->cases(request).size();
    request.vary = {{"accumulator_bits", {"18", "20", "35"}}};
    EXPECT_EQ(study->cases(request).size(), before + 2 * 3) << "by each lookup";
    request.vary = {{"light.azimuth", {"-100", "-60"}}};
    EXPECT_EQ(study->cases(request).size(), 2 * before);
}

TEST(GrowthPerDoubling, IsThePower) {
    std::vector<Row> rows;
    for (const int bits : {6, 7, 9})
        rows.push_back(row_with({{"xy_bits", std::int64_t{bits}},
                                 {"bytes", 3 * std::pow(4.0, bits)},
                                 {"error", std::pow(2.0, -0.5 * bits)},
                                 {"none", 0.0}}));
    EXPECT_NEAR(growth_per_doubling(rows, "bytes"), 2, 1e-9);
    EXPECT_NEAR(growth_per_doubling(rows, "error"), -0.5, 1e-9);
    EXPECT_TRUE(std::isnan(growth_per_doubling(rows, "none")));
}

}  // namespace
}  // namespace umbra78::tools::study
