#include "tools/study/rivals/rivals.hpp"

#include "shadow/frame/methods.hpp"
#include "tools/study/report_sections.hpp"
#include "tools/study/strip.hpp"
#include "tools/truth/scene_truth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using Rows = std::vector<const Row*>;

std::vector<std::string> methods_in(std::span<const Row> rows) {
    std::vector<std::string> names;
    for (const Row& row : rows)
        if (std::ranges::find(names, row.text("method")) == names.end())
            names.push_back(row.text("method"));
    return names;
}

Rows rows_of(std::span<const Row> all, std::string_view question, std::string_view method) {
    Rows rows;
    for (const Row& row : all)
        if (row.text("status") == "ok" && row.text("question") == question &&
            row.text("method") == method)
            rows.push_back(&row);
    return rows;
}

// A method's row with the most facets that all have: where methods are compared.
const Row* finest(std::span<const Row> all, std::string_view method) {
    const Rows rows = rows_of(all, by_dicing, method);
    const auto most = std::ranges::max_element(
        rows, {}, [](const Row* row) { return row->number("facets"); });
    return most == rows.end() ? nullptr : *most;
}

using Points = std::vector<std::pair<double, double>>;

Points points_of(const Rows& rows, std::string_view x, std::string_view y, double scale = 1) {
    Points points;
    for (const Row* row : rows)
        points.emplace_back(row->number(x), scale * row->number(y));
    std::ranges::sort(points);
    return points;
}

double pixels(const Row& row) { return std::exp2(2 * row.number("xy_bits")); }

void answer_exactness(std::span<const Row> all, Report& report) {
    double wrong = 0, drawn = 0;
    for (const Row& row : all) {
        if (row.text("status") != "ok" || std::isnan(row.number("wrong_on_polygons_px"))) continue;
        wrong += row.number("wrong_on_polygons_px");
        drawn += pixels(row);
    }
    report.answer(fmt::format("On the polygons that they are given the rivals have {} wrong pixels "
                              "of {:.0f}, against brute force.", wrong, drawn));
    report.summary()["wrong_on_polygons_px"] = wrong;
}

double wrong_share(const Row& row) {
    return (row.number("wrong_cast_px") + row.number("wrong_terminator_px")) /
           row.number("compared_px");
}

void answer_cost(std::span<const Row> all, Report& report) {
    const Row* cheapest = nullptr;
    for (const std::string& method : methods_in(all)) {
        const Row* row = finest(all, method);
        if (row == nullptr || std::isnan(row->number("wrong_on_polygons_px"))) continue;
        if (cheapest == nullptr ||
            row->number("shadow_cycles") < cheapest->number("shadow_cycles"))
            cheapest = row;
    }
    const Row* map = finest(all, "depth map, patches");
    if (cheapest == nullptr || map == nullptr) return;
    const auto million = [](const Row& row) { return rounded(row.number("shadow_cycles") / 1e6); };
    report.answer(fmt::format(
        "With {:.0f} facets the cheapest of them for a frame is {}: {} million cycles, where the "
        "depth map takes {} on the patches.{}",
        cheapest->number("facets"), cheapest->text("method"),
        million(*cheapest), million(*map),
        std::isnan(map->number("false_shadow"))
            ? ""
            : fmt::format(" Of the smooth surfaces' pixels it gets {} wrong, and the depth map {}.",
                          percent(wrong_share(*cheapest)), percent(wrong_share(*map)))));
}

