// The table of settings: complete, consistent, its ranges, and accessors that reach what they name.
#include "shadow/frame/settings.hpp"

#include "shadow/frame/ledger.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::Rounding;

// Converts to whatever a member is: as many as fit, that many members a struct has.
struct Anything {
    template <class T>
    operator T() const;
};
template <class Struct, class Base, class... Members>
concept Has = requires { Struct{Base{}, Members{}...}; };
using A = Anything;

// Every member of Settings, by value. A new member no longer fits the bindings or the counts, which
// is a compile error here until it is named, and then a failure below until the table names it too.
static_assert(Has<TimedTest, ShadowTest, A> && !Has<TimedTest, ShadowTest, A, A>);
static_assert(
    Has<Settings, TimedTest, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A> &&
    !Has<Settings, TimedTest, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A, A>);
auto members(const Settings& s) {
    const auto& [machine, registration, lookup, background, taps, tap_places, dither, receiver,
                 normal_offset_q8, slope_source] = static_cast<const ShadowTest&>(s);
    const auto& [xy_bits, z_bits, coefficient_bits, fraction_bits, multipliers,
                 max_accumulator_bits, product_rounding, transform_rounding, coefficient_rounding,
                 depth_rounding, depth_store, divide_order] = machine;
    const auto& [shape, size_q8, seed] = dither;
    const auto& [clock_ns, multiply_ns, add_ns, register_ns, divider, noise_bits, light_banks,
                 dram] = s.timing;
    const auto& [access_ns, cycle_ns, column_ns, page_ns, rows, video] = dram;
    return std::make_tuple(xy_bits, z_bits, coefficient_bits, fraction_bits, multipliers,
                           max_accumulator_bits, product_rounding, transform_rounding,
                           coefficient_rounding, depth_rounding, depth_store, divide_order,
                           s.surface, s.dice_levels, s.facing, s.sampling, registration, lookup,
                           background,
                           taps, tap_places, s.bias_q16, s.bias_unit, s.map_depth, s.bias_slope_q8,
                           s.bias_clamp_q16, receiver, normal_offset_q8, slope_source, shape,
                           size_q8, seed, s.dequantize_passes, s.low_pass_passes, s.ambient_q8,
                           s.shading, s.composite, s.density_q8, s.form, clock_ns, multiply_ns,
                           add_ns, register_ns, divider, noise_bits, light_banks, access_ns,
                           cycle_ns, column_ns, page_ns, rows, video, s.arithmetic, s.array_memory,
                           s.sector_test);
}
constexpr std::size_t member_count = std::tuple_size_v<decltype(members(Settings{}))>;

std::vector<std::int64_t> all_values(const Settings& s) {
    std::vector<std::int64_t> values;
    for (const Setting& row : settings_table()) values.push_back(row.get(s));
    return values;
}

TEST(SettingsTable, HasOneRowForEachMember) {
    EXPECT_EQ(settings_table().size(), member_count);
}

TEST(SettingsTable, KeysAreUniqueAndFound) {
    std::set<std::string_view> keys;
    for (const Setting& row : settings_table()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key << " twice";
        EXPECT_EQ(find_setting(row.key), &row) << row.key;
        EXPECT_EQ(row.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), row.key.npos)
            << row.key;
    }
    for (const std::string_view unknown : {"", "bia", "bias_", "Bias", "profile"})
        EXPECT_EQ(find_setting(unknown), nullptr) << unknown;
}

TEST(SettingsTable, RowsAreConsistent) {
    for (const Setting& row : settings_table()) {
        EXPECT_FALSE(row.meaning.empty()) << row.key;
        EXPECT_LE(row.min, row.max) << row.key;
        EXPECT_EQ(row.kind == SettingKind::choice, row.unit.empty()) << row.key;
        EXPECT_EQ(row.kind == SettingKind::decimal, row.fraction > 0) << row.key;
        EXPECT_EQ(row.kind == SettingKind::choice, !row.names.empty()) << row.key;
        if (row.kind != SettingKind::choice) continue;
        EXPECT_EQ(row.min, 0) << row.key;
        EXPECT_EQ(row.max + 1, static_cast<std::int64_t>(row.names.size())) << row.key;
        EXPECT_EQ(std::set<std::string_view>(row.names.begin(), row.names.end()).size(),
                  row.names.size())
            << row.key;
    }
}

