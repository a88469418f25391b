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

}  // namespace

// Each form by what is left for the constant, and by what it costs: light where shadow is.
void report_forms(std::span<const Row> rows, Report& report) {
    if (rows.empty()) return;
    report.heading("Bias that follows the surface");
    Plot plot;
    plot.name = "forms";
    plot.title = "What is left for the constant bias, and what leaks";
    plot.x_label = "least constant bias beside the form (Z quanta)";
    plot.y_label = "false light at that bias (%)";
    TableCells table{{"form", "lookup", "dither",
                      "least constant bias outside the edge band, quanta",
                      "texels", "world units", "false shadow", "false light", "false light outside",
                      "gap, texels", "gap, world units"}};
    auto& json = report.summary()["forms"];
    for (const auto& [name, some] : by_form(rows)) {
        Series series;
        series.title = name;
        series.line = false;
        for (const Row& row : some) {
            table.push_back({form_of(row), row.text("lookup"), row.text("dither"),
                             figure(row, "least_outside_quanta"),
                             figure(row, "least_outside_texels"),
                             figure(row, "least_outside_world"),
                             percent(row.number("false_shadow")),
                             percent(row.number("false_light")),
                             percent(row.number("false_light_outside")),
                             figure(row, "gap_texels"), figure(row, "gap_world")});
            json.push_back({{"form", form_of(row)},
                            {"lookup", row.text("lookup")},
                            {"dither", row.text("dither")},
                            {"least_outside_quanta", row.number("least_outside_quanta")},
                            {"false_light", row.number("false_light")},
                            {"gap_texels", row.number("gap_texels")}});
            if (std::isnan(row.number("least_outside_quanta"))) continue;
            series.points.emplace_back(row.number("least_outside_quanta"),
                                       100 * row.number("false_light"));
            series.labels.push_back(row.text("lookup").substr(0, 3) +
                                    (row.text("dither") == "none" ? "" : ", dither"));
        }
        if (!series.points.empty()) plot.series.push_back(std::move(series));
    }
    report.plot(plot, "Each form of bias at the least constant bias that it still needs. Left is "
                      "less left to tune, down is less leak. A map of back faces leaks on the side "
                      "that faces away from the light, which no direct light reaches.");
    report.table(table, "The least constant bias, in whole quanta, with under 0.1 % false shadow "
                        "outside the edge band beside each form, and both errors there. The gap is "
                        "the distance from its caster at which a shadow begins.");
}

}  // namespace umbra78::tools::study
