#include "tools/scene/scene_keys.hpp"

#include "fixed/decimal.hpp"
#include "fixed/trap.hpp"
#include "shadow/filters/ramp.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace umbra78::tools {
namespace {

using enum KeyKind;

constexpr NumberRange elevation_range{16, -90 * world_one, 90 * world_one};
// From the plane through the target, or in perspective from the eye.
constexpr NumberRange depth_range{16, -4 * world_reach, 4 * world_reach};
constexpr NumberRange depth_range_from_eye{16, 1, 4 * world_reach};
constexpr NumberRange level_range{0, 0, 255};
constexpr NumberRange shininess_range{0, 0, 8};

constexpr std::string_view world_units = "world units", degrees = "degrees";
constexpr std::string_view of_grey = "grey levels";
constexpr std::string_view fitted = "fitted to the scene", needed = "must be given";
constexpr raster::Material plain;

constexpr std::string_view projections[] = {"orthographic", "perspective"};  // raster::Projection
constexpr std::string_view on_or_off[] = {"on", "off"};
constexpr std::string_view up_axes[] = {"y", "z"};
constexpr std::string_view shadings[] = {"smooth", "flat"};
constexpr std::string_view light_kinds[] = {"directional", "point", "area", "sectors"};
constexpr NumberRange light_level_range{8, 0, 256}, samples_range{0, 1, 8},
    ramp_range{0, 0, shadow::max_ramp_px},
    seed_range{0, 1, 0x7fffffff};
constexpr std::string_view area_places[] = {"grid", "noise"};

constexpr SceneKey target{.key = "target", .kind = point, .unit = world_units,
                          .range = place_range, .left_out = "the middle of the scene",
                          .meaning = "the point in the middle of the picture"};
constexpr SceneKey extent{.key = "extent", .kind = number, .unit = world_units,
                          .range = length_range, .left_out = fitted,
                          .meaning = "from the middle of the picture to its edge, at the target"};
constexpr SceneKey near_depth{
    .key = "near", .kind = number, .unit = world_units, .range = depth_range,
    .perspective = &depth_range_from_eye, .left_out = fitted,
    .meaning = "depth of the first Z code, away from the viewer from the target, or from the eye"};
constexpr SceneKey far_depth{
    .key = "far", .kind = number, .unit = world_units, .range = depth_range,
    .perspective = &depth_range_from_eye, .left_out = fitted,
    .meaning = "depth of the last Z code, more than near"};
constexpr SceneKey material{.key = "material", .kind = text,
                            .left_out = "a material with all defaults",
                            .meaning = "the name of a [[material]]"};

constexpr SceneKey turn{
    .key = "turn", .kind = point, .unit = degrees, .range = azimuth_range,
    .left_out = "[0, 0, 0]",
    .meaning = "right-handed, first about the x axis, then about y, then about z"};
constexpr SceneKey centre{.key = "centre", .kind = point, .unit = world_units,
                          .range = place_range, .left_out = needed, .example = "[0, 0, 0]",
                          .meaning = "about which it is turned"};
constexpr SceneKey base{.key = "base", .kind = point, .unit = world_units, .range = place_range,
                        .left_out = needed, .example = "[0, 0, 0]",
                        .meaning = "the middle of its lower end, about which it is turned"};
constexpr SceneKey height{.key = "height", .kind = number, .unit = world_units,
                          .range = length_range, .left_out = needed, .example = "2",
                          .meaning = "from the lower end to the upper one"};
constexpr SceneKey capped{.key = "capped", .kind = choice, .choices = on_or_off,
                          .meaning = "discs close the ends"};

constexpr SceneKey observer_keys[] = {
    {.key = "projection", .kind = choice, .choices = projections, .meaning = "of the picture"},
    {.key = "azimuth", .kind = number, .unit = degrees, .range = azimuth_range,
     .meaning = "of the observer about the vertical axis; 0 is on the z axis, 90 on the x axis"},
    {.key = "elevation", .kind = number, .unit = degrees, .range = elevation_range,
     .meaning = "of the observer over the horizontal plane"},
    target,
    extent,
    near_depth,
    far_depth,
    {.key = "distance", .kind = number, .unit = world_units, .range = length_range,
     .left_out = "must be given in perspective", .example = "8",
     .meaning = "from the eye to the target, in perspective only"},
    {.key = "recentre", .kind = choice, .choices = on_or_off,
     .meaning = "count places from the target, if all lie within 32766 of it, so that a far "
                "scene keeps its bits"},
};
constexpr SceneKey light_keys[] = {
    {.key = "kind", .kind = choice, .choices = light_kinds,
     .meaning = "at infinity (its view is orthographic), at a point (perspective), a square of "
                "points, each with a depth map of its own, or a point that shines in all "
                "directions, with six maps"},
    {.key = "azimuth", .kind = number, .unit = degrees, .range = azimuth_range,
     .left_out = "must be given if directional", .example = "-100",
     .meaning = "of a directional light, as the observer's"},
    {.key = "elevation", .kind = number, .unit = degrees, .range = elevation_range,
     .meaning = "of a directional light over the horizontal plane"},
    target,
    extent,
    near_depth,
    far_depth,
    {.key = "position", .kind = point, .unit = world_units, .range = place_range,
     .left_out = "must be given unless directional", .example = "[-4, 6, 5]",
     .meaning = "of a point light, or the middle of an area, at most 32767 from its target (which "
                "with sectors only says at what distance a bias in texels is taken)"},
    {.key = "size", .kind = number, .unit = world_units, .range = length_range,
     .left_out = "must be given if an area", .example = "1",
     .meaning = "of an area: the side of its square, which faces the target"},
    {.key = "samples", .kind = number, .range = samples_range, .fallback = 4,
     .meaning = "of an area: n x n points on it; 1 is its middle, for a ramp"},
    {.key = "places", .kind = choice, .choices = area_places,
     .meaning = "of an area's points: in the middles of n x n cells, or in each where the noise "
                "puts it"},
    {.key = "seed", .kind = number, .range = seed_range, .fallback = 0x12345678,
     .meaning = "of that noise"},
    {.key = "ramp", .kind = number, .unit = "pixels", .range = ramp_range, .fallback = 0,
     .meaning = "around a hard shadow the darkness falls off over that width (Crow 1977); 0: none"},
    {.key = "level", .kind = levels, .range = light_level_range, .fallback = 256,
     .meaning = "of its light, in red, green and blue if it is coloured; 1 is as bright as the "
                "material's levels say"},
};
constexpr SceneKey material_keys[] = {
    {.key = "name", .kind = text, .left_out = needed, .example = "\"clay\"",
     .meaning = "by which surfaces refer to it; no two have the same"},
    {.key = "diffuse", .kind = levels, .unit = of_grey, .range = level_range,
     .fallback = plain.diffuse[0], .meaning = "of a surface that faces the light"},
    {.key = "specular", .kind = levels, .unit = of_grey, .range = level_range,
     .fallback = plain.specular[0], .meaning = "that the highlight adds in its middle"},
    {.key = "shininess", .kind = number, .range = shininess_range, .fallback = plain.shininess,
     .meaning = "n: the highlight's exponent is 2^n"},
};
constexpr SceneKey sphere_keys[] = {
    {.key = "centre", .kind = point, .unit = world_units, .range = place_range,
     .left_out = needed, .example = "[0, 0, 0]", .meaning = "of the sphere"},
    {.key = "radius", .kind = number, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "1",
     .meaning = "the sphere stays within -32767 .. 32767 in x, y and z"},
    material,
};
constexpr SceneKey plane_keys[] = {
    {.key = "origin", .kind = point, .unit = world_units, .range = place_range,
     .left_out = needed, .example = "[0, 0, 0]", .meaning = "a corner"},
    {.key = "u", .kind = point, .unit = world_units, .range = place_range, .left_out = needed,
     .example = "[1, 0, 0]", .meaning = "from the corner along one side"},
    {.key = "v", .kind = point, .unit = world_units, .range = place_range, .left_out = needed,
     .example = "[0, 0, -1]",
     .meaning = "along the other side, not parallel to u; all corners stay within -32767 .. 32767"},
    {.key = "ground", .kind = choice, .choices = on_or_off, .fallback = 1,
     .meaning = "with form = ground or blob shadows fall on this plane alone; one may be it"},
    material,
};
constexpr SceneKey patch_keys[] = {
    {.key = "control", .kind = control, .unit = world_units, .range = place_range,
     .left_out = needed, .example = "[16 points [x, y, z]]",
     .meaning = "control points (i, j) of a bicubic Bezier patch: row j, i = 0 .. 3"},
    material,
};

constexpr SceneKey torus_keys[] = {
    centre,
    {.key = "radius", .kind = number, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "1", .meaning = "from the centre to the middle of the tube"},
    {.key = "tube", .kind = number, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "0.4", .meaning = "the tube's own radius, at most radius"},
    turn,
    material,
};
constexpr SceneKey cylinder_keys[] = {
    base,
    {.key = "radius", .kind = number, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "1", .meaning = "of both ends"},
    height,
    capped,
    turn,
    material,
};
constexpr SceneKey cone_keys[] = {
    base,
    {.key = "radius", .kind = number, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "1", .meaning = "of the lower end"},
    {.key = "top", .kind = number, .unit = world_units, .range = {16, 0, world_reach},
     .meaning = "radius of the upper end; 0 is a tip"},
    height,
    capped,
    turn,
    material,
};
constexpr SceneKey box_keys[] = {
    centre,
    {.key = "size", .kind = point, .unit = world_units, .range = length_range,
     .left_out = needed, .example = "[1, 1, 1]", .meaning = "along x, y and z, before the turn"},
    turn,
    material,
};
constexpr SceneKey triangle_keys[] = {
    {.key = "a", .kind = point, .unit = world_units, .range = place_range, .left_out = needed,
     .example = "[0, 0, 0]", .meaning = "a corner"},
    {.key = "b", .kind = point, .unit = world_units, .range = place_range, .left_out = needed,
     .example = "[1, 0, 0]", .meaning = "a corner"},
    {.key = "c", .kind = point, .unit = world_units, .range = place_range, .left_out = needed,
     .example = "[0, 1, 0]", .meaning = "a corner, not on a line with the others"},
    material,
};
constexpr SceneKey model_keys[] = {
    {.key = "file", .kind = text, .left_out = needed, .example = "\"models/teapot.tea\"",
     .meaning = "its path from the scene's folder"},
    {.key = "place", .kind = point, .unit = world_units, .range = place_range,
     .left_out = "[0, 0, 0]", .meaning = "where the model's origin is put"},
    turn,
    {.key = "scale", .kind = number, .range = {48, 1, 32767 * (std::int64_t{1} << 48)},
     .fallback = std::int64_t{1} << 48, .meaning = "world units for a unit of the model"},
    {.key = "up", .kind = choice, .choices = up_axes,
     .meaning = "the axis of the file that points up, before the turn"},
    {.key = "shading", .kind = choice, .choices = shadings,
     .meaning = "of triangles: by normals at the vertices (the file's, or the mean of the "
                "triangles there), or each by its own"},
    material,
};

constexpr SceneKey stream_keys[] = {
    {.key = "file", .kind = text, .left_out = needed, .example = "\"hills.u78p\"",
     .meaning = "a packed file, its path from the scene's folder; \"-\" is standard input"},
    {.key = "largest", .kind = number, .unit = world_units, .range = length_range,
     .left_out = "found by a pass over the file",
     .meaning = "no coordinate of the stream is farther from 0. It decides the format of the "
                "object words in place of the stream's own largest coordinate: the bits are the "
                "same up to the next power of two, and beyond it a step of all places is coarser"},
};

constexpr SceneTable tables[] = {
    {"observer", false, "The view of the picture. It may be left out.", observer_keys},
    {"light", true,
     "A light, and its view of the scene: the depth map. One at least must be given, and one alone "
     "may be written [light]; at most 8, with 64 depth maps.",
     light_keys},
    {"material", true, "How surfaces are shaded.", material_keys},
    {"sphere", true, "A sphere, drawn as 32 patches.", sphere_keys},
    {"plane", true, "A parallelogram origin + s u + t v, 0 <= s, t <= 1.", plane_keys},
    {"patch", true, "A surface of any shape, seen from both sides.", patch_keys},
    {"torus", true, "A ring about the y axis, drawn as 64 patches.", torus_keys},
    {"cylinder", true, "A cylinder along the y axis, drawn as 8 patches and 8 for a cap.",
     cylinder_keys},
    {"cone", true, "A cone along the y axis, drawn as 8 patches and 8 for a cap.", cone_keys},
    {"box", true, "A box along the axes, drawn as six patches.", box_keys},
    {"triangle", true, "A triangle, seen from both sides.", triangle_keys},
    {"model", true, "Surfaces from a file: .bpt, .bez, .tea, .obj, .stl or .ply.", model_keys},
    {"stream", false,
     "Any number of patches and triangles, read as they are drawn and never held. They come after "
     "the scene's other surfaces and bring their own materials. `umbra78 pack` writes such a file, "
     "`umbra78 render` alone reads it, and tools/stream/packed.hpp is its format.",
     stream_keys},
};
constexpr auto names = [] {
    std::array<std::string_view, std::size(tables) + 1> made{};
    for (std::size_t k = 0; k < std::size(tables); ++k) made[k] = tables[k].name;
    made.back() = "settings";
    return made;
}();

std::string print(std::int64_t word, int fraction) {
    if (word == 1 && fraction > 8) return fmt::format("2^-{}", fraction);  // 13 digits and more
    std::array<char, fixed::longest_decimal> digits;
    const int length = fixed::print_decimal(word, fraction, digits);
    return {digits.data(), static_cast<std::size_t>(length)};
}

}  // namespace

