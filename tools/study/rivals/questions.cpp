// The cases of the study of rivals.
#include "tools/study/rivals/rivals.hpp"

#include "shadow/frame/methods.hpp"
#include "shadow/frame/rivals.hpp"
#include "tools/study/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace umbra78::tools::study {
namespace {

using Values = std::vector<std::string>;

struct Drawn {
    std::string_view method, form, surface;
};

// The depth map on patches, on the rivals' facets and at the visible points; then the rivals of the
// table of methods.
std::vector<Drawn> methods_drawn() {
    std::vector<Drawn> all{{map_on_patches, "post_process", "catmull"},
                           {map_on_facets, "post_process", "diced"},
                           {map_at_points, "irregular_map", "catmull"}};
    for (const shadow::Method& m : shadow::methods())
        if (shadow::is_rival(m.form)) all.push_back({m.name, m.name, "diced"});
    return all;
}

class Cases {
public:
    explicit Cases(const Request& request) : request_(request) {}

    void add(std::string_view question, std::string_view method, std::vector<GridKey> axes,
             std::vector<std::pair<std::string, std::string>> more) {
        axes.insert(axes.end(), {{"dequantize", {"0"}}, {"low_pass", {"0"}}});
        for (Case c : grid(request_, axes)) {
            c.extra = {{"question", std::string(question)}, {"method", std::string(method)}};
            c.extra.insert(c.extra.end(), more.begin(), more.end());
            const std::string at = more.empty() ? "" : " at " + more.front().second;
            c.name = fmt::format("{}{}: {}, {}", question, at, method, c.name);
            all_.push_back(std::move(c));
        }
    }
    void add(std::string_view question, const Drawn& d, std::vector<GridKey> axes,
             std::vector<std::pair<std::string, std::string>> more) {
        axes.insert(axes.end(), {{"form", {std::string(d.form)}},
                                 {"surface", {std::string(d.surface)}}});
        add(question, d.method, std::move(axes), std::move(more));
    }
    std::vector<Case> take() { return std::move(all_); }

private:
    Request request_;
    std::vector<Case> all_;
};

std::vector<GridKey> at_size(const Request& request, std::vector<GridKey> axes) {
    if (request.quick) axes.push_back({"xy_bits", {"5"}});
    return axes;
}

// The study's own scenes are not varied, whatever --vary says of the given one.
Request without_vary(Request request) {
    request.vary.clear();
    return request;
}

void ask_of_scene(const Request& request, std::vector<Case>& all) {
    const Values levels = request.quick ? Values{"1", "2"} : Values{"1", "2", "3", "4"};
    const Values bits = request.quick ? Values{"4", "5"} : Values{"7", "8", "9", "10"};
    const Values level = request.quick ? Values{"2"} : Values{"3"};
    Cases cases(request);
    for (const Drawn& d : methods_drawn()) {
        const bool patches = d.surface == "catmull";
        cases.add(question::dicing, d,
                  at_size(request, {{"dice_levels", patches ? level : levels}}), {});
        cases.add(question::resolution, d, {{"xy_bits", bits}, {"dice_levels", level}}, {});
    }
    all = cases.take();
}

void ask_of_codes(const Request& request, Cases& cases) {
    for (const std::string_view form : stencils())
        for (const char* bits : {"6", "8", "10", "12", "16"})
            cases.add(question::codes, form,
                      at_size(request, {{"dice_levels", {request.quick ? "1" : "3"}},
                                        {"form", {std::string(form)}},
                                        {"surface", {"diced"}},
                                        {"z_bits", {bits}}}),
                      {{"at", bits}});
}

void ask_of_boxes(const Request& request, Cases& cases) {
    const Values sides = request.quick ? Values{"1", "2"} : Values{"1", "2", "4", "8", "16"};
    const Values lights = request.quick ? Values{"1", "2"} : Values{"1", "2", "4", "8"};
    for (const Drawn& d : methods_drawn()) {
        const auto axes = at_size(request, {{"dice_levels", {"0"}}});
        for (const std::string& side : sides) cases.add(question::objects, d, axes, {{"at", side}});
        for (const std::string& n : lights) cases.add(question::lights, d, axes, {{"at", n}});
    }
}

struct Remedy {
    std::string_view name;
    std::vector<GridKey> set;
    std::string_view ramp = "0";
};

// What textbooks offer, each with the least that it needs: a constant bias of 1.5 texels where
// nothing follows the surface, half a texel where something does.
std::vector<Remedy> remedies() {
    const GridKey half{"bias", {"0.5"}}, whole{"bias", {"1.5"}};
    return {{"nearest texel", {whole}},
            {"four texels between, dithered", {whole, {"lookup", {"bilinear"}},
                                               {"dither", {"normal"}}}},
            {"percentage closer, 3 x 3", {whole, {"lookup", {"percentage"}}}},
            {"filtered depth, 3 x 3 (wrong)", {whole, {"lookup", {"filtered_depth"}}}},
            {"slope-scaled bias", {half, {"bias_slope", {"1"}}}},
            {"receiver's plane", {half, {"receiver", {"plane"}}, {"slope_source", {"normals"}}}},
            {"normal offset", {half, {"receiver", {"normal"}}, {"slope_source", {"normals"}}}},
            {"second depth", {half, {"map_depth", {"back"}}}},
            {"midpoint", {half, {"map_depth", {"midpoint"}}}},
            {"Crow's ramp of 6 pixels", {whole}, "6"},
            {"ground plane", {{"form", {"ground"}}}},
            {"blob", {{"form", {"blob"}}}},
            {"shadow volumes", {{"form", {"volumes"}}, {"surface", {"diced"}},
                                {"dice_levels", {"4"}}}}};
}

void ask_of_textbook(const Request& request, Cases& cases) {
    for (const Remedy& r : remedies()) {
        std::vector<GridKey> axes = r.set;
        axes.insert(axes.end(), {{"bias_unit", {"texels"}},
                                 {"xy_bits", {request.quick ? "5" : "8"}}});
        cases.add(question::textbook, r.name, axes, {{"at", std::string(r.ramp)}});
    }
}

void ask_of_scan_out(const Request& request, Cases& cases) {
    const auto add = [&](std::string_view question, std::string_view method, const char* levels,
                         const std::string& at, const char* cells, const char* edges,
                         const char* stop) {
        cases.add(question, method,
                  at_size(request, {{"dice_levels", {levels}}, {"form", {"bouknight_kelley"}},
                                    {"surface", {"diced"}}}),
                  {{"at", at}, {"cells", cells}, {"edges", edges}, {"stop", stop}});
    };
    const char* level = request.quick ? "1" : "3";
    for (const char* cells : {"1", "2", "4", "8", "16", "32", "64", "128", "256"})
        add(question::sectors, "bouknight_kelley", level, cells, cells, "every", "yes");
    const Values levels = request.quick ? Values{"1", "2"} : Values{"1", "2", "3", "4"};
    for (const std::string& k : levels) {
        add(question::edges, "every edge", k.c_str(), k, "0", "every", "yes");
        add(question::edges, "contours alone", k.c_str(), k, "0", "contour", "no");
    }
    for (const char* sheets : {"1", "2", "4", "8"}) {
        add(question::layers, "stopped when dark", level, sheets, "0", "every", "yes");
        add(question::layers, "not stopped", level, sheets, "0", "every", "no");
    }
}

int whole(std::string_view text) {
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

}  // namespace

std::string_view extra_of(const Case& c, std::string_view column) {
    for (const auto& [name, value] : c.extra)
        if (name == column) return value;
    return {};
}

std::vector<std::string_view> stencils() {
    std::vector<std::string_view> names;
    for (const shadow::RivalRow& row : shadow::rival_rows)
        if (!row.is_exact) names.push_back(row.name);
    return names;
}

bool is_exact(std::string_view method) {
    return std::ranges::any_of(shadow::rival_rows, [&](const shadow::RivalRow& row) {
        return row.name == method && row.is_exact;
    });
}

std::string own_scene(const Case& c) {
    const std::string_view asked = extra_of(c, "question");
    const int at = whole(extra_of(c, "at"));
    if (asked == question::objects) return boxes_scene(at, 1);
    if (asked == question::lights) return boxes_scene(4, at);
    if (asked == question::textbook) return textbook_scene(at);
    if (asked == question::layers) return layers_scene(at);
    return "";
}

std::vector<Case> rivals_cases(const Request& request) {
    std::vector<Case> all;
    ask_of_scene(request, all);
    Cases more(without_vary(request));
    ask_of_codes(request, more);
    ask_of_boxes(request, more);
    ask_of_textbook(request, more);
    ask_of_scan_out(request, more);
    std::vector<Case> rest = more.take();
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

}  // namespace umbra78::tools::study
