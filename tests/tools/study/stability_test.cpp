// The study of stability: every case holds, planted faults are found, rows are reproducible.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/stability/stability.hpp"

#include "fixed/overflow.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace umbra78::tools::study {
namespace {

Request quick() {
    Request r;
    r.quick = true;
    r.host_times = false;
    return r;
}

std::vector<std::string> texts(const Row& row) {
    std::vector<std::string> all;
    for (const auto& [column, value] : row.cells()) all.push_back(column + "=" + row.text(column));
    return all;
}

TEST(StudyStability, EveryCaseHoldsAndSaysSoTwice) {
    const auto study = make_stability_study();
    const std::vector<Case> cases = study->cases(quick());
    EXPECT_GE(cases.size(), 40u);
    std::set<std::string> names;
    for (const Case& c : cases) {
        EXPECT_TRUE(names.insert(c.name).second) << c.name << " is there twice";
        const Row row = figures_of(*study, quick(), c);
        EXPECT_EQ(row.text("holds"), "yes") << c.name << ": " << row.text("observed");
        EXPECT_NE(row.text("machine_status"), "") << c.name;
        EXPECT_EQ(texts(row), texts(figures_of(*study, quick(), c))) << c.name;
    }
}

// The cases that do not hold with these units.
std::set<std::string> red_cases(const UnitsUnderTest& units) {
    std::set<std::string> red;
    for (const UnitCase& c : unit_cases())
        if (!c.examine(units, {true}).holds) red.emplace(c.name);
    return red;
}

TEST(StudyStability, AWrapInPlaceOfASaturateIsSeen) {
    UnitsUnderTest units;
    EXPECT_TRUE(red_cases(units).empty());
    units.saturate = [](std::int64_t v, int bits) { return fixed::wrap(v, bits); };
    EXPECT_EQ(red_cases(units), std::set<std::string>{"unit: saturation at every width"});
}

TEST(StudyStability, AQuotientThatWrapsIsSeen) {
    UnitsUnderTest units;
    units.divide = [](std::int64_t num, std::int64_t den, int shift, int bits,
                      fixed::Rounding r) -> fixed::Quotient {
        const fixed::Quotient q = fixed::divide(num, den, shift, 63, r);
        if (q.status != fixed::DivideStatus::ok) return q;
        return {fixed::wrap(q.value, bits), fixed::DivideStatus::ok};
    };
    EXPECT_EQ(red_cases(units), std::set<std::string>{"unit: quotients of extreme sums"});
}

TEST(StudyStability, AnAccumulatorOf32BitsIsSeen) {
    UnitsUnderTest units;
    units.accumulate = [](const hw::MatrixWords& m, hw::Row row, const hw::Words& v,
                          std::int32_t one) {
        return fixed::wrap(hw::accumulate(m, row, v, one), 32);
    };
    EXPECT_EQ(red_cases(units), std::set<std::string>{"unit: all corner products of 3 x 4"});
}

// 1/3 in 16 bits comes near its bound, and the identity, which is exact, has no error.
TEST(StudyStability, TheBoundOfTheTransformIsTight) {
    hw::RationalMatrix identity{};
    for (std::size_t k = 0; k < 4; ++k) identity[k][k] = 1;
    const TransformError exact = transform_error(identity, {});
    EXPECT_EQ(exact.points, 13 * 13 * 13);
    EXPECT_TRUE(exact.sound);
    EXPECT_EQ(exact.over_bound, 0);
    hw::RationalMatrix third = identity;
    third[0][0] = fixed::Rational(1, 3);
    const TransformError rounded = transform_error(third, {});
    EXPECT_GT(rounded.over_bound, 0.3);
    EXPECT_LE(rounded.over_bound, 1);
}

TEST(StudyStability, ACaseWithTooManySplitsOrAnUnexpectedStatusIsRed) {
    FrameCase c = stiff_frames().front();
    EXPECT_TRUE(examine(c, {true}).holds);
    c.max_splits = 1;
    EXPECT_FALSE(examine(c, {true}).holds);
    c = stiff_frames().front();
    c.set.push_back("bias=33554432");
    const Finding refused = examine(c, {true});
    EXPECT_FALSE(refused.holds);
    EXPECT_TRUE(refused.status.starts_with("refused: ")) << refused.status;
}

// The numbers of the table of depths are columns, and the settings are those of the drawn frame.
TEST(StudyStability, ADepthCaseCarriesItsRatioAndItsSettings) {
    const auto study = make_stability_study();
    int found = 0;
    std::int64_t must = 10;
    for (const Case& c : study->cases(quick())) {
        if (!c.name.starts_with("far/near ")) continue;
        const Row row = figures_of(*study, quick(), c);
        EXPECT_EQ(row.number("far_over_near"), double(must)) << c.name;
        EXPECT_FALSE(row.text("far_codes").empty()) << c.name;
        EXPECT_EQ(study->scene(quick(), c)->settings.machine.xy_bits, 6) << "as --quick draws it";
        must *= 10;
        ++found;
    }
    EXPECT_EQ(found, 6);
}

TEST(StudyStability, LimitsAreFoundByBisection) {
    const auto from_12 = [](int k) -> std::string { return k < 12 ? "ok" : "too far"; };
    EXPECT_EQ(examine(LimitCase{"a", "", 0, 30, from_12, "units"}).onset, "2^12 units: too far");
    const auto twice = [](int k) -> std::string { return k == 3 || k > 9 ? "bad" : "ok"; };
    EXPECT_FALSE(examine(LimitCase{"b", "", 0, 30, twice, "units"}).holds);
    const auto never = [](int) -> std::string { return "ok"; };
    EXPECT_EQ(examine(LimitCase{"c", "", 0, 8, never, "units"}).onset, "never, to 2^8 units");
}

}  // namespace
}  // namespace umbra78::tools::study
