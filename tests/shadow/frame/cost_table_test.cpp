// The constants of the costs are the rows of the table in hw/MACHINE.md, section 16, word for word.
#include "raster/drawing_cost.hpp"
#include "shadow/frame/bias_cost.hpp"
#include "shadow/frame/filter_cost.hpp"
#include "shadow/frame/sector_cost.hpp"
#include "shadow/frame/planar_cost.hpp"
#include "tests/support/machine_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace umbra78::shadow {
namespace {

using hw::Operations;

std::string text(std::uint64_t n) {
    std::string digits = std::to_string(n);
    for (std::size_t at = digits.size(); digits.size() > 4 && at > 3; at -= 3)
        digits.insert(at - 3, 1, ' ');
    return digits;
}
// "8 (128)"; empty for none.
std::string pair(std::uint64_t count, std::uint64_t size) {
    return count == 0 ? "" : text(count) + " (" + text(size) + ")";
}
std::string cell(const std::string& words) { return words.empty() ? "| " : "| " + words + " "; }

std::string row(const char* what, const std::string& adds, const std::string& products,
                const std::string& quotients, const std::string& accesses) {
    return "| " + std::string(what) + " " + cell(adds) + cell(products) + cell(quotients) +
           cell(accesses) + "|\n";
}
std::string row(const char* what, const Operations& o) {
    return row(what, o.adds == 0 ? "" : text(o.adds), pair(o.products, o.passes),
               pair(o.quotients, o.quotient_bits), o.accesses == 0 ? "" : text(o.accesses));
}
// "40 + n": what one more of the unknown adds is one, or "6 n" for six.
std::string linear(std::uint64_t at_0, std::uint64_t at_1, const char* unknown) {
    const std::uint64_t slope = at_1 - at_0;
    return text(at_0) + " + " + (slope == 1 ? "" : text(slope) + " ") + unknown;
}

using umbra78::test::machine_text;

void expect_row(const std::string& line) {
    EXPECT_NE(machine_text().find(line), std::string::npos) << "not in hw/MACHINE.md: " << line;
}

TEST(CostTable, Filters) {
    const Operations none = cost::chain_step(0), one = cost::chain_step(1);
    expect_row(row("dequantize, chain step, q passes", linear(none.adds, one.adds, "q"),
                   pair(none.products, none.passes), pair(none.quotients, none.quotient_bits),
                   text(none.accesses)));
    for (int q = 0; q <= 6; ++q) {
        const Operations o = cost::chain_step(q);
        EXPECT_EQ(o.adds, none.adds + std::uint64_t(q) * (one.adds - none.adds)) << q;
        EXPECT_EQ(o.passes, none.passes) << q;
        EXPECT_EQ(o.products, none.products) << q;
        EXPECT_EQ(o.quotients, none.quotients) << q;
        EXPECT_EQ(o.quotient_bits, none.quotient_bits) << q;
        EXPECT_EQ(o.accesses, none.accesses) << q;
    }
    expect_row(row("dequantize, pixel of the frame", cost::coverage_pixel));
    expect_row(row("low-pass, pixel and pass", cost::low_pass_pixel));
    const Operations zero = cost::join_pixel(0), of_one = cost::join_pixel(1);
    EXPECT_EQ(cost::join_pixel(9).adds, zero.adds + 9);
    expect_row("| darkness of n lights, pixel (section 23) | n + 1 | " +
               pair(zero.products, zero.passes) + " | " +
               pair(zero.quotients, zero.quotient_bits) + " | n + 1 |\n");
    EXPECT_EQ(of_one.accesses, 2u);
    EXPECT_EQ(of_one.adds, 2u);
    expect_row("| ramp of w pixels, pixel (section 23) | 4 w + 2 | | | 2 w + 5 |\n");
    for (const int w : {1, 32}) {
        const auto wide = static_cast<std::uint64_t>(w);
        EXPECT_EQ(cost::ramp_pixel(w).adds, 4 * wide + 2);
        EXPECT_EQ(cost::ramp_pixel(w).accesses, 2 * wide + 5);
        EXPECT_EQ(cost::ramp_pixel(w).passes, 0u);
    }
    expect_row(row("composite, pixel, source and channel", cost::composite_pixel));
}

TEST(CostTable, Ground) {
    expect_row(row("sample of the observer's view, a light's mask with its record",
                   cost::mask_with_record));
}

TEST(CostTable, Facets) {
    namespace c = raster::cost;
    const std::uint64_t n = c::facet_quotients;
    expect_row(row("facet in perspective: corners divided", "", "",
                   pair(n, n * c::divided_corner_bits), ""));
    expect_row(row("triangle whose box holds a centre", c::triangle_setup));
    expect_row(row("line of its box", c::triangle_line));
    expect_row(row("sample of a facet", c::triangle_sample));
    expect_row(row("facet, shading: its own normal", c::facet_normal));
    expect_row(row("vertex of a diced patch", c::diced_vertex));
    expect_row(row("its normal, where the view shades", c::diced_normal));
    expect_row(row("shaded sample of a facet, beside section 16's", c::corner_weights));
}

TEST(CostTable, SurfaceBias) {
    expect_row(row("sample of a leaf, its triangle's slope", raster::cost::leaf_slope));
    expect_row(row("triangle whose box holds a centre, its slope", raster::cost::facet_slope));
    expect_row(row("sample of a facet, moved", raster::cost::moved_sample));
    expect_row(row("sample, second depth kept", cost::second_sample));
    expect_row(row("texel, midpoint", cost::midpoint_texel));
    expect_row(row("visible pixel, its plane", cost::receiver_plane));
    expect_row(row("visible pixel, moved along its normal", cost::receiver_normal));
    expect_row(row("the same, in a light's perspective, besides", cost::receiver_tilt));
}

TEST(CostTable, KeptNormals) {
    namespace c = raster::cost;
    expect_row(row("sample of a leaf, its normal kept", c::leaf_normal_kept));
    expect_row(row("the same with shading = none, besides", c::leaf_normal_made));
    expect_row(row("sample of a facet, its normal kept", c::facet_normal_kept));
    expect_row(row("visible pixel, its plane from the normal", cost::kept_plane));
    expect_row(row("its plane from the normal, in a light's perspective, besides",
                   cost::kept_plane_tilt));
    expect_row(row("visible pixel, moved along its kept normal", cost::kept_normal));
    expect_row(row("moved along its kept normal, in a light's perspective, besides",
                   cost::kept_normal_tilt));
}

TEST(CostTable, Sectors) {
    expect_row(row("visible pixel of a pass, its sector", cost::sector_pixel));
}

TEST(CostTable, Drawing) {
    namespace c = raster::cost;
    const auto adds = [](const char* what, std::uint64_t n) {
        expect_row(row(what, Operations{.adds = n}));
    };
    adds("patch, component: corrections", c::corners_from_control);
    adds("split, component", c::split);
    adds("drawn block, component of the screen: 17 x 17 corners", c::leaf_corners);
    expect_row(row("leaf, centre sampling: window; leaf sampling: mean",
                   text(c::leaf_window.adds) + "; " + text(c::leaf_mean.adds), "", "", ""));
    expect_row(row("centre in a window: two triangles", c::tested_centre));
    const Operations centre = c::centre_sample, leaf = c::leaf_sample;
    expect_row(row("sample, centre; leaf", text(centre.adds) + "; " + text(leaf.adds),
                   pair(centre.products, centre.passes) + "; " + text(leaf.products),
                   pair(centre.quotients, centre.quotient_bits) + "; " + text(leaf.quotients),
                   text(centre.accesses) + "; " + text(leaf.accesses)));
    expect_row(row("drawn block, shading: 4 normals, each", c::corner_normal));
    using enum raster::ShadingRule;
    const auto of_shininess = [](const char* what, const Operations& dull,
                                 const Operations& shiny) {
        expect_row(row(what, linear(dull.adds, shiny.adds, "n"),
                       linear(dull.products, shiny.products, "n") + " (" +
                           linear(dull.passes, shiny.passes, "n") + ")",
                       pair(dull.quotients, dull.quotient_bits), text(dull.accesses)));
    };
    of_shininess("shaded sample, shininess n", c::shaded_sample(0), c::shaded_sample(1));
    of_shininess("shaded sample, each further source", c::shaded_source(0), c::shaded_source(1));
    of_shininess("shaded sample by blinn", c::shaded_sample(0, blinn), c::shaded_sample(1, blinn));
    of_shininess("shaded sample by blinn, each further source", c::shaded_source(0, blinn),
                 c::shaded_source(1, blinn));
    expect_row(row("shaded sample by lambert", c::shaded_sample(8, lambert)));
    expect_row(row("shaded sample by lambert, each further source", c::shaded_source(8, lambert)));
    for (const Operations& o : {c::shaded_sample(8, none), c::shaded_source(8, none)})
        EXPECT_EQ(o.adds + o.passes + o.quotient_bits, 0u);
    EXPECT_EQ(c::shaded_sample(8, none).accesses, 2u);
    EXPECT_EQ(c::shaded_source(8, none).accesses, 1u);
    expect_row(row("shaded sample, each further channel", c::channel));
    expect_row(row("and each source in it", c::channel_source));
    const std::uint64_t corners = 3 * 17 * 17;
    expect_row(row("drawn block in perspective: corners divided",
                   Operations{.quotients = corners,
                              .quotient_bits = corners * c::divided_corner_bits}));
    EXPECT_EQ(c::bounds_and_action, 43u);
}

// The oracle above finds what is there and no more.
TEST(CostTable, AWrongNumberIsNotFound) {
    Operations wrong = cost::composite_pixel;
    ++wrong.adds;
    EXPECT_EQ(machine_text().find(row("composite, pixel, source and channel", wrong)),
              std::string::npos);
}

}  // namespace
}  // namespace umbra78::shadow
