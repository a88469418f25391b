// Settings: every width and choice of the machine in one value, and the table that names them.
//
// A setting's key, unit, range and meaning are written in this table: the scene file, `--set`,
// `--help` and the documentation read it. Its default is the initializer of its member. The parts
// check their own ranges again (hw::check); a test holds the two equal. A setter stores what it is
// given: a value from outside is compared with min and max first.
#pragma once

#include "hw/ap120b/processor.hpp"
#include "raster/draw.hpp"
#include "shadow/bias.hpp"
#include "shadow/clocked/timed_test.hpp"
#include "shadow/filters/composite.hpp"
#include "shadow/sectors.hpp"
#include "shadow/window.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

// How a pixel comes to be in shadow: two forms of the test against a depth map; or a shadow that is
// drawn on a scene's ground and has no map (hw/MACHINE.md, section 26): the scene's, flat, or an
// ellipse beneath each object; or a depth at each visible point's own place in the light's view; or
// a rival of the depth map, exact on the scene's polygons (shadow/rivals/RIVALS.md).
enum class Form : std::uint8_t {
    post_process, correct, ground, blob, irregular_map,
    brute, volumes, ordered_volumes, stencil_pass, stencil_fail, bouknight_kelley, appel, splitting,
    perimeters, atherton, irregular,
};
constexpr bool is_on_ground(Form form) { return form == Form::ground || form == Form::blob; }
constexpr bool is_rival(Form form) { return form >= Form::brute; }
// What the post-process computes in: the transform unit's words, or the AP-120B's floating point.
enum class Arithmetic : std::uint8_t { fixed, ap120b };

// What the light's map keeps of a texel's samples: the nearest; the nearest of those that face away
// from the light; or half way between the two nearest (shadow/midpoint.hpp).
enum class MapDepth : std::uint8_t { first, back, midpoint };

// What the shadow test reads (machine, timing, registration, lookup, background, taps, tap_places,
// dither) is the base class; the members here are what the other stages of a frame read.
struct Settings : TimedTest {
    raster::PatchForm surface = raster::PatchForm::catmull;
    std::int32_t dice_levels = 3;  // a diced patch has at most 2^levels cells a side; a rival's has
    raster::Facing facing = raster::Facing::both;
    raster::Sampling sampling = raster::Sampling::centre;
    std::int64_t bias_q16 = 64 << 16;  // in bias_unit, Q.16
    BiasUnit bias_unit = BiasUnit::quanta;
    MapDepth map_depth = MapDepth::first;
    std::int32_t bias_slope_q8 = 0;   // texels of a caster's slope, added to its Z; Q.8
    std::int64_t bias_clamp_q16 = 0;  // of what follows a slope, at most; in bias_unit; 0: none
    std::int32_t dequantize_passes = 0;  // 1-2-1 averages along the edge chain; 0: off
    std::int32_t low_pass_passes = 0;    // 3 x 3 binomial; 0: off
    std::int32_t ambient_q8 = 77;        // 0..256
    raster::ShadingRule shading = raster::ShadingRule::phong;
    Composite composite = Composite::direct;
    std::int32_t density_q8 = 218;       // of the shadow: 0 invisible, 256 nothing is left
    Form form = Form::post_process;
    Arithmetic arithmetic = Arithmetic::fixed;
    SectorTest sector_test = SectorTest::classified;
    hw::ap120b::MemorySpeed array_memory = hw::ap120b::MemorySpeed::standard;
};

// How a setting is written: a whole number, a decimal with `fraction` bits, or one of `names`.
enum class SettingKind : std::uint8_t { whole, decimal, choice };

struct Setting {
    std::string_view key;
    SettingKind kind;
    std::string_view unit;     // "" for a choice
    std::int64_t min, max;  // words, both inclusive (decimal: in 2^-fraction units)
    int fraction;
    std::span<const std::string_view> names;  // of a choice, by value
    std::string_view meaning;
    std::int64_t (*get)(const Settings&);
    void (*set)(Settings&, std::int64_t);
};

std::span<const Setting> settings_table();
const Setting* find_setting(std::string_view key);

// Whether a machine can be built with these settings: the machine's widths, the parts' times, and a
// method that can do what they ask (shadow/frame/methods.hpp).
bool can_be_built(const Settings& settings);

// Z codes a texel that are kept while the light's map is drawn; 0: the form has no map.
constexpr int map_layers(const Settings& s) {
    if (is_on_ground(s.form) || is_rival(s.form) || s.form == Form::irregular_map) return 0;
    return s.map_depth == MapDepth::midpoint ? 2 : 1;
}

}  // namespace umbra78::shadow
