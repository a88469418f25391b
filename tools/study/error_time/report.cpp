#include "tools/study/error_time/error_time.hpp"
#include "tools/study/error_time/pareto.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace umbra78::tools::study {
namespace {

// A column, its word in a file's name, how it is told, and in which unit.
struct Axis2 {
    const char *column, *name, *label, *unit;
    double scale = 1;  // units in one of the column's
};
constexpr std::array<Axis2, 2> costs{
    {{"total_host_ms", "host", "host, ms a frame (median)", "ms"},
     {"frame_machine_ms", "machine", "machine of the time, ms a frame (simulated)", "ms"}}};
constexpr std::array<Axis2, 3> errors{
    {{"outside_wrong", "outside", "wrong pixels outside the edge band, %", "%", 100},
     {"wrong", "overall", "wrong pixels, %", "%", 100},
     {"edge_mean_world", "edge", "mean distance of the shadow's edge, world units",
      "world units"}}};

// A front with the rows it is of.
struct Front {
    Axis2 cost, error;
    std::vector<Row> rows;
    std::vector<CostAndError> points;
    std::vector<std::size_t> front;    // cheapest first
    double floor = 0;                  // half the least error there can be, drawn for none

    const Row& row(std::size_t k) const { return rows[front[k]]; }
    const CostAndError& point(std::size_t k) const { return points[front[k]]; }
    std::size_t knee() const { return knee_of(points, front, floor); }
};

// The edge band is a texel wide: with fewer bits of X and Y it leaves more pixels out. So errors
// outside it are compared at one resolution, the scene's own or else that of the most rows.
std::string resolution_of(const Request& request, std::span<const Row> rows) {
    std::map<std::string, std::size_t> count;
    for (const Row& row : rows) ++count[row.text("xy_bits")];
    const std::string own = fmt::format("{}", request.scene.settings.machine.xy_bits);
    if (count.contains(own)) return own;
    const auto max = std::max_element(
        count.begin(), count.end(), [](auto& a, auto& b) { return a.second < b.second; });
    return max == count.end() ? own : max->first;
}

Front front_of(std::span<const Row> rows, const Axis2& cost, const Axis2& error,
               const std::string& one_resolution) {
    Front f{cost, error, {}, {}, {}, 0};
    const bool rate = std::string_view(error.unit) == "%";
    double min = error.scale;
    const bool outside = std::string_view(error.name) == "outside";
    for (const Row& row : rows) {
        if (row.text("status") != "ok" || std::isnan(row.number(error.column))) continue;
        if (outside && row.text("xy_bits") != one_resolution) continue;
        f.rows.push_back(row);
        f.points.emplace_back(row.number(cost.column), error.scale * row.number(error.column));
        const double pixels = row.number("lit_pixels") + row.number("shadowed_pixels");
        const double here = rate ? error.scale / std::max(pixels, 1.0) : f.points.back().second;
        if (here > 0) min = std::min(min, here);
    }
    f.front = pareto_front(f.points);
    f.floor = min / 2;
    return f;
}

std::string cloud_of(const Row& row) {
    return fmt::format("{}, {}", row.text("lookup"),
                       row.text("dither") == "none" ? "no dither" : "dither");
}

void plot_front(const Front& f, Report& to) {
    Plot plot;
    plot.name = fmt::format("front-{}-{}", f.cost.name, f.error.name);
    plot.title = fmt::format("Error against time: {}", f.error.label);
    plot.x_label = f.cost.label;
    plot.y_label = f.error.label;
    plot.log_x = plot.log_y = true;
    const auto shown = [&](const CostAndError& p) {
        return CostAndError{p.first, std::max(p.second, f.floor)};
    };
    for (const char* name : {"nearest, no dither", "nearest, dither", "bilinear, no dither",
                             "bilinear, dither"}) {
        Series cloud{name, {}, false, {}};
        for (std::size_t k = 0; k < f.rows.size(); ++k)
            if (cloud_of(f.rows[k]) == name) cloud.points.push_back(shown(f.points[k]));
        if (!cloud.points.empty()) plot.series.push_back(std::move(cloud));
    }
    Series line{"Pareto front", {}, true, {}};
    for (std::size_t k = 0; k < f.front.size(); ++k) {
        line.points.push_back(shown(f.point(k)));
        line.labels.push_back(f.row(k).text("case"));
    }
    plot.series.push_back(std::move(line));
    to.plot(plot, fmt::format("Each point is a setting; left is faster, down is better. The line "
                              "joins the settings that no other beats in both, {} of {}, with the "
                              "numbers of their cases, which the table names. No error at all is "
                              "drawn as {:.2g} {}, for the axis is logarithmic.",
                              f.front.size(), f.rows.size(), f.floor, f.error.unit));
}

void table_of(const Front& f, std::span<const Row> all, Report& to) {
    std::vector<std::vector<std::string>> table{
        {"case", "setting", f.cost.label, f.error.label, "false shadow %", "false light %",
         "isolated pixels"}};
    for (std::size_t k = 0; k < f.front.size(); ++k) {
        const Row& row = f.row(k);
        table.push_back({row.text("case"), short_name(row, all),
                         fmt::format("{:.4g}", f.point(k).first),
                         fmt::format("{:.4g}", f.point(k).second),
                         fmt::format("{:.3g}", 100 * row.number("false_shadow")),
                         fmt::format("{:.3g}", 100 * row.number("false_light")),
                         row.text("isolated_pixels")});
    }
    to.table(table, fmt::format("The front of {} against {}, fastest first.", f.error.label,
                                f.cost.label));
}

nlohmann::ordered_json to_json(const Front& f, std::span<const Row> all) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < f.front.size(); ++k)
        json.push_back({{"case", std::int64_t(f.row(k).number("case"))},
                        {"setting", short_name(f.row(k), all)},
                        {f.cost.column, f.point(k).first},
                        {f.error.column, f.row(k).number(f.error.column)}});
    return json;
}

