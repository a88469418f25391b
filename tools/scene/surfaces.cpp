#include "tools/scene/surfaces.hpp"

#include "fixed/decimal.hpp"
#include "tools/scene/materials.hpp"
#include "tools/scene/scene_models.hpp"
#include "tools/scene/scene_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace umbra78::tools {
namespace {

using Kind = TomlNode::Kind;

raster::Sphere read_sphere(const TomlNode& node, const MaterialNames& names, FirstError& error) {
    const TableReader in(node, scene_table("sphere"), error);
    raster::Sphere sphere;
    sphere.centre = in.needed_point("centre");
    sphere.radius = static_cast<std::int32_t>(in.needed_number("radius"));
    sphere.material = read_material(in, names);
    for (const std::int64_t c : {sphere.centre.x, sphere.centre.y, sphere.centre.z})
        if (std::abs(c) + sphere.radius > world_reach)
            in.report(in.need("radius"),
                      "the sphere reaches out of the world, -32767 .. 32767; scale the scene");
    return sphere;
}

bool parallel(const raster::World& u, const raster::World& v) {
    const auto minor = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
        return a * d == b * c;
    };
    return minor(u.x, u.y, v.x, v.y) && minor(u.y, u.z, v.y, v.z) && minor(u.x, u.z, v.x, v.z);
}

raster::Plane read_plane(const TomlNode& node, const MaterialNames& names, FirstError& error) {
    const TableReader in(node, scene_table("plane"), error);
    raster::Plane plane;
    plane.origin = in.needed_point("origin");
    plane.u = in.needed_point("u");
    plane.v = in.needed_point("v");
    plane.material = read_material(in, names);
    if (parallel(plane.u, plane.v))
        in.report(in.need("v"), "'u' and 'v' in [[plane]] are parallel; turn one of them");
    const auto reaches_out = [](std::int64_t o, std::int64_t u, std::int64_t v) {
        return std::max({std::abs(o + u), std::abs(o + v), std::abs(o + u + v)}) > world_reach;
    };
    if (reaches_out(plane.origin.x, plane.u.x, plane.v.x) ||
        reaches_out(plane.origin.y, plane.u.y, plane.v.y) ||
        reaches_out(plane.origin.z, plane.u.z, plane.v.z))
        in.report(node, "the plane reaches out of the world, -32767 .. 32767; scale the scene");
    return plane;
}

// Whether the plane is the ground; `is_second` if another one is.
bool reads_ground(const TomlNode& node, bool is_second, FirstError& error) {
    const TableReader in(node, scene_table("plane"), error);
    if (in.choice("ground") != 0) return false;
    if (is_second)
        in.report(in.need("ground"), "a second [[plane]] is the ground; leave 'ground' out of one");
    return true;
}

// The numbers of arrays in each other, `sizes` of them at each level, into the words from `next`
// on. False if the tokens are something else, or a number is out of the range.
bool read_words(ArrayTokens& tokens, std::span<const int> sizes, const NumberRange& range,
                std::int32_t*& next) {
    if (tokens.next().kind != ArrayToken::Kind::open) return false;
    for (int k = 0; k < sizes.front(); ++k) {
        if (sizes.size() > 1) {
            if (!read_words(tokens, sizes.subspan(1), range, next)) return false;
            continue;
        }
        const ArrayToken token = tokens.next();
        if (token.kind != ArrayToken::Kind::number) return false;
        const auto [word, status] = fixed::parse_decimal(token.text, range.fraction, 64);
        if (status != fixed::DecimalStatus::ok || word < range.min || word > range.max)
            return false;
        *next++ = static_cast<std::int32_t>(word);
    }
    return tokens.next().kind == ArrayToken::Kind::close;
}

// The control points of a patch that has stayed text, without a tree of it. False if the text is
// not as most patches' is: then read_control() says what is wrong, if anything is.
bool read_plain_control(std::string_view text, const NumberRange& range, raster::Patch& patch) {
    constexpr int points[] = {16, 3}, rows[] = {4, 4, 3};
    for (const auto sizes : {std::span<const int>(points), std::span<const int>(rows)}) {
        std::array<std::int32_t, 48> words{};
        std::int32_t* next = words.data();
        ArrayTokens tokens(text);
        if (!read_words(tokens, sizes, range, next)) continue;
        for (std::size_t k = 0; k < patch.control.size(); ++k)
            patch.control[k] = {words[3 * k], words[3 * k + 1], words[3 * k + 2]};
        return true;
    }
    return false;
}

