#include "tools/study/widths/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace umbra78::tools::study {
namespace {

using Rows = std::vector<Row>;
using Wanted = std::initializer_list<std::pair<const char*, const char*>>;

constexpr std::array<const char*, 5> bit_keys{"xy_bits", "z_bits", "coefficient_bits",
                                              "accumulator_bits", "fraction_bits"};
constexpr std::array<const char*, 4> rounding_keys{"coefficient_rounding", "product_rounding",
                                                   "transform_rounding", "depth_rounding"};

Rows where(std::span<const Row> rows, Wanted wanted) {
    Rows kept;
    for (const Row& row : rows) {
        bool fits = row.text("status") == "ok";
        for (const auto& [column, value] : wanted) fits = fits && row.text(column) == value;
        if (fits) kept.push_back(row);
    }
    return kept;
}

std::string rate(const Row& row, const char* column) {
    return fmt::format("{:.3f} %", 100 * row.number(column));
}

Series curve(std::string title, const Rows& rows, const char* x, const char* y, double scale) {
    Series series;
    series.title = std::move(title);
    for (const Row& row : rows) series.points.emplace_back(row.number(x), scale * row.number(y));
    std::sort(series.points.begin(), series.points.end());
    return series;
}

void plot_width(std::span<const Row> rows, const char* key, const char* unit, Report& report) {
    Plot plot;
    plot.name = fmt::format("errors-{}-{}", key, unit);
    plot.title = fmt::format("Errors over {}, bias kept in {}", key, unit);
    plot.x_label = fmt::format("{} (bits)", key);
    plot.y_label = "rate (%)";
    for (const char* lookup : {"nearest", "bilinear"}) {
        const Rows some = where(rows, {{"varies", key}, {"lookup", lookup}, {"bias_unit", unit}});
        if (some.empty()) continue;
        plot.series.push_back(
            curve(fmt::format("false shadow, {}", lookup), some, key, "false_shadow", 100));
        plot.series.push_back(
            curve(fmt::format("false light, {}", lookup), some, key, "false_light", 100));
    }
    if (!plot.series.empty())
        report.plot(plot, fmt::format("The other widths stay the scene's; the bias is the same in "
                                      "{} for all.",
                                      std::string_view(unit) == "world" ? "world units" : unit));
}

void tell_roundings(std::span<const Row> rows, Report& report) {
    std::vector<std::vector<std::string>> table{{"stage", "rounding", "lookup", "false shadow",
                                                 "false light", "outside the band: false shadow",
                                                 "false light"}};
    for (const char* key : rounding_keys)
        for (const Row& row : where(rows, {{"varies", key}}))
            table.push_back({key, row.text(key), row.text("lookup"), rate(row, "false_shadow"),
                             rate(row, "false_light"), rate(row, "false_shadow_outside"),
                             rate(row, "false_light_outside")});
    if (table.size() > 1)
        report.table(table, "Each rounding in place of the scene's own, a stage at a time: of a "
                            "matrix word, of a product (the accumulator being 22 bits "
                            "wide, so that there is something to round), of a transformed "
                            "coordinate, of a drawn sample's Z.");
}

// Y slowest: Z bits up, X/Y bits across.
void map_errors(std::span<const Row> rows, const char* unit, const char* column,
                const char* title, Report& report) {
    const Rows some = where(rows, {{"varies", "xy_bits and z_bits"}, {"bias_unit", unit}});
    std::set<int> across, up;
    for (const Row& row : some) {
        across.insert(static_cast<int>(row.number("xy_bits")));
        up.insert(static_cast<int>(row.number("z_bits")));
    }
    if (across.size() < 2 || up.size() < 2) return;
    HeatMap map{fmt::format("map-{}-{}", column, unit), fmt::format("{}, bias kept in {}", title,
                unit), "X and Y (bits)", "Z (bits)", "rate (%)", {}, {}, {}};
    for (const int xy : across) map.x_ticks.push_back(std::to_string(xy));
    for (const int z : up) {
        map.y_ticks.push_back(std::to_string(z));
        for (const int xy : across) {
            double value = std::nan("");
            for (const Row& row : some)
                if (row.number("xy_bits") == xy && row.number("z_bits") == z)
                    value = 100 * row.number(column);
            map.values.push_back(value);
        }
    }
    report.heat_map(map, fmt::format("Nearest lookup, no dither. The bias is the same {} on every "
                                     "machine: half a texel of the scene's own.",
                                     std::string_view(unit) == "world" ? "length in the world"
                                                                       : "part of its texel"));
}

// What the least step from the scene's own value does, for each width.
void tell_steps(std::span<const Row> rows, Report& report) {
    std::vector<std::vector<std::string>> table{
        {"width", "lookup", "from", "to", "false shadow", "changes by", "false light",
         "changes by"}};
    for (const char* key : bit_keys)
        for (const char* lookup : {"nearest", "bilinear"}) {
            Rows some = where(rows, {{"varies", key}, {"lookup", lookup}, {"bias_unit", "world"}});
            std::stable_sort(some.begin(), some.end(), [&](const Row& a, const Row& b) {
                return a.number(key) < b.number(key);
            });
            for (std::size_t k = 1; k < some.size(); ++k) {
                const auto gain = [&](const char* column) {
                    return fmt::format("{:+.3f} %", 100 * (some[k].number(column) -
                                                           some[k - 1].number(column)));
                };
                table.push_back({key, lookup, some[k - 1].text(key), some[k].text(key),
                                 rate(some[k], "false_shadow"), gain("false_shadow"),
                                 rate(some[k], "false_light"), gain("false_light")});
            }
        }
    report.table(table, "What each step of a width buys, the bias the same in world units.");
}

// Williams 1978, p. 273: the nine bits of X and Y, not the sixteen of Z, are the problem.
void tell_paper(std::span<const Row> rows, Report& report) {
    auto& json = report.summary()["xy_against_z"];
    for (const char* lookup : {"nearest", "bilinear"}) {
        // NaN where the study has not both ends.
        const auto differs = [&](const char* key, double min, double max) {
            double low = std::nan(""), high = std::nan("");
            for (const Row& row :
                 where(rows, {{"varies", key}, {"lookup", lookup}, {"bias_unit", "world"}})) {
                if (row.number(key) == min) low = row.number("false_shadow");
                if (row.number(key) == max) high = row.number("false_shadow");
            }
            return std::abs(high - low);
        };
        const double by_xy = differs("xy_bits", 8, 9), by_z = differs("z_bits", 12, 16);
        if (std::isnan(by_xy) || std::isnan(by_z)) continue;
        json[lookup] = {{"xy_8_to_9", by_xy}, {"z_12_to_16", by_z}};
        report.paragraph(fmt::format(
            "{} lookup, the bias kept in world units: between 8 and 9 bits of X and Y false shadow "
            "differs by {:.3f} % of the lit pixels, between 12 and 16 bits of Z by {:.3f} %. "
            "One bit of X and Y weighs {} "
            "than four of Z.",
            lookup, 100 * by_xy, 100 * by_z, by_xy > by_z ? "more" : "less"));
    }
}

// With n pixels a side, from the scene's own number upward if there are two: what grows as which
// power of n, and what halving an error costs.
void tell_growth(const Request& request, std::span<const Row> rows, const char* lookup,
                 Report& report) {
    for (const char* unit : {"world", "texels"}) {
        const Rows all =
            where(rows, {{"varies", "xy_bits"}, {"lookup", lookup}, {"bias_unit", unit}});
        Rows some;
        for (const Row& row : all)
            if (row.number("xy_bits") >= request.scene.settings.machine.xy_bits)
                some.push_back(row);
        if (some.size() < 2) some = all;
        if (some.size() < 2) continue;
        auto& json = report.summary()["grows_with_pixels_a_side_to_the"][lookup][unit];
        std::string words, price;
        for (const char* column : {"light_map_bytes", "drawing_cycles", "transformation_cycles",
                                   "false_shadow", "false_light"}) {
            const double power = growth_per_doubling(some, column);
            json[column] = power;
            if (!std::isfinite(power)) continue;
            words += fmt::format("{}{} {:.2f}", words.empty() ? "" : ", ", column, power);
            if (power < -0.1)
                price += fmt::format("; half the {} costs {:.3g} times the memory", column,
                                     std::pow(2.0, -2 / power));
        }
        if (!words.empty())
            report.paragraph(fmt::format(
                "{} lookup, n pixels a side from {} to {} bits of X and Y, the bias kept in {}: as "
                "n to the power grow {}{}.", lookup, some.front().text("xy_bits"),
                some.back().text("xy_bits"), unit, words, price));
    }
}

void tell_square_law(const Request& request, std::span<const Row> rows, Report& report) {
    std::vector<std::vector<std::string>> table{{"lookup", "X/Y bits", "false shadow",
        "false light", "light map, bytes", "drawing, cycles", "transformation, cycles",
        "host, ms"}};
    for (const char* lookup : {"nearest", "bilinear"}) {
        const Rows some =
            where(rows, {{"varies", "xy_bits"}, {"lookup", lookup}, {"bias_unit", "texels"}});
        if (some.empty()) continue;
        const auto cells = some[0].cells();
        const bool has_times = std::any_of(
            cells.begin(), cells.end(), [](const auto& c) { return c.first == "frame_host_ms"; });
        for (const Row& row : some)
            table.push_back({lookup, row.text("xy_bits"), rate(row, "false_shadow"),
                             rate(row, "false_light"), row.text("light_map_bytes"),
                             row.text("drawing_cycles"), row.text("transformation_cycles"),
                             has_times ? fmt::format("{:.1f}", row.number("frame_host_ms")) : ""});
        tell_growth(request, rows, lookup, report);
        Plot plot;
        plot.name = fmt::format("square-law-{}", lookup);
        plot.title = fmt::format("What lateral resolution buys, {} lookup", lookup);
        plot.x_label = "light map (bytes)";
        plot.y_label = "rate (%)";
        plot.log_x = true;
        for (const char* column : {"false_shadow", "false_light", "false_shadow_outside"})
            plot.series.push_back(curve(column, some, "light_map_bytes", column, 100));
        report.plot(plot, "Every doubling of the sides is four times the memory, a point on each "
                          "line, and four times the transformation's cycles; the bias is half a "
                          "texel of each map. The edge band is a texel wide: a coarser map's "
                          "leaves more of the error out.");
    }
    if (table.size() > 1)
        report.table(table, "The square-law expense of lateral resolution (Williams 1978, p. 273): "
                            "X and Y of both frame stores, the bias half a texel of each map. "
                            "Errors are of the picture's own pixels; cycles with the units side "
                            "by side.");
}

// The fewest bits that move no rate by a thousandth.
void tell_accumulator(std::span<const Row> rows, Report& report) {
    for (const char* lookup : {"nearest", "bilinear"}) {
        Rows some = where(rows, {{"varies", "accumulator_bits"}, {"lookup", lookup}});
        std::stable_sort(some.begin(), some.end(), [](const Row& a, const Row& b) {
            return a.number("accumulator_bits") > b.number("accumulator_bits");
        });
        const auto is_exact = [](const Row& row) {
            return row.number("built_accumulator_bits") ==
                   row.number("word_bits") + row.number("coefficient_bits") + 3;
        };
        if (some.size() < 2 || !is_exact(some.front())) continue;
        const Row& exact = some.front();
        const auto moved = [&](const Row& row, const char* column) {
            return row.number(column) - exact.number(column);
        };
        const auto enough = std::find_if(some.begin(), some.end(), [&](const Row& row) {
            return std::abs(moved(row, "false_shadow")) >= 0.001 ||
                   std::abs(moved(row, "false_light")) >= 0.001;
        }) - 1;
        report.paragraph(fmt::format(
            "{} lookup: an accumulator that holds four products exactly has {} bits; with {} no "
            "rate moves by a tenth of a point; with {} false shadow moves by {:+.2f} % and "
            "false light by {:+.2f} %.",
            lookup, exact.text("built_accumulator_bits"), enough->text("built_accumulator_bits"),
            some.back().text("built_accumulator_bits"), 100 * moved(some.back(), "false_shadow"),
            100 * moved(some.back(), "false_light")));
    }
}

}  // namespace

