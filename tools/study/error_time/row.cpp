// The figures of one case of the study of error against run time, except host times.
#include "tools/study/error_time/error_time.hpp"

#include "shadow/frame/profiles.hpp"
#include "tools/study/measures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools::study {
namespace {

std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

void set_errors(Row& row, const LoadedScene& scene, const RenderJob& job, const Traced* known) {
    const bool has = known != nullptr;
    ShadowReport found;
    DepthError depth;
    if (has) {
        const std::vector<std::uint8_t> visible = job.visible();
        const Buffer depths = job.buffer(Plane::observer_z);
        found = report(known->truth, {job.bytes(Plane::filtered), visible},
                       widened(known->band, known->truth, scene.settings), &depths);
        depth = depth_error(scene, known->truth.truth, job.buffer(Plane::observer_z));
    }
    const auto set = [&](const char* column, auto value) {
        row.set(column, has ? Value(value) : Value());
    };
    const auto wrong = [](const ShadowError& e) {
        return double(e.false_shadow + e.false_light) / std::max(e.lit + e.shadowed, 1);
    };
    const ShadowError &all = found.all, &out = found.outside_band;
    set("lit_pixels", std::int64_t{all.lit});
    set("shadowed_pixels", std::int64_t{all.shadowed});
    set("false_shadow", all.false_shadow_rate());
    set("false_light", all.false_light_rate());
    set("wrong", wrong(all));
    set("outside_lit_pixels", std::int64_t{out.lit});
    set("outside_shadowed_pixels", std::int64_t{out.shadowed});
    set("outside_false_shadow", out.false_shadow_rate());
    set("outside_false_light", out.false_light_rate());
    set("outside_wrong", wrong(out));
    set("isolated_pixels", std::int64_t{found.isolated_pixels});
    set("edge_mean_px", found.edge.mean);
    set("edge_hausdorff_px", found.edge.hausdorff);
    set("edge_mean_world", has ? found.edge.mean * known->truth.observer.pixel() : 0);
    for (const ColumnMeaning& column : coverage_columns) row.set(column.name, Value());
    if (has) set_coverage(row, *found.coverage);
    set("depth_pixels", depth.pixels);
    set("depth_min_quanta", depth.min);
    set("depth_mean_quanta", depth.mean);
    set("depth_max_quanta", depth.max);
    set("depth_rms_quanta", depth.rms);
}

// Whether the profile's machine could have drawn the case, so that its cycles mean something: it
// makes as many passes of the multiplier for a coefficient, and has the same post-process. A
// profile that names no arithmetic is one of the fixed-point machine.
bool applies(const shadow::Profile& profile, const shadow::Settings& settings) {
    shadow::Settings its, both = settings;
    shadow::apply(profile, its);
    shadow::apply(profile, both);
    const bool same_passes =
        (its.machine.coefficient_bits > 16) == (settings.machine.coefficient_bits > 16);
    const shadow::Method *its_method = shadow::method_of(its), *method =
    shadow::method_of(settings);
    return its_method != nullptr && method != nullptr &&
           its_method->arithmetic == method->arithmetic &&
           (!method->uses_transform_unit || same_passes) && shadow::can_be_built(both);
}

void set_cycles(Row& row, const std::string& prefix, const RenderJob& job) {
    const shadow::FrameLedger ledger = job.ledger();
    const int clock_ns = job.settings().timing.clock_ns;
    const auto set = [&](const char* column, std::uint64_t cycles) {
        row.set(fmt::format("{}{}_cycles", prefix, column), whole(cycles));
        row.set(fmt::format("{}{}_machine_ms", prefix, column), simulated_ms(cycles, clock_ns));
    };
    set("frame", ledger.total(true));
    set("transformation", ledger.transformation(true));
}

// A profile changes no bit of the picture except by the coefficients' width, and that stays the
// case's.
void set_profiles(Row& row, RenderJob& job) {
    const shadow::Settings settings = job.settings();
    for (const shadow::Profile& profile : shadow::profiles_of_1978()) {
        const std::string prefix = fmt::format("{}_", profile.name);
        if (!applies(profile, settings)) {
            for (const char* column : {"frame", "transformation"})
                for (const char* unit : {"cycles", "machine_ms"})
                    row.set(fmt::format("{}{}_{}", prefix, column, unit), Value());
            continue;
        }
        shadow::Settings its = settings;
        shadow::apply(profile, its);
        its.machine.coefficient_bits = settings.machine.coefficient_bits;
        job.use(its);
        set_cycles(row, prefix, job);
    }
    job.use(settings);
}

}  // namespace

Row error_time_row(const LoadedScene& scene, RenderJob& drawn, const Traced* known) {
    Row row;
    for (const Plane plane : {Plane::mask, Plane::filtered, Plane::picture})
        row.set(drawn.buffer(plane).name + "_hash", hash_of(drawn.buffer(plane)));
    set_errors(row, scene, drawn, known);
    row.set("frame_bytes", whole(drawn.frame_bytes()));
    set_cycles(row, "", drawn);
    set_profiles(row, drawn);
    return row;
}

}  // namespace umbra78::tools::study