void table_of_methods(std::span<const Row> all, Report& report) {
    TableCells table{{"method", "facets", "wrong on its polygons", "wrong, cast",
                      "wrong, terminator", "once, million cycles", "a frame, million cycles",
                      "grows with facets", "with pixels", "memory, MB", "host, ms"}};
    for (const std::string& method : methods_in(all)) {
        const Row* row = finest(all, method);
        if (row == nullptr) continue;
        const PowerLaw facets =
            power_law(points_of(rows_of(all, by_dicing, method), "facets", "shadow_cycles"));
        Points by_pixels;
        for (const Row* r : rows_of(all, by_resolution, method))
            by_pixels.emplace_back(pixels(*r), r->number("shadow_cycles"));
        const PowerLaw grows = power_law(by_pixels);
        const auto million = [&](std::string_view column) {
            return rounded(row->number(column) / 1e6);
        };
        table.push_back({method, rounded(row->number("facets"), 9),
                         rounded(row->number("wrong_on_polygons_px"), 9),
                         rounded(row->number("wrong_cast_px"), 9),
                         rounded(row->number("wrong_terminator_px"), 9), million("once_cycles"),
                         million("shadow_cycles"), rounded(facets.exponent, 2),
                         rounded(grows.exponent, 2), million("frame_bytes"),
                         row->has("shadow_host_ms") ? rounded(row->number("shadow_host_ms")) : ""});
        report.summary()["methods"][method] = {{"frame_cycles", row->number("shadow_cycles")},
                                               {"exponent_of_facets", facets.exponent},
                                               {"exponent_of_pixels", grows.exponent}};
    }
    report.table(table, "At the finest dicing. Exponents are fitted by least squares to the "
                        "logarithms of all rows of a question. Cycles are the machine's, its units "
                        "side by side; once is what a scene and a light take apart from the "
                        "frames. The depth map takes its light's view with the frame.");
}

void plots(std::span<const Row> all, Report& report) {
    Plot cost{"rivals-cost", "Cycles of a frame's shadow over facets", "facets",
              "million cycles, map and test", true, true, {}};
    Plot error{"rivals-error", "Error against cycles", "million cycles, map and test",
               "wrong pixels (%)", true, true, {}};
    for (const std::string& method : methods_in(all)) {
        const Rows rows = rows_of(all, by_dicing, method);
        const bool patches = method == "depth map, patches";
        cost.series.push_back({method, points_of(rows, "facets", "shadow_cycles", 1e-6), !patches,
                               {}});
        Points errors;
        for (const Row* row : rows)
            if (!std::isnan(row->number("false_shadow")))
                errors.emplace_back(row->number("shadow_cycles") / 1e6, 100 * wrong_share(*row));
        if (!errors.empty()) error.series.push_back({method, errors, !patches, {}});
    }
    report.plot(cost, "What a frame's shadow takes the machine, as patches are diced more finely. "
                      "The depth map on patches does not read facets and stands alone.");
    if (!error.series.empty())
        report.plot(error, "Pixels that differ from the smooth surfaces' truth against what the "
                           "shadow takes: below and to the left is better. Each line goes from "
                           "coarse to fine dicing.");
}

// Drawn again, at the finest dicing: of the exact rivals one stands for all, since their masks are
// one mask.
void picture(const Request& request, std::span<const Row> all, Report& report) {
    std::vector<std::vector<std::uint8_t>> panels;
    std::string names;
    int size = 0;
    for (const char* method : {"depth map, patches", "depth map, facets", "volumes"}) {
        const Row* row = finest(all, method);
        if (row == nullptr) continue;
        Case c;
        for (const char* key : {"form", "surface", "dice_levels", "dequantize", "low_pass",
                                "xy_bits"})
            c.set.push_back(fmt::format("{}={}", key, row->text(key)));
        const LoadedScene scene = scene_of(request, c);
        const auto truth = trace(scene);
        if (!truth) return;
        RenderJob job(scene.view(), scene.settings);
        draw_mask(job);
        const std::vector<std::uint8_t> visible = job.visible();
        panels.push_back(error_picture(*truth, {job.bytes(Plane::mask), visible}));
        size = truth->truth.size;
        names += (names.empty() ? "" : "; ") + std::string(method);
    }
    if (panels.empty()) return;
    const Strip strip = side_by_side(panels, size);
    report.picture("rivals-wrong", strip.width, strip.height, strip.gray,
                   fmt::format("From the left: {}, which stands for all exact rivals. False shadow "
                               "is black, false light white, light grey is lit and dark grey in "
                               "shadow.", names));
}

}  // namespace

void report_rivals(const Request& request, std::span<const Row> all, Report& report) {
    const bool any = std::ranges::any_of(
        all, [](const Row& row) { return row.text("status") == "ok"; });
    if (!any) return report.answer("No case was measured; the rows' status says why.");
    answer_exactness(all, report);
    answer_cost(all, report);
    plots(all, report);
    picture(request, all, report);
    table_of_methods(all, report);
}

}  // namespace umbra78::tools::study
