// The answer without a scene, and how an answer is printed.
#include "tools/bias/answer.hpp"

#include "tools/io/text_formats.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbra78::tools::bias {
namespace {

using nlohmann::ordered_json;
using Number = std::optional<double>;

std::string text_of(Number value) { return value ? fmt::format("{:.6g}", *value) : "none"; }
Number in(Number world, double unit) { return world ? Number(*world / unit) : Number(); }
ordered_json json_of(Number value) { return value ? ordered_json(*value) : ordered_json(nullptr); }

std::string describe(const MapSetup& s) {
    return fmt::format("a map of {0} x {0} texels over {1:.6g} world units, {2:.6g} deep, {3}{4}, "
                       "{5}, a slope of {6:.4g} degrees at an azimuth of {7:.4g}",
                       s.map_px, s.extent, s.range, name_of(s.format),
                       s.reversed ? " reversed" : "", name_of(s.filter), s.slope_deg,
                       s.azimuth_deg);
}

ordered_json in_three_units(const Answer& a, Number world) {
    return {{"world", json_of(world)}, {"texels", json_of(in(world, a.texel))},
            {"pixels", json_of(in(world, a.pixel))}};
}

void add_rows(const Answer& a, const Least& l, std::vector<std::vector<std::string>>& table) {
    const auto row = [&](const char* what, Number world) {
        table.push_back({std::string(name_of(l.kind)), what, text_of(world),
                         text_of(in(world, a.texel)), text_of(in(world, a.pixel))});
    };
    row("least, by the bound", l.bound);
    row("least, by experiment", l.found);
    row("shadow detaches", l.detaches);
    if (l.detaches_facing) row("the same, facing the light", l.detaches_facing);
}

// Why a converted bias may not do what it says.
void add_remarks(const MapSetup& s, Answer& a) {
    if (s.format != DepthFormat::d32f) return;
    a.remarks.push_back(fmt::format(
        "a float's constant counts steps of 2^{}, which is that of a depth of {:.4g}{}: give "
        "--z for another place", s.exponent() - 23, s.depth,
        s.reversed ? ", stored as one minus it" : ""));
    if (s.reversed)
        a.remarks.push_back("near the far plane a reversed float's steps go to 0, and a constant "
                            "bias in them too: use the slope factor, the normal offset, or "
                            "Vulkan's FLOAT representation");
}

}  // namespace

Answer answer(const MapSetup& s) {
    const Need need = need_of(s);
    const Found found = experiment(s);
    const double cosine = std::cos(std::atan(s.tangent()));
    Answer a;
    a.name = describe(s);
    a.texel = s.texel();
    a.pixel = s.pixel_world();
    a.constant = amount_of(s, need.constant());
    a.geometry = amount_of(s, need.geometry);
    Number constant, slope, normal;
    if (found.constant) constant = *found.constant * need.step;
    // m is a texel's change of depth along the steeper axis.
    if (found.slope) slope = *found.slope * s.largest_slope() * s.texel() + need.step;
    if (found.normal) normal = *found.normal * s.texel();
    a.least.push_back({Kind::constant, need.constant(), constant, constant, constant});
    a.least.push_back({Kind::slope, need.constant(), slope, slope, need.step});
    const Number along = normal ? Number(*normal / cosine + need.step) : Number();
    const Number facing = normal ? Number(*normal + need.step) : Number();
    a.least.push_back({Kind::normal, need.normal, normal, along, facing});
    add_remarks(s, a);
    return a;
}

std::string print(const Answer& a) {
    std::string text = fmt::format("{}\n\n", a.name);
    std::vector<std::vector<std::string>> table{{"bias", "", "world units", "texels", "pixels"}};
    for (const Least& l : a.least) add_rows(a, l, table);
    text += markdown_table(table) + "\n";
    std::vector<std::vector<std::string>> units{{"for", "parameter", "kind", "value", "unit",
                                                 "defined by", "remark"}};
    for (const Converted& c : convert(a.constant, a.geometry)) {
        const Parameter& p = *c.parameter;
        units.push_back({std::string(p.target), std::string(p.name), std::string(name_of(p.kind)),
                         text_of(c.value), std::string(p.unit), std::string(name_of(p.source)),
                         std::string(p.remark)});
    }
    text += markdown_table(units);
    text += "\nThe parameters are those of the bound. Each delivers all of the bias alone, and "
            "what follows the\nsurface does so beside a constant of one step; UNITS.md derives "
            "them.\n";
    for (const std::string& remark : a.remarks) text += remark + "\n";
    return text;
}

ordered_json to_json(const Answer& a) {
    ordered_json json{{"of", a.name}, {"texel_world", a.texel}, {"pixel_world", a.pixel}};
    for (const Least& l : a.least)
        json["least"][std::string(name_of(l.kind))] = {
            {"bound", in_three_units(a, l.bound)},
            {"experiment", in_three_units(a, l.found)},
            {"detaches", in_three_units(a, l.detaches)},
            {"detaches_facing_the_light", in_three_units(a, l.detaches_facing)}};
    for (const Converted& c : convert(a.constant, a.geometry)) {
        const Parameter& p = *c.parameter;
        json["units"].push_back({{"for", p.target}, {"parameter", p.name},
                                 {"kind", name_of(p.kind)}, {"value", json_of(c.value)},
                                 {"unit", p.unit}, {"defined_by", name_of(p.source)},
                                 {"remark", p.remark}});
    }
    json["remarks"] = a.remarks;
    return json;
}

}  // namespace umbra78::tools::bias