// 16 points, or four rows of four.
void read_control(const TableReader& in, const TomlNode& control, raster::Patch& patch) {
    const NumberRange& range = scene_key(scene_table("patch"), "control").range;
    if (read_plain_control(control.numbers.text, range, patch)) return;
    std::size_t count = 0;
    const auto add = [&](const TomlNode& point) {
        const raster::World world =
            read_point(point, fmt::format("point {} of {}", count, in.called("control")), range,
                       in.error());
        if (count < patch.control.size()) patch.control[count] = world;
        ++count;
    };
    TomlNode room;
    for (const TomlNode& row : with_items(control, room).children) {
        const bool is_row = row.kind == Kind::array && !row.children.empty() &&
                            row.children.front().kind == Kind::array;
        if (is_row && row.children.size() != 4)
            in.report(row,
                      fmt::format("a row of {} holds {} points; write 16 points, or 4 rows of 4",
                                  in.called("control"), row.children.size()));
        if (is_row) {
            for (const TomlNode& point : row.children) add(point);
        } else {
            add(row);
        }
    }
    if (count != patch.control.size())
        in.report(control, fmt::format("{} holds {} points; write 16, or 4 rows of 4",
                                       in.called("control"), count));
}

raster::Patch read_patch(const TomlNode& node, const MaterialNames& names, FirstError& error) {
    const TableReader in(node, scene_table("patch"), error);
    raster::Patch patch;
    read_control(in, in.need("control"), patch);
    patch.material = read_material(in, names);
    return patch;
}

}  // namespace

void take_origin(const raster::World& origin, LoadedScene& scene) {
    const auto take = [&](raster::World& w) {
        w = {w.x - origin.x, w.y - origin.y, w.z - origin.z};
    };
    for (raster::Sphere& sphere : scene.spheres) take(sphere.centre);
    for (raster::Plane& plane : scene.planes) take(plane.origin);
    for (raster::Patch& patch : scene.patches)
        for (raster::World& point : patch.control) take(point);
    for (raster::World& vertex : scene.vertices) take(vertex);
    if (scene.stream) scene.stream->take_origin(origin);
    scene.origin = origin;
}

bool make_blobs(LoadedScene& scene) {
    scene.blobs.clear();
    if (!scene.ground) return true;
    const std::size_t ground = scene.ground_patch();
    bool all = true;
    SceneObject from;
    for (const SceneObject& to : scene.objects) {
        raster::EllipseFit fit(scene.patches[ground]);
        for (std::size_t k = from.patches_end; k < to.patches_end; ++k)
            for (const raster::World& p : scene.patches[k].control) fit.add(p);
        for (std::size_t k = from.facets_end; k < to.facets_end; ++k)
            for (const std::uint32_t v : scene.facets[k].vertex) fit.add(scene.vertices[v]);
        const bool is_ground = from.patches_end == ground && to.patches_end == ground + 1;
        const bool is_empty =
            from.patches_end == to.patches_end && from.facets_end == to.facets_end;
        from = to;
        if (is_ground || is_empty) continue;
        raster::Ellipse blob;
        const bool fits = fit.fit(blob);
        if (fits) scene.blobs.push_back(blob);
        all = all && fits;
    }
    return all;
}

void append_closed_forms(LoadedScene& scene) {
    for (const raster::Sphere& sphere : scene.spheres) {
        std::array<raster::Patch, raster::patches_per_sphere> made;
        raster::sphere_patches(sphere, made);
        scene.patches.insert(scene.patches.end(), made.begin(), made.end());
        scene.end_object();
    }
    for (const raster::Plane& plane : scene.planes) {
        scene.patches.push_back(raster::plane_patch(plane));
        scene.end_object();
    }
}

void read_surfaces(const TomlNode& root, const FileSource& files, LoadedScene& scene,
                   FirstError& error) {
    const MaterialNames names = read_materials(root, scene.materials, error);
    for (const TomlNode& node : tables_of(root, "sphere", error))
        scene.spheres.push_back(read_sphere(node, names, error));
    for (const TomlNode& node : tables_of(root, "plane", error)) {
        if (reads_ground(node, scene.ground.has_value(), error)) scene.ground = scene.planes.size();
        scene.planes.push_back(read_plane(node, names, error));
    }
    if (error.any()) return;
    append_closed_forms(scene);
    const std::size_t closed = scene.patches.size();
    for (const TomlNode& node : tables_of(root, "patch", error)) {
        scene.patches.push_back(read_patch(node, names, error));
        scene.end_object();
    }
    read_solids(root, names, scene, error);
    if (error.any()) return;
    read_models(root, names, files, scene, error);
    scene.free_patches = scene.patches.size() - closed;
}

}  // namespace umbra78::tools
