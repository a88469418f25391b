// The error map has the colours of its legend, as many pixels of each as the report counts.
#include "tools/render/error_map.hpp"

#include "tests/tools/render/case_scenes.hpp"

#include <map>

namespace umbra78::tools {
namespace {

using test::DrawnCase;

std::map<std::array<int, 3>, int> colours(const std::vector<std::uint8_t>& rgb) {
    std::map<std::array<int, 3>, int> count;
    for (std::size_t at = 0; at < rgb.size(); at += 3)
        ++count[{rgb[at], rgb[at + 1], rgb[at + 2]}];
    return count;
}

TEST(ErrorMap, CountsWhatTheReportCounts) {
    const DrawnCase drawn(test::first_natural_scene(),
                          {"xy_bits=8", "bias=0.25", "observer.near=6.8", "observer.far=20"});
    auto count = colours(error_map(*drawn.truth, *drawn.job));
    const Coverage& c = *drawn.report->coverage;
    EXPECT_GT(c.missing, 0);
    // A misplaced pixel has its own colour, so its shadow's error is not shown.
    const int red = count[{235, 50, 40}], blue = count[{70, 120, 255}];
    EXPECT_EQ((count[{255, 220, 0}]), c.missing + c.extra + c.misplaced);
    EXPECT_LE(red, drawn.report->all.false_shadow);
    EXPECT_GE(red, drawn.report->all.false_shadow - c.misplaced);
    EXPECT_LE(blue, drawn.report->all.false_light);
    EXPECT_GE(blue, drawn.report->all.false_light - c.misplaced);
    EXPECT_GT(red, 100);
    EXPECT_GT(blue, 20);
    const int edge = count[{70, 210, 90}];
    EXPECT_GT(edge, 50);
    EXPECT_LT(edge, 2000);  // thin
}

}  // namespace
}  // namespace umbra78::tools
