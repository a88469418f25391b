// The bias study: the bound against its formula and the machine, the search, the gap, the units.
#include "tests/tools/study/study_cases.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/study/bias/maps.hpp"
#include "tools/study/bias/report.hpp"
#include "tools/study/bias/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace umbra78::tools::study {
namespace {

using shadow::Lookup;

// The plane z = 0, seen along z and lit from 30 degrees aside.
Request plane_lit_aslant(const std::string& elevation = "0") {
    return request_of("[light]\nelevation = " + elevation + R"(
azimuth = 30
extent  = 4
near    = -8
far     = 8

[observer]
extent  = 1

[[plane]]
origin  = [-1.5, -1.5, 0]
u       = [3, 0, 0]
v       = [0, 3, 0]

[settings]
xy_bits = 8
)");
}

TEST(BiasBound, IsItsFormula) {
    shadow::Settings s;  // 16 bits of Z, nearest, no dither
    const double slope = std::ldexp(100, -16);
    EXPECT_EQ(bias_bound(slope, s), 51);
    s.dither.shape = hw::DitherShape::uniform;  // a texel of jitter doubles the term
    EXPECT_EQ(bias_bound(slope, s), 101);
    s.lookup = Lookup::bilinear;
    EXPECT_EQ(bias_bound(slope, s), 51);
    s.dither.size_q8 = 128;
    EXPECT_EQ(bias_bound(slope, s), 26);
    s.dither.shape = hw::DitherShape::none;
    EXPECT_EQ(bias_bound(slope, s), 1);
    EXPECT_EQ(bias_bound(INFINITY, s), 1) << "no term, whatever the slope";
    s.lookup = Lookup::nearest;
    EXPECT_TRUE(std::isinf(bias_bound(INFINITY, s)));
    for (s.taps = 2; s.taps <= 5; ++s.taps) {
        s.lookup = Lookup::percentage;
        s.tap_places = shadow::TapPlaces::grid;
        EXPECT_EQ(bias_bound(slope, s), 50 * s.taps + 1);
        s.tap_places = shadow::TapPlaces::jittered;
        EXPECT_EQ(bias_bound(slope, s), 50 * (s.taps + 1) + 1);
        s.lookup = Lookup::filtered_depth;
        EXPECT_EQ(bias_bound(slope, s), 101);
        s.tap_places = shadow::TapPlaces::grid;
        EXPECT_EQ(bias_bound(slope, s), 51);
    }
}

TEST(BiasBound, ForAShareLeavesOutTheSteepest) {
    std::vector<double> slope;
    for (int k = 1; k <= 1000; ++k) slope.push_back(std::ldexp(2 * k, -16));
    const std::vector<std::uint8_t> lit(1000, 1);
    std::vector<std::uint8_t> out(1000, 0);
    EXPECT_EQ(bias_bound_for(0, slope, lit, {}, {}), 1001);
    EXPECT_EQ(bias_bound_for(0.001, slope, lit, {}, {}), 1000);
    EXPECT_EQ(bias_bound_for(0.1, slope, lit, {}, {}), 901);
    out[999] = out[998] = 1;
    EXPECT_EQ(bias_bound_for(0, slope, lit, out, {}), 999);
    EXPECT_TRUE(std::isnan(bias_bound_for(0, slope, std::vector<std::uint8_t>(1000), {}, {})));
}

// With the light at azimuth a and elevation b the normal (0, 0, 1) is -sin a along the light's X,
// -cos a sin b along its Y, and cos a cos b toward it.
TEST(Traced, KnowsAPlanesSlopeInTheLightsSpace) {
    const double degree = std::acos(-1.0) / 180, a = 30 * degree;
    for (const int elevation : {0, 20}) {
        const Request request = plane_lit_aslant(std::to_string(elevation));
        const double b = elevation * degree, texel = 8.0 / 256, range = 16;
        const double sum =
            (std::sin(a) + std::cos(a) * std::sin(b)) / (std::cos(a) * std::cos(b));
        const TruthCache truths;
        const auto traced = truths.of(request.scene);
        for (const std::size_t at : {0u, 128u * 256 + 128, 256u * 256 - 1})
            EXPECT_NEAR(traced->slope[at] / (sum * texel / range), 1, 1e-6) << at;
        EXPECT_EQ(truths.of(request.scene), traced) << "traced once";
    }
}

// On a plane the bound is exact: with a bias of the bound no pixel is in false shadow, and the
// least bias that clears 99.9 % of the pixels is nearly as large.
TEST(LeastBias, OfAPlaneIsItsBound) {
    const Request request = plane_lit_aslant();
    const TruthCache truths;
    const auto traced = truths.of(request.scene);
    BiasedFrames frames(request.scene, *traced);
    const double bound = frames.bound(traced->band);
    const LeastBias min = min_bias(frames);
    EXPECT_LE(min.outside, std::ceil(bound) + 1);
    EXPECT_GE(min.outside, 0.9 * bound - 2);
    EXPECT_LE(frames.beyond_bound(frames.draw(bound + 1), bound + 1), 0);
}

TEST(LeastBias, IsTheFirstThatIsEnough) {
    EXPECT_EQ(bisect(100, [](int b) { return b >= 37; }), 37);
    EXPECT_EQ(bisect(100, [](int) { return true; }), 0);
    EXPECT_EQ(bisect(100, [](int b) { return b == 100; }), 100);
    EXPECT_EQ(bisect(100, [](int) { return false; }), std::nullopt);

    const Request request = small_sphere();
    const TruthCache truths;
    const auto traced = truths.of(request.scene);
    BiasedFrames frames(request.scene, *traced);
    const LeastBias min = min_bias(frames);
    ASSERT_GT(min.outside, 10);
    const auto rate = [&](double bias) {
        return frames.errors(frames.draw(bias)).outside_band.false_shadow_rate();
    };
    EXPECT_LT(rate(min.outside), tolerated_false_shadow);
    EXPECT_GE(rate(min.outside - 1), tolerated_false_shadow);
}

// Pixels up to 3.0 units from their caster are lit, farther ones are shadowed: the gap is 3.0.
TEST(DetachmentGap, OfAStepIsWhereTheMaskBegins) {
    Traced traced;
    const int size = 10;
    traced.truth.truth.size = size;
    traced.truth.truth.visible.assign(100, 1);
    traced.truth.truth.lit.assign(100, 0);
    traced.truth.unlit_side.assign(100, 0);
    std::vector<std::uint8_t> mask(100, 255);
    for (int at = 0; at < 100; ++at) {
        traced.truth.truth.behind.push_back(at * 0.1);
        if (at <= 30) mask[at] = 0;
    }
    mask[90] = 0;  // at an edge: lit falsely, far from its caster
    EXPECT_NEAR(detachment_gap(traced, {mask, {}}), 3.0, 1e-12);
    EXPECT_EQ(detachment_gap(traced, {std::vector<std::uint8_t>(100, 255), {}}), 0);
}

TEST(BiasStudy, RunsASweepAndASearch) {
    Request request = small_sphere();
    request.quick = true;
    const auto study = make_bias_study();
    const auto cases = study->cases(request);
    const auto find = [&](const char* kind) {
        return *std::find_if(cases.begin(), cases.end(),
                             [&](const Case& c) { return c.extra.at(0).second == kind; });
    };
    const Row rates = figures_of(*study, request, find("rates"));
    EXPECT_GT(rates.number("false_shadow"), 0.1) << "no bias";
    EXPECT_EQ(rates.number("bias_quanta"), 0);
    EXPECT_TRUE(std::isnan(rates.number("least_quanta")));
    const Row search = figures_of(*study, request, find("least"));
    EXPECT_LT(search.number("false_shadow_outside"), 0.001);
    EXPECT_EQ(search.number("bias_quanta"), search.number("least_outside_quanta"));
    // 65536 quanta in 4 world units, 128 texels in 4.
    EXPECT_NEAR(search.number("bias_quanta") / search.number("bias_world"), 16384, 1e-6);
    EXPECT_NEAR(search.number("bias_quanta") / search.number("bias_texels"), 512, 1e-6);
    EXPECT_DOUBLE_EQ(search.number("gap_quanta"), search.number("gap_world") * 16384);

    int forms = 0;
    for (const Case& c : cases) forms += c.extra.at(0).second == "form" ? 1 : 0;
    EXPECT_EQ(forms, 18) << "the constant alone, two maps, two slopes, one with a limit; and by "
                            "either source a plane, one with a limit, four normal offsets";
    const Row form = figures_of(*study, request, find("form"));
    EXPECT_EQ(form.number("least_outside_quanta"), search.number("least_outside_quanta"))
        << "the first form is the constant alone";

    const auto is_map = [](const Case& c) { return c.extra.at(0).second == "map"; };
    EXPECT_EQ(std::count_if(cases.begin(), cases.end(), is_map), 10)
        << "the scene's own map and four of today, as deep as it is and 32 times as deep";
    request.vary = {{"lookup", {"nearest"}}};
    const auto varied = study->cases(request);
    EXPECT_EQ(std::count_if(varied.begin(), varied.end(), is_map), 0) << "of no other grid";
    request.vary.clear();

    request.automatic = true;
    const auto own = study->cases(request);
    ASSERT_EQ(own.size(), 1u);
    EXPECT_EQ(own[0].extra.at(0).second, "least");
    request.vary = {{"bias", {"3"}}, {"lookup", {"nearest", "bilinear"}}};
    EXPECT_EQ(study->cases(request).size(), 2u) << "the search finds the bias by itself";
}

// A step of 16 bits is 32 times as large in a range 32 times as deep, and so is the same bias fewer
// steps; a float has steps to spare.
TEST(BiasStudy, MapsOfTodayStandBesideTheScenesOwn) {
    Request request = small_sphere();
    request.quick = true;
    const auto study = make_bias_study();
    std::map<std::string, Row> rows;
    for (const Case& c : map_cases(request)) {
        const std::string name = c.extra.at(1).second + " " + c.extra.at(2).second;
        rows.emplace(name, figures_of(*study, request, c));
        EXPECT_NEAR(rows.at(name).number("bias_texels"), 0.5, 1e-9) << name;
        EXPECT_GT(rows.at(name).number("false_shadow"), 0.1) << name;
        EXPECT_GT(rows.at(name).number("least_outside_texels"), 0.5) << name;
    }
    ASSERT_EQ(rows.size(), 10u);
    const auto quanta = [&](const char* name) { return rows.at(name).number("bias_quanta"); };
    EXPECT_DOUBLE_EQ(quanta("d16_unorm 1"), 32 * quanta("d16_unorm 32"));
    EXPECT_DOUBLE_EQ(quanta("d24 1"), 256 * quanta("d16_unorm 1"));
    EXPECT_DOUBLE_EQ(quanta("d32f 1"), 4 * quanta("d24 1"));
}

TEST(UnitSpreads, PutsTheSteadiestUnitFirst) {
    std::vector<Row> rows;
    for (const double texels : {1.0, 2.0, 4.0})
        rows.push_back(row_with({{"least_outside_quanta", 60 / texels},
                                 {"least_outside_texels", 0.5},
                                 {"least_outside_world", 0.1 / texels}}));
    const auto spreads = unit_spreads(rows);
    ASSERT_EQ(spreads.size(), 3u);
    EXPECT_EQ(spreads[0].unit, "texels");
    EXPECT_EQ(spreads[0].spread, 1);
    EXPECT_NEAR(spreads[1].spread, 4, 1e-12);
}

}  // namespace
}  // namespace umbra78::tools::study
