// The page of the study of contours.
#include "tools/study/contours/contours.hpp"
#include "tools/study/contours/crops.hpp"
#include "tools/study/report_sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace umbra78::tools::study {
namespace {

// The edges that passes are chosen by: the surfaces' own shadow lines, which dither roughens most,
// or cast shadows' edges in a scene that shows none of the others.
struct ChosenBy {
    const char *rough, *length, *moved, *name;
};
constexpr ChosenBy by_self{"self_rough_px", "self_length_ratio", "self_moved_px",
                           "the surfaces' own shadow lines"};
constexpr ChosenBy by_cast{"cast_rough_px", "cast_length_ratio", "cast_moved_px",
                           "cast shadows' edges"};
using ByPasses = std::map<std::pair<int, int>, const Row*>;  // (dequantize, low_pass)

std::pair<int, int> passes_of(const Row& row) {
    return {static_cast<int>(row.number("dequantize")), static_cast<int>(row.number("low_pass"))};
}

std::string name_of(std::pair<int, int> passes) {
    return fmt::format("dequantize {}, low-pass {}", passes.first, passes.second);
}

// The rows of one dither and one bias.
struct Group {
    std::string dither;
    double bias;
    ByPasses edges;

    const ChosenBy& by() const {
        return std::isnan(edges.begin()->second->number(by_self.rough)) ? by_cast : by_self;
    }
    bool has(const char* column) const {
        return std::any_of(edges.begin(), edges.end(), [&](const auto& e) {
            return !std::isnan(e.second->number(column));
        });
    }
};

struct Measured {
    std::vector<Group> groups;
    ByPasses small;
    const Group* own = nullptr;  // of the scene's own dither and bias, or the first
};

Measured measured(const Request& request, std::span<const Row> rows) {
    Measured all;
    for (const Row& row : rows) {
        if (row.text("status") != "ok") continue;
        if (row.text("measured") == "small") {
            all.small[passes_of(row)] = &row;
            continue;
        }
        const auto same = [&](const Group& g) {
            return g.dither == row.text("dither") && g.bias == row.number("bias");
        };
        auto found = std::find_if(all.groups.begin(), all.groups.end(), same);
        if (found == all.groups.end())
            found = all.groups.insert(found, {row.text("dither"), row.number("bias"), {}});
        found->edges[passes_of(row)] = &row;
    }
    const shadow::Settings& own = request.scene.settings;
    const bool dithered = !hw::silent(own.dither, own.machine);
    for (const Group& g : all.groups)
        if ((g.dither != "none") == dithered &&
            g.bias == std::ldexp(static_cast<double>(own.bias_q16), -16))
            all.own = &g;
    if (all.own == nullptr && !all.groups.empty()) all.own = &all.groups.front();
    return all;
}

// What of the limits the row exceeds, in words; "" if it keeps them all.
std::string over_limit(const Row& row, const Row& unfiltered, const Row* small) {
    std::string words;
    const double moved = row.number("cast_moved_rms_px") - unfiltered.number("cast_moved_rms_px");
    if (moved > max_moved_px) words = fmt::format("moves a cast edge by {} px", rounded(moved, 2));
    if (small == nullptr) return words;
    for (const WidthLimit& limit : width_limits) {
        const double lost = small->number(fmt::format("lost_bar_{}", limit.width_px));
        if (lost > limit.max_lost)
            words += fmt::format("{}takes {} of a bar {} px wide", words.empty() ? "" : ", ",
                                 percent(lost), limit.width_px);
    }
    return words;
}

std::vector<PassesAndError> within_limits(const Group& group, const ByPasses& small) {
    std::vector<PassesAndError> kept;
    const auto none = group.edges.find({0, 0});
    if (none == group.edges.end()) return kept;
    for (const auto& [passes, row] : group.edges) {
        const auto lost = small.find(passes);
        if (!over_limit(*row, *none->second, lost == small.end() ? nullptr : lost->second).empty())
            continue;
        kept.push_back({passes.first, passes.second, row->number(group.by().rough)});
    }
    return kept;
}

std::string words_of(const Row& row, const ChosenBy& by) {
    std::string words = fmt::format("{} px rough and {} times as long as the exact one",
                                    rounded(row.number(by.rough)), rounded(row.number(by.length)));
    if (&by == &by_self && !std::isnan(row.number(by_cast.rough)))
        words += fmt::format(" (cast shadows: {} px, {} times)",
                             rounded(row.number(by_cast.rough)),
                             rounded(row.number(by_cast.length)));
    return words;
}

void answer(const Request& request, const Group& group, const ByPasses& small, Report& report) {
    if (!group.has(group.by().rough)) {
        report.answer("The observer sees no edge of a shadow on a surface: there is nothing to "
                      "smooth.");
        return;
    }
    const auto kept = within_limits(group, small);
    const auto least = least_by_passes(kept);
    const auto knee = knee_of_passes(least);
    const auto none = group.edges.find({0, 0});
    if (!knee || none == group.edges.end()) {
        report.answer("There is no knee: the passes asked for are too few.");
        return;
    }
    const Row& chosen = *group.edges.at({knee->dequantize, knee->low_pass});
    const Row& unfiltered = *none->second;
    const ChosenBy& by = group.by();
    double least_rough = knee->error;
    for (const PassesAndError& p : least) least_rough = std::min(least_rough, p.error);
    report.answer(fmt::format(
        "The knee is at {}: the contour of {} is then {}. Unfiltered it is {}. The "
        "smoothest passes within the limits leave {} px.",
        name_of(passes_of(chosen)), by.name, words_of(chosen, by), words_of(unfiltered, by),
        rounded(least_rough)));
    const shadow::Settings& s = request.scene.settings;
    const std::pair own{s.dequantize_passes, s.low_pass_passes};
    if (own != passes_of(chosen) && group.edges.contains(own))
        report.answer(fmt::format("The scene's own passes, {}, leave it {}.", name_of(own),
                                  words_of(*group.edges.at(own), by)));
    report.answer(fmt::format(
        "What no filter mends: the contour lies {} px beside the exact edge on average "
        "(unfiltered {} px; negative: the shadow is too small), for the bias and the light's "
        "texels put it there; and waves longer than a few pixels stay, {} px rms. The rates do not "
        "see the smoothing: false light goes from {} to {}, false shadow from {} to {}.",
        rounded(chosen.number(by.moved)), rounded(unfiltered.number(by.moved)),
        rounded(least_rough), percent(unfiltered.number("false_light")),
        percent(chosen.number("false_light")), percent(unfiltered.number("false_shadow")),
        percent(chosen.number("false_shadow"))));
    report.summary()["knee"] = {{"dequantize", knee->dequantize},
                                {"low_pass", knee->low_pass},
                                {by.rough, knee->error}};
}

void plot_curve(const Group& group, const ByPasses& small, Report& report) {
    Plot plot{"roughness", "Roughness of the shadow's contour over passes of the filters",
              "passes of both filters", "rms distance from a fitted line, px", false, true, {}};
    Series dequantize{"dequantize alone", {}, true, {}}, low_pass{"low-pass alone", {}, true, {}};
    for (const auto& [passes, row] : group.edges) {
        const std::pair at{static_cast<double>(passes.first + passes.second),
                           row->number(group.by().rough)};
        if (passes.second == 0) dequantize.points.push_back(at);
        if (passes.first == 0) low_pass.points.push_back(at);
    }
    Series least{"both, the least within the limits", {}, true, {}};
    for (const PassesAndError& p : least_by_passes(within_limits(group, small))) {
        least.points.emplace_back(p.passes(), p.error);
        least.labels.push_back(fmt::format("{}+{}", p.dequantize, p.low_pass));
    }
    plot.series = {std::move(least), std::move(dequantize), std::move(low_pass)};
    report.plot(plot, fmt::format(
        "Of {}; dither {}, bias {}. Labels are passes of dequantizing + of low-pass. The limits "
        "are those of the table of small shadows and {} px of a cast edge's displacement; the "
        "curves of one filter alone have none.", group.by().name, group.dither, rounded(group.bias),
        max_moved_px));
}

void map_of(const Group& group, const char* name, const char* column, const char* title,
            Report& report) {
    if (!group.has(column)) return;
    HeatMap map{name, title, "low-pass passes", "dequantize passes", column, {}, {}, {}};
    std::map<int, int> xs, ys;
    for (const auto& [passes, row] : group.edges) ys[passes.first] = xs[passes.second] = 0;
    for (const auto& [x, unused] : xs) map.x_ticks.push_back(std::to_string(x));
    for (const auto& [y, unused] : ys) {
        map.y_ticks.push_back(std::to_string(y));
        for (const auto& [x, also_unused] : xs) {
            const auto found = group.edges.find({y, x});
            map.values.push_back(found == group.edges.end() ? std::nan("")
                                                            : found->second->number(column));
        }
    }
    report.heat_map(map, fmt::format("{} Dither {}, bias {}.", title, group.dither,
                                     rounded(group.bias)));
}

void show_crops(const Request& request, const Group& group, const ByPasses& small,
                Report& report) {
    const auto knee = knee_of_passes(least_by_passes(within_limits(group, small)));
    std::vector<std::pair<int, int>> passes{{0, 0}};
    if (knee) passes.emplace_back(knee->dequantize, knee->low_pass);
    passes.push_back(group.edges.rbegin()->first);
    const Crops drawn = crops(request.scene, passes);
    if (drawn.grey.empty()) return;
    std::string names;
    for (const auto& p : passes) names += (names.empty() ? "" : "; ") + name_of(p);
    report.picture("crops", drawn.width, drawn.height, drawn.grey,
                   fmt::format("The mask about the shadow line, three times as large, with the "
                               "scene's own bias and dither. From the left: {}.", names));
}

// Unfiltered and at the knee, over the bias.
void table_of_bias(const Measured& all, Report& report) {
    TableCells table{{"dither", "bias", "passes at the knee", "self shadow: rough, px",
                      "length ratio", "moved, px", "cast: rough, px", "length ratio",
                      "moved, px (rms)", "unfiltered self: rough, px", "length ratio"}};
    for (const Group& group : all.groups) {
        const auto knee = knee_of_passes(least_by_passes(within_limits(group, all.small)));
        if (!knee) continue;
        const Row& row = *group.edges.at({knee->dequantize, knee->low_pass});
        const Row& none = *group.edges.at({0, 0});
        table.push_back({group.dither, rounded(group.bias),
                         fmt::format("{} + {}", knee->dequantize, knee->low_pass),
                         rounded(row.number("self_rough_px")),
                         rounded(row.number("self_length_ratio")),
                         rounded(row.number("self_moved_px")), rounded(row.number("cast_rough_px")),
                         rounded(row.number("cast_length_ratio")),
                         rounded(row.number("cast_moved_rms_px")),
                         rounded(none.number("self_rough_px")),
                         rounded(none.number("self_length_ratio"))});
    }
    if (table.size() > 1)
        report.table(table, "For each dither and bias the passes at the knee (dequantize + "
                            "low-pass) and the contours that they leave; then the unfiltered.");
}

void table_of_small(const Measured& all, Report& report) {
    TableCells table{{"dequantize", "low-pass", "bar 2 px", "bar 4 px", "bar 8 px", "spot 2 px",
                      "spot 4 px", "spot 8 px", "over the limits"}};
    const auto none = all.own->edges.find({0, 0});
    for (const auto& [passes, small] : all.small) {
        std::vector<std::string> cells{std::to_string(passes.first),
                                       std::to_string(passes.second)};
        for (const char* shape : {"bar", "spot"})
            for (const WidthLimit& limit : width_limits)
                cells.push_back(percent(
                    small->number(fmt::format("lost_{}_{}", shape, limit.width_px))));
        const auto edges = all.own->edges.find(passes);
        const bool both = edges != all.own->edges.end() && none != all.own->edges.end();
        cells.push_back(both ? over_limit(*edges->second, *none->second, small) : "");
        table.push_back(std::move(cells));
    }
    if (table.size() > 1)
        report.table(table, "What the filters take from small shadows: the share of a bar (32 px "
                            "long) and of a round spot that becomes lighter than half. The limits "
                            "are of bars; a spot 2 px wide is lost by any useful filter.");
}

void report_all(const Request& request, std::span<const Row> rows, Report& report) {
    const Measured all = measured(request, rows);
    if (all.own == nullptr) {
        report.answer("No contour was measured; the rows' status says why.");
        return;
    }
    answer(request, *all.own, all.small, report);
    if (all.own->has(all.own->by().rough)) plot_curve(*all.own, all.small, report);
    show_crops(request, *all.own, all.small, report);
    report.heading("Both filters");
    map_of(*all.own, "self-rough", "self_rough_px", "Roughness of the shadow line, px.", report);
    map_of(*all.own, "self-length", "self_length_ratio",
           "Length of the shadow line's contour over the exact edge's.", report);
    map_of(*all.own, "cast-rough", "cast_rough_px", "Roughness of cast shadows' edges, px.",
           report);
    report.heading("Over the bias");
    table_of_bias(all, report);
    report.heading("Small shadows");
    table_of_small(all, report);
}

}  // namespace

