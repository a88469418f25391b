// umbra78 study error-time: what a setting costs, and how much error it saves.
//
// Errors are those of tools/truth/metrics.hpp against exact truth, over all pixels and outside the
// edge band (one light texel mapped back to the observer, and the filters' reach). Costs are the
// machine's cycles, and the host's milliseconds: the thread's own time on a processor. Other cases
// run on the other cores meanwhile and share the caches; --jobs 1 gives quieter times.
#include "tools/study/error_time/error_time.hpp"

#include "shadow/frame/paper_scene_words.hpp"
#include "tools/render/report.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/study/error_time/shared_draw.hpp"
#include "tools/study/grid.hpp"
#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

constexpr int full_runs = 5, quick_runs = 3;

bool varies(const Request& request, std::string_view key) {
    return std::any_of(request.vary.begin(), request.vary.end(),
                       [&](const GridKey& axis) { return axis.first == key; });
}

// The scene's bias in texels, in which the slope errors that it must exceed are constant. In quanta
// it would be another length with every width of Z.
std::vector<GridKey> same_bias(const Request& request) {
    if (varies(request, "bias") || varies(request, "bias_unit")) return {};
    const shadow::Settings& s = request.scene.settings;
    const RenderJob job(request.scene.view(), s);
    const BiasReport bias = bias_report(job);
    const auto word = static_cast<std::int64_t>(std::lround(std::ldexp(bias.texels, 16)));
    return {{"bias_unit", {"texels"}},
            {"bias", {tools::print(*shadow::find_setting("bias"), word)}}};
}

std::vector<GridKey> with(std::vector<GridKey> axes, std::vector<GridKey> others) {
    for (GridKey& other : others) {
        const auto found = std::find_if(axes.begin(), axes.end(), [&](const GridKey& axis) {
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

// The grid with the filters off, then with as many passes as figure 5 has.
std::vector<Case> both_filters(const Request& request, const std::vector<GridKey>& axes) {
    using namespace shadow::paper_scene;
    const std::vector<GridKey> off{{"dequantize", {"0"}}, {"low_pass", {"0"}}};
    const std::vector<GridKey> on{{"dequantize", {std::to_string(dequantize_passes)}},
                                  {"low_pass", {std::to_string(low_pass_passes)}}};
    return joined(grid(request, with(axes, off)), grid(request, with(axes, on)));
}

// Sorts cases that share drawn views next to one another, for SharedDraw.
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
    Takes takes() const override { return {.only = true}; }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_error_time(request, rows, to);
    }

private:
    TruthCache truths_;
};

// A main grid, and the other keys one at a time with the scene's own widths. The product of all
// keys would take hours.
std::vector<Case> ErrorTime::cases(const Request& request) const {
    if (request.only) {
        std::vector<Case> all = grid(request, {});
        put_shared_drawing_together(all);
        return all;
    }
    const std::vector<GridKey> bias = same_bias(request);
    const GridKey lookup{"lookup", {"nearest", "bilinear"}};
    if (request.quick) {
        const std::vector<GridKey> axes{{"xy_bits", {"7"}}, lookup, {"dither", {"none", "normal"}}};
        return both_filters(request, with(axes, bias));
    }
    const std::vector<GridKey> main{{"form", {"post_process", "correct"}},
                                 {"xy_bits", {"8", "9", "10"}},
                                 lookup,
                                 {"dither", {"none", "uniform", "normal"}}};
    std::vector<Case> all = both_filters(request, with(main, bias));
    const std::vector<GridKey> about{lookup, {"dither", {"none", "normal"}}};
    std::vector<GridKey> alone{{"z_bits", {"12", "20"}},
                            {"coefficient_bits", {"12"}},
                            {"sampling", {"leaf"}},
                            {"dither", {"triangular", "normal4"}},
                            {"profile", {"ap120b"}}};
    if (!bias.empty()) alone.push_back({"bias", {"0.25", "0.5", "1", "2", "3", "4", "6"}});
    for (const GridKey& axis : alone)
        all = joined(std::move(all), both_filters(request, with(with(about, bias), {axis})));
    put_shared_drawing_together(all);
    return all;
}

Row ErrorTime::run(const Request& request, const Case&, const LoadedScene* scene) const {
    // A thread goes through neighbouring cases; what they share is drawn once.
    thread_local SharedDraw shared;
    const int runs = !request.host_times ? 1 : request.quick ? quick_runs : full_runs;
    RenderJob& drawn = shared.draw(request.scene_text, *scene, runs);
    Row row = error_time_row(*scene, drawn, truths_.of(*scene).get());
    set_times(row, shared);
    return row;
}

std::vector<ColumnMeaning> ErrorTime::columns() const {
    return {
        {"*_hash", "FNV-1a-64 of a plane of the frame: equal hashes, equal pixels"},
        {"lit_pixels", "pixels that truth lights and both see"},
        {"shadowed_pixels", "pixels that truth shadows and both see"},
        {"false_shadow", "share of the lit pixels that the filtered mask shadows, 0 .. 1"},
        {"false_light", "share of the shadowed pixels that the filtered mask lights, 0 .. 1"},
        {"wrong", "share of all pixels seen that are in false shadow or false light, 0 .. 1"},
        {"outside_*", "the same without the edge band: pixels within a light texel (mapped back "
                      "to the observer) and the filters' reach of a shadow's edge in truth"},
        {"isolated_pixels", "drawn pixels none of whose four neighbours has the same answer"},
        {"edge_mean_px", "mean distance of the drawn shadow's edge from the true one, and of the "
                         "true one from the drawn one, pixels; the edges of acne count"},
        {"edge_hausdorff_px", "the maximum of those distances, pixels"},
        {"edge_mean_world", "edge_mean_px in world units, comparable across resolutions"},
        {"depth_pixels", "pixels whose Z is compared with truth, away from silhouettes"},
        {"depth_*", "drawn Z minus exact Z over those pixels, quanta: min, mean, max, rms"},
        {"frame_bytes", "memory of the frame's planes on this computer, bytes"},
        {"*_cycles", "cycles of the machine, simulated: of the frame, or of the transformation "
                     "alone; before them the profile's name, empty where it cannot draw the case"},
        {"*_machine_ms", "those cycles in milliseconds of the machine's clock"},
        {"spread_host_ms", "maximum minus minimum of the repeated runs, ms, summed over stages"},
        {"*_host_ms", "this computer's time for a stage or for all, ms, median of repeated runs"},
    };
}

}  // namespace

std::unique_ptr<Study> make_error_time_study() { return std::make_unique<ErrorTime>(); }

}  // namespace umbra78::tools::study