std::string print(const NumberRange& range) {
    return print(range.min, range.fraction) + " .. " + print(range.max, range.fraction);
}

std::span<const SceneTable> scene_tables() { return tables; }

std::span<const std::string_view> scene_table_names() { return names; }

const SceneTable& scene_table(std::string_view name) {
    const auto found = std::find_if(std::begin(tables), std::end(tables),
                                    [&](const SceneTable& t) { return t.name == name; });
    fixed::require(found != std::end(tables), "scene_table: no such table");
    return *found;
}

const SceneKey& scene_key(const SceneTable& table, std::string_view key) {
    const auto found = std::find_if(table.keys.begin(), table.keys.end(),
                                    [&](const SceneKey& k) { return k.key == key; });
    fixed::require(found != table.keys.end(), "scene_key: no such key");
    return *found;
}

std::string title_of(const SceneTable& table) {
    return table.many ? fmt::format("[[{}]]", table.name) : fmt::format("[{}]", table.name);
}

std::string print_range(const SceneKey& key) {
    switch (key.kind) {
        case choice: return fmt::format("{}", fmt::join(key.choices, ", "));
        case text: return "a text";
        case point: return fmt::format("[x, y, z], each {}", print(key.range));
        case levels:
            return fmt::format("{0}, or [red, green, blue], each {0}", print(key.range));
        case control: return fmt::format("16 points [x, y, z], or 4 rows of 4, each {}",
                                         print(key.range));
        case number: break;
    }
    if (!key.perspective) return print(key.range);
    return fmt::format("{}, in perspective {}", print(key.range), print(*key.perspective));
}

std::string print_fallback(const SceneKey& key) {
    if (!key.left_out.empty()) return std::string(key.left_out);
    if (key.kind == choice) return std::string(key.choices[static_cast<std::size_t>(key.fallback)]);
    return print(key.fallback, key.range.fraction);
}

}  // namespace umbra78::tools
