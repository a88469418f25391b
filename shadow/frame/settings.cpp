#include "shadow/frame/settings.hpp"

#include "shadow/frame/methods.hpp"

#include <array>

namespace umbra78::shadow {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 7> rounding_names{
    "floor", "ceiling", "to_zero", "half_up", "half_to_zero", "half_away", "half_even"};
constexpr std::array<std::string_view, 2> divide_names{"exact", "round_first"};
constexpr std::array<std::string_view, 3> depth_store_names{"fixed", "float", "float_reversed"};
constexpr std::array<std::string_view, 2> divider_names{"serial", "pipelined"};
constexpr std::array<std::string_view, 2> dram_rows_names{"lines", "words"};
constexpr std::array<std::string_view, 3> video_names{"off", "observer", "all"};
constexpr std::array<std::string_view, 2> surface_names{"catmull", "diced"};
constexpr std::array<std::string_view, 2> facing_names{"both", "front"};
constexpr std::array<std::string_view, 2> sampling_names{"leaf", "centre"};
constexpr std::array<std::string_view, 2> registration_names{"centre", "index"};
constexpr std::array<std::string_view, 4> lookup_names{"nearest", "bilinear", "percentage",
                                                       "filtered_depth"};
constexpr std::array<std::string_view, 2> tap_places_names{"grid", "jittered"};
constexpr std::array<std::string_view, 2> background_names{"blend", "fall_back"};
constexpr std::array<std::string_view, 3> bias_unit_names{"quanta", "texels", "world"};
constexpr std::array<std::string_view, 3> map_depth_names{"first", "back", "midpoint"};
constexpr std::array<std::string_view, 3> receiver_names{"point", "plane", "normal"};
constexpr std::array<std::string_view, 2> slope_source_names{"depths", "normals"};
constexpr std::array<std::string_view, 5> dither_names{"none", "uniform", "triangular", "normal4",
                                                       "normal"};
constexpr std::array<std::string_view, 4> shading_names{"phong", "blinn", "lambert", "none"};
constexpr std::array<std::string_view, 2> composite_names{"direct", "whole"};
constexpr std::array<std::string_view, 16> form_names{
    "post_process", "correct", "ground",          "blob",         "irregular_map",
    "brute",        "volumes", "ordered_volumes", "stencil_pass", "stencil_fail",
    "bouknight_kelley", "appel", "splitting", "perimeters", "atherton",
    "irregular"};
constexpr std::array<std::string_view, 2> arithmetic_names{"fixed", "ap120b"};
constexpr std::array<std::string_view, 2> sector_test_names{"classified", "every"};
constexpr std::array<std::string_view, 2> memory_names{"standard", "fast"};

template <auto Get, auto Set>
constexpr Setting whole(std::string_view key, std::string_view unit, std::int64_t min,
                        std::int64_t max, std::string_view meaning) {
    return {key, SettingKind::whole, unit, min, max, 0, {}, meaning, Get, Set};
}
template <auto Get, auto Set>
constexpr Setting decimal(std::string_view key, std::string_view unit, std::int64_t min,
                          std::int64_t max, int fraction, std::string_view meaning) {
    return {key, SettingKind::decimal, unit, min, max, fraction, {}, meaning, Get, Set};
}
template <auto Get, auto Set>
constexpr Setting choice(std::string_view key, Names names, std::string_view meaning) {
    const auto max = static_cast<std::int64_t>(names.size()) - 1;
    return {key, SettingKind::choice, "", 0, max, 0, names, meaning, Get, Set};
}

// A setting's two accessors, from the member that it sets.
#define UMBRA78_ACCESS(member)                                                            \
    [](const Settings& s) { return static_cast<std::int64_t>(s.member); },                \
        [](Settings& s, std::int64_t v) { s.member = static_cast<decltype(s.member)>(v); }

constexpr std::array all_settings{
    whole<UMBRA78_ACCESS(machine.xy_bits)>(
        "xy_bits", "bits", 4, 12, "X and Y of both frame stores: 2^bits pixels a side"),
    whole<UMBRA78_ACCESS(machine.z_bits)>(
        "z_bits", "bits", 4, 26,
        "Z of both frame stores, at most xy_bits + 20; all ones is the background"),
    whole<UMBRA78_ACCESS(machine.coefficient_bits)>(
        "coefficient_bits", "bits", 8, 32, "a matrix word, Q1.(bits - 2) with an exponent a row"),
    whole<UMBRA78_ACCESS(machine.fraction_bits)>(
        "fraction_bits", "bits", 0, 12, "fraction of X and Y after the transform"),
    whole<UMBRA78_ACCESS(machine.multipliers)>(
        "multipliers", "multipliers", 1, 16, "16 x 16 multipliers in the unit: 1, 4 or 16"),
    whole<UMBRA78_ACCESS(machine.max_accumulator_bits)>(
        "accumulator_bits", "bits", 16, 64,
        "a row's accumulator, to what it needs; fewer cut the low bits of its products"),
    choice<UMBRA78_ACCESS(machine.product_rounding)>(
        "product_rounding", rounding_names, "of a product that the accumulator cuts"),
    choice<UMBRA78_ACCESS(machine.transform_rounding)>(
        "transform_rounding", rounding_names, "of a transformed coordinate, once per result"),
    choice<UMBRA78_ACCESS(machine.coefficient_rounding)>(
        "coefficient_rounding", rounding_names, "of a matrix word"),
    choice<UMBRA78_ACCESS(machine.depth_rounding)>(
        "depth_rounding", rounding_names, "of a drawn sample's Z to its code"),
    choice<UMBRA78_ACCESS(machine.depth_store)>(
        "depth_store", depth_store_names,
        "the codes that both stores keep: all, or those that 32-bit floats hold, 0 or 1 near"),
    choice<UMBRA78_ACCESS(machine.divide_order)>(
        "divide_order", divide_names,
        "perspective: round at the quotient, or x and w before it (to show what that costs)"),
    choice<UMBRA78_ACCESS(surface)>(
        "surface", surface_names,
        "patches: subdivided to the pixel, or diced to triangles, which is coarser"),
    whole<UMBRA78_ACCESS(dice_levels)>(
        "dice_levels", "levels", 0, 5,
        "a diced patch has at most 2^levels cells a side; flat ones take fewer"),
    choice<UMBRA78_ACCESS(facing)>(
        "facing", facing_names,
        "triangles drawn: all, or those whose vertices turn counter-clockwise as they are seen"),
    choice<UMBRA78_ACCESS(sampling)>(
        "sampling", sampling_names,
        "a drawn sample: the leaf's centre as it falls, or the surface at the pixel's centre"),
    choice<UMBRA78_ACCESS(registration)>(
        "registration", registration_names,
        "a pixel's coordinate in the post-process: its centre, or its index (half a pixel off)"),
    choice<UMBRA78_ACCESS(lookup)>("lookup", lookup_names,
                                   "light-map Z: of one texel, interpolated between four, each of "
                                   "a window compared by itself, or a window's mean (wrong)"),
    choice<UMBRA78_ACCESS(background)>(
        "background", background_names,
        "bilinear lookup beside the background: blend its Z, or fall back to nearest"),
    whole<UMBRA78_ACCESS(taps)>("taps", "taps", 2, max_taps_a_side,
                                "a side of the window of percentage and filtered_depth lookup"),
    choice<UMBRA78_ACCESS(tap_places)>(
        "tap_places", tap_places_names,
        "a window's taps: the texels nearest to the point, or cells about it, each at random"),
    decimal<UMBRA78_ACCESS(bias_q16)>(
        "bias", "bias_unit", -(std::int64_t{1} << 40), std::int64_t{1} << 40, 16,
        "taken from the transformed Z before it is compared"),
    choice<UMBRA78_ACCESS(bias_unit)>(
        "bias_unit", bias_unit_names,
        "light-map Z quanta, light-map texels, or world units (both measured at the target)"),
    choice<UMBRA78_ACCESS(map_depth)>(
        "map_depth", map_depth_names,
        "the light's map: nearest Z, nearest that faces away, or half way between the first two"),
    decimal<UMBRA78_ACCESS(bias_slope_q8)>(
        "bias_slope", "texels", 0, 64 << 8, 8,
        "of a caster's slope in the light's view, added to its Z in the light's map"),
    decimal<UMBRA78_ACCESS(bias_clamp_q16)>(
        "bias_clamp", "bias_unit", 0, std::int64_t{1} << 40, 16,
        "the most that follows a slope; 0: no limit"),
    choice<UMBRA78_ACCESS(receiver)>(
        "receiver", receiver_names,
        "the depth compared: the pixel's, its tangent plane's where the map is sampled, or that of "
        "the pixel moved along its normal"),
    decimal<UMBRA78_ACCESS(normal_offset_q8)>(
        "normal_offset", "texels", 0, 16 << 8, 8,
        "of receiver = normal: the way along the normal, in the light map's texels at the pixel"),
    choice<UMBRA78_ACCESS(slope_source)>(
        "slope_source", slope_source_names,
        "a pixel's surface for receiver = plane and normal: Z differences of the observer's store, "
        "or normals kept beside it (3 words a pixel)"),
    choice<UMBRA78_ACCESS(dither.shape)>(
        "dither", dither_names,
        "noise on the light's X and Y: the sum of 0, 1, 2, 4 or 12 uniform bytes"),
    decimal<UMBRA78_ACCESS(dither.size_q8)>("dither_size", "texels", 0, 4 << 8, 8,
                                            "peak to peak: 1 is -0.5 .. +0.5 texel"),
    whole<UMBRA78_ACCESS(dither.seed)>("dither_seed", "word", 1, 0x7fffffff,
                                       "first 31 bits of the noise register"),
    whole<UMBRA78_ACCESS(dequantize_passes)>(
        "dequantize", "passes", 0, 6, "1-2-1 averages along the shadow's edge chain; 0 is off"),
    whole<UMBRA78_ACCESS(low_pass_passes)>("low_pass", "passes", 0, 8,
                                           "3 x 3 binomial low-pass of the mask; 0 is off"),
    decimal<UMBRA78_ACCESS(ambient_q8)>("ambient", "of 1", 0, 256, 8,
                                        "light that reaches a surface from everywhere"),
    choice<UMBRA78_ACCESS(shading)>(
        "shading", shading_names,
        "Lambert's cosine with Phong's highlight, with Blinn's, without one; or the material's "
        "levels alone"),
    choice<UMBRA78_ACCESS(composite)>(
        "composite", composite_names,
        "what a shadow darkens: its light's direct share, or the whole picture (ambient, too)"),
    decimal<UMBRA78_ACCESS(density_q8)>(
        "density", "of 1", 0, 256, 8,
        "how much of that a full shadow takes away: 0 invisible, 1 all of it"),
    choice<UMBRA78_ACCESS(form)>(
        "form", form_names,
        "test visible pixels once the picture is drawn, or points as they are shaded; or draw the "
        "scene flat on its ground, or an ellipse beneath each object; or ask the scene's polygons "
        "as a rival of the depth map does (shadow/rivals/RIVALS.md)"),
    choice<UMBRA78_ACCESS(arithmetic)>(
        "arithmetic", arithmetic_names,
        "of the post-process: the transform unit's, or an FPS AP-120B's (Z to 16 bits)"),
    choice<UMBRA78_ACCESS(array_memory)>(
        "array_memory", memory_names,
        "the AP-120B's main memory: 333 or 167 ns; no bit depends on it"),
    choice<UMBRA78_ACCESS(sector_test)>(
        "sector_test", sector_test_names,
        "of a light in sectors: each pixel is sorted into its own, or goes through every one; no "
        "bit depends on it"),
    whole<UMBRA78_ACCESS(timing.clock_ns)>("clock_ns", "ns", 100, 10000,
                                           "a cycle; no bit depends on this or what follows"),
    whole<UMBRA78_ACCESS(timing.multiply_ns)>("multiply_ns", "ns", 1, 400,
                                              "a 16 x 16 product; more than a clock: more stages"),
    whole<UMBRA78_ACCESS(timing.add_ns)>("add_ns", "ns", 1, 150,
                                         "an addition as wide as the accumulator"),
    whole<UMBRA78_ACCESS(timing.register_ns)>("register_ns", "ns", 0, 40,
                                              "a stage's register, out of every clock"),
    choice<UMBRA78_ACCESS(timing.divider)>(
        "divider", divider_names,
        "one, with a quotient bit a cycle; or three, cut into stages: a point a cycle"),
    whole<UMBRA78_ACCESS(timing.noise_bits)>("noise_bits", "bits", 1, 1024,
                                             "the noise registers advance so far in a cycle"),
    whole<UMBRA78_ACCESS(timing.light_banks)>(
        "light_banks", "banks", 1, 4, "light-map words read in a cycle: 1, or 2 x 2 texels' 4"),
    whole<UMBRA78_ACCESS(timing.dram.access_ns)>("dram_access_ns", "ns", 1, 1000,
                                                 "a frame store's chip: from a closed row to data"),
    whole<UMBRA78_ACCESS(timing.dram.cycle_ns)>(
        "dram_cycle_ns", "ns", 1, 1000, "from one opening of a chip's row to the next"),
    whole<UMBRA78_ACCESS(timing.dram.column_ns)>(
        "dram_column_ns", "ns", 1, 1000, "from a column of the open row to data"),
    whole<UMBRA78_ACCESS(timing.dram.page_ns)>(
        "dram_page_ns", "ns", 0, 1000,
        "from one column of the open row to the next; 0: no row is left open"),
    choice<UMBRA78_ACCESS(timing.dram.rows)>(
        "dram_rows", dram_rows_names,
        "a row of the chips holds whole scan lines, or words far apart, which video refreshes"),
    choice<UMBRA78_ACCESS(timing.dram.video)>(
        "video", video_names, "frame stores read out to a monitor during the post-process"),
};

#undef UMBRA78_ACCESS

}  // namespace

std::span<const Setting> settings_table() { return all_settings; }

const Setting* find_setting(std::string_view key) {
    for (const Setting& s : all_settings)
        if (s.key == key) return &s;
    return nullptr;
}

bool can_be_built(const Settings& settings) {
    return hw::check(settings.machine) == hw::SpecStatus::ok &&
           hw::check(settings.timing) == hw::TimingStatus::ok && method_can(settings);
}

}  // namespace umbra78::shadow
