// umbra78 study rivals: what Crow's classes cost and miss beside the depth map of 1978.
//
// Crow 1977 described three classes of shadow algorithms and found the third the most appealing;
// Williams' depth map came a year later; nobody has measured them together. Here each draws the
// mask of one scene: the depth map on the patches and on facets, and the exact rivals on facets,
// over how finely patches are diced and over the picture's resolution. Two truths are kept apart.
// Against the polygons' own, which is brute force, an exact rival has no wrong pixel. Against the
// smooth surfaces' every one has those that dicing makes.
#include "tools/study/rivals/rivals.hpp"

#include "shadow/frame/methods.hpp"
#include "shadow/rivals/dicing.hpp"
#include "tools/render/report.hpp"
#include "tools/study/grid.hpp"
#include "tools/truth/scene_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using shadow::Form;

// Where a surface turns from the light: |cosine| below this, 11.5 degrees, which facets get wrong.
constexpr double terminator_cosine = 0.2;

class Rivals final : public Study {
public:
    std::string_view name() const override { return "rivals"; }
    std::string_view meaning() const override {
        return "Crow's three classes and the depth map: errors, operations, growth";
    }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_rivals(request, rows, to);
    }

private:
    TruthCache truths_;
};

struct Drawn {
    const char *method, *form, *surface;
};

// The depth map on patches and on the rivals' facets, then the rows of the table of methods.
std::vector<Drawn> methods_drawn() {
    std::vector<Drawn> all{{"depth map, patches", "post_process", "catmull"},
                           {"depth map, facets", "post_process", "diced"}};
    for (const shadow::Method& m : shadow::methods())
        if (shadow::is_rival(m.form)) all.push_back({m.name.data(), m.name.data(), "diced"});
    return all;
}

std::vector<Case> Rivals::cases(const Request& request) const {
    std::vector<Case> all;
    const auto add = [&](std::string_view question, const Drawn& d, std::vector<GridKey> axes) {
        axes.insert(axes.end(), {{"form", {d.form}},
                                 {"surface", {d.surface}},
                                 {"dequantize", {"0"}},
                                 {"low_pass", {"0"}}});
        for (Case c : grid(request, axes)) {
            c.extra = {{"question", std::string(question)}, {"method", d.method}};
            c.name = fmt::format("{}: {}, {}", question, d.method, c.name);
            all.push_back(std::move(c));
        }
    };
    using Values = std::vector<std::string>;
    const Values levels = request.quick ? Values{"1", "2"} : Values{"1", "2", "3", "4"};
    const Values bits = request.quick ? Values{"5", "6"} : Values{"7", "8", "9", "10"};
    const Values level = request.quick ? Values{"2"} : Values{"3"};
    for (const Drawn& d : methods_drawn()) {
        const bool patches = std::string_view(d.surface) == "catmull";
        std::vector<GridKey> axes{{"dice_levels", patches ? level : levels}};
        if (request.quick) axes.push_back({"xy_bits", {"6"}});
        add(by_dicing, d, axes);
        add(by_resolution, d, {{"xy_bits", bits}, {"dice_levels", level}});
    }
    return all;
}

// Facets that a rival has, before those without three vertices are left out.
std::int64_t facets_of(const LoadedScene& scene) {
    return static_cast<std::int64_t>(
        shadow::rivals::diced_size(scene.surfaces(), scene.settings.dice_levels).facets);
}

// Pixels that differ from brute force on the same polygons.
std::int64_t wrong_on_polygons(const LoadedScene& scene, const RenderJob& job) {
    shadow::Settings settings = scene.settings;
    settings.form = Form::brute;
    RenderJob brute(scene.view(), settings);
    draw_mask(brute);
    const auto right = brute.bytes(Plane::mask), mask = job.bytes(Plane::mask);
    std::int64_t wrong = 0;
    for (std::size_t at = 0; at < mask.size(); ++at) wrong += mask[at] != right[at] ? 1 : 0;
    return wrong;
}

void set_wrong(Row& row, const SceneTruth& truth, const MachineMask& mask) {
    std::int64_t terminator = 0, cast = 0, compared = 0;
    const Truth& t = truth.truth;
    for (std::size_t at = 0; at < t.visible.size(); ++at) {
        if (!t.visible[at] || !mask.drawn(at) || truth.unlit_side[at]) continue;
        ++compared;
        if (mask.in_shadow(at) != (t.lit[at] != 0)) continue;
        ++(std::abs(t.n_dot_l[at]) < terminator_cosine ? terminator : cast);
    }
    row.set("compared_px", compared);
    row.set("wrong_cast_px", cast);
    row.set("wrong_terminator_px", terminator);
}

