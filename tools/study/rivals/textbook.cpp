// The page of the study of rivals: pictures of the methods, what stencils count wrongly, and the
// methods of textbooks.
#include "tools/study/rivals/tables.hpp"

#include "tools/study/strip.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbra78::tools::study {
namespace {

using Panels = std::vector<std::vector<std::uint8_t>>;

struct Drawing {
    std::vector<std::uint8_t> picture, errors;  // errors: empty without truth
    int size = 0;
};

LoadedScene scene_again(const Request& request, const Row& row) {
    Case c;
    for (const char* key : {"form", "surface", "dice_levels", "dequantize", "low_pass", "xy_bits",
                            "lookup", "dither", "bias_unit", "bias", "bias_slope", "map_depth",
                            "receiver", "slope_source", "z_bits"})
        c.set.push_back(fmt::format("{}={}", key, row.text(key)));
    for (const char* column : {"question", "at"})
        if (row.has(column)) c.extra.emplace_back(column, row.text(column));
    const std::string own = own_scene(c);
    return own.empty() ? scene_of(request, c) : parse_scene(own, "the study's scene", c.set);
}

// The row's frame again, and how its mask differs from truth. Nothing is filtered.
Drawing drawn_again(const Request& request, const Row& row, const TruthCache& truths) {
    const LoadedScene scene = scene_again(request, row);
    RenderJob job(scene.view(), scene.settings);
    job.render();
    const auto picture = job.bytes(Plane::picture);
    Drawing drawing{{picture.begin(), picture.end()}, {}, scene.settings.machine.size_px()};
    if (const auto traced = truths.of(scene)) {
        const std::vector<std::uint8_t> visible = job.visible();
        drawing.errors = error_picture(traced->truth, {job.bytes(Plane::filtered), visible});
    }
    return drawing;
}

struct Compared {
    std::vector<std::uint8_t> picture;
    int size;
};

// As error_picture(), with the polygons' own truth.
Compared against_brute_force(const Request& request, const Row& row) {
    const LoadedScene scene = scene_again(request, row);
    shadow::Settings exact = scene.settings;
    exact.form = shadow::Form::brute;
    RenderJob job(scene.view(), scene.settings), brute(scene.view(), exact);
    draw_mask(job);
    draw_mask(brute);
    const auto mask = job.bytes(Plane::mask), right = brute.bytes(Plane::mask);
    const std::vector<std::uint8_t> visible = job.visible();
    Compared made{std::vector<std::uint8_t>(mask.size(), 235), scene.settings.machine.size_px()};
    for (std::size_t at = 0; at < mask.size(); ++at)
        if (visible[at] != 0)
            made.picture[at] = mask[at] == right[at] ? (mask[at] != 0 ? 110 : 200)
                                                     : (mask[at] != 0 ? 0 : 255);
    return made;
}

// Methods whose masks are one mask share a panel.
struct Shown {
    const Row* row;
    std::vector<std::string> names;
};

std::vector<Shown> distinct(std::span<const Row> all) {
    std::vector<Shown> shown;
    for (const std::string& method : methods_in(all)) {
        const Row* row = finest(all, method);
        if (row == nullptr) continue;
        const auto same = std::ranges::find_if(shown, [&](const Shown& s) {
            return s.row->text("mask_hash") == row->text("mask_hash");
        });
        if (same != shown.end()) {
            same->names.push_back(method);
        } else {
            shown.push_back({row, {method}});
        }
    }
    return shown;
}

}  // namespace

