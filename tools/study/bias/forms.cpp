#include "tools/study/bias/forms.hpp"

#include "tools/study/bias/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

// A form's name: what its row sets beside the constant.
std::string form_of(const Row& row) {
    std::string name;
    if (row.text("map_depth") != "first") name = row.text("map_depth") + " map";
    if (row.number("bias_slope") > 0) name = "slope x " + row.text("bias_slope");
    if (row.text("receiver") == "plane") name = "receiver's plane";
    if (row.text("receiver") == "normal")
        name = "normal offset x " + row.text("normal_offset");
    if (name.empty()) return "constant";
    if (row.text("slope_source") == "normals") name += ", kept normals";
    if (row.number("bias_clamp") > 0)
        name += fmt::format(", at most {} quanta", row.text("bias_clamp"));
    return name;
}

// In the order of their first rows.
std::vector<std::pair<std::string, std::vector<Row>>> by_form(std::span<const Row> rows) {
    std::vector<std::pair<std::string, std::vector<Row>>> forms;
    for (const Row& row : rows) {
        const auto found = std::ranges::find(forms, form_of(row), [](const auto& f) {
            return f.first;
        });
        if (found != forms.end()) {
            found->second.push_back(row);
        } else {
            forms.push_back({form_of(row), {row}});
        }
    }
    return forms;
}

std::string short_label(const Row& row) {
    return row.text("lookup").substr(0, 3) + (row.text("dither") == "none" ? "" : ", dither");
}

bool by_normals(const Row& row) { return row.text("slope_source") == "normals"; }

// A point for each row whose search found a bias.
template <class Y, class Label>
Series series_of(const std::string& title, std::span<const Row> rows, Y&& y, Label&& label) {
    Series series;
    series.title = title;
    series.line = false;
    for (const Row& row : rows) {
        if (std::isnan(row.number("least_outside_quanta"))) continue;
        series.points.emplace_back(row.number("least_outside_quanta"), y(row));
        series.labels.push_back(label(row));
    }
    return series;
}

void add(Plot& plot, Series series) {
    if (!series.points.empty()) plot.series.push_back(std::move(series));
}

// The forms that are the machine's own: receivers by Z differences.
void plot_forms(std::span<const Row> rows, Report& report) {
    Plot plot;
    plot.name = "forms";
    plot.title = "What is left for the constant bias, and what leaks";
    plot.x_label = "least constant bias beside the form (Z quanta)";
    plot.y_label = "false light at that bias (%)";
    for (const auto& [name, some] : by_form(rows))
        if (!by_normals(some.front()))
            add(plot, series_of(name, some,
                                [](const Row& row) { return 100 * row.number("false_light"); },
                                short_label));
    report.plot(plot, "Each form of bias at the least constant bias that it still needs, a "
                      "receiver's slope by Z differences. Left is less left to tune, down is less "
                      "leak. A map of back faces leaks on the side that faces away from the light, "
                      "which no direct light reaches.");
}

// The receivers by either source of their slope.
void plot_sources(std::span<const Row> rows, Report& report) {
    Plot plot;
    plot.name = "slope-sources";
    plot.title = "A receiver's slope by Z differences and by kept normals";
    plot.x_label = "least constant bias beside the receiver (Z quanta)";
    plot.y_label = "false shadow at that bias, edges and all (%)";
    for (const bool normals : {false, true}) {
        std::vector<Row> some;
        for (const Row& row : rows)
            if (row.text("receiver") != "point" && by_normals(row) == normals) some.push_back(row);
        add(plot, series_of(normals ? "kept normals" : "Z differences", some,
                            [](const Row& row) { return 100 * row.number("false_shadow"); },
                            [](const Row& row) {
                                const char* plane =
                                    row.number("bias_clamp") > 0 ? "plane, limited" : "plane";
                                return (row.text("receiver") == "plane"
                                            ? plane
                                            : row.text("normal_offset")) +
                                       ", " + short_label(row);
                            }));
    }
    if (plot.series.size() == 2)
        report.plot(plot, "The receiver's plane and normal offsets, by their texels, at the least "
                          "constant bias that they need outside the edge band. What differs is at "
                          "the edges, where Z differences straddle two surfaces.");
}

}  // namespace

// Each form by what is left for the constant, and by what it costs: light where shadow is.
void report_forms(std::span<const Row> rows, Report& report) {
    if (rows.empty()) return;
    report.heading("Bias that follows the surface");
    TableCells table{{"form", "lookup", "dither",
                      "least constant bias outside the edge band, quanta",
                      "texels", "world units", "with edges, quanta", "false shadow", "false light",
                      "false light outside", "gap, texels", "gap, world units"}};
    auto& json = report.summary()["forms"];
    for (const auto& [name, some] : by_form(rows)) {
        for (const Row& row : some) {
            table.push_back({name, row.text("lookup"), row.text("dither"),
                             figure(row, "least_outside_quanta"),
                             figure(row, "least_outside_texels"),
                             figure(row, "least_outside_world"), figure(row, "least_quanta"),
                             percent(row.number("false_shadow")),
                             percent(row.number("false_light")),
                             percent(row.number("false_light_outside")),
                             figure(row, "gap_texels"), figure(row, "gap_world")});
            json.push_back({{"form", name},
                            {"lookup", row.text("lookup")},
                            {"dither", row.text("dither")},
                            {"least_outside_quanta", row.number("least_outside_quanta")},
                            {"least_quanta", row.number("least_quanta")},
                            {"false_shadow", row.number("false_shadow")},
                            {"false_light", row.number("false_light")},
                            {"gap_texels", row.number("gap_texels")}});
        }
    }
    plot_forms(rows, report);
    plot_sources(rows, report);
    report.table(table, "The least constant bias, in whole quanta, with under 0.1 % false shadow "
                        "outside the edge band beside each form, and both errors there; with edges "
                        "the least that keeps it over all pixels. The gap is the distance from its "
                        "caster at which a shadow begins.");
}

}  // namespace umbra78::tools::study
