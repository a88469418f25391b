// The page of the study of error against run time.
#include "tools/study/error_time/error_time.hpp"
#include "tools/study/pareto.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace umbra78::tools::study {
namespace {

// A figure of a row: its column, its word in files' names, its label on an axis, how it reads in a
// sentence, its unit.
struct Quantity {
    const char *column, *name, *label, *words, *unit;
    double scale = 1;  // the column's value times this is in the unit
};
constexpr std::array<Quantity, 2> costs{
    {{"frame_machine_ms", "machine", "time on the machine of 1978, ms a frame (simulated)",
      "the machine's time", "ms"},
     {"total_host_ms", "host", "time on this computer, ms a frame (median)",
      "this computer's time", "ms"}}};
constexpr std::array<Quantity, 3> errors{
    {{"wrong", "overall", "wrong pixels, %", "wrong pixels", "%", 100},
     {"edge_mean_world", "edge", "mean distance of the shadow's edge, world units",
      "the mean distance of the shadow's edge from the true one", "world units"},
     {"outside_wrong", "outside", "wrong pixels outside the edge band, %",
      "wrong pixels outside the edge band", "%", 100}}};

bool is_host(const Quantity& cost) { return std::string_view(cost.name) == "host"; }

// The median, over all settings, of the share of its time by which a setting's repeated runs
// differ.
double host_noise(std::span<const Row> rows) {
    std::vector<double> shares;
    for (const Row& row : rows)
        shares.push_back(row.number("spread_host_ms") / row.number("total_host_ms"));
    std::sort(shares.begin(), shares.end());
    return shares[shares.size() / 2];
}

// A front and the rows it was made from.
struct Front {
    Quantity cost, error;
    std::vector<Row> rows;
    std::vector<CostAndError> points;
    double noise = 0;                // a share of the cost; costs that differ by less are equal
    std::vector<std::size_t> front;  // cheapest first
    std::vector<std::size_t> equal;  // on the front but for the noise
    double floor = 0;  // half the least error that can be measured; no error is drawn there

    const Row& row(std::size_t k) const { return rows[front[k]]; }
    const CostAndError& point(std::size_t k) const { return points[front[k]]; }
    std::size_t knee() const { return knee_of(points, front, floor); }
};

// The edge band is a texel wide, so with fewer bits of X and Y it leaves out more pixels. Errors
// outside it are therefore compared at one resolution: the scene's own, or that of the most rows.
std::string resolution_of(const Request& request, std::span<const Row> rows) {
    std::map<std::string, std::size_t> count;
    for (const Row& row : rows) ++count[row.text("xy_bits")];
    const std::string own = fmt::format("{}", request.scene.settings.machine.xy_bits);
    if (count.contains(own)) return own;
    const auto max = std::max_element(
        count.begin(), count.end(), [](auto& a, auto& b) { return a.second < b.second; });
    return max == count.end() ? own : max->first;
}

Front front_of(std::span<const Row> rows, const Quantity& cost, const Quantity& error,
               const std::string& one_resolution) {
    Front f{cost, error, {}, {}, 0, {}, {}, 0};
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
    if (is_host(cost) && !f.rows.empty()) f.noise = host_noise(f.rows);
    f.front = pareto_front(f.points, f.noise);
    for (const std::size_t k : pareto_front(f.points))
        if (std::find(f.front.begin(), f.front.end(), k) == f.front.end()) f.equal.push_back(k);
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
    const auto shown = [&](std::size_t k) {
        return CostAndError{f.points[k].first, std::max(f.points[k].second, f.floor)};
    };
    for (const char* name : {"nearest, no dither", "nearest, dither", "bilinear, no dither",
                             "bilinear, dither"}) {
        Series cloud{name, {}, false, {}};
        for (std::size_t k = 0; k < f.rows.size(); ++k)
            if (cloud_of(f.rows[k]) == name) cloud.points.push_back(shown(k));
        if (!cloud.points.empty()) plot.series.push_back(std::move(cloud));
    }
    const auto named = [&](const char* title, bool line, const std::vector<std::size_t>& which) {
        Series series{title, {}, line, {}};
        for (const std::size_t k : which) {
            series.points.push_back(shown(k));
            series.labels.push_back(f.rows[k].text("case"));
        }
        if (!series.points.empty()) plot.series.push_back(std::move(series));
    };
    named("Pareto front", true, f.front);
    named("as fast as one of the front, within the noise", false, f.equal);
    std::string caption = fmt::format(
        "Each point is a setting; left is faster, down is better. The line joins the {} of {} "
        "settings that no other setting beats in both, labelled with the numbers of their cases, "
        "which the table below names. The axis is logarithmic: no error at all is drawn as {} {}.",
        f.front.size(), f.rows.size(), rounded(f.floor, 2), f.error.unit);
    if (f.noise > 0)
        caption += fmt::format(" Times that differ by less than the noise, {}, count as equal: {} "
                               "settings are left out of the line because one with less error "
                               "takes the same time.", percent(f.noise), f.equal.size());
    to.plot(plot, caption);
}

void table_of(const Front& f, Report& to) {
    TableCells table{{"case", "setting", f.cost.label, f.error.label, "false shadow",
                      "false light", "isolated pixels"}};
    for (std::size_t k = 0; k < f.front.size(); ++k) {
        const Row& row = f.row(k);
        table.push_back({row.text("case"), short_name(row, f.rows), rounded(f.point(k).first),
                         rounded(f.point(k).second, 2), percent(row.number("false_shadow")),
                         percent(row.number("false_light")), row.text("isolated_pixels")});
    }
    to.table(table, fmt::format("The front of {} against {}, fastest first. False shadow is the "
                                "share of the lit pixels that are drawn in shadow, false light the "
                                "reverse; an isolated pixel agrees with none of its neighbours.",
                                f.error.label, f.cost.label));
}

nlohmann::ordered_json to_json(const Front& f) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < f.front.size(); ++k)
        json.push_back({{"case", std::int64_t(f.row(k).number("case"))},
                        {"setting", short_name(f.row(k), f.rows)},
                        {f.cost.column, f.point(k).first},
                        {f.error.column, f.row(k).number(f.error.column)}});
    return json;
}