// Over both ends of the range, and what lies next to them and between.
TEST(SettingsTable, WhatIsSetIsGotAndNothingElseChanges) {
    for (const Setting& row : settings_table()) {
        const std::int64_t middle = row.min + (row.max - row.min) / 2;
        for (const std::int64_t v : {row.min, row.min + 1, middle, row.max - 1, row.max}) {
            if (v < row.min || v > row.max) continue;
            Settings s;
            row.set(s, v);
            EXPECT_EQ(row.get(s), v) << row.key;
            for (const Setting& other : settings_table()) {
                if (&other == &row) continue;
                EXPECT_EQ(other.get(s), other.get(Settings{}))
                    << row.key << " = " << v << " changes " << other.key;
            }
        }
    }
}

// From any state, setting every row to its default is Settings{}: no member escapes the table.
TEST(SettingsTable, DefaultsAreSettings) {
    const Settings defaults;
    for (const bool high : {false, true}) {
        Settings s;
        for (const Setting& row : settings_table()) row.set(s, high ? row.max : row.min);
        EXPECT_NE(members(s), members(defaults));
        for (const Setting& row : settings_table()) {
            const std::int64_t value = row.get(defaults);
            EXPECT_GE(value, row.min) << row.key;
            EXPECT_LE(value, row.max) << row.key;
            row.set(s, value);
        }
        EXPECT_EQ(members(s), members(defaults));
        EXPECT_EQ(all_values(s), all_values(defaults));
    }
}

// 1978's machine, in the words of the scene file.
TEST(SettingsTable, DefaultsAreThese) {
    const std::map<std::string_view, std::int64_t> expected{
        {"xy_bits", 9},         {"z_bits", 16},
        {"coefficient_bits", 16}, {"fraction_bits", 7},
        {"multipliers", 4},     {"transform_rounding", 3},
        {"accumulator_bits", 64}, {"product_rounding", 0},
        {"coefficient_rounding", 6}, {"depth_rounding", 3},
        {"depth_store", 0},
        {"divide_order", 0},    {"sampling", 1},
        {"surface", 0},         {"dice_levels", 3},
        {"facing", 0},          {"registration", 0}, {"lookup", 0},
        {"background", 0},      {"bias", 64 << 16},
        {"taps", 3},            {"tap_places", 0},
        {"bias_unit", 0},       {"dither", 0},
        {"map_depth", 0},       {"bias_slope", 0},
        {"bias_clamp", 0},      {"receiver", 0},
        {"normal_offset", 256}, {"slope_source", 0},
        {"dither_size", 256},   {"dither_seed", 0x12345678},
        {"dequantize", 0},      {"low_pass", 0},
        {"ambient", 77},        {"shading", 0},
        {"composite", 0},      {"density", 218},
        {"form", 0},            {"clock_ns", 200},
        {"multiply_ns", 160},   {"add_ns", 60},
        {"register_ns", 20},    {"divider", 0},
        {"noise_bits", 192},    {"light_banks", 1},
        {"arithmetic", 0},      {"array_memory", 0},
        {"sector_test", 0},
        {"dram_access_ns", 200}, {"dram_cycle_ns", 375},
        {"dram_column_ns", 135}, {"dram_page_ns", 225},
        {"dram_rows", 0},       {"video", 1}};
    EXPECT_EQ(expected.size(), settings_table().size());
    for (const Setting& row : settings_table()) {
        const auto at = expected.find(row.key);
        ASSERT_NE(at, expected.end()) << row.key;
        EXPECT_EQ(row.get(Settings{}), at->second) << row.key;
    }
}

