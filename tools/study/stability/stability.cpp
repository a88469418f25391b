// study stability: stiff and extreme cases, one row each, with the verdict "holds".
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

// The case of that name among all three lists.
Finding examine_named(std::string_view name, const Effort& effort) {
    for (const FrameCase& c : frames())
        if (c.name == name) return examine(c, effort);
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
    row.set("far_codes", whole(f.far_codes));
    row.set("depth_error_units", f.depth_error_units);
    row.set("depth_error_quanta", f.depth_error_quanta);
    row.set("false_shadow", f.false_shadow);
    row.set("false_light", f.false_light);
    row.set("onset", f.onset);
    return row;
}

// Frames in which there is something to see.
struct Shown {
    std::string_view name, file, caption;
};
constexpr Shown shown[] = {
    {"grazing: 1 degree", "grazing_1_degree",
     "A light one degree above the floor: a texel's length on it is 57 of them, and the floor's "
     "shadow on itself is that of its own quanta."},
    {"far/near 10000", "far_near_10000",
     "A wall from 0.3 to 0.95 of far, with seven Z codes for the far half of the depths: shadow in "
     "steps, and at the far edge the wall is lost behind the last code."},
    {"a lamp behind half of the scene", "lamp_in_the_scene",
     "A lamp in the scene that looks to the right: what is behind it has no quotient and is lit."},
    {"a huge crumpled patch through the eye", "patch_through_the_eye",
     "A folded patch 80 units wide with the eye inside: drawn to its end."},
};

// Nothing where the case is refused.
std::optional<shadow::Settings> settings_of(const FrameCase& c) {
    try {
        return parse_scene(c.scene, std::string(c.name), c.set).settings;
    } catch (const SceneError&) {
        return std::nullopt;
    }
}

// The row's frame drawn once more; its picture.
void show(const Shown& s, const Effort& effort, Report& report) {
    for (const FrameCase& c : frames()) {
        if (c.name != s.name) continue;
        const Picture picture = picture_of(c, effort);
        report.picture(s.file, picture.size, picture.size, picture.gray, s.caption);
    }
}

class Stability : public Study {
public:
    std::string_view name() const override { return "stability"; }
    std::string_view meaning() const override {
        return "Stiff and extreme cases: status, error within its bound, an end";
    }
    Takes takes() const override { return {false, false}; }
    std::optional<shadow::Settings> settings(const Request&, const Case& c) const override {
        for (const FrameCase& frame : frames())
            if (frame.name == c.name) return settings_of(frame);
        return std::nullopt;
    }

    std::vector<Case> cases(const Request&) const override {
        std::vector<Case> all;
        for (const FrameCase& c : frames()) all.push_back(case_of(c.name, c.kind, c.must));
        for (const LimitCase& c : limit_cases()) all.push_back(case_of(c.name, "limit", c.must));
        for (const UnitCase& c : unit_cases()) all.push_back(case_of(c.name, "unit", c.must));
        return all;
    }

    Row run(const Request& request, const Case& c) const override {
        const auto start = std::chrono::steady_clock::now();
        Row row = row_of(examine_named(c.name, {request.quick}));
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        if (request.host_times) row.set("case_host_ms", spent.count());
        return row;
    }

    void report(const Request&, std::span<const Row>, Report&) const override;
};

std::vector<std::string> head_of_table() {
    return {"case",     "kind",  "must hold", "holds", "machine's status",
            "observed", "error", "bound",     "unit"};
}

void Stability::report(const Request& request, std::span<const Row> rows, Report& report) const {
    std::vector<std::vector<std::string>> table{head_of_table()}, limits{{"limit", "begins at"}};
    Series codes{"Z codes for the far half", {}, true, {}};
    std::int64_t red = 0;
    for (const Row& r : rows) {
        table.push_back({r.text("name"), r.text("kind"), r.text("must"), r.text("holds"),
                         r.text("machine_status"), r.text("observed"), r.text("error"),
                         r.text("bound"), r.text("unit")});
        if (r.text("kind") == "limit") limits.push_back({r.text("name"), r.text("onset")});
        if (r.text("far_codes") != "" && r.text("name").starts_with("far/near"))
            codes.points.emplace_back(std::stod(r.text("name").substr(9)), r.number("far_codes"));
        if (r.text("holds") != "yes") {
            ++red;
            report.paragraph(fmt::format("Does not hold: {}: {}.", r.text("name"),
                                         r.text("observed")));
        }
    }
    report.summary()["cases"] = rows.size();
    report.summary()["red"] = red;
    report.paragraph(fmt::format("{} of {} cases hold.", std::ssize(rows) - red, rows.size()));
    report.table(table, "Every case: what must hold and what was found.");
    report.table(limits, "Where the words end: the magnitude at which the named status begins.");
    std::sort(codes.points.begin(), codes.points.end());
    if (codes.points.size() > 1)
        report.plot({"far_codes", "Z codes left for the far half of the scene", "far / near",
                     "codes", true, true, {codes}},
                    "A perspective Z spends its codes near the eye: of the 65 535, the far half "
                    "of the depths gets one in far / near of them.");
    for (const Shown& s : shown) show(s, {request.quick}, report);
}

}  // namespace

std::unique_ptr<Study> make_stability_study() { return std::make_unique<Stability>(); }

}  // namespace umbra78::tools::study
