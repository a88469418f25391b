#include "tools/study/widths/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

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

std::string rate(const Row& row, const char* column) { return percent(row.number(column)); }

// A difference of two rates, in percentage points with their sign.
std::string points(double difference) { return fmt::format("{:+.2f} points", 100 * difference); }

// A column's name in prose; the word itself where it says enough.
std::string words_of(std::string_view column) {
    constexpr std::pair<std::string_view, std::string_view> words[] = {
        {"xy_bits", "bits of X and Y"}, {"z_bits", "bits of Z"},
        {"coefficient_bits", "bits of a matrix coefficient"},
        {"accumulator_bits", "bits of the accumulator, at most"},
        {"fraction_bits", "fraction bits of X and Y"},
        {"coefficient_rounding", "matrix coefficient"}, {"product_rounding", "product"},
        {"transform_rounding", "transformed coordinate"}, {"depth_rounding", "drawn sample's Z"},
        {"light_map_bytes", "the light map's memory"}, {"drawing_cycles", "cycles of drawing"},
        {"transformation_cycles", "cycles of the transformation"},
        {"false_shadow", "false shadow"}, {"false_light", "false light"},
        {"false_shadow_outside", "false shadow outside the edge band"},
        {"world", "world units"}};
    for (const auto& [name, meaning] : words)
        if (name == column) return std::string(meaning);
    return std::string(column);
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
    plot.title = fmt::format("Errors over {}, bias kept in {}", words_of(key), words_of(unit));
    plot.x_label = words_of(key);
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
        report.plot(plot, fmt::format("The other widths are the scene's; the bias is the same in "
                                      "{} for all.", words_of(unit)));
}

void table_roundings(std::span<const Row> rows, Report& report) {
    TableCells table{{"what is rounded", "rounding", "lookup", "false shadow", "false light",
                      "outside the edge band: false shadow", "false light"}};
    for (const char* key : rounding_keys)
        for (const Row& row : where(rows, {{"varies", key}}))
            table.push_back({words_of(key), row.text(key), row.text("lookup"),
                             rate(row, "false_shadow"), rate(row, "false_light"),
                             rate(row, "false_shadow_outside"), rate(row, "false_light_outside")});
    if (table.size() == 1) return;
    report.heading("Roundings");
    report.table(table, "Each rounding in place of the scene's own, one stage at a time. For the "
                        "product the accumulator has 22 bits, so that there is something to "
                        "round.");
}

// Bits of X and Y go across, bits of Z go up.
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
                words_of(unit)), "bits of X and Y", "bits of Z", "rate (%)", {}, {}, {}};
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

// What each step of a width changes.
void table_steps(std::span<const Row> rows, Report& report) {
    TableCells table{{"width", "lookup", "from", "to", "false shadow", "changes by", "false light",
                      "changes by"}};
    for (const char* key : bit_keys)
        for (const char* lookup : {"nearest", "bilinear"}) {
            Rows some = where(rows, {{"varies", key}, {"lookup", lookup}, {"bias_unit", "world"}});
            std::stable_sort(some.begin(), some.end(), [&](const Row& a, const Row& b) {
                return a.number(key) < b.number(key);
            });
            for (std::size_t k = 1; k < some.size(); ++k) {
                const auto gain = [&](const char* column) {
                    return points(some[k].number(column) - some[k - 1].number(column));
                };
                table.push_back({words_of(key), lookup, some[k - 1].text(key), some[k].text(key),
                                 rate(some[k], "false_shadow"), gain("false_shadow"),
                                 rate(some[k], "false_light"), gain("false_light")});
            }
        }
    report.heading("Every step of every width");
    report.table(table, "The rates with the wider of two widths, and by how much they differ from "
                        "those with the narrower. The bias is the same in world units.");
    // Of the paper's scene with 1 fraction bit: false shadow 7.1 % with the light at azimuth -100,
    // 43.8 % at +100; with 7, 23.9 % and 23.4 %.
    report.paragraph(
        "A step that loses bits may lower false shadow, and is no gain. With nearest lookup X and "
        "Y are rounded half up to f fraction bits and then cut to a texel, so that the lookup is "
        "half of 2^-f texel too far to one side. A light from one side turns this into less false "
        "shadow and more false light, a light from the other side into the reverse.");
}

// How false shadow changes from one width of a sweep to another.
struct Change {
    std::string from, to;  // the widths
    double points = 0;     // of a rate 0 .. 1
};

// Between the given widths, or where the sweep has not both, between its two widest; nothing if it
// has fewer than two.
std::optional<Change> change_of(std::span<const Row> all, const char* key, const char* lookup,
                                const char* from, const char* to) {
    Rows rows = where(all, {{"varies", key}, {"lookup", lookup}, {"bias_unit", "world"}});
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        return a.number(key) < b.number(key);
    });
    if (rows.size() < 2) return std::nullopt;
    const Row *low = nullptr, *high = nullptr;
    for (const Row& row : rows) {
        if (row.text(key) == from) low = &row;
        if (row.text(key) == to) high = &row;
    }
    if (low == nullptr || high == nullptr) low = &rows[rows.size() - 2], high = &rows.back();
    return Change{low->text(key), high->text(key),
                  std::abs(high->number("false_shadow") - low->number("false_shadow"))};
}