std::string told(const Front& f, std::size_t k, std::span<const Row> all) {
    return fmt::format("{} (case {}: {:.{}f} {}, {:.3g} {})", short_name(f.row(k), all),
                       f.row(k).text("case"), f.point(k).first, f.point(k).first < 1000 ? 1 : 0,
                       f.cost.unit, f.point(k).second, f.error.unit);
}

// Of the host's time.
double median_spread(std::span<const Row> rows) {
    std::vector<double> shares;
    for (const Row& row : rows)
        shares.push_back(row.number("spread_host_ms") / row.number("total_host_ms"));
    std::sort(shares.begin(), shares.end());
    return shares[shares.size() / 2];
}

void tell(const Front& f, std::span<const Row> all, Report& to) {
    std::string text = fmt::format("By the {}'s time and {}: for speed, {}",
                                   f.cost.name, f.error.label, told(f, 0, all));
    if (f.front.size() == 1) {
        text += fmt::format("; none of the {} settings has less error, so that one dominates "
                            "them all.", f.rows.size());
    } else {
        text += fmt::format("; for least error, {}", told(f, f.front.size() - 1, all));
        if (const std::size_t knee = f.knee(); knee > 0)
            text += fmt::format("; where the front bends, {}", told(f, knee, all));
        text += fmt::format(". The front has {} settings of {}: each buys less error with more "
                            "time, and none is best for all.", f.front.size(), f.rows.size());
    }
    if (std::string_view(f.cost.name) == "host")
        text += fmt::format(" Runs of one setting differ by {:.1f} % of its time (median): costs "
                            "nearer than that are equal.", 100 * median_spread(f.rows));
    to.paragraph(text);
    const auto answer = [&](std::size_t k) {
        return nlohmann::ordered_json{{"case", std::int64_t(f.row(k).number("case"))},
                                      {"setting", short_name(f.row(k), all)}};
    };
    nlohmann::ordered_json& json =
        to.summary()[fmt::format("{}_{}", f.cost.name, f.error.name)];
    json["for_speed"] = answer(0);
    json["for_least_error"] = answer(f.front.size() - 1);
    json["between"] = answer(f.knee());
    json["front"] = to_json(f, all);
}

}  // namespace

void report_error_time(const Request& request, std::span<const Row> rows, Report& to) {
    to.paragraph("A main grid of form, resolution, lookup, dither and filters, and the other "
                 "settings one at a time about the scene's own; --vary replaces a key's values. "
                 "The bias is the scene's in texels, where it is not varied: with fewer bits of "
                 "X and Y it grows as the texels do, with fewer of Z it stays. Host times are "
                 "medians of a thread's own time on a processor, while other cases run on the "
                 "other cores. The edge band is a light texel mapped back and the filters' "
                 "reach: it leaves out more where texels are larger, so errors outside it are "
                 "compared at one resolution. The distance of the shadow's edge from the true one, "
                 "in world units, is compared at all: acne is edge, too, and far from a true one.");
    bool any = false;
    for (const Axis2& cost : costs) {
        if (!request.host_times && std::string_view(cost.name) == "host") continue;
        for (const Axis2& error : errors) {
            const Front f = front_of(rows, cost, error, resolution_of(request, rows));
            if (f.front.empty()) continue;
            any = true;
            tell(f, f.rows, to);
            plot_front(f, to);
            table_of(f, f.rows, to);
        }
    }
    if (!any)
        to.paragraph("The scene has free patches, whose truth is traced by Embree, without which "
                     "this program is built: there are times and hashes, but no errors.");
}

}  // namespace umbra78::tools::study
