#include "shadow/frame/methods.hpp"

#include "shadow/ap120b/post_process.hpp"
#include "shadow/correct_form.hpp"
#include "shadow/frame/bias_cost.hpp"
#include "shadow/frame/costs.hpp"
#include "shadow/frame/drawing.hpp"
#include "shadow/frame/sector_stage.hpp"
#include "shadow/frame/ground.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace umbra78::shadow {
namespace {

using hw::built;
using hw::Feature;

hw::UnitCycles fixed_units(const hw::Operations& o, const Settings& s) {
    return hw::unit_cycles(o, s.machine);
}

// --- the post-process ----------------------------------------------------------------------------

template <class Depth>
void cast_post_process(const FrameInputs& in, const FramePlan& plan, std::size_t l,
                       FrameBuffers<Depth>& frame, FrameCounts& counts) {
    if constexpr (built(Feature::lights)) {
        if (in.scene.source_of(l).sectored) return cast_sectors(in, plan, l, frame, counts);
    }
    LightBuffers<Depth>& light = frame.lights[l];
    const hw::MatrixWords& matrix = in.matrices.lights[l].observer_to_light;
    PostProcessCounts& counted = counts.lights[l].post_process;
    if constexpr (built(Feature::rows) && sizeof(Depth) == sizeof(hw::Depth16)) {
        if (work_of(plan) == needed_work(in.settings) && rows_cover(in.settings, matrix)) {
            counted = post_process_rows(frame.maps(l), matrix, in.settings, *frame.rows,
                                        light.mask);
            return;
        }
    }
    counted = post_process(frame.maps(l), matrix, in.settings, work_of(plan), light.mask,
                           receiver_words(in, l));
}

// The schedule of the observer's visible pixels through the clocked stages.
template <class Depth>
void cost_of_post_process(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>& frame,
                          const FrameCounts&, FrameLedger& ledger) {
    if (!has_pass(in, l)) return;
    const PostProcessPipeline pipeline(in.settings, in.matrices.lights[l].observer_to_light);
    ledger.test.operations += ledger.visible * test_operations(in, l);
    ledger.test.units = fixed_units(ledger.test.operations, in.settings);
    ledger.post_process = closed_form(
        schedule<Depth>(frame.observer.depth, in.settings.machine.background(),
                        pipeline.read_cycles, pipeline.slot_cycles),
        pipeline);
}

template <class Depth>
constexpr MethodStages<Depth> post_process_stages{nullptr, cast_post_process<Depth>,
                                                  cost_of_post_process<Depth>};

// --- the correct form ----------------------------------------------------------------------------

template <class Depth>
void draw_correct_form(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                       FrameCounts& counts) {
    const Settings& settings = in.settings;
    TestedLights<Depth> lights;
    fixed::require(in.scene.light_count == in.scene.sources_used(),
                   "the correct form has no lights with area");
    for (std::size_t l = 0; l < in.scene.light_count; ++l) {
        if (plan.leaves_out(Omission::post_process, l)) continue;  // its mask is lit already
        LightBuffers<Depth>& light = frame.lights[l];
        lights[l].emplace(TestedLight<Depth>{
            light_map<Depth>(light.map, settings),
            hw::TransformUnit(settings.machine, in.matrices.lights[l].observer_to_light,
                              plan.unit_work()),
            light.mask});
    }
    CorrectSink<Depth> sink(frame.observer, lights, settings, work_of(plan).noise);
    counts.observer = draw_view(in, plan, in.scene.observer, in.matrices.world_to_observer, frame,
                                sink);
}

template <class Depth>
void count_correct_form(const FrameInputs&, const FramePlan&, std::size_t l,
                        FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const std::span<const std::uint8_t> mask = frame.lights[l].mask;
    counts.lights[l].post_process.visible = counts.observer.samples;
    counts.lights[l].post_process.shadowed =
        static_cast<std::uint64_t>(std::count(mask.begin(), mask.end(), mask_shadow));
}

// Each generated point goes through the same stages, at the slots' pace.
template <class Depth>
void cost_of_correct_form(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                          const FrameCounts&, FrameLedger& ledger) {
    const PostProcessPipeline pipeline(in.settings, in.matrices.lights[l].observer_to_light);
    const std::uint64_t points = ledger.observer_counts.samples;
    const int pace = std::max(pipeline.slot_cycles, pipeline.read_cycles);
    Schedule s;
    s.visible = s.pixels = points;
    if (points > 0) s.last_issue = (points - 1) * static_cast<std::uint64_t>(pace);
    ledger.post_process = closed_form(s, pipeline);
}

template <class Depth>
constexpr MethodStages<Depth> correct_stages{draw_correct_form<Depth>, count_correct_form<Depth>,
                                             cost_of_correct_form<Depth>};

// --- the AP-120B ---------------------------------------------------------------------------------

void load_array(const hw::RationalMatrix& exact, const Settings& settings, LightMatrices& out) {
    out.array = array_matrix(exact, settings);
}

hw::UnitCycles array_units(const hw::Operations& o, const Settings& s) {
    return hw::ap120b_cycles(o, s.array_memory == hw::ap120b::MemorySpeed::fast ? 1 : 2);
}

template <class Depth>
void cast_on_array(const FrameInputs& in, const FramePlan&, std::size_t l,
                   FrameBuffers<Depth>& frame, FrameCounts& counts) {
    const LightMatrices& m = in.matrices.lights[l];
    counts.lights[l].post_process =
        array_post_process(frame.maps(l), m.array, m.observer_to_light.affine, in.settings,
                           frame.lights[l].mask);
}

template <class Depth>
void cost_on_array(const FrameInputs& in, std::size_t l, const FrameBuffers<Depth>&,
                   const FrameCounts& counts, FrameLedger& ledger) {
    ledger.on_array = true;
    ledger.array = array_cost(counts.lights[l].post_process, in.settings,
                              in.settings.array_memory,
                              in.matrices.lights[l].observer_to_light.affine);
}

template <class Depth>
constexpr MethodStages<Depth> array_stages{nullptr, cast_on_array<Depth>, cost_on_array<Depth>};

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
    .max_z_bits = 24,
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
    .max_z_bits = 24,
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
    .max_z_bits = 24,
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
    .units = fixed_units,
    .scene_cost = nullptr,
    .plan_cost = built(Feature::ledger) ? ground_cycles : nullptr,
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

// The rows that are built.
constexpr std::size_t rows_built =
    1 + (built(Feature::windows) ? 1 : 0) + (built(Feature::correct_form) ? 1 : 0) +
    (built(Feature::ap120b) ? 1 : 0) + (built(Feature::ground) ? 2 : 0);

constexpr std::array<Method, rows_built> build_table() {
    std::array<Method, rows_built> rows{};
    std::size_t n = 0;
    rows[n++] = post_process_method;
    if constexpr (built(Feature::windows)) rows[n++] = percentage_method;
    if constexpr (built(Feature::correct_form)) rows[n++] = correct_method;
    if constexpr (built(Feature::ap120b)) rows[n++] = array_method;
    if constexpr (built(Feature::ground)) rows[n++] = ground_method;
    if constexpr (built(Feature::ground)) rows[n++] = blob_method;
    return rows;
}
constexpr std::array<Method, rows_built> table = build_table();

}  // namespace

std::span<const Method> methods() { return table; }

const Method* method_of(const Settings& settings) {
    for (const Method& m : table)
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
           window_in_range(settings) &&
           method->takes(settings.receiver, settings.lookup);
}

}  // namespace umbra78::shadow