TEST(SettingsTable, NamesAreTheEnumerators) {
    struct Named {
        std::string_view key, name;
        int value;
    };
    const auto named = [](std::string_view key, std::string_view name, auto enumerator) {
        return Named{key, name, static_cast<int>(enumerator)};
    };
    std::vector<Named> all;
    for (const std::string_view key :
         {"product_rounding", "transform_rounding", "coefficient_rounding", "depth_rounding"}) {
        all.push_back(named(key, "floor", Rounding::floor));
        all.push_back(named(key, "ceiling", Rounding::ceiling));
        all.push_back(named(key, "to_zero", Rounding::to_zero));
        all.push_back(named(key, "half_up", Rounding::half_up));
        all.push_back(named(key, "half_to_zero", Rounding::half_to_zero));
        all.push_back(named(key, "half_away", Rounding::half_away));
        all.push_back(named(key, "half_even", Rounding::half_even));
    }
    all.push_back(named("depth_store", "fixed", hw::DepthStore::fixed));
    all.push_back(named("depth_store", "float", hw::DepthStore::of_floats));
    all.push_back(named("depth_store", "float_reversed", hw::DepthStore::of_reversed_floats));
    all.push_back(named("divide_order", "exact", hw::DivideOrder::exact));
    all.push_back(named("divide_order", "round_first", hw::DivideOrder::round_first));
    all.push_back(named("surface", "catmull", raster::PatchForm::catmull));
    all.push_back(named("surface", "diced", raster::PatchForm::diced));
    all.push_back(named("facing", "both", raster::Facing::both));
    all.push_back(named("facing", "front", raster::Facing::front));
    all.push_back(named("sampling", "leaf", raster::Sampling::leaf));
    all.push_back(named("sampling", "centre", raster::Sampling::centre));
    all.push_back(named("registration", "centre", Registration::centre));
    all.push_back(named("registration", "index", Registration::index));
    all.push_back(named("lookup", "nearest", Lookup::nearest));
    all.push_back(named("lookup", "bilinear", Lookup::bilinear));
    all.push_back(named("lookup", "percentage", Lookup::percentage));
    all.push_back(named("lookup", "filtered_depth", Lookup::filtered_depth));
    all.push_back(named("tap_places", "grid", TapPlaces::grid));
    all.push_back(named("tap_places", "jittered", TapPlaces::jittered));
    all.push_back(named("background", "blend", Background::blend));
    all.push_back(named("background", "fall_back", Background::fall_back));
    all.push_back(named("bias_unit", "quanta", BiasUnit::quanta));
    all.push_back(named("bias_unit", "texels", BiasUnit::texels));
    all.push_back(named("bias_unit", "world", BiasUnit::world));
    all.push_back(named("map_depth", "first", MapDepth::first));
    all.push_back(named("map_depth", "back", MapDepth::back));
    all.push_back(named("map_depth", "midpoint", MapDepth::midpoint));
    all.push_back(named("receiver", "point", Receiver::point));
    all.push_back(named("receiver", "plane", Receiver::plane));
    all.push_back(named("receiver", "normal", Receiver::normal));
    all.push_back(named("slope_source", "depths", SlopeSource::depths));
    all.push_back(named("slope_source", "normals", SlopeSource::normals));
    all.push_back(named("dither", "none", hw::DitherShape::none));
    all.push_back(named("dither", "uniform", hw::DitherShape::uniform));
    all.push_back(named("dither", "triangular", hw::DitherShape::triangular));
    all.push_back(named("dither", "normal4", hw::DitherShape::normal4));
    all.push_back(named("dither", "normal", hw::DitherShape::normal));
    all.push_back(named("divider", "serial", hw::Divider::serial));
    all.push_back(named("divider", "pipelined", hw::Divider::pipelined));
    all.push_back(named("dram_rows", "lines", hw::DramRows::lines));
    all.push_back(named("dram_rows", "words", hw::DramRows::words));
    all.push_back(named("video", "off", hw::Video::off));
    all.push_back(named("video", "observer", hw::Video::observer));
    all.push_back(named("video", "all", hw::Video::all));
    all.push_back(named("shading", "phong", raster::ShadingRule::phong));
    all.push_back(named("shading", "blinn", raster::ShadingRule::blinn));
    all.push_back(named("shading", "lambert", raster::ShadingRule::lambert));
    all.push_back(named("shading", "none", raster::ShadingRule::none));
    all.push_back(named("composite", "direct", Composite::direct));
    all.push_back(named("composite", "whole", Composite::whole));
    using enum Form;
    for (const auto& [name, form] :
         {std::pair{"post_process", post_process}, {"correct", correct}, {"ground", ground},
          {"blob", blob}, {"brute", brute}, {"volumes", volumes}, {"appel", appel},
          {"ordered_volumes", ordered_volumes}, {"stencil_pass", stencil_pass},
          {"stencil_fail", stencil_fail},
          {"bouknight_kelley", bouknight_kelley}, {"splitting", splitting},
          {"perimeters", perimeters}, {"atherton", atherton}, {"irregular", irregular},
          {"irregular_map", irregular_map}})
        all.push_back(named("form", name, form));
    all.push_back(named("arithmetic", "fixed", Arithmetic::fixed));
    all.push_back(named("arithmetic", "ap120b", Arithmetic::ap120b));
    all.push_back(named("array_memory", "standard", hw::ap120b::MemorySpeed::standard));
    all.push_back(named("array_memory", "fast", hw::ap120b::MemorySpeed::fast));
    all.push_back(named("sector_test", "classified", SectorTest::classified));
    all.push_back(named("sector_test", "every", SectorTest::every));

    std::size_t names = 0;
    for (const Setting& row : settings_table()) names += row.names.size();
    EXPECT_EQ(names, all.size());
    for (const Named& n : all) {
        const Setting* row = find_setting(n.key);
        ASSERT_NE(row, nullptr) << n.key;
        ASSERT_LT(static_cast<std::size_t>(n.value), row->names.size()) << n.key;
        EXPECT_EQ(row->names[static_cast<std::size_t>(n.value)], n.name) << n.key;
    }
}

