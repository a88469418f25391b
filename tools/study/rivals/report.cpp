// The page of the study of rivals: the answers, the plots and the table of methods.
#include "tools/study/rivals/tables.hpp"

#include "shadow/frame/methods.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace umbra78::tools::study {
namespace {

void answer_exactness(std::span<const Row> all, Report& report) {
    double wrong = 0, drawn = 0;
    for (const Row& row : all) {
        if (row.text("status") != "ok" || std::isnan(row.number("wrong_on_polygons_px")) ||
            !is_exact(row.text("form")))
            continue;
        wrong += row.number("wrong_on_polygons_px");
        drawn += pixels_of(row);
    }
    report.answer(fmt::format("On the polygons that they are given the exact rivals have {} wrong "
                              "pixels of {:.0f}, against brute force.", wrong, drawn));
    report.summary()["wrong_on_polygons_px"] = wrong;
}

void answer_cost(std::span<const Row> all, Report& report) {
    const Row* cheapest = nullptr;
    for (const std::string& method : methods_in(all)) {
        const Row* row = finest(all, method);
        if (row == nullptr || !is_exact(method)) continue;
        if (cheapest == nullptr ||
            row->number("shadow_cycles") < cheapest->number("shadow_cycles"))
            cheapest = row;
    }
    const Row* map = finest(all, map_on_patches);
    if (cheapest == nullptr || map == nullptr) return;
    const auto million = [](const Row& row) { return rounded(row.number("shadow_cycles") / 1e6); };
    report.answer(fmt::format(
        "With {:.0f} facets the cheapest of them for a frame is {}: {} million cycles, where the "
        "depth map takes {} on the patches.{}",
        cheapest->number("facets"), cheapest->text("method"), million(*cheapest), million(*map),
        std::isnan(map->number("false_shadow"))
            ? ""
            : fmt::format(" Of the smooth surfaces' pixels it gets {} wrong, and the depth map {}.",
                          percent(wrong_share_of(*cheapest)), percent(wrong_share_of(*map)))));
}

void plots(std::span<const Row> all, Report& report) {
    Plot cost{"rivals-cost", "Cycles of a frame's shadow over facets", "facets",
              "million cycles, map and test", true, true, {}};
    Plot error{"rivals-error", "Error against cycles", "million cycles, map and test",
               "wrong pixels (%)", true, true, {}};
    for (const std::string& method : methods_in(all)) {
        const Rows rows = rows_of(all, question::dicing, method);
        const bool patches = method == map_on_patches || method == map_at_points;
        cost.series.push_back({method, points_of(rows, "facets", "shadow_cycles", 1e-6), !patches,
                               {}});
        Points errors;
        for (const Row* row : rows)
            if (row->has("false_shadow") && !std::isnan(row->number("false_shadow")))
                errors.emplace_back(row->number("shadow_cycles") / 1e6,
                                    100 * wrong_share_of(*row));
        if (!errors.empty()) error.series.push_back({method, errors, !patches, {}});
    }
    report.plot(cost, "What a frame's shadow takes the machine, as patches are diced more finely. "
                      "The depth map on patches does not read facets: it is one point.");
    if (!error.series.empty())
        report.plot(error, "Pixels that differ from the smooth surfaces' truth against what the "
                           "shadow takes: below and to the left is better. Each line goes from "
                           "coarse to fine dicing.");
}

void table_of_methods(std::span<const Row> all, Report& report) {
    TableCells table{{"method", "facets", "wrong on its polygons", "wrong, cast",
                      "wrong, terminator", "mean distance of edges, px", "once, million cycles",
                      "a frame, million cycles", "entries added", "memory, MB", "host, ms"}};
    for (const std::string& method : methods_in(all)) {
        const Row* row = finest(all, method);
        if (row == nullptr) continue;
        const auto cell = [&](const char* column, double scale = 1, int digits = 9) {
            return row->has(column) ? rounded(row->number(column) * scale, digits) : "";
        };
        table.push_back({method, cell("facets"), cell("wrong_on_polygons_px"),
                         cell("wrong_cast_px"), cell("wrong_terminator_px"),
                         cell("edge_mean_px", 1, 3), cell("once_cycles", 1e-6, 3),
                         cell("shadow_cycles", 1e-6, 3), cell("entries"),
                         cell("frame_bytes", 1e-6, 3), cell("shadow_host_ms", 1, 3)});
    }
    report.table(table, "At the finest dicing. Cycles are the machine's, its units side by side; "
                        "once is what a scene and a light take apart from the frames. The depth "
                        "map takes its light's view with the frame. Entries are what a method "
                        "makes and keeps beside the scene's own polygons.");
}

void table_of_limits(std::span<const Row> all, Report& report) {
    TableCells table{{"method", "how", "what it cannot do"}};
    for (const std::string& name : methods_in(all))
        for (const shadow::Method& m : shadow::methods()) {
            const std::string_view of = name == map_at_points           ? "irregular_map"
                                        : name.starts_with("depth map") ? "post_process"
                                                                        : std::string_view(name);
            if (m.name == of)
                table.push_back({name, std::string(m.meaning), std::string(m.cannot)});
        }
    report.table(table, "As the table of methods (shadow/frame/methods.cpp) has them.");
}

}  // namespace

std::vector<std::string> methods_in(std::span<const Row> rows) {
    std::vector<std::string> names;
    for (const Row& row : rows) {
        const std::string asked = row.text("question");
        if ((asked == question::dicing || asked == question::resolution) &&
            std::ranges::find(names, row.text("method")) == names.end())
            names.push_back(row.text("method"));
    }
    return names;
}

Rows rows_of(std::span<const Row> all, std::string_view question, std::string_view method) {
    Rows rows;
    for (const Row& row : all)
        if (row.text("status") == "ok" && row.text("question") == question &&
            (method.empty() || row.text("method") == method))
            rows.push_back(&row);
    return rows;
}

const Row* finest(std::span<const Row> all, std::string_view method) {
    const Rows rows = rows_of(all, question::dicing, method);
    const auto most = std::ranges::max_element(
        rows, {}, [](const Row* row) { return row->number("facets"); });
    return most == rows.end() ? nullptr : *most;
}

Points points_of(const Rows& rows, std::string_view x, std::string_view y, double scale) {
    Points points;
    for (const Row* row : rows)
        points.emplace_back(row->number(x), scale * row->number(y));
    std::ranges::sort(points);
    return points;
}

double at_of(const Row& row) {  // extra columns of a case are text
    return std::strtod(row.text("at").c_str(), nullptr);
}

double pixels_of(const Row& row) { return std::exp2(2 * row.number("xy_bits")); }

double wrong_share_of(const Row& row) {
    return (row.number("wrong_cast_px") + row.number("wrong_terminator_px")) /
           row.number("compared_px");
}

void report_rivals(const Request& request, std::span<const Row> all, Report& report) {
    const bool any = std::ranges::any_of(
        all, [](const Row& row) { return row.text("status") == "ok"; });
    if (!any) return report.answer("No case was measured; the rows' status says why.");
    answer_exactness(all, report);
    answer_cost(all, report);
    plots(all, report);
    sheet_of_methods(request, all, report);
    table_of_methods(all, report);
    table_of_limits(all, report);
    report_insides(request, all, report);
    report_codes(request, all, report);
    report_growth(all, report);
    report_textbook(request, all, report);
    report_scan_out(all, report);
}

}  // namespace umbra78::tools::study
