// umbra78 study contours: which passes of the filters make a shadow's contour smooth, and what it
// costs.
//
// Williams' figure 5 filters the shadows "to smooth the contours and merge the dithered edge of
// self shadowing". One kind of case draws the scene, filters its mask and compares the contour at
// half darkness with the exact edge, cast and self shadow apart. The other kind draws no scene: it
// filters bars and spots 2, 4 and 8 pixels wide and counts what is left of them. Rates of wrong
// pixels hardly change with the passes, so they cannot choose among them.
#include "tools/study/contours/contours.hpp"

#include "tools/render/render_job.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/study/contours/roughness.hpp"
#include "tools/study/contours/small_shadows.hpp"
#include "tools/study/grid.hpp"
#include "tools/study/measures.hpp"
#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools::study {
namespace {

std::vector<std::string> numbers(int from, int to, int step) {
    std::vector<std::string> all;
    for (int n = from; n <= to; n += step) all.push_back(std::to_string(n));
    return all;
}

std::vector<Case> of_kind(const std::string& kind, std::vector<Case> cases) {
    for (Case& c : cases) {
        if (kind == "small") c.name = "small shadows " + c.name;
        c.extra.emplace_back("measured", kind);
    }
    return cases;
}

void set_edge(Row& row, const std::string& name, const EdgeRoughness& r) {
    row.set(name + "_exact_px", r.exact_px);
    row.set(name + "_length_ratio", r.length_ratio);
    row.set(name + "_rough_px", r.rms_px);
    row.set(name + "_moved_px", r.displacement_px);
    row.set(name + "_moved_rms_px", r.displacement_rms_px);
    row.set(name + "_max_px", r.max_px);
}

class Contours final : public Study {
public:
    std::string_view name() const override { return "contours"; }
    std::string_view meaning() const override {
        return "How smooth the filters make a shadow's contour, and what they take from it";
    }
    std::vector<Case> cases(const Request&) const override;
    std::optional<LoadedScene> scene(const Request&, const Case&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_contours(request, rows, to);
    }

private:
    static Row run_small(const LoadedScene&);
    Row run_edges(const LoadedScene&) const;
    TruthCache truths_;
};

std::vector<Case> Contours::cases(const Request& request) const {
    std::vector<GridKey> axes{
        {"dither", {"none", "normal"}},
        {"bias", {"64", "128", "192", "256", "384"}},
        {"dequantize", numbers(0, shadow::max_dequantize_passes, 1)},
        {"low_pass", numbers(0, 8, 1)}};
    std::vector<GridKey> small(axes.begin() + 2, axes.end());
    if (request.quick) {
        axes = {{"dither", {"normal"}}, {"bias", {"192"}},
                {"dequantize", {"0", "1", "4"}}, {"low_pass", {"0", "1", "2", "8"}}};
        small = {axes.begin() + 2, axes.end()};
    }
    axes.insert(axes.begin() + 1, {"bias_unit", {"quanta"}});
    constexpr std::array<std::string_view, 3> not_small{"dither", "bias", "bias_unit"};
    return joined(of_kind("edges", grid(request, axes)),
                  of_kind("small", grid(for_sweep(request, not_small, {}), small)));
}

std::optional<LoadedScene> Contours::scene(const Request& request, const Case& c) const {
    return scene_of(request, c);
}

Row Contours::run_small(const LoadedScene& scene) {
    const Passes passes{scene.settings.dequantize_passes, scene.settings.low_pass_passes};
    Row row;
    for (const WidthLimit& limit : width_limits) {
        row.set(fmt::format("lost_bar_{}", limit.width_px),
                lost_area(SmallShadow::bar, limit.width_px, passes));
        row.set(fmt::format("lost_spot_{}", limit.width_px),
                lost_area(SmallShadow::spot, limit.width_px, passes));
    }
    return row;
}

Row Contours::run_edges(const LoadedScene& scene) const {
    const auto traced = truths_.needed(scene);
    if (!traced->truth.closed_form)
        throw SceneError("the exact edge of free patches is not known; use spheres and planes");
    RenderJob job(scene.view(), scene.settings);
    job.render();
    const std::vector<std::uint8_t> visible = job.visible();
    const Truth& truth = traced->truth.truth;
    const auto cells = cells_of_one_surface(truth, visible);
    const auto exact = shadow_edges(traced->truth, cells);
    const auto mask = job.bytes(Plane::filtered);
    const Roughness rough = roughness(exact, mask_contours(truth.size, mask, cells), truth.size);
    Row row;
    set_edge(row, "cast", rough[EdgeKind::cast]);
    set_edge(row, "self", rough[EdgeKind::self]);
    row.set("stray_px", rough.stray_px);
    const MachineMask drawn{mask, visible};
    const Buffer depths = job.buffer(Plane::observer_z);
    const ShadowReport made = tools::report(traced->truth, drawn, traced->band, &depths);
    const ShadowError& error = made.all;
    set_coverage(row, *made.coverage);
    row.set("false_shadow", error.false_shadow_rate());
    row.set("false_light", error.false_light_rate());
    row.set("filter_cycles", static_cast<std::int64_t>(job.ledger().filters(false)));
    return row;
}

Row Contours::run(const Request&, const Case& c, const LoadedScene* scene) const {
    return c.extra.at(0).second == "small" ? run_small(*scene) : run_edges(*scene);
}

std::vector<ColumnMeaning> Contours::columns() const {
    return {
        {"measured", "edges: the scene's contours; small: what is left of small shadows"},
        {"*_exact_px", "length of the exact edge of cast shadows, or of the surfaces' own shadow "
                       "lines (self), pixels"},
        {"*_length_ratio", "length of the drawn contour nearest to it, over its own"},
        {"*_rough_px", "rms distance of the contour from a straight line fitted in windows of 16 "
                       "pixels, pixels"},
        {"*_moved_px", "mean displacement of the contour, positive where the shadow is too large"},
        {"*_moved_rms_px", "rms of the windows' displacements, pixels"},
        {"*_max_px", "greatest distance of the contour from the exact edge, pixels"},
        {"stray_px", "length of contours more than 24 pixels from any exact edge"},
        {"false_shadow", "share of the pixels lit in truth that the filtered mask shadows, 0 .. 1"},
        {"false_light", "share of the pixels shadowed in truth that it lights, 0 .. 1"},
        {"filter_cycles", "cycles of the machine for filters and composite, one unit at a time"},
        {"lost_*", "share of the pixels of a bar or a spot so many pixels wide that the filters "
                   "make lighter than half, 0 .. 1"},
    };
}

}  // namespace

std::unique_ptr<Study> make_contours_study() { return std::make_unique<Contours>(); }

}  // namespace umbra78::tools::study
