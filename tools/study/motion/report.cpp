// The page of the study of motion.
#include "tools/study/motion/picture.hpp"
#include "tools/study/report_sections.hpp"
#include "tools/study/strip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace umbra78::tools::study {
namespace {

using Rows = std::vector<const Row*>;

// What a row does against flicker, in words.
std::string settings_of(const Row& row) {
    const bool silent = row.text("dither") == "none";
    return fmt::format("{}, {}, bias {}", row.text("lookup"),
                       silent ? "no dither"
                              : fmt::format("{} dither {}", row.text("noise"), row.text("dither")),
                       row.text("bias"));
}

std::string motion_of(const Row& row) {
    return row.text("motion") + (row.text("snapped") == "on" ? ", snapped" : "");
}

Rows ok_rows(std::span<const Row> rows) {
    Rows ok;
    for (const Row& row : rows)
        if (row.text("status") == "ok") ok.push_back(&row);
    return ok;
}

// Figure 3's and figure 4's settings, and figure 4's with noise that is another in each frame.
struct Kind {
    const char *name, *lookup, *dither, *bias, *noise;
};
constexpr Kind kinds[] = {  // a name that begins with a figure is that figure's
    {"figure 3: nearest lookup, bias 64", "nearest", "none", "64", "fixed"},
    {"bilinear lookup, bias 192", "bilinear", "none", "192", "fixed"},
    {"figure 4: the same, dithered, noise fixed to the place", "bilinear", "normal", "192",
     "fixed"},
    {"its dither renewed in each frame", "bilinear", "normal", "192", "renewed"}};

bool is(const Row& row, const Kind& kind) {
    return row.text("lookup") == kind.lookup && row.text("dither") == kind.dither &&
           row.text("bias") == kind.bias && row.text("noise") == kind.noise;
}

const Row* find(const Rows& rows, std::string_view motion, const char* snapped, const Kind& kind) {
    for (const Row* row : rows)
        if (row->text("motion") == motion && row->text("snapped") == snapped && is(*row, kind))
            return row;
    return nullptr;
}

std::string flicker(const Row& row) { return percent(row.number("flicker_mean")); }

// The settings with the least and with the most flicker.
void answer_range(const Rows& rows, Report& report) {
    const auto [least, most] = std::ranges::minmax_element(rows, {}, [](const Row* row) {
        return row->number("flicker_mean");
    });
    const auto words = [](const Row& row) {
        return fmt::format("{} ({}; {})", flicker(row), motion_of(row), settings_of(row));
    };
    report.answer(fmt::format("From frame to frame {} to {} of the compared pixels flicker: they "
                              "flip in the mask, and their true state stays.", words(**least),
                              words(**most)));
}

// A sentence on each motion, of the kinds that are there.
void answer_motions(const Rows& rows, Report& report) {
    for (const std::string_view motion : motion_names) {
        std::string words;
        const Row* any = nullptr;
        for (const Kind& kind : kinds) {
            const Row* row = find(rows, motion, "off", kind);
            if (row == nullptr) continue;
            any = row;
            words += fmt::format("{}{}: {} ({} outside the edge bands)", words.empty() ? "" : "; ",
                                 kind.name, flicker(*row),
                                 percent(row->number("flicker_outside_mean")));
        }
        if (any != nullptr)
            report.answer(fmt::format("The {}. In truth {} of the compared pixels flip from frame "
                                      "to frame. These flicker: {}.", motion,
                                      percent(any->number("truth_flips_mean")), words));
    }
}

void answer_snapping(const Rows& rows, Report& report) {
    std::string words;
    for (const std::string_view motion : motion_names)
        for (const Kind& kind : {kinds[0], kinds[2]}) {
            const Row* off = find(rows, motion, "off", kind);
            const Row* on = find(rows, motion, "on", kind);
            if (off == nullptr || on == nullptr) continue;
            words += fmt::format("{}{} with the settings of {}: {} without, {} with it",
                                 words.empty() ? "" : "; ", motion, std::string(kind.name, 8),
                                 flicker(*off), flicker(*on));
            report.summary()["snapping"].push_back({{"motion", motion},
                                                    {"kind", kind.name},
                                                    {"off", off->number("flicker_mean")},
                                                    {"on", on->number("flicker_mean")}});
        }
    if (!words.empty())
        report.answer(fmt::format(
            "Snapping the light's window to whole texels. Flicker: {}. It keeps the texels on the "
            "same places of the scene while the light's axes stand still. When the light turns, "
            "all texels turn with it, and snapping takes away no more than the slide of the "
            "origin. When the observer moves, other points of the surfaces are looked up in each "
            "frame, whatever the light's window does.", words));
}

void answer_lost(const Rows& rows, Report& report) {
    double most = 0;
    for (const Row* row : rows) most = std::max(most, row->number("outside_light"));
    if (most > 0)
        report.answer(fmt::format("Up to {} surfaces leave the light's volume while it moves, and "
                                  "their shadows with them; give the light a larger extent, near "
                                  "and far, which --vary light.extent=VALUE can do.", most));
}

void plot_steps(const Rows& rows, std::string_view motion, Report& report) {
    Plot plot;
    plot.name = fmt::format("steps-{}", motion);
    std::ranges::replace(plot.name, ' ', '-');
    plot.title = fmt::format("Flicker from frame to frame: {}", motion);
    plot.x_label = "step";
    plot.y_label = "flicker (% of the compared pixels)";
    for (const Kind& kind : kinds) {
        const Row* row = find(rows, motion, "off", kind);
        if (row == nullptr) continue;
        Series series{kind.name, {}, true, {}};
        double step = 0;
        for (const double share : steps_of(*row, "flicker_steps"))
            series.points.emplace_back(++step, 100 * share);
        plot.series.push_back(std::move(series));
    }
    if (plot.series.empty()) return;
    report.plot(plot, "Each step leads from one frame to the next. A pixel flickers if its state "
                      "in the mask changes and its true state does not.");
}

void picture(const Request& request, const char* name, std::string_view motion,
             const std::string& caption, Report& report) {
    const TruthCache truths;
    std::vector<std::vector<std::uint8_t>> panels;
    std::string names;
    int size = 0;
    for (const Kind& kind : {kinds[0], kinds[2], kinds[3]}) {
        const Case c{"",
                     {fmt::format("lookup={}", kind.lookup), fmt::format("dither={}", kind.dither),
                      "bias_unit=quanta", fmt::format("bias={}", kind.bias)},
                     {{"motion", std::string(motion)},
                      {"snapped", "off"},
                      {"frames", frames_of(request)},
                      {"noise", kind.noise}}};
        const MotionSeen seen = see_motion(scene_of(request, c), motion_case(c), truths);
        size = seen.size_px;
        panels.push_back(flicker_picture(seen));
        names += fmt::format("{}{}", names.empty() ? "" : "; ", kind.name);
    }
    const Strip strip = side_by_side(panels, size);
    report.picture(name, strip.width, strip.height, strip.gray,
                   fmt::format("{} From the left: {}. Light grey never flickered; the darker, the "
                               "more often.", caption, names));
}

void map_of(const Rows& rows, Report& report) {
    HeatMap map{"flicker", "Flicker a step, % of the compared pixels", "motion", "settings",
                "flicker (%)", {}, {}, {}};
    const auto add = [](std::vector<std::string>& to, const std::string& name) {
        if (std::ranges::find(to, name) == to.end()) to.push_back(name);
    };
    for (const Row* row : rows) {
        add(map.x_ticks, motion_of(*row));
        add(map.y_ticks, settings_of(*row));
    }
    for (const std::string& y : map.y_ticks)
        for (const std::string& x : map.x_ticks) {
            const auto found = std::ranges::find_if(rows, [&](const Row* row) {
                return motion_of(*row) == x && settings_of(*row) == y;
            });
            map.values.push_back(found == rows.end() ? std::nan("")
                                                     : 100 * (*found)->number("flicker_mean"));
        }
    report.heat_map(map, "The mean over the steps, edges and all.");
}

void table_all(const Rows& rows, Report& report) {
    TableCells table{{"motion", "settings", "flip in truth", "flip in the mask", "rightful",
                      "flicker, mean", "flicker, maximum", "outside the bands", "filtered",
                      "flickered ever", "false shadow", "false light"}};
    for (const Row* row : rows) {
        std::vector<std::string> cells{motion_of(*row), settings_of(*row)};
        for (const char* column :
             {"truth_flips_mean", "flips_mean", "rightful_mean", "flicker_mean", "flicker_max",
              "flicker_outside_mean", "filtered_flicker_mean", "ever_flickered", "false_shadow",
              "false_light"})
            cells.push_back(percent(row->number(column)));
        table.push_back(std::move(cells));
    }
    report.table(table, "Shares of the compared pixels a step; the last three of the whole "
                        "sequence. Rightful is what flips in the mask and in truth at the same "
                        "pixel. Within the bands an edge that the bias moves flips beside the true "
                        "one, which counts as flicker. Filtered is the flicker after the scene's "
                        "own filters.");
}

void report_all(const Request& request, std::span<const Row> all, Report& report) {
    const Rows rows = ok_rows(all);
    if (rows.empty()) return report.answer("No sequence was drawn; the rows' status says why.");
    answer_range(rows, report);
    answer_motions(rows, report);
    answer_snapping(rows, report);
    answer_lost(rows, report);
    plot_steps(rows, "light turns", report);
    picture(request, "flickered-light-turns", "light turns",
            "Where the mask flickered while the light turned by 0.1 degree a frame.", report);
    report.heading("Every motion");
    map_of(rows, report);
    for (const std::string_view motion : {"observer turns", "light moves", "observer moves"})
        plot_steps(rows, motion, report);
    picture(request, "flickered-light-moves", "light moves",
            "The same while the light's window slid by a fraction of a texel a frame: truth does "
            "not change at all, if the light is at infinity.", report);
    report.heading("Every case");
    table_all(rows, report);
    auto& json = report.summary()["flicker"];
    for (const Row* row : rows)
        json.push_back({{"motion", row->text("motion")},
                        {"snapped", row->text("snapped")},
                        {"settings", settings_of(*row)},
                        {"mean", row->number("flicker_mean")},
                        {"max", row->number("flicker_max")},
                        {"outside_mean", row->number("flicker_outside_mean")}});
}

}  // namespace

std::vector<double> steps_of(const Row& row, const char* column) {
    std::vector<double> shares;
    const std::string text = row.text(column);
    for (const char* at = text.c_str(); *at != '\0';) {
        char* end = nullptr;
        shares.push_back(std::strtod(at, &end));
        if (end == at) break;
        at = *end == ';' ? end + 1 : end;
    }
    return shares;
}

void report_motion(const Request& request, std::span<const Row> all, Report& report) {
    constexpr std::array<std::string_view, 4> own{"lookup", "dither", "bias", "bias_unit"};
    write_sections(request, own, all, report, [&](std::span<const Row> rows, Report& some) {
        report_all(request, rows, some);
    });
}

}  // namespace umbra78::tools::study