Row Rivals::run(const Request&, const Case&, const LoadedScene* drawn) const {
    const LoadedScene& scene = *drawn;
    RenderJob job(scene.view(), scene.settings);
    draw_mask(job);
    const bool rival = shadow::is_rival(scene.settings.form);
    Row row;
    row.set("facets", facets_of(scene));
    row.set("mask_hash", hash_of(job.buffer(Plane::mask)));
    row.set("wrong_on_polygons_px",
            rival ? Value(wrong_on_polygons(scene, job)) : Value(std::monostate{}));
    if (const auto truth = truths_.of(scene)) {
        const std::vector<std::uint8_t> visible = job.visible();
        const MachineMask mask{job.bytes(Plane::mask), visible};
        set_wrong(row, truth->truth, mask);
        const ShadowReport errors = tools::report(truth->truth, mask, truth->band);
        row.set("false_shadow", errors.all.false_shadow_rate());
        row.set("false_light", errors.all.false_light_rate());
        row.set("edge_mean_px", errors.edge.mean);
    }
    const shadow::FrameLedger l = job.ledger();
    const auto cycles = [&](const char* column, std::uint64_t n) {
        row.set(column, static_cast<std::int64_t>(n));
    };
    const std::uint64_t map = shadow::FrameLedger::cycles(l.light, true);
    cycles("once_cycles", l.scene.units.side_by_side());
    cycles("map_cycles", map);
    cycles("test_cycles", l.transformation(true));
    cycles("shadow_cycles", map + l.transformation(true));
    cycles("observer_cycles", shadow::FrameLedger::cycles(l.observer, true));
    row.set("frame_bytes", static_cast<std::int64_t>(job.frame_bytes()));
    const StageTimes& t = job.times();
    row.set("shadow_host_ms", t.light_ms + t.post_process_ms);
    return row;
}

std::vector<ColumnMeaning> Rivals::columns() const {
    return {
        {"question", "what is varied: how finely patches are diced, or the picture's resolution"},
        {"method", "the depth map on patches or on facets, or a rival's name"},
        {"facets", "that patches and meshes make; the depth map on patches does not read them"},
        {"mask_hash", "FNV-1a-64 of the mask: equal hashes, equal pixels"},
        {"wrong_on_polygons_px", "pixels that differ from brute force on the same polygons; empty "
                                 "for the depth map"},
        {"compared_px", "pixels that both truth and the machine see"},
        {"wrong_cast_px", "of them, those that differ from the smooth surfaces' truth away from "
                          "where the surface turns from the light"},
        {"wrong_terminator_px", "those that differ where the cosine of surface and light is below "
                                "0.2: attached shadow, which facets get wrong, and acne"},
        {"false_shadow", "share of the pixels lit in smooth truth that the mask shadows, 0 .. 1"},
        {"false_light", "share of the pixels shadowed in smooth truth that the mask lights"},
        {"edge_mean_px", "mean distance of the drawn shadow's edge from the true one and back"},
        {"once_cycles", "cycles of the machine once for a scene and a light, simulated"},
        {"*_cycles", "cycles for each frame, simulated, units side by side: of the light's map, of "
                     "the test, of both, of the observer's view"},
        {"frame_bytes", "memory of the frame and of what the method keeps, on this computer"},
        {"shadow_host_ms", "this computer's time for the light's map and the test, ms"},
    };
}

}  // namespace

PowerLaw power_law(std::span<const std::pair<double, double>> points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    PowerLaw law{std::nan(""), std::nan(""), INFINITY, 0};
    for (const auto& [px, py] : points) {
        if (!(px > 0) || !(py > 0)) continue;
        const double u = std::log(px), v = std::log(py);
        ++n, x += u, y += v, xx += u * u, xy += u * v;
        law.from = std::min(law.from, px);
        law.to = std::max(law.to, px);
    }
    const double spread = n * xx - x * x;
    if (n < 2 || !(spread > 1e-9)) return law;
    law.exponent = (n * xy - x * y) / spread;
    law.factor = std::exp((y - law.exponent * x) / n);
    return law;
}

std::unique_ptr<Study> make_rivals_study() { return std::make_unique<Rivals>(); }

}  // namespace umbra78::tools::study