// The machine's check and the table's ranges are the same ranges, but for 2 and 3 multipliers.
TEST(SettingsTable, RangesAreTheMachines) {
    for (const std::string_view key : {"xy_bits", "z_bits", "coefficient_bits", "fraction_bits",
                                       "accumulator_bits"}) {
        const Setting& row = *find_setting(key);
        for (std::int64_t v = row.min - 2; v <= row.max + 2; ++v) {
            Settings s;
            row.set(s, v);
            EXPECT_EQ(hw::check(s.machine) == hw::SpecStatus::ok, v >= row.min && v <= row.max)
                << key << " " << v;
        }
    }
    const Setting& row = *find_setting("multipliers");
    for (std::int64_t v = row.min - 2; v <= row.max + 2; ++v) {
        Settings s;
        row.set(s, v);
        EXPECT_EQ(hw::check(s.machine) == hw::SpecStatus::ok, v == 1 || v == 4 || v == 16) << v;
    }
}

// The machine's check and the parts' are the table's ranges, at both ends and one beyond.
TEST(SettingsTable, RangesAreTheParts) {
    for (const std::string_view key : {"multiply_ns", "add_ns", "register_ns"}) {
        const Setting& row = *find_setting(key);
        for (const std::int64_t v : {row.min - 1, row.min, row.max, row.max + 1}) {
            Settings s;
            row.set(s, v);
            EXPECT_EQ(hw::check(s.timing) == hw::TimingStatus::ok, v >= row.min && v <= row.max)
                << key << " " << v;
        }
    }
    for (const std::string_view key : {"clock_ns", "noise_bits", "light_banks"}) {
        const Setting& row = *find_setting(key);
        Settings s;
        for (const std::int64_t v : {row.min, row.max}) {
            row.set(s, v);
            EXPECT_EQ(hw::check(s.timing), hw::TimingStatus::ok) << key << " " << v;
        }
        row.set(s, row.min - 1);
        EXPECT_NE(hw::check(s.timing), hw::TimingStatus::ok) << key;
    }
    EXPECT_EQ(find_setting("dequantize")->max, max_dequantize_passes);
}

