#include "tools/study/bias/report.hpp"

#include "tools/study/bias/forms.hpp"
#include "tools/study/bias/maps.hpp"
#include "tools/study/bias/search.hpp"
#include "tools/study/report_sections.hpp"

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

std::string words_of(const std::string& unit) { return unit == "world" ? "world units" : unit; }

Rows measured(std::span<const Row> rows, std::string_view find) {
    Rows kept;
    for (const Row& row : rows)
        if (row.text("status") == "ok" && row.text("find") == find) kept.push_back(row);
    return kept;
}

// Rows of one curve each: those that agree in the columns `by`, in the order of the rows.
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
    for (const Row& row : rows)  // a logarithmic axis has no zero
        if (row.number(x) > 0 && row.number(y) > 0)
            series.points.emplace_back(row.number(x), 100 * row.number(y));
    std::sort(series.points.begin(), series.points.end());
    return series;
}

// The row's lookup, sampling and dither in words.
std::string setting_of(const Row& row) {
    const std::string dither = row.text("dither");
    return fmt::format("{} lookup, {}, {}", row.text("lookup"),
                       row.text("sampling") == "centre" ? "exact centres" : "leaf sampling",
                       dither == "none" ? "no dither" : dither + " dither");
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
        for (const auto& [shape, line] : grouped(some, {"dither"})) {
            const std::string dither = shape == "none" ? "no dither" : shape + " dither";
            plot.series.push_back(
                curve("false shadow, " + dither, line, "bias_quanta", "false_shadow"));
            plot.series.push_back(
                curve("false light, " + dither, line, "bias_quanta", "false_light"));
        }
        report.plot(plot, "False shadow, a share of the pixels lit in truth, falls with the bias; "
                          "false light, a share of those in shadow, rises. One pair of curves for "
                          "each dither. Rates of 0 and a bias of 0 have no place on logarithmic "
                          "axes; the CSV has them.");
    }
}

// The maximum over the biases of the sweep that belongs to a search, and the search itself.
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
    TableCells table{
        {"sampling", "lookup", "dither", "X/Y bits", "Z bits", "least bias, quanta", "texels",
         "world units", "outside the edge band: quanta", "texels", "world units",
         "analytic bound, quanta", "pixels beyond it", "false light", "gap, texels",
         "gap, world units"}};
    for (const Row& row : searches) {
        std::vector<std::string> line;
        for (const char* key : {"sampling", "lookup", "dither", "xy_bits", "z_bits"})
            line.push_back(row.text(key));
        for (const char* column : {"least_quanta", "least_texels", "least_world",
                                   "least_outside_quanta", "least_outside_texels",
                                   "least_outside_world", "bound_outside_quanta"})
            line.push_back(figure(row, column));
        line.push_back(fmt::format("{}", max_beyond(rates, row)));
        line.push_back(percent(row.number("false_light")));
        for (const char* column : {"gap_texels", "gap_world"}) line.push_back(figure(row, column));
        table.push_back(std::move(line));
    }
    report.table(table,
        "The least bias, in whole quanta, with under 0.1 % false shadow: over all lit pixels, and "
        "over those outside the edge band, which are more than a light texel from a shadow's edge. "
        "The analytic bound is T (|zu| + |zv|)/2 + q, T the texel, zu and zv the surface's slopes, "
        "q the quantum, for the steepest surface but one pixel in a thousand; bilinear lookup has "
        "no T term, a dither of d texels adds d T. Pixels beyond it are in false shadow although "
        "the bias exceeds their own bound, at any tested bias: curvature and rounding are not in "
        "the bound. False light and gap are those at the least bias outside the band; the gap is "
        "the distance from its caster at which a shadow begins. Dither 'none' is no dither; 'not "
        "found' means that no bias up to an eighth of the depth range suffices.");
}

// The power of the texel with which the least bias in world units grows: least squares of the
// logarithms.
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

