// The study of error against run time: what a setting costs, and what it is worth.
//
// Errors are those of tools/metrics.hpp against exact truth, over all pixels and outside the edge
// band (one light texel mapped back and the filters' reach). Costs are the machine's cycles and
// the host's milliseconds. Host times are taken while other cases run on the other cores;
// --jobs 1 gives quieter ones.
#include "tools/study/error_time.hpp"

#include "tools/report.hpp"
#include "tools/settings_text.hpp"
#include "tools/study/shared_draw.hpp"
#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

constexpr int full_runs = 5, quick_runs = 3;

bool varies(const Request& request, std::string_view key) {
    return std::any_of(request.vary.begin(), request.vary.end(),
                       [&](const Axis& axis) { return axis.first == key; });
}

// The scene's bias in texels, as the slope errors are that it must exceed: in quanta it would
// mean another length with every width of Z.
std::vector<Axis> same_bias(const Request& request) {
    if (varies(request, "bias") || varies(request, "bias_unit")) return {};
    const shadow::Settings& s = request.scene.settings;
    const RenderJob job(request.scene.view(), s);
    const BiasReport bias = bias_report(request.scene.light, job);
    const auto word = static_cast<std::int64_t>(std::lround(std::ldexp(bias.texels, 16)));
    return {{"bias_unit", {"texels"}},
            {"bias", {tools::print(*shadow::find_setting("bias"), word)}}};
}

std::vector<Axis> with(std::vector<Axis> axes, std::vector<Axis> others) {
    for (Axis& other : others) {
        const auto found = std::find_if(axes.begin(), axes.end(), [&](const Axis& axis) {
            return axis.first == other.first;
        });
        if (found != axes.end()) {
            found->second = std::move(other.second);
        } else {
            axes.push_back(std::move(other));
        }
    }
    return axes;
}

// The grid with the filters off, then with the paper's figures' on.
std::vector<Case> both_filters(const Request& request, const std::vector<Axis>& axes) {
    const std::vector<Axis> off{{"dequantize", {"0"}}, {"low_pass", {"0"}}};
    const std::vector<Axis> on{{"dequantize", {"4"}}, {"low_pass", {"1"}}};
    return joined(grid(request, with(axes, off)), grid(request, with(axes, on)));
}

// Neighbours share what is drawn.
void put_shared_drawing_together(std::vector<Case>& cases) {
    const auto drawing = [](const Case& c) {
        std::string key;
        for (const std::string_view part :
             {"xy_bits", "z_bits", "coefficient_bits", "sampling", "form", "profile"})
            for (const std::string& set : c.set)
                if (set.starts_with(fmt::format("{}=", part))) key += set + ' ';
        return key;
    };
    std::stable_sort(cases.begin(), cases.end(), [&](const Case& a, const Case& b) {
        return drawing(a) < drawing(b);
    });
}

std::int64_t whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

void set_errors(Row& row, const LoadedScene& scene, const RenderJob& job,
                const TruthCache::Entry& known) {
    const bool has = known.truth.has_value();
    ShadowReport found;
    DepthError depth;
    if (has) {
        const std::vector<std::uint8_t> visible = job.visible();
        found = report(*known.truth, {job.bytes(Plane::filtered), visible},
                       widened(known.band, *known.truth, scene.settings));
        depth = depth_error(scene, known.truth->truth, job.buffer(Plane::observer_z));
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
    set("depth_pixels", depth.pixels);
    set("depth_min_quanta", depth.least);
    set("depth_mean_quanta", depth.mean);
    set("depth_max_quanta", depth.greatest);
    set("depth_rms_quanta", depth.rms);
}

// A profile's cycles mean something for a case that its words and its arithmetic could have made:
// as many passes of the multiplier a coefficient, and the same post-process.
bool applies(const shadow::Profile& profile, const shadow::Settings& settings) {
    shadow::Settings its = settings;
    shadow::apply(profile, its);
    const auto passes = [](const shadow::Settings& s) { return s.machine.coefficient_bits > 16; };
    return its.arithmetic == settings.arithmetic &&
           (its.arithmetic == shadow::Arithmetic::ap120b || passes(its) == passes(settings)) &&
           shadow::closes(its);
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

// Bits do not depend on a profile, its coefficients' width apart: that stays the case's.
void set_profiles(Row& row, RenderJob& job) {
    const shadow::Settings settings = job.settings();
    for (const shadow::Profile& profile : shadow::profiles()) {
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

void set_times(Row& row, const SharedDraw& draw) {
    row.set("light_host_ms", draw.light.median_ms);
    row.set("observer_host_ms", draw.observer.median_ms);
    row.set("post_process_host_ms", draw.post_process.median_ms);
    row.set("filters_host_ms", draw.filters.median_ms);
    row.set("total_host_ms", draw.total_ms());
    row.set("spread_host_ms", draw.spread_ms());
}

class ErrorTime final : public Study {
public:
    std::string_view name() const override { return "error-time"; }
    std::string_view meaning() const override {
        return "Error against run time: what each setting costs, and what it is worth";
    }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&) const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_error_time(request, rows, to);
    }

private:
    TruthCache truths_;
};

// A main grid, and the other axes one at a time about the scene's own widths: the whole product
// would take hours and say the same.
std::vector<Case> ErrorTime::cases(const Request& request) const {
    const std::vector<Axis> bias = same_bias(request);
    const Axis lookup{"lookup", {"nearest", "bilinear"}};
    if (request.quick) {
        const std::vector<Axis> axes{{"xy_bits", {"7"}}, lookup, {"dither", {"none", "normal"}}};
        return both_filters(request, with(axes, bias));
    }
    const std::vector<Axis> main{{"form", {"post_process", "correct"}},
                                 {"xy_bits", {"8", "9", "10"}},
                                 lookup,
                                 {"dither", {"none", "uniform", "normal"}}};
    std::vector<Case> all = both_filters(request, with(main, bias));
    const std::vector<Axis> about{lookup, {"dither", {"none", "normal"}}};
    std::vector<Axis> alone{{"z_bits", {"12", "20"}},
                            {"coefficient_bits", {"12"}},
                            {"sampling", {"leaf"}},
                            {"dither", {"triangular", "normal4"}},
                            {"profile", {"ap120b"}}};
    if (!bias.empty()) alone.push_back({"bias", {"0.25", "0.5", "1", "2", "3", "4", "6"}});
    for (const Axis& axis : alone)
        all = joined(std::move(all), both_filters(request, with(with(about, bias), {axis})));
    put_shared_drawing_together(all);
    return all;
}

Row ErrorTime::run(const Request& request, const Case& c) const {
    // A thread goes through neighbouring cases; its frame is drawn anew where it must be.
    thread_local SharedDraw shared;
    const LoadedScene scene = scene_of(request, c);
    RenderJob& drawn = shared.draw(request.scene_text, scene,
                                     request.quick ? quick_runs : full_runs);
    Row row;
    for (const Plane plane : {Plane::mask, Plane::filtered, Plane::picture})
        row.set(fmt::format("{}_hash", name_of(plane)), hash_of(drawn.buffer(plane)));
    set_errors(row, scene, drawn, *truths_.of(scene));
    row.set("frame_bytes", whole(drawn.frame_bytes()));
    set_cycles(row, "", drawn);
    set_profiles(row, drawn);
    set_times(row, shared);
    return row;
}

}  // namespace

std::unique_ptr<Study> make_error_time_study() { return std::make_unique<ErrorTime>(); }

}  // namespace umbra78::tools::study
