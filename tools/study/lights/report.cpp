// The page of the study of lights.
#include "tools/study/lights/lights.hpp"

#include "tools/study/bias/report.hpp"
#include "tools/study/strip.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using Rows = std::vector<const Row*>;

// How a question's page reads.
struct Words {
    Question question;
    const char *heading, *of, *x_label, *name;
    const char *before, *behind;  // a place: "height " 0.5, or 90 " degrees"
    bool log_x;
    std::vector<const char*> shown;  // in the picture

    std::string place(const std::string& at) const { return before + at + behind; }
};
const Words pages[] = {
    {Question::size, "The map's size beside the picture's", "the size of a texel",
     "texel over pixel, relative to the scene's own", "size", "texel times ", "", true,
     {"1", "2", "4"}},
    {Question::angle, "The angle between light and observer",
     "the angle between a light at infinity and the observer", "angle, degrees", "angle",
     "", " degrees", false, {"45", "90", "150"}},
    {Question::opposed_lamp, "A lamp that faces the observer",
     "the angle between a lamp and the observer, as far and as high as each other",
     "angle, degrees", "opposed", "", " degrees", false, {"0", "90", "180"}},
    {Question::low_lamp, "A lamp closer and closer to a floor", "a lamp's height over a floor",
     "height, world units", "low", "height ", "", true, {"4", "1", "0.25"}},
};

std::string curve_name(const Row& row) {
    return row.text("lookup") + " lookup" +
           (row.text("dither") == "none" ? "" : ", " + row.text("dither") + " dither");
}

Rows rows_of(std::span<const Row> all, const Words& page) {
    Rows rows;
    for (const Row& row : all)
        if (row.text("status") == "ok" &&
            row.text("question") == question_names[static_cast<std::size_t>(page.question)])
            rows.push_back(&row);
    return rows;
}

// The rows of each lookup and dither, in the order of the first.
std::vector<std::pair<std::string, Rows>> by_curve(const Rows& rows) {
    std::vector<std::pair<std::string, Rows>> groups;
    for (const Row* row : rows) {
        const std::string name = curve_name(*row);
        auto found = std::ranges::find(groups, name, [](const auto& g) { return g.first; });
        if (found == groups.end()) found = groups.insert(found, {name, {}});
        found->second.push_back(row);
    }
    return groups;
}

void plot(const Words& page, const Rows& rows, const char* column, const char* name,
          const char* label, double scale, bool log_y, Report& report) {
    Plot plot{fmt::format("{}-{}", page.name, name), fmt::format("{} over {}", label, page.of),
              page.x_label, label, page.log_x, log_y, {}};
    for (const auto& [title, of] : by_curve(rows)) {
        Series series{title, {}, true, {}};
        for (const Row* row : of) {
            const double y = row->number(column) * scale;
            if (std::isfinite(y) && (!log_y || y > 0))
                series.points.emplace_back(row->number("at"), y);
        }
        std::ranges::sort(series.points);
        if (!series.points.empty()) plot.series.push_back(std::move(series));
    }
    if (plot.series.empty()) return;
    report.plot(plot, "With the least bias that suffices outside the edge band, or at a bias of "
                      "1.5 texels of the case's own map, as the table below says.");
}

// "LEAST (PLACE) to GREATEST (PLACE)", over the rows that have both light and shadow.
template <class Print>
std::string range_of(const Rows& rows, const char* column, const Words& page, Print print) {
    const Row *least = nullptr, *most = nullptr;
    for (const Row* row : rows) {
        const double value = row->number(column);
        if (std::isnan(value) || row->number("lit_px") == 0 || row->number("shadowed_px") == 0)
            continue;
        if (least == nullptr || value < least->number(column)) least = row;
        if (most == nullptr || value > most->number(column)) most = row;
    }
    if (least == nullptr) return "not found";
    const auto words = [&](const Row& row) {
        return fmt::format("{} ({})", print(row.number(column)), page.place(row.text("at")));
    };
    return fmt::format("{} to {}", words(*least), words(*most));
}

// How far the least bias and the errors go, for each lookup.
void answer(const Words& page, const Rows& rows, Report& report) {
    std::string words;
    const auto plain = [](double value) { return rounded(value); };
    const auto groups = by_curve(rows);
    for (const auto& [name, of] : groups) {
        // The table has the curves between, too.
        if (name == groups.front().first || name == groups.back().first)
            words += fmt::format(
                " With {} the least bias in world units is {}; false light with it is {}; at 1.5 "
                "texels false shadow is {}.",
                name, range_of(of, "least_outside_world", page, plain),
                range_of(of, "false_light_at_least", page, percent),
                range_of(of, "false_shadow", page, percent));
        auto& json = report.summary()[page.name][name];
        for (const Row* row : of)
            json.push_back({{"at", row->number("at")},
                            {"least_outside_world", row->number("least_outside_world")},
                            {"false_light_at_least", row->number("false_light_at_least")},
                            {"false_shadow", row->number("false_shadow")},
                            {"false_light", row->number("false_light")},
                            {"frame_cycles", row->number("frame_cycles")}});
    }
    report.answer(fmt::format("{}.{}", page.heading, words));
}

