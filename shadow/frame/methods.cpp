#include "shadow/frame/methods.hpp"

#include "shadow/frame/ground.hpp"
#include "shadow/frame/irregular_map.hpp"
#include "shadow/frame/map_stages.hpp"
#include "shadow/frame/rivals.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace umbra78::shadow {
namespace {

using hw::built;
using hw::Feature;

// --- the table -----------------------------------------------------------------------------------

// A method's work, as far as this build has it.
template <class Depth>
constexpr MethodStages<Depth> as_built(MethodStages<Depth> stages) {
    if (sizeof(Depth) > sizeof(hw::Depth16) && !built(Feature::z32)) return {};
    if (!built(Feature::ledger)) stages.frame_cost = nullptr;
    return stages;
}
constexpr auto cost_of_plan = built(Feature::ledger) ? post_process_cycles : nullptr;
constexpr std::string_view no_cost =
    built(Feature::ledger) ? "" : "the ledger is not built; build with the feature ledger";

constexpr std::array answering_lookups{Lookup::nearest, Lookup::bilinear, Lookup::filtered_depth};
constexpr std::array array_lookups{Lookup::nearest, Lookup::bilinear};
constexpr std::array graded_lookups{Lookup::percentage};
constexpr std::array all_lookups{Lookup::nearest, Lookup::bilinear, Lookup::percentage,
                                 Lookup::filtered_depth};

constexpr Method post_process_method{
    .name = "post_process",
    .meaning = "visible pixels are tested after the picture is drawn (Williams 1978)",
    .cannot = "a highlight in shadow is darkened and not left out",
    .form = Form::post_process,
    .arithmetic = Arithmetic::fixed,
    .lookups = answering_lookups,
    .max_z_bits = 26,
    .takes_floats = true,
    .depth_layers = 1,
    .surfaces = Surfaces::patches,
    .plane = ExtraPlane::normal,
    .darkness = Darkness::binary,
    .may_run_out = false,
    .takes_plane = built(Feature::surface_bias),
    .takes_normal = built(Feature::surface_bias),
    .takes_sectors = built(Feature::lights),
    .in_shading = false,
    .uses_transform_unit = true,
    .trace = Trace::clocked_post_process,
    .no_trace = "",
    .no_plan_cost = no_cost,
    .load = nullptr,
    .memory = nullptr,
    .units = fixed_units,
    .scene_cost = nullptr,
    .plan_cost = cost_of_plan,
    .stages16 = as_built(post_process_stages<hw::Depth16>),
    .stages32 = as_built(post_process_stages<hw::Depth32>)};

constexpr Method with_shares(Method method) {
    method.name = "percentage";
    method.meaning = "by percentage closer filtering (Reeves, Salesin & Cook 1987)";
    method.cannot = "no edge to dequantize, no receiver's plane, and no correct form: no sample is "
                    "shaded by a share";
    method.takes_plane = false;
    method.lookups = graded_lookups;
    method.darkness = Darkness::graded;
    return method;
}
constexpr Method percentage_method = with_shares(post_process_method);

constexpr Method correct_method{
    .name = "correct",
    .meaning = "each generated point is tested before it is shaded (Williams 1978, p. 272)",
    .cannot = "its cost grows with everything that is drawn; no light has an area, a ramp or "
              "sectors",
    .form = Form::correct,
    .arithmetic = Arithmetic::fixed,
    .lookups = answering_lookups,
    .max_z_bits = 26,
    .takes_floats = true,
    .depth_layers = 1,
    .surfaces = Surfaces::patches,
    .plane = ExtraPlane::none,
    .darkness = Darkness::binary,
    .may_run_out = false,
    .takes_plane = false,
    .takes_normal = false,
    .takes_sectors = false,
    .in_shading = true,
    .uses_transform_unit = true,
    .trace = Trace::none,
    .no_trace = "the correct form has no post-process to watch; give --set form=post_process",
    .no_plan_cost = no_cost,
    .load = nullptr,
    .memory = nullptr,
    .units = fixed_units,
    .scene_cost = nullptr,
    .plan_cost = cost_of_plan,
    .stages16 = as_built(correct_stages<hw::Depth16>),
    .stages32 = as_built(correct_stages<hw::Depth32>)};

constexpr Method array_method{
    .name = "ap120b",
    .meaning = "the post-process in the floating point of an FPS AP-120B",
    .cannot = "no correct form, no window of taps, no light with sectors, and z_bits up to 16, "
              "because the host sends 16-bit integers",
    .form = Form::post_process,
    .arithmetic = Arithmetic::ap120b,
    .lookups = array_lookups,
    .max_z_bits = 16,
    .takes_floats = false,
    .depth_layers = 1,
    .surfaces = Surfaces::patches,
    .plane = ExtraPlane::none,
    .darkness = Darkness::binary,
    .may_run_out = false,
    .takes_plane = false,
    .takes_normal = false,
    .takes_sectors = false,
    .in_shading = false,
    .uses_transform_unit = false,
    .trace = Trace::none,
    .no_trace = "only the fixed-point machine can be watched; give --set arithmetic=fixed",
    .no_plan_cost = "only the fixed-point machine has a plan; give --set arithmetic=fixed",
    .load = load_array,
    .memory = nullptr,
    .units = array_units,
    .scene_cost = nullptr,
    .plan_cost = nullptr,
    .stages16 = as_built(array_stages<hw::Depth16>),
    .stages32 = as_built(array_stages<hw::Depth32>)};

template <class Depth>
constexpr MethodStages<Depth> ground_stages{draw_on_ground<Depth>, count_on_ground<Depth>,
                                            cost_on_ground<Depth>};

constexpr Method ground_method{
    .name = "ground",
    .meaning = "the scene is drawn flat on one of its planes, from the light (Blinn 1988)",
    .cannot = "nothing but the ground is in shadow, and the ground casts none",
    .form = Form::ground,
    .arithmetic = Arithmetic::fixed,
    .lookups = all_lookups,  // there is none
    .max_z_bits = 26,
    .takes_floats = true,
    .depth_layers = 0,
    .surfaces = Surfaces::patches,
    .plane = ExtraPlane::none,
    .darkness = Darkness::binary,
    .may_run_out = false,
    .takes_plane = false,
    .takes_normal = false,
    .takes_sectors = false,
    .in_shading = false,
    .uses_transform_unit = true,
    .trace = Trace::none,
    .no_trace = "a shadow on the ground is drawn, and no pixel is tested; give "
                "--set form=post_process",
    .no_plan_cost = no_cost,
    .load = nullptr,
    .memory = nullptr,
    .units = fixed_units,
    .scene_cost = nullptr,
    .plan_cost = built(Feature::ledger) ? counted_cycles : nullptr,
    .stages16 = as_built(ground_stages<hw::Depth16>),
    .stages32 = as_built(ground_stages<hw::Depth32>)};

constexpr Method as_blobs(Method method) {
    method.name = "blob";
    method.meaning = "an ellipse on one of the scene's planes beneath each object";
    method.cannot = "no light changes its place or its shape, and nothing but the ground is in "
                    "shadow";
    method.form = Form::blob;
    return method;
}
constexpr Method blob_method = as_blobs(ground_method);

// A rival is a row of rival_rows; what it shares with a shadow on the ground is that it has no map.
constexpr Method as_rival(Method method, const RivalRow& row) {
    method.max_z_bits = 24;
    method.takes_floats = false;
    method.name = row.name;
    method.meaning = row.meaning;
    method.cannot = "curved surfaces are polygons, and no light has sectors";
    method.form = row.form;
    method.surfaces = Surfaces::facets;
    method.may_run_out = true;
    method.uses_transform_unit = false;
    method.no_trace = "a rival of the depth map looks nothing up; give --set form=post_process";
    method.memory = rival_bytes;
    method.stages16 = as_built(rival_stages<hw::Depth16>);
    method.stages32 = as_built(rival_stages<hw::Depth32>);
    return method;
}

constexpr Method as_irregular_map(Method method) {
    method.max_z_bits = 24;
    method.takes_floats = false;
    method.name = "irregular_map";
    method.meaning = "the light is sampled at the visible points: only Z is quantized (after "
                     "Johnson, Mark & Burns 2004)";
    method.cannot = "no dither, no window of taps, no receiver's plane, no light with sectors";
    method.form = Form::irregular_map;
    method.may_run_out = true;
    method.no_trace = "there is no map to look up; give --set form=post_process";
    method.memory = irregular_map_bytes;
    method.stages16 = as_built(irregular_map_stages<hw::Depth16>);
    method.stages32 = as_built(irregular_map_stages<hw::Depth32>);
    return method;
}

// The rows that are built.
constexpr std::size_t rows_built =
    1 + (built(Feature::windows) ? 1 : 0) + (built(Feature::correct_form) ? 1 : 0) +
    (built(Feature::ap120b) ? 1 : 0) + (built(Feature::ground) ? 2 : 0) +
    (built(Feature::rivals) ? 1 + rival_rows.size() : 0);

constexpr std::array<Method, rows_built> build_table() {
    std::array<Method, rows_built> rows{};
    std::size_t n = 0;
    rows[n++] = post_process_method;
    if constexpr (built(Feature::windows)) rows[n++] = percentage_method;
    if constexpr (built(Feature::correct_form)) rows[n++] = correct_method;
    if constexpr (built(Feature::ap120b)) rows[n++] = array_method;
    if constexpr (built(Feature::ground)) rows[n++] = ground_method;
    if constexpr (built(Feature::ground)) rows[n++] = blob_method;
    if constexpr (built(Feature::rivals)) rows[n++] = as_irregular_map(ground_method);
    if constexpr (built(Feature::rivals))
        for (const RivalRow& row : rival_rows) rows[n++] = as_rival(ground_method, row);
    return rows;
}
constexpr std::array<Method, rows_built> all_methods = build_table();

}  // namespace

std::span<const Method> methods() { return all_methods; }

const Method* method_of(const Settings& settings) {
    for (const Method& m : all_methods)
        if (m.form == settings.form && m.arithmetic == settings.arithmetic &&
            std::ranges::find(m.lookups, settings.lookup) != m.lookups.end())
            return &m;
    return nullptr;
}

const Method& method_of(const FrameInputs& in) {
    const Method* method = in.method != nullptr ? in.method : method_of(in.settings);
    fixed::require(method != nullptr, "no method for these settings");
    return *method;
}

bool method_can(const Settings& settings) {
    const Method* method = method_of(settings);
    return method != nullptr && settings.machine.z_bits <= method->max_z_bits &&
           (method->takes_floats || settings.machine.depth_store == hw::DepthStore::fixed) &&
           window_in_range(settings) &&
           method->takes(settings.receiver, settings.lookup);
}

}  // namespace umbra78::shadow
