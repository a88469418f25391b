#include "tools/study/bias/report.hpp"

#include "tools/study/bias/search.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace umbra78::tools::study {
namespace {

using Rows = std::vector<Row>;
constexpr std::array<const char*, 3> units{"quanta", "texels", "world"};

Rows measured(std::span<const Row> rows, std::string_view find) {
    Rows kept;
    for (const Row& row : rows)
        if (row.text("status") == "ok" && row.text("find") == find) kept.push_back(row);
    return kept;
}

// Rows by what tells their curve, in the order they came.
using Groups = std::vector<std::pair<std::string, Rows>>;
Groups grouped(const Rows& rows, std::initializer_list<const char*> by) {
    Groups groups;
    for (const Row& row : rows) {
        std::string name;
        for (const char* key : by) name += (name.empty() ? "" : ", ") + row.text(key);
        const auto found = std::find_if(groups.begin(), groups.end(),
                                        [&](const auto& g) { return g.first == name; });
        if (found != groups.end()) {
            found->second.push_back(row);
        } else {
            groups.push_back({name, {row}});
        }
    }
    return groups;
}

Series curve(const std::string& title, const Rows& rows, const char* x, const char* y) {
    Series series;
    series.title = title;
    for (const Row& row : rows)  // an axis of logarithms has no zero
        if (row.number(x) > 0 && row.number(y) > 0)
            series.points.emplace_back(row.number(x), 100 * row.number(y));
    std::sort(series.points.begin(), series.points.end());
    return series;
}

void plot_rates(const Rows& rates, Report& report) {
    for (const auto& [name, some] : grouped(rates, {"sampling", "lookup"})) {
        std::string file = "rates-" + name;
        file.replace(file.find(", "), 2, "-");
        Plot plot;
        plot.name = file;
        plot.title = fmt::format("{} sampling, {} lookup", some[0].text("sampling"),
                                 some[0].text("lookup"));
        plot.x_label = "bias (Z quanta)";
        plot.y_label = "rate (%)";
        plot.log_x = plot.log_y = true;
        for (const auto& [dither, line] : grouped(some, {"dither"})) {
            plot.series.push_back(
                curve("false shadow, " + dither, line, "bias_quanta", "false_shadow"));
            plot.series.push_back(
                curve("false light, " + dither, line, "bias_quanta", "false_light"));
        }
        report.plot(plot, "False shadow (of the pixels lit in truth) falls with the bias, false "
                          "light (of those in shadow) rises. Rates of 0 and a bias of 0 have no "
                          "place on these axes; the table has them.");
    }
}

std::string figure(const Row& row, const std::string& column) {
    const double value = row.number(column);
    return std::isnan(value) ? "none" : fmt::format("{:.4g}", value);
}

// Of the sweep that belongs to a search, at any of its biases.
std::int64_t max_beyond(const Rows& rates, const Row& search) {
    double max = search.number("beyond_bound");
    for (const Row& row : rates) {
        bool same = true;
        for (const char* key : {"sampling", "lookup", "dither", "xy_bits", "z_bits"})
            same = same && row.text(key) == search.text(key);
        if (same) max = std::max(max, row.number("beyond_bound"));
    }
    return static_cast<std::int64_t>(max);
}

void table_min(const Rows& searches, const Rows& rates, Report& report) {
    std::vector<std::vector<std::string>> table{
        {"sampling", "lookup", "dither", "X/Y bits", "Z bits", "least, quanta", "texels", "world",
         "least outside the band, quanta", "texels", "world", "bound there", "beyond it",
         "false light", "gap, quanta", "gap, texels", "gap, world"}};
    for (const Row& row : searches) {
        std::vector<std::string> line;
        for (const char* key : {"sampling", "lookup", "dither", "xy_bits", "z_bits"})
            line.push_back(row.text(key));
        for (const char* column : {"least_quanta", "least_texels", "least_world",
                                   "least_outside_quanta", "least_outside_texels",
                                   "least_outside_world", "bound_outside_quanta"})
            line.push_back(figure(row, column));
        line.push_back(fmt::format("{}", max_beyond(rates, row)));
        line.push_back(fmt::format("{:.2f} %", 100 * row.number("false_light")));
        for (const char* column : {"gap_quanta", "gap_texels", "gap_world"})
            line.push_back(figure(row, column));
        table.push_back(std::move(line));
    }
    report.table(table, fmt::format(
        "The least bias, in whole quanta, with under 0.1 % false shadow over all lit pixels, and "
        "over those more than a light texel from a shadow's edge; beside it the analytic bound "
        "T (|zu| + |zv|)/2 + q that 99.9 % of those pixels keep (bilinear lookup has no T term; "
        "a dither of d texels adds d T), and the most pixels outside the band that are in false "
        "shadow at a tested bias beyond their own bound: what curvature and rounding add to it. "
        "False light and gap are those at the least bias outside the band; the gap is how far "
        "behind its caster a shadow begins. 'none': none up to an eighth of the depth range."));
}

// The power of the texel that the least bias in world units grows as: least squares of logarithms.
double growth(const Rows& rows) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Row& row : rows) {
        const double min = row.number("least_outside_world");
        if (std::isnan(min) || min <= 0) continue;
        const double x = -row.number("xy_bits") * std::log(2), y = std::log(min);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// Rows of one lookup, without dither, at several widths.
void answer_unit(const Rows& searches, Report& report) {
    auto& json = report.summary()["least_bias_changes_by"];
    for (const char* key : {"xy_bits", "z_bits"})
        for (const auto& [lookup, some] : grouped(searches, {"sampling", "lookup", "dither"})) {
            Rows of_key;
            for (const Row& row : some) {  // the other width stays the scene's, the first row's
                const char* other = key == std::string("xy_bits") ? "z_bits" : "xy_bits";
                if (row.number(other) == some[0].number(other)) of_key.push_back(row);
            }
            if (of_key.size() < 2) continue;
            const auto spreads = unit_spreads(of_key);
            if (spreads.empty()) continue;  // no bias is needed, or none suffices
            std::string words;
            for (const UnitSpread& u : spreads) {
                words += fmt::format("{}{:.3g} in {}", words.empty() ? "" : ", ", u.spread, u.unit);
                json[key][lookup][u.unit] = u.spread;
            }
            if (key == std::string("xy_bits") && std::isfinite(growth(of_key)))
                words += fmt::format("; in world units it grows as the texel to the power {:.2f} "
                                     "(1 on a plane, 1/2 on a sphere up to a texel from its limb, "
                                     "0 where the quantum decides)", growth(of_key));
            report.paragraph(fmt::format(
                "{}: over {} widths of {} the least bias outside the edge band changes by a factor "
                "of {}.", lookup, of_key.size(), key, words));
        }
}

void answer_scene(const Row& row, Report& report) {
    if (row.text("status") != "ok") {
        report.paragraph("No least bias for this scene: " + row.text("status"));
        return;
    }
    report.paragraph(fmt::format(
        "Least bias with under 0.1 % false shadow more than a light texel from a shadow's edge "
        "({} lookup, dither {}, {} sampling): {} quanta = {} texels = {} world units. With it "
        "{:.2f} % of the shadowed pixels are lit, edges and all, and shadows begin {} "
        "world units behind their casters. The least bias, edges and all: {} "
        "quanta.",
        row.text("lookup"), row.text("dither"), row.text("sampling"),
        figure(row, "least_outside_quanta"), figure(row, "least_outside_texels"),
        figure(row, "least_outside_world"), 100 * row.number("false_light"),
        figure(row, "gap_world"), figure(row, "least_quanta")));
    for (const char* unit : units) {
        const double min = row.number(std::string("least_outside_") + unit);
        if (!std::isnan(min)) report.summary()["least_bias"][unit] = min;
    }
}

void report_all(std::span<const Row> rows, Report& report) {
    const Rows searches = measured(rows, "least");
    plot_rates(measured(rows, "rates"), report);
    table_min(searches, measured(rows, "rates"), report);
    answer_unit(searches, report);
    auto& json = report.summary()["least_bias_quanta"];
    for (const Row& row : searches)
        json.push_back({{"sampling", row.text("sampling")},
                        {"lookup", row.text("lookup")},
                        {"dither", row.text("dither")},
                        {"xy_bits", row.number("xy_bits")},
                        {"z_bits", row.number("z_bits")},
                        {"overall", row.number("least_quanta")},
                        {"outside_band", row.number("least_outside_quanta")},
                        {"bound_outside_band", row.number("bound_outside_quanta")}});
}

}  // namespace

std::vector<UnitSpread> unit_spreads(std::span<const Row> rows) {
    std::vector<UnitSpread> spreads;
    for (const char* unit : units) {
        double min = INFINITY, max = 0;
        for (const Row& row : rows) {
            const double value = row.number(std::string("least_outside_") + unit);
            if (std::isnan(value) || value <= 0) continue;
            min = std::min(min, value);
            max = std::max(max, value);
        }
        if (max > 0) spreads.push_back({unit, max / min});
    }
    std::stable_sort(spreads.begin(), spreads.end(),
                     [](const auto& a, const auto& b) { return a.spread < b.spread; });
    return spreads;
}

void report_bias(const Request& request, std::span<const Row> all, Report& report) {
    constexpr std::array<std::string_view, 7> told{"sampling", "lookup", "dither", "bias",
                                                   "bias_unit", "xy_bits", "z_bits"};
    const auto own = std::span(told).first(request.automatic ? 5 : 7);  // an answer names no widths
    for_combinations(request, own, all, report, [&](std::span<const Row> rows, Report& some) {
        if (!request.automatic) return report_all(rows, some);
        for (const Row& row : rows) answer_scene(row, some);
    });
}

}  // namespace umbra78::tools::study