std::vector<PassesAndError> least_by_passes(std::span<const PassesAndError> all) {
    std::map<int, PassesAndError> least;
    for (const PassesAndError& p : all) {
        if (p.passes() > 0 && (p.dequantize == 0 || p.low_pass == 0)) continue;
        const auto [found, is_new] = least.try_emplace(p.passes(), p);
        if (!is_new && p.error < found->second.error) found->second = p;
    }
    std::vector<PassesAndError> curve;
    for (const auto& [passes, p] : least) curve.push_back(p);
    return curve;
}

std::optional<PassesAndError> knee_of_passes(std::span<const PassesAndError> least) {
    if (least.size() < 3) return std::nullopt;
    const auto end = std::min_element(least.begin(), least.end(),
                                      [](auto& a, auto& b) { return a.error < b.error; });
    const PassesAndError &first = least.front(), &last = *end;
    std::optional<PassesAndError> knee;
    double deepest = 0;
    for (const PassesAndError& p : least.first(static_cast<std::size_t>(end - least.begin()))) {
        const double x = static_cast<double>(p.passes() - first.passes()) /
                         (last.passes() - first.passes());
        const double y = (p.error - last.error) / (first.error - last.error);
        const double below = 1 - x - y;
        if (below <= 0 || below < deepest - 0.01) continue;
        deepest = std::max(deepest, below);
        knee = p;
    }
    return knee;
}

void report_contours(const Request& request, std::span<const Row> all, Report& report) {
    constexpr std::array<std::string_view, 5> keys{"dither", "bias", "bias_unit", "dequantize",
                                                   "low_pass"};
    write_sections(request, keys, all, report, [&](std::span<const Row> rows, Report& some) {
        report_all(request, rows, some);
    });
}

}  // namespace umbra78::tools::study
