// What figures 1 to 6 do not reach: other samplings, forms, widths, perspective and point light.
//
// Each variant is the figures' scene (from the fifth on, with a floor) with a few settings changed.
// Its hashes are looked up in hw/MACHINE.md, section 15; the scene words here are that section's.
#include "fixed/fnv.hpp"
#include "shadow/frame/profiles.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

template <class Value>
std::string hash(std::span<const Value> values, int size) {
    fixed::Fnv1a64 h;
    for (const Value v : values) {
        if constexpr (sizeof(Value) == 1) h.byte(v);
        if constexpr (sizeof(Value) == 2) h.u16be(v);
        if constexpr (sizeof(Value) == 4) h.u32be(v);
    }
    char text[80];
    std::snprintf(text, sizeof text, "u%d%s:%dx%d:fnv1a64:%016llx",
                  static_cast<int>(8 * sizeof(Value)), sizeof(Value) == 1 ? "" : "be", size, size,
                  static_cast<unsigned long long>(h.value()));
    return text;
}

const std::string& machine_md() {
    static const std::string text = [] {
        std::ifstream file(UMBRA78_SOURCE_DIR "/hw/MACHINE.md");
        return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    return text;
}

// A row of the table: | variant | buffer | `hash` |
void expect_documented(const std::string& variant, const std::string& buffer,
                       const std::string& hash) {
    const std::string row = "| " + variant + " | " + buffer + " | `" + hash + "` |";
    EXPECT_NE(machine_md().find(row), std::string::npos)
        << "hw/MACHINE.md, section 15, has no row\n  " << row;
}

template <class Depth>
void expect_variant(const std::string& name, const Scene& scene, const Settings& settings) {
    test::Frame<Depth> f(scene, settings);
    ASSERT_EQ(f.status, FrameStatus::ok);
    EXPECT_EQ(f.counts.lights[0].map.unresolved + f.counts.observer.unresolved, 0u);
    const int size = settings.machine.size_px();
    expect_documented(name, "observer_z", hash<Depth>(f.buffers.observer.depth, size));
    expect_documented(name, "light_z", hash<Depth>(f.buffers.lights[0].map.depth, size));
    expect_documented(name, "intensity",
                      hash<std::uint8_t>(f.buffers.observer.intensity, size));
    expect_documented(name, "mask", hash<std::uint8_t>(f.buffers.lights[0].mask, size));
}

// The mask alone, on the AP-120B: section 18's table.
void expect_on_array(const std::string& name, const Scene& scene, Settings settings) {
    const int coefficient_bits = settings.machine.coefficient_bits;  // of the views: stays
    apply(*find_profile("ap120b"), settings);
    settings.machine.coefficient_bits = coefficient_bits;
    test::Frame<> f(scene, settings);
    ASSERT_EQ(f.status, FrameStatus::ok);
    expect_documented(name, "mask_ap120b", hash<std::uint8_t>(f.buffers.lights[0].mask, 512));
}

// The four spheres on a floor of 6 by 6 units.
struct FloorScene {
    std::vector<raster::Patch> patches;
    std::array<raster::Material, 1> materials{figure_material};

    FloorScene() {
        const FigurePatches spheres = figure_patches();
        patches.assign(spheres.begin(), spheres.end());
        patches.push_back(raster::plane_patch(
            {{-3 * 65536, -127795, 3 * 65536}, {6 * 65536, 0, 0}, {0, 0, -6 * 65536}, 0}));
    }
    void fit(raster::View& v) const { raster::fit_depth(v, raster::depth_range(v, patches)); }

    raster::View perspective_observer() const {
        raster::View v;
        v.projection = raster::Projection::perspective;
        v.axes = raster::axes_from_angles(30 * 65536, 20 * 65536);
        v.extent = 2 * 65536;
        v.distance = 6 * 65536;
        fit(v);
        return v;
    }
    raster::View far_light() const {
        raster::View v;
        v.axes = raster::axes_from_angles(-100 * 65536, 30 * 65536);
        v.extent = 4 * 65536;
        fit(v);
        return v;
    }
    raster::View point_light() const {
        raster::View v;
        v.projection = raster::Projection::perspective;
        const raster::World at{-5 * 65536, 4 * 65536, 2 * 65536};
        raster::axes_from_points(at, v.target, v.axes);
        v.distance = 439629;  // sqrt(45) units
        v.extent = 4 * 65536;
        fit(v);
        return v;
    }
};

Settings figure_four() { return figure_settings(4); }

TEST(Variants, leaf_sampling) {
    test::FigureScene s;
    Settings set = figure_settings(3);
    set.sampling = raster::Sampling::leaf;
    expect_variant<hw::Depth16>("leaf", s.scene(), set);
}

TEST(Variants, short_accumulator) {
    const test::FigureScene s;
    Settings set = figure_settings(3);
    set.machine.max_accumulator_bits = 22;
    const test::Frame<> f(s.scene(), set);
    ASSERT_EQ(f.status, FrameStatus::ok);
    expect_documented("a short accumulator | figure 3's, A = 22", "mask3_short",
                      hash<std::uint8_t>(f.buffers.lights[0].mask, 512));
}

// The constant of each row is cut, too: 100 quanta of bias are no multiple of what is left.
TEST(Variants, shorter_accumulator_rounded) {
    const test::FigureScene s;
    Settings set = figure_settings(3);
    set.machine.max_accumulator_bits = 16;
    set.machine.product_rounding = fixed::Rounding::half_up;
    set.bias_q16 = 100 << 16;
    const test::Frame<> f(s.scene(), set);
    ASSERT_EQ(f.status, FrameStatus::ok);
    expect_documented("a shorter one, rounded | A = 16, product_rounding half_up, bias 100",
                      "mask3_shorter", hash<std::uint8_t>(f.buffers.lights[0].mask, 512));
}

TEST(Variants, short_accumulators_that_divide_or_draw) {
    FloorScene floor;
    Settings set = figure_four();
    set.machine.coefficient_bits = 24;
    set.machine.max_accumulator_bits = 22;
    const Scene scene{floor.patches, floor.materials, floor.perspective_observer(),
                      {{floor.point_light()}}};
    const test::Frame<> divided(scene, set);
    ASSERT_EQ(divided.status, FrameStatus::ok);
    expect_documented("point, A = 22", "mask",
                      hash<std::uint8_t>(divided.buffers.lights[0].mask, 512));

    const test::FigureScene s;
    Settings correct = figure_four();
    correct.form = Form::correct;
    correct.machine.max_accumulator_bits = 20;
    const test::Frame<> drawn(s.scene(), correct);
    ASSERT_EQ(drawn.status, FrameStatus::ok);
    expect_documented("correct, A = 20", "mask",
                      hash<std::uint8_t>(drawn.buffers.lights[0].mask, 512));
}

TEST(Variants, index_registration) {
    test::FigureScene s;
    Settings set = figure_settings(3);
    set.registration = Registration::index;
    expect_variant<hw::Depth16>("index", s.scene(100 * 65536), set);
    expect_on_array("index", s.scene(100 * 65536), set);
}

TEST(Variants, fall_back) {
    test::FigureScene s;
    Settings set = figure_four();
    set.background = Background::fall_back;
    expect_variant<hw::Depth16>("fall_back", s.scene(), set);
    expect_on_array("fall_back", s.scene(), set);
}

TEST(Variants, correct_form) {
    test::FigureScene s;
    Settings set = figure_four();
    set.form = Form::correct;
    expect_variant<hw::Depth16>("correct", s.scene(), set);
}

TEST(Variants, narrow_words) {
    test::FigureScene s;
    Settings set = figure_four();
    set.machine.xy_bits = 8;
    set.machine.z_bits = 12;
    set.machine.coefficient_bits = 12;
    set.machine.fraction_bits = 5;
    set.bias_q16 = 12 << 16;
    expect_variant<hw::Depth16>("narrow", s.scene(), set);
}

TEST(Variants, wide_words) {
    test::FigureScene s;
    Settings set = figure_four();
    set.machine.z_bits = 24;
    set.machine.coefficient_bits = 32;
    set.machine.fraction_bits = 12;
    set.bias_q16 = std::int64_t{192 << 8} << 16;
    expect_variant<hw::Depth32>("wide", s.scene(), set);
}

TEST(Variants, perspective_observer) {
    FloorScene s;
    Settings set = figure_four();
    set.machine.coefficient_bits = 24;
    const Scene scene{s.patches, s.materials, s.perspective_observer(), {{s.far_light()}}};
    expect_variant<hw::Depth16>("perspective", scene, set);
    expect_on_array("perspective", scene, set);
}

TEST(Variants, point_light) {
    FloorScene s;
    Settings set = figure_four();
    set.machine.coefficient_bits = 24;
    const Scene scene{s.patches, s.materials, s.perspective_observer(), {{s.point_light()}}};
    expect_variant<hw::Depth16>("point", scene, set);
    expect_on_array("point", scene, set);
}

}  // namespace
}  // namespace umbra78::shadow