// How the least bias changes, in each unit, over several widths of X and Y, and of Z.
void answer_unit(const Rows& searches, Report& report) {
    auto& json = report.summary()["least_bias_changes_by"];
    TableCells table{{"setting", "width", "values", "quanta", "texels",
                      "world units", "grows as the texel to the power"}};
    const Groups curves = grouped(searches, {"sampling", "lookup", "dither"});
    for (const char* key : {"xy_bits", "z_bits"})
        for (const auto& [lookup, some] : curves) {
            const bool is_xy = key == std::string("xy_bits");
            Rows of_key;
            for (const Row& row : some) {  // the other width stays the scene's, the first row's
                const char* other = is_xy ? "z_bits" : "xy_bits";
                if (row.number(other) == some[0].number(other)) of_key.push_back(row);
            }
            if (of_key.size() < 2) continue;
            const auto spreads = unit_spreads(of_key);
            if (spreads.empty()) continue;  // no bias is needed, or none suffices
            std::map<std::string, std::string> factor;
            for (const UnitSpread& u : spreads) {
                factor[u.unit] = rounded(u.spread);
                json[key][lookup][u.unit] = u.spread;
            }
            const double power = is_xy ? growth(of_key) : std::nan("");
            table.push_back({setting_of(some[0]), is_xy ? "bits of X and Y" : "bits of Z",
                             fmt::format("{}", of_key.size()), factor["quanta"], factor["texels"],
                             factor["world"], std::isfinite(power) ? rounded(power, 2) : ""});
            const UnitSpread &steady = spreads.front(), &other = spreads.back();
            if (lookup == curves.front().first)
                report.answer(fmt::format(
                    "The unit in which a bias holds ({}): over {} widths of {} the least bias "
                    "outside the edge band changes by a factor of {} in {}, but of {} in {}.",
                    setting_of(some[0]), of_key.size(), is_xy ? "X and Y" : "Z",
                    rounded(steady.spread), words_of(steady.unit), rounded(other.spread),
                    words_of(other.unit)));
        }
    if (table.size() == 1) return;
    report.heading("In which unit does a bias hold?");
    report.table(table, "The factor by which the least bias outside the edge band changes over the "
                        "widths, in each unit: 1 would mean that one number serves all widths. The "
                        "power is 1 on a plane, 1/2 on a sphere up to a texel from its limb (its "
                        "visible edge), 0 where the quantum decides.");
}

// The rows of the scene's own widths, with no dither or the paper's.
void answer_least(const Rows& searches, Report& report) {
    std::string words;
    for (const Row& row : searches) {
        const Row& first = searches.front();
        const bool own = row.text("xy_bits") == first.text("xy_bits") &&
                         row.text("z_bits") == first.text("z_bits") &&
                         row.text("sampling") == first.text("sampling");
        if (!own || (row.text("dither") != "none" && row.text("dither") != "normal")) continue;
        words += fmt::format("{}{}: {}", words.empty() ? "" : "; ", setting_of(row),
                             figure(row, "least_outside_quanta"));
        if (!std::isnan(row.number("least_outside_quanta")))
            words += fmt::format(" quanta = {} texels", figure(row, "least_outside_texels"));
    }
    if (words.empty()) return;
    report.answer(fmt::format("The least bias with under 0.1 % false shadow more than a light "
                              "texel from a shadow's edge: {}.", words));
}

void answer_scene(const Row& row, Report& report) {
    if (row.text("status") != "ok") {
        report.answer("There is no least bias for this scene: " + row.text("status"));
        return;
    }
    const bool found = !std::isnan(row.number("least_outside_quanta"));
    std::string text = fmt::format(
        "Least bias with under 0.1 % false shadow more than a light texel from a shadow's edge "
        "({}): ", setting_of(row));
    text += found ? fmt::format("{} quanta = {} texels = {} world units. With it {} of the "
                                "shadowed pixels are lit, edges and all, and shadows begin {} "
                                "world units from their casters.",
                                figure(row, "least_outside_quanta"),
                                figure(row, "least_outside_texels"),
                                figure(row, "least_outside_world"),
                                percent(row.number("false_light")), figure(row, "gap_world"))
                  : "not found up to an eighth of the depth range.";
    const bool overall = !std::isnan(row.number("least_quanta"));
    text += fmt::format(" With edges counted, too, the least bias is {}{}.",
                        figure(row, "least_quanta"), overall ? " quanta" : "");
    report.answer(text);
    for (const char* unit : units) {
        const double min = row.number(std::string("least_outside_") + unit);
        if (!std::isnan(min)) report.summary()["least_bias"][unit] = min;
    }
}

void report_all(std::span<const Row> rows, Report& report) {
    const Rows searches = measured(rows, "least"), rates = measured(rows, "rates");
    answer_least(searches, report);
    plot_rates(rates, report);
    report.heading("The least bias of each setting");
    table_min(searches, rates, report);
    answer_unit(searches, report);
    report_forms(measured(rows, "form"), report);
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

std::string figure(const Row& row, const std::string& column, int digits) {
    const double value = row.number(column);
    return std::isnan(value) ? "not found" : rounded(value, digits);
}

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
    constexpr std::array<std::string_view, 13> keys{
        "sampling", "lookup", "dither", "bias", "bias_unit", "xy_bits", "z_bits", "map_depth",
        "bias_slope", "bias_clamp", "receiver", "normal_offset", "slope_source"};
    // --auto names neither widths nor forms.
    const auto own = std::span(keys).first(request.automatic ? 5 : keys.size());
    write_sections(request, own, all, report, [&](std::span<const Row> rows, Report& some) {
        if (!request.automatic) return report_all(rows, some);
        for (const Row& row : rows) answer_scene(row, some);
    });
    report_maps(request, measured(all, "map"), report);
}

}  // namespace umbra78::tools::study
