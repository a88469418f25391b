// umbra78 study stability: stiff and extreme cases, one row each, with the verdict "holds".
#include "tools/study/stability/stability.hpp"
#include "tools/study/study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

Case case_of(std::string_view name, std::string_view kind, std::string_view must) {
    return {std::string(name), {}, {{"name", std::string(name)}, {"kind", std::string(kind)},
                                    {"must", std::string(must)}}};
}

std::vector<FrameCase> frames() {
    std::vector<FrameCase> all = stiff_frames();
    for (FrameCase& c : extreme_frames()) all.push_back(std::move(c));
    return all;
}

// The frame case of that name; nothing for a limit or a unit.
std::optional<FrameCase> frame_named(std::string_view name) {
    for (FrameCase& c : frames())
        if (c.name == name) return std::move(c);
    return std::nullopt;
}

// The case of that name among all three lists. A frame's scene is null if it is refused.
Finding examine_named(std::string_view name, const LoadedScene* scene, const Effort& effort) {
    if (const auto frame = frame_named(name))
        return scene != nullptr ? examine(*frame, *scene) : examine(*frame, effort);
    for (const LimitCase& c : limit_cases())
        if (c.name == name) return examine(c);
    for (const UnitCase& c : unit_cases())
        if (c.name == name) return c.examine({}, effort);
    throw std::invalid_argument(fmt::format("study stability has no case '{}'", name));
}

Value whole(const std::optional<std::int64_t>& v) { return v ? Value(*v) : Value(); }

Row row_of(const Finding& f) {
    Row row;
    row.set("machine_status", f.status);
    row.set("holds", f.holds ? "yes" : "no");
    row.set("observed", f.observed);
    row.set("error", f.error);
    row.set("bound", f.bound);
    row.set("unit", f.unit);
    row.set("splits", whole(f.splits));
    row.set("blocks", whole(f.blocks));
    row.set("unresolved", whole(f.unresolved));
    row.set("cycles", whole(f.cycles));
    row.set("lost", whole(f.lost));
    row.set("far_over_near", whole(f.far_over_near));
    row.set("far_codes", whole(f.far_codes));
    row.set("depth_error_units", f.depth_error_units);
    row.set("depth_error_quanta", f.depth_error_quanta);
    row.set("false_shadow", f.false_shadow);
    row.set("false_light", f.false_light);
    row.set("onset", f.onset);
    return row;
}

// Frames whose pictures the page shows.
struct Shown {
    std::string_view name, file, caption;
};
constexpr Shown shown[] = {
    {"grazing: 1 degree", "grazing_1_degree",
     "A light one degree above the floor. A texel covers 57 texels' length of the floor, and the "
     "floor's shadow on itself is that of its own quanta."},
    {"far/near 10000", "far_near_10000",
     "A wall from 0.3 to 0.95 of the far depth, with seven Z codes for the far half of the depths: "
     "the shadow has steps, and the wall's far end is lost beyond the last code."},
    {"a lamp behind half of the scene", "lamp_in_the_scene",
     "A lamp in the scene that looks to the right. What is behind it has no quotient and is lit."},
    {"a huge crumpled patch through the eye", "patch_through_the_eye",
     "A folded patch 80 units wide with the eye inside it, drawn to its end."},
};

void show(const Shown& s, const Effort& effort, Report& report) {
    const auto frame = frame_named(s.name);
    if (!frame) throw std::logic_error(fmt::format("no frame is named '{}'", s.name));
    const Picture picture = picture_of(*frame, effort);
    report.picture(s.file, picture.size, picture.size, picture.gray, s.caption);
}

class Stability : public Study {
public:
    std::string_view name() const override { return "stability"; }
    std::string_view meaning() const override {
        return "Stiff and extreme cases: status, error within its bound, an end";
    }
    Takes takes() const override { return {false, false}; }
    // Nothing if the scene is refused: that is a finding, and no failure of the case.
    std::optional<LoadedScene> scene(const Request& request, const Case& c) const override {
        const auto frame = frame_named(c.name);
        if (!frame) return std::nullopt;
        try {
            return scene_of(*frame, Effort{request.quick});
        } catch (const SceneError&) {
            return std::nullopt;
        }
    }

    std::vector<Case> cases(const Request&) const override {
        std::vector<Case> all;
        for (const FrameCase& c : frames()) all.push_back(case_of(c.name, c.kind, c.must));
        for (const LimitCase& c : limit_cases()) all.push_back(case_of(c.name, "limit", c.must));
        for (const UnitCase& c : unit_cases()) all.push_back(case_of(c.name, "unit", c.must));
        return all;
    }

    Row run(const Request& request, const Case& c, const LoadedScene* scene) const override {
        const auto start = std::chrono::steady_clock::now();
        Row row = row_of(examine_named(c.name, scene, {request.quick}));
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        if (request.host_times) row.set("case_host_ms", spent.count());
        return row;
    }