std::string setting_of(const Front& f, std::size_t k) {
    return fmt::format("{} (case {}: {} {}, {} {})", short_name(f.row(k), f.rows),
                       f.row(k).text("case"), rounded(f.point(k).first), f.cost.unit,
                       rounded(f.point(k).second, 2), f.error.unit);
}

std::string answer_of(const Front& f) {
    std::string text = fmt::format("By {} and {}: the fastest setting is {}.", f.cost.words,
                                   f.error.words, setting_of(f, 0));
    if (f.front.size() == 1) {
        text += fmt::format(" It also has the least error of all {} settings.", f.rows.size());
    } else {
        text += fmt::format(" The setting with the least error is {}.",
                            setting_of(f, f.front.size() - 1));
        if (const std::size_t knee = f.knee(); knee > 0)
            text += fmt::format(" Between them the front bends at {}.", setting_of(f, knee));
        text += fmt::format(" No other setting beats {} of the {} in both time and error.",
                            f.front.size(), f.rows.size());
    }
    if (f.noise > 0)
        text += fmt::format(" Repeated runs of a setting differ by {} of its time (median); times "
                            "that differ by less count as equal.", percent(f.noise));
    return text;
}

void summarize(const Front& f, Report& to) {
    const auto answer = [&](std::size_t k) {
        return nlohmann::ordered_json{{"case", std::int64_t(f.row(k).number("case"))},
                                      {"setting", short_name(f.row(k), f.rows)}};
    };
    nlohmann::ordered_json& json =
        to.summary()[fmt::format("{}_{}", f.cost.name, f.error.name)];
    json["for_speed"] = answer(0);
    json["for_least_error"] = answer(f.front.size() - 1);
    json["between"] = answer(f.knee());
    if (f.noise > 0) json["noise"] = f.noise;
    json["front"] = to_json(f);
}

}  // namespace

void report_error_time(const Request& request, std::span<const Row> rows, Report& to) {
    bool any = false;
    for (const Quantity& cost : costs) {
        if (is_host(cost) && !request.host_times) continue;
        for (const Quantity& error : errors) {
            const Front f = front_of(rows, cost, error, resolution_of(request, rows));
            if (f.front.empty()) continue;
            if (!is_host(cost)) to.answer(answer_of(f));
            if (any) to.heading(fmt::format("By {} and {}", cost.words, error.words));
            any = true;
            if (is_host(cost)) to.paragraph(answer_of(f));
            plot_front(f, to);
            table_of(f, to);
            summarize(f, to);
        }
    }
    if (!any) {
        to.answer("There are times and hashes, but no errors: the scene has free patches, whose "
                  "truth is traced by Embree, and this program is built without it.");
        return;
    }
    to.heading("How it was measured");
    to.paragraph(request.only
                     ? "The cases are the product of what --vary names; the rest is the scene's."
                     : "The cases are a grid of form, resolution, lookup, dither and filters, and "
                       "the other settings one at a time with the scene's own values; the values "
                       "of --vary replace a key's. Where the bias is not varied it is the scene's "
                       "in texels: with fewer bits of X and Y it grows as the texels do, with "
                       "fewer bits of Z it stays.");
    to.paragraph("A time on this computer is the median of a thread's own time on a processor, "
                 "while other cases run on the other cores.");
    to.paragraph("The edge band is one light texel, mapped back to the observer, on either side of "
                 "the true shadow's edge, and the filters' reach. It leaves out more pixels where "
                 "texels are larger, so errors outside it are compared at one resolution. The "
                 "distance of the shadow's edge from the true one is compared at all resolutions; "
                 "acne has edges, too, far from the true one.");
}

}  // namespace umbra78::tools::study