TEST(SettingsTable, RangesAreThese) {
    struct Range {
        std::int64_t min, max;
    };
    constexpr std::int64_t one = 1;
    const std::map<std::string_view, Range> expected{
        {"xy_bits", {4, 12}},
        {"z_bits", {4, 26}},
        {"coefficient_bits", {8, 32}},
        {"fraction_bits", {0, 12}},
        {"multipliers", {1, 16}},
        {"accumulator_bits", {16, 64}},
        {"product_rounding", {0, 6}},
        {"transform_rounding", {0, 6}},
        {"coefficient_rounding", {0, 6}},
        {"depth_rounding", {0, 6}},
        {"depth_store", {0, 2}},
        {"divide_order", {0, 1}},
        {"surface", {0, 1}},
        {"dice_levels", {0, 5}},
        {"facing", {0, 1}},
        {"sampling", {0, 1}},
        {"registration", {0, 1}},
        {"lookup", {0, 3}},
        {"taps", {2, 5}},
        {"tap_places", {0, 1}},
        {"background", {0, 1}},
        {"bias", {-(one << 40), one << 40}},
        {"bias_unit", {0, 2}},
        {"map_depth", {0, 2}},
        {"bias_slope", {0, 64 << 8}},
        {"bias_clamp", {0, one << 40}},
        {"receiver", {0, 2}},
        {"normal_offset", {0, 16 << 8}},
        {"slope_source", {0, 1}},
        {"dither", {0, 4}},
        {"dither_size", {0, 1024}},
        {"dither_seed", {1, 2147483647}},
        {"dequantize", {0, 6}},
        {"low_pass", {0, 8}},
        {"ambient", {0, 256}},
        {"shading", {0, 3}},
        {"composite", {0, 1}},
        {"density", {0, 256}},
        {"form", {0, 15}},
        {"arithmetic", {0, 1}},
        {"array_memory", {0, 1}},
        {"sector_test", {0, 1}},
        {"clock_ns", {100, 10000}},
        {"multiply_ns", {1, 400}},
        {"add_ns", {1, 150}},
        {"register_ns", {0, 40}},
        {"divider", {0, 1}},
        {"noise_bits", {1, 1024}},
        {"light_banks", {1, 4}},
        {"dram_access_ns", {1, 1000}},
        {"dram_cycle_ns", {1, 1000}},
        {"dram_column_ns", {1, 1000}},
        {"dram_page_ns", {0, 1000}},
        {"dram_rows", {0, 1}},
        {"video", {0, 2}}};
    EXPECT_EQ(expected.size(), settings_table().size());
    for (const Setting& row : settings_table()) {
        const auto found = expected.find(row.key);
        ASSERT_NE(found, expected.end()) << row.key;
        EXPECT_EQ(row.min, found->second.min) << row.key;
        EXPECT_EQ(row.max, found->second.max) << row.key;
    }
}

// Both ends of every range can be drawn and costed, each by itself and all together.
TEST(SettingsTable, BothEndsOfARangeAreDrawn) {
    int drawn = 0;
    const auto draw = [&](Settings s, std::string_view what) {
        s.machine.xy_bits = std::min(s.machine.xy_bits, 5);
        if (!can_be_built(s)) return;
        const test::FigureScene figures;
        test::Frame<hw::Depth32> frame(s.machine, figures.patches.size(),
                                         FrameShape(map_layers(s)));
        Scene scene = figures.scene();
        scene.ground = 17;  // as good as any plane, by its corners
        const FrameStatus status = frame.draw(scene, s);
        EXPECT_TRUE(status == FrameStatus::ok || what == "bias" || what == "all") << what;
        if (status != FrameStatus::ok) return;
        const FrameInputs in{scene, s, frame.matrices};
        EXPECT_GT(frame_ledger(in, frame.buffers, frame.counts).total(true), 0u) << what;
        ++drawn;
    };
    Settings low, high;
    std::size_t rows = 0;
    for (const Setting& row : settings_table()) {
        const std::int64_t one_end = ++rows % 2 == 0 ? row.min : row.max;
        for (const std::int64_t v : {row.min, row.max}) {
            for (const Lookup lookup : {Lookup::percentage, Lookup::bilinear}) {
                if (umbra78::test::sanitized && (lookup == Lookup::bilinear || v != one_end))
                    continue;
                Settings s = figure_settings(6);
                s.lookup = lookup;
                row.set(s, v);
                draw(s, row.key);
            }
        }
        row.set(low, row.min);
        row.set(high, row.max);
    }
    high.form = Form::post_process;
    high.receiver = Receiver::point;
    high.lookup = Lookup::bilinear;
    low.bias_q16 = high.bias_q16 = high.bias_clamp_q16 = 0;
    high.machine.z_bits = 16;
    for (const Settings& s : {low, high}) draw(s, "all");
    EXPECT_GT(drawn, umbra78::test::sanitized ? 35 : 150);
}

}  // namespace
}  // namespace umbra78::shadow