void table(const Rows& rows, Report& report) {
    TableCells table{{"at", "settings", "texel's side, px (median)", "(95 %)",
                      "least bias, quanta", "texels", "world units", "false light with it",
                      "outside the band", "at 1.5 texels: false shadow", "outside the band",
                      "false light", "outside the band", "missing, extra, misplaced",
                      "lit px", "shadowed px", "cycles of the light's view", "of the frame"}};
    for (const Row* row : rows) {
        std::vector<std::string> cells{row->text("at"), curve_name(*row)};
        for (const char* column : {"texel_px_median", "texel_px_95"})
            cells.push_back(rounded(row->number(column)));
        for (const char* unit : {"quanta", "texels", "world"})
            cells.push_back(figure(*row, std::string("least_outside_") + unit));
        for (const char* column : {"false_light_at_least", "false_light_outside_at_least",
                                   "false_shadow", "false_shadow_outside", "false_light",
                                   "false_light_outside"})
            cells.push_back(percent(row->number(column)));
        cells.push_back(fmt::format("{}, {}, {}", row->text("missing_pixels"),
                                    row->text("extra_pixels"), row->text("misplaced_pixels")));
        for (const char* column : {"lit_px", "shadowed_px", "light_cycles", "frame_cycles"})
            cells.push_back(row->text(column));
        table.push_back(std::move(cells));
    }
    report.table(table, "The least bias has under 0.1 % false shadow outside the edge band. Rates "
                        "without pixels are 0.");
}

// Drawn again, with nearest lookup at the constant bias.
void picture(const Request& request, const Words& page, std::span<const Case> cases,
             Report& report) {
    std::vector<std::vector<std::uint8_t>> panels;
    std::string names;
    int size = 0;
    for (const Case& c : cases) {
        const LoadedScene scene = lights_scene(request, c);
        const auto truth = trace(scene);
        if (!truth) return;
        RenderJob job(scene.view(), scene.settings);
        draw_mask(job);
        const std::vector<std::uint8_t> visible = job.visible();
        const auto panel = error_picture(*truth, {job.bytes(Plane::mask), visible});
        if (size != 0 && truth->truth.size != size) return;
        size = truth->truth.size;
        panels.push_back(panel);
        names += (names.empty() ? "" : ", ") + page.place(c.extra.at(1).second);
    }
    if (panels.empty()) return;
    const Strip strip = side_by_side(panels, size);
    report.picture(fmt::format("{}-errors", page.name), strip.width, strip.height, strip.gray,
                   fmt::format("Nearest lookup at a bias of 1.5 texels; from the left: {}. False "
                               "shadow is black, false light white, light grey is lit and dark "
                               "grey in shadow.", names));
}

// The cases of the study itself, so that the pictures are of its rows.
std::vector<Case> shown_cases(const Request& request, const Words& page) {
    std::vector<Case> shown;
    const auto study = make_lights_study();
    for (const char* at : page.shown)
        for (const Case& c : study->cases(request)) {
            const bool nearest = std::ranges::find(c.set, "lookup=nearest") != c.set.end();
            if (question_of(c) != page.question || c.extra.at(1).second != at || !nearest) continue;
            shown.push_back(c);
            break;
        }
    return shown;
}

}  // namespace

void report_lights(const Request& request, std::span<const Row> all, Report& report) {
    bool any = false;
    for (const Words& page : pages) {
        const Rows rows = rows_of(all, page);
        if (rows.empty()) continue;
        answer(page, rows, report);
        any = true;
    }
    if (!any) return report.answer("No case was measured; the rows' status says why.");
    bool first = true;
    for (const Words& page : pages) {
        const Rows rows = rows_of(all, page);
        if (rows.empty()) continue;
        if (!first) report.heading(page.heading);
        first = false;
        if (page.question == Question::size)
            report.paragraph("Both frame stores have equally many pixels, so a coarser map is one "
                             "with a larger window, and a finer one has more bits of X and Y; the "
                             "observer's pixels keep their size. Where both views' rows are "
                             "parallel, as in the paper's scene, every row of the picture falls on "
                             "the same place of a row of a finer map, which errs by as much "
                             "everywhere; --vary light.elevation=7 turns one against the other.");
        plot(page, rows, "least_outside_world", "least", "least bias, world units", 1, true,
             report);
        plot(page, rows, "false_light_at_least", "false-light",
             "false light at the least bias (%)", 100, false, report);
        picture(request, page, shown_cases(request, page), report);
        table(rows, report);
    }
}

}  // namespace umbra78::tools::study