double growth_per_doubling(std::span<const Row> rows, const char* column) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Row& row : rows) {
        if (!(row.number(column) > 0)) continue;
        const double x = row.number("xy_bits"), y = std::log2(row.number(column));
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void report_widths(const Request& request, std::span<const Row> rows, Report& report) {
    tell_paper(rows, report);
    tell_accumulator(rows, report);
    tell_square_law(request, rows, report);
    for (const char* key : bit_keys) plot_width(rows, key, "world", report);
    plot_width(rows, "xy_bits", "texels", report);
    for (const char* unit : {"world", "texels"}) {
        map_errors(rows, unit, "false_shadow", "False shadow", report);
        map_errors(rows, unit, "false_light", "False light", report);
    }
    tell_steps(rows, report);
    // Of the paper's scene at f = 1: false shadow 7.1 % with the light at azimuth -100, 43.8 % at
    // +100; at f = 7, 23.9 % and 23.4 %.
    report.paragraph(
        "A step that loses bits may lower false shadow, and is no gain: with nearest lookup X and "
        "Y rounded half up to f fraction bits, and then cut to a texel, look half of 2^-f texel "
        "too far to one side, which a light from one side turns into less false shadow and more "
        "false light, and from the other into the reverse.");
    tell_roundings(rows, report);
}

}  // namespace umbra78::tools::study