void sheet_of_methods(const Request& request, std::span<const Row> all, Report& report) {
    const TruthCache truths;
    Panels pictures, errors;
    std::string names;
    int size = 0;
    for (const Shown& s : distinct(all)) {
        Drawing d = drawn_again(request, *s.row, truths);
        size = d.size;
        pictures.push_back(std::move(d.picture));
        if (!d.errors.empty()) errors.push_back(std::move(d.errors));
        names += fmt::format("{}{}", names.empty() ? "" : "; ", fmt::join(s.names, ", "));
    }
    if (pictures.empty()) return;
    const int columns = static_cast<int>(pictures.size());
    const bool truth = errors.size() == pictures.size();
    Panels panels = std::move(pictures);
    if (truth) std::ranges::move(errors, std::back_inserter(panels));
    const Strip strip = in_rows(panels, size, columns);
    report.picture("rivals-sheet", strip.width, strip.height, strip.gray,
                   fmt::format("From the left: {}. Methods of one mask share a panel.{}", names,
                               truth ? " Below, against the smooth surfaces' truth: false shadow "
                                       "is black, false light white, light grey is lit and dark "
                                       "grey in shadow."
                                     : " There is no truth for this scene, so no error is shown."));
}

// The picture is that of the row with most such pixels.
void report_codes(const Request& request, std::span<const Row> all, Report& report) {
    const Rows rows = rows_of(all, question::codes);
    if (rows.empty()) return;
    TableCells table{{"bits of a code"}};
    for (const std::string_view form : stencils())
        table[0].push_back(fmt::format("{}: pixels wrong on its polygons", form));
    for (const Row* row : rows) {
        const auto same = std::ranges::find_if(
            table, [&](const auto& line) { return line.front() == row->text("at"); });
        auto& line = same != table.end() ? *same : table.emplace_back(1, row->text("at"));
        line.push_back(rounded(row->number("wrong_on_polygons_px"), 9));
    }
    report.heading("Volumes in a frame store");
    report.table(table, "The stencil forms compare Z codes of sides with those of what is seen, "
                        "and where both have one code, or round to the wrong order, they count "
                        "wrongly. They differ from brute force and not from each other.");
    const Row* worst = *std::ranges::max_element(
        rows, {}, [](const Row* row) { return row->number("wrong_on_polygons_px"); });
    if (worst->number("wrong_on_polygons_px") == 0) return;
    const auto [wrong, size] = against_brute_force(request, *worst);
    report.picture("rivals-codes", size, size, wrong,
                   fmt::format("{} with {} bits of Z against brute force: dark where it counts a "
                               "shadow that is none, white where it counts none.",
                               worst->text("method"), worst->text("at")));
}

void report_textbook(const Request& request, std::span<const Row> all, Report& report) {
    const Rows rows = rows_of(all, question::textbook);
    if (rows.empty()) return;
    report.heading("What textbooks offer");
    TableCells table{{"method", "false shadow", "false light", "mean error of the mask",
                      "distance of edges, px", "map, million cycles", "test, million cycles"}};
    const TruthCache truths;
    Panels panels;
    std::vector<std::string> names;
    int size = 0;
    for (const Row* row : rows) {
        const auto rate = [&](const char* column) {
            return row->has(column) ? percent(row->number(column)) : "";
        };
        table.push_back({row->text("method"), rate("false_shadow"), rate("false_light"),
                         rate("mask_error"),
                         row->has("edge_mean_px") ? rounded(row->number("edge_mean_px")) : "",
                         rounded(row->number("map_cycles") / 1e6),
                         rounded(row->number("test_cycles") / 1e6)});
        Drawing d = drawn_again(request, *row, truths);
        if (d.errors.empty()) continue;
        size = d.size;
        panels.push_back(std::move(d.errors));
        names.push_back(row->text("method"));
    }
    report.table(table, "On things of all kinds on a floor, at 256 x 256 unless the study is "
                        "quick, against the smooth surfaces' truth, which is that of a point "
                        "light: a ramp is meant to differ. Where something follows the surface "
                        "the constant bias is half a texel, of a window 2.5, else 1.5. Of a graded "
                        "mask the rates are those at half; its mean error tells the rest.");
    if (panels.empty()) return;
    const Strip strip = in_rows(panels, size, 5);
    report.picture("rivals-textbook", strip.width, strip.height, strip.gray,
                   fmt::format("False shadow black, false light white, by rows: {}.",
                               fmt::join(names, "; ")));
}

}  // namespace umbra78::tools::study