// Williams 1978, p. 273: the nine bits of X and Y, not the sixteen of Z, are the problem.
void answer_paper(std::span<const Row> rows, Report& report) {
    auto& json = report.summary()["xy_against_z"];
    for (const char* lookup : {"nearest", "bilinear"}) {
        const auto xy = change_of(rows, "xy_bits", lookup, "8", "9"),
                   z = change_of(rows, "z_bits", lookup, "12", "16");
        if (!xy || !z) continue;
        json[lookup] = {{fmt::format("xy_{}_to_{}", xy->from, xy->to), xy->points},
                        {fmt::format("z_{}_to_{}", z->from, z->to), z->points}};
        report.answer(fmt::format(
            "With {} lookup and the bias kept in world units, false shadow changes by {:.2f} "
            "points between {} and {} bits of X and Y, and by {:.2f} between {} and {} bits of Z: "
            "X and Y matter {}.",
            lookup, 100 * xy->points, xy->from, xy->to, 100 * z->points, z->from, z->to,
            xy->points > z->points ? "more" : "less"));
    }
}

// n pixels a side, from the scene's own number upward if there are two: the power of n with which
// a column grows, and what halving an error costs in memory, which grows as n^2.
void add_growth(const Request& request, std::span<const Row> rows, const char* lookup,
                TableCells& table, Report& report) {
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
        for (const char* column : {"light_map_bytes", "drawing_cycles", "transformation_cycles",
                                   "false_shadow", "false_light"}) {
            const double power = growth_per_doubling(some, column);
            json[column] = power;
            if (!std::isfinite(power)) continue;
            table.push_back({lookup, words_of(unit), some.front().text("xy_bits"),
                             some.back().text("xy_bits"), words_of(column),
                             fmt::format("{:.2f}", power),
                             power < -0.1 ? rounded(std::pow(2.0, -2 / power), 2) + " times"
                                          : ""});
        }
    }
}

void report_square_law(const Request& request, std::span<const Row> rows, Report& report) {
    report.heading("The square-law expense of lateral resolution");
    TableCells table{{"lookup", "bits of X and Y", "false shadow", "false light",
                      "light map, bytes", "drawing, cycles", "transformation, cycles",
                      "this computer, ms"}};
    TableCells growth{{"lookup", "bias kept in", "bits of X and Y, from", "to", "what grows",
                       "as the pixels a side to the power", "memory for half of it"}};
    for (const char* lookup : {"nearest", "bilinear"}) {
        const Rows some =
            where(rows, {{"varies", "xy_bits"}, {"lookup", lookup}, {"bias_unit", "texels"}});
        if (some.empty()) continue;
        const bool has_times = some[0].has("frame_host_ms");
        for (const Row& row : some)
            table.push_back({lookup, row.text("xy_bits"), rate(row, "false_shadow"),
                             rate(row, "false_light"), row.text("light_map_bytes"),
                             row.text("drawing_cycles"), row.text("transformation_cycles"),
                             has_times ? rounded(row.number("frame_host_ms"), 2) : ""});
        add_growth(request, rows, lookup, growth, report);
        Plot plot;
        plot.name = fmt::format("square-law-{}", lookup);
        plot.title = fmt::format("What lateral resolution buys, {} lookup", lookup);
        plot.x_label = "light map (bytes)";
        plot.y_label = "rate (%)";
        plot.log_x = true;
        for (const char* column : {"false_shadow", "false_light", "false_shadow_outside"})
            plot.series.push_back(
                curve(words_of(column), some, "light_map_bytes", column, 100));
        report.plot(plot, "From each point of a line to the next the sides double, which is four "
                          "times the memory and four times the transformation's cycles. The bias "
                          "is half a texel of each map. The edge band is a texel wide, so that of "
                          "a coarser map leaves more of the error out.");
    }
    if (table.size() > 1)
        report.table(table, "Both frame stores have the bits of X and Y (Williams 1978, p. 273); "
                            "the bias is half a texel of each map. Errors are of the picture's "
                            "own pixels; cycles are those of units that work side by side.");
    if (growth.size() > 1)
        report.table(growth, "The powers are a least-squares fit of logarithms. The last column is "
                             "the factor in memory, which grows as the square, that halves the "
                             "error.");
}

// The fewest bits that change no rate by a tenth of a percentage point.
void answer_accumulator(std::span<const Row> rows, Report& report) {
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
        report.answer(fmt::format(
            "With {} lookup the accumulator needs {} of its {} bits: with {} no rate changes by a "
            "tenth of a point. With {}, false shadow changes by {} and false light by {}.",
            lookup, enough->text("built_accumulator_bits"), exact.text("built_accumulator_bits"),
            enough->text("built_accumulator_bits"), some.back().text("built_accumulator_bits"),
            points(moved(some.back(), "false_shadow")),
            points(moved(some.back(), "false_light"))));
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
    answer_paper(rows, report);
    answer_accumulator(rows, report);
    plot_width(rows, "xy_bits", "world", report);
    plot_width(rows, "z_bits", "world", report);
    report.heading("The other widths");
    for (const char* key : {"coefficient_bits", "accumulator_bits", "fraction_bits"})
        plot_width(rows, key, "world", report);
    plot_width(rows, "xy_bits", "texels", report);
    report_square_law(request, rows, report);
    report.heading("X and Y against Z");
    for (const char* unit : {"world", "texels"}) {
        map_errors(rows, unit, "false_shadow", "False shadow", report);
        map_errors(rows, unit, "false_light", "False light", report);
    }
    table_steps(rows, report);
    table_roundings(rows, report);
}

}  // namespace umbra78::tools::study
