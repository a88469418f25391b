// The study of precision: every unit is within its bound, and a unit that is not is found.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/precision/precision.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numeric>

namespace umbra78::tools::study {
namespace {

TEST(StudyPrecision, EveryUnitIsWithinItsBoundAndNearIt) {
    const auto study = make_precision_study();
    Request request;
    request.quick = true;
    const std::vector<Case> cases = study->cases(request);
    EXPECT_GE(cases.size(), 10u);
    for (const Case& c : cases) {
        const Row row = figures_of(*study, request, c);
        EXPECT_EQ(row.text("holds"), "yes") << c.name << " at " << row.text("worst_input");
        EXPECT_EQ(row.number("above_bound"), 0) << c.name;
        EXPECT_LE(row.number("over_bound"), 1) << c.name;
        EXPECT_GT(row.number("over_bound"), 0.99) << c.name << ": the search is weak";
        EXPECT_GT(row.number("cases"), 60000) << c.name;
    }
}

TEST(StudyPrecision, ATruncationIsAboveTheBoundOfARounding) {
    const PrecisionUnit truncates{"truncates", "", 0.5, 1, {16, 0, 0, 0}, true,
                                  [](const Input& in) {
                                      return static_cast<double>(in[0] & 127) / 128;
                                  }};
    const PrecisionResult r = measure(truncates, false);
    EXPECT_EQ(r.cases, 65536u);
    EXPECT_EQ(r.worst, 127.0 / 128);
    EXPECT_EQ(r.at[0] & 127, 127);
    EXPECT_EQ(r.histogram[error_bins], 63u * 512);  // 65 .. 127 of each 128
    EXPECT_EQ(std::accumulate(r.histogram.begin(), r.histogram.end(), std::uint64_t{0}), r.cases);
}

// One pair in 2^32 is wrong, at the top of a slope: the climb finds what random draws do not.
TEST(StudyPrecision, TheClimbFindsARareFault) {
    const PrecisionUnit slope{"slope", "", 1, 2, {16, 16, 0, 0}, false, [](const Input& in) {
                                  const auto x = static_cast<double>(in[0] ^ 0x1234);
                                  const auto y = static_cast<double>(in[1] ^ 0x0caf);
                                  return x == 0 && y == 0 ? 2 : 1 / (1 + x * x + y * y);
                              }};
    const PrecisionResult r = measure(slope, false);
    EXPECT_EQ(r.worst, 2);
    EXPECT_EQ(r.at[0], 0x1234);
    EXPECT_GE(r.histogram[error_bins], 1u);
}

}  // namespace
}  // namespace umbra78::tools::study
