// The study of growth: its cycles are those of the held scene and lie on a line, and the line's fit
// would show if they did not.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/growth/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace umbra78::tools::study {
namespace {

TEST(StudyGrowth, CyclesAreALineOverNumberAndArea) {
    const auto study = make_growth_study();
    Request request;
    request.quick = true;
    request.host_times = false;
    std::vector<std::pair<double, double>> number, area;
    for (const Case& c : study->cases(request)) {
        const Row row = figures_of(*study, request, c);
        ASSERT_EQ(row.number("patches"), std::stod(c.extra[1].second)) << c.name;
        (c.extra[0].second == "number" ? number : area)
            .emplace_back(row.number(c.extra[0].second == "number" ? "patches" : "area_px"),
                          row.number("frame_cycles"));
    }
    ASSERT_GE(number.size(), 5u);
    ASSERT_EQ(area.size(), 5u);
    EXPECT_LT(line_through(number).worst, 0.15);
    EXPECT_LT(line_through(area).worst, 0.15);
    EXPECT_GT(line_through(number).slope, 0);
    EXPECT_GT(line_through(area).slope, 0);
}

TEST(StudyGrowth, TheLineIsThatOfItsPoints) {
    const std::vector<std::pair<double, double>> line{{100, 1200}, {1000, 3000}, {1e6, 2001000}};
    const Line exact = line_through(line);
    EXPECT_NEAR(exact.fixed, 1000, 1e-6);
    EXPECT_NEAR(exact.slope, 2, 1e-9);
    EXPECT_LT(exact.worst, 1e-9);
    std::vector<std::pair<double, double>> square;
    for (const double x : {100.0, 1000.0, 10000.0, 100000.0}) square.emplace_back(x, x * x);
    EXPECT_GT(line_through(square).worst, 0.5) << "a square is not taken for a line";
}

}  // namespace
}  // namespace umbra78::tools::study