    void report(const Request&, std::span<const Row>, Report&) const override;
    std::vector<ColumnMeaning> columns() const override;
};

// Z codes for the far half of the depths over far / near, in the order of the latter.
Series codes_of(std::span<const Row> rows) {
    Series codes{"Z codes for the far half", {}, true, {}};
    for (const Row& r : rows)
        if (r.number("far_codes") > 0)  // a logarithmic axis has no zero
            codes.points.emplace_back(r.number("far_over_near"), r.number("far_codes"));
    std::sort(codes.points.begin(), codes.points.end());
    return codes;
}

void Stability::report(const Request& request, std::span<const Row> rows, Report& report) const {
    TableCells table{{"case", "kind", "must hold", "holds", "machine's status", "observed",
                      "error", "bound", "unit"}},
        limits{{"limit", "refused from"}},
        depths{{"far / near", "Z codes for the far half of the depths",
                "maximum depth error, world units", "in quanta"}};
    std::string red;
    std::int64_t failed = 0;
    for (const Row& r : rows) {
        table.push_back({r.text("name"), r.text("kind"), r.text("must"), r.text("holds"),
                         r.text("machine_status"), r.text("observed"), rounded(r.number("error")),
                         rounded(r.number("bound")), r.text("unit")});
        if (r.text("kind") == "limit") limits.push_back({r.text("name"), r.text("onset")});
        if (!r.text("far_over_near").empty())
            depths.push_back({r.text("far_over_near"), r.text("far_codes"),
                              rounded(r.number("depth_error_units"), 2),
                              rounded(r.number("depth_error_quanta"), 2)});
        if (r.text("holds") == "yes") continue;
        ++failed;
        red += fmt::format(" {}: {}.", r.text("name"), r.text("observed"));
    }
    report.summary()["cases"] = rows.size();
    report.summary()["red"] = failed;
    report.answer(fmt::format("{} of {} stiff and extreme cases hold: each has a defined status, "
                              "words within their bounds and an end.{}{}",
                              std::ssize(rows) - failed, rows.size(),
                              failed > 0 ? " NOT held:" : "", red));
    if (const Series codes = codes_of(rows); codes.points.size() > 1)
        report.plot({"far_codes", "Z codes left for the far half of the scene", "far / near",
                     "codes", true, true, {codes}},
                    "A perspective Z spends its codes near the eye: of the 65 535 codes, the far "
                    "half of the depths gets about one in far / near. 0 codes have no place on "
                    "this axis.");
    if (depths.size() > 1)
        report.table(depths, "The cases named far/near: 16 bits of Z, 24-bit coefficients, far = "
                             "1000 world units. An empty cell means that nothing was drawn.");
    report.heading("Where the words end");
    report.table(limits, "The magnitude from which on the machine refuses, and the name of its "
                         "refusal.");
    report.heading("Some of the frames");
    for (const Shown& s : shown) show(s, {request.quick}, report);
    report.heading("Every case");
    report.table(table, "What must hold and what was found. Error and bound are those of the "
                        "point where their quotient is maximal.");
}

std::vector<ColumnMeaning> Stability::columns() const {
    return {
        {"kind", "stiff or extreme: a frame; limit: a magnitude; unit: a sweep over words"},
        {"must", "what must hold, in words"},
        {"machine_status", "ok, or the name of the machine's refusal; beyond_last_code: some "
                           "depths have no Z code; unresolved: blocks were dropped"},
        {"holds", "yes if it holds"},
        {"observed", "what was found, in words"},
        {"error", "the error of a transformed word, or the number of wrong words, in `unit`"},
        {"bound", "its bound, in `unit`"},
        {"unit", "the unit of error and bound"},
        {"splits", "subdivisions of patches, of both views"},
        {"blocks", "blocks of at most 16 pixels that were drawn, of both views"},
        {"unresolved", "blocks dropped at the last level of subdivision"},
        {"cycles", "cycles of the frame, simulated"},
        {"lost", "pixels inside a surface in truth that the machine did not draw"},
        {"far_over_near", "the far depth over the near depth, of the cases that vary it"},
        {"far_codes", "Z codes for the far half of the depths"},
        {"depth_error_units", "the maximum error of a drawn depth, world units"},
        {"depth_error_quanta", "the maximum error of a drawn Z, quanta"},
        {"false_shadow", "share of the lit pixels outside the edge band that are shadowed"},
        {"false_light", "share of the shadowed pixels outside the edge band that are lit"},
        {"onset", "of a limit: the first magnitude that is refused, and how"},
        {"case_host_ms", "this computer's time for the case, ms"},
    };
}

}  // namespace

std::unique_ptr<Study> make_stability_study() { return std::make_unique<Stability>(); }

}  // namespace umbra78::tools::study
