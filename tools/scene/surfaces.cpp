#include "tools/scene/surfaces.hpp"

#include "tools/io/suggest.hpp"
#include "tools/scene/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace umbra78::tools {
namespace {

using Kind = TomlNode::Kind;
using Names = std::vector<std::string>;

constexpr NumberRange level_range{0, 0, 255};
constexpr NumberRange shininess_range{0, 0, 8};

// The tables [[key]], of which there may be none.
std::span<const TomlNode> tables(const TomlNode& root, std::string_view key) {
    const TomlNode* node = root.find(key);
    if (!node) return {};
    if (node->kind != Kind::array)
        fail(*node, fmt::format("[{}] must be written [[{}]]: there may be many", key, key));
    return node->children;
}

Names read_materials(const TomlNode& root, std::vector<raster::Material>& materials) {
    constexpr std::array<std::string_view, 4> keys{"name", "diffuse", "specular", "shininess"};
    Names names;
    for (const TomlNode& node : tables(root, "material")) {
        const TableReader in(node, "[[material]]", keys);
        const TomlNode& name_node = in.need("name", "\"clay\"");
        const std::string name = read_text(name_node, in.called("name"));
        if (std::find(names.begin(), names.end(), name) != names.end())
            fail(name_node, fmt::format("there is a material '{}' already; rename one", name));
        const auto word = [&](const char* key, const NumberRange& range, std::int32_t otherwise) {
            return static_cast<std::int32_t>(in.number(key, range, otherwise));
        };
        const raster::Material plain;
        materials.push_back({word("diffuse", level_range, plain.diffuse),
                             word("specular", level_range, plain.specular),
                             word("shininess", shininess_range, plain.shininess)});
        names.push_back(name);
    }
    if (materials.size() >= std::numeric_limits<std::uint16_t>::max())
        fail(*root.find("material"), "there are 65535 materials or more; use fewer");
    materials.push_back({});  // of surfaces that name none
    return names;
}

std::uint16_t read_material(const TableReader& in, const Names& names) {
    const TomlNode* node = in.find("material");
    if (!node) return static_cast<std::uint16_t>(names.size());
    const std::string name = read_text(*node, in.called("material"));
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const std::vector<std::string_view> known(names.begin(), names.end());
        fail(*node, fmt::format("unknown material '{}' in {}; {}", name, in.title(),
                                known.empty() ? "add a [[material]] of that name"
                                              : suggest(name, known)));
    }
    return static_cast<std::uint16_t>(found - names.begin());
}

raster::Sphere read_sphere(const TomlNode& node, const Names& names) {
    constexpr std::array<std::string_view, 3> keys{"centre", "radius", "material"};
    const TableReader in(node, "[[sphere]]", keys);
    raster::Sphere sphere;
    sphere.centre = read_point(in.need("centre", "[0, 0, 0]"), in.called("centre"));
    const TomlNode& radius = in.need("radius", "1");
    sphere.radius =
        static_cast<std::int32_t>(read_number(radius, in.called("radius"), length_range));
    sphere.material = read_material(in, names);
    for (const std::int64_t c : {sphere.centre.x, sphere.centre.y, sphere.centre.z})
        if (std::abs(c) + sphere.radius > world_reach)
            fail(radius, "the sphere reaches out of the world, -32767 .. 32767; scale the scene");
    return sphere;
}

bool parallel(const raster::World& u, const raster::World& v) {
    const auto minor = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
        return a * d == b * c;
    };
    return minor(u.x, u.y, v.x, v.y) && minor(u.y, u.z, v.y, v.z) && minor(u.x, u.z, v.x, v.z);
}

raster::Plane read_plane(const TomlNode& node, const Names& names) {
    constexpr std::array<std::string_view, 4> keys{"origin", "u", "v", "material"};
    const TableReader in(node, "[[plane]]", keys);
    raster::Plane plane;
    plane.origin = read_point(in.need("origin", "[0, 0, 0]"), in.called("origin"));
    plane.u = read_point(in.need("u", "[1, 0, 0]"), in.called("u"));
    plane.v = read_point(in.need("v", "[0, 0, -1]"), in.called("v"));
    plane.material = read_material(in, names);
    if (parallel(plane.u, plane.v))
        fail(*in.find("v"), "'u' and 'v' in [[plane]] are parallel; turn one of them");
    const auto reaches_out = [](std::int64_t o, std::int64_t u, std::int64_t v) {
        return std::max({std::abs(o + u), std::abs(o + v), std::abs(o + u + v)}) > world_reach;
    };
    if (reaches_out(plane.origin.x, plane.u.x, plane.v.x) ||
        reaches_out(plane.origin.y, plane.u.y, plane.v.y) ||
        reaches_out(plane.origin.z, plane.u.z, plane.v.z))
        fail(node, "the plane reaches out of the world, -32767 .. 32767; scale the scene");
    return plane;
}

// 16 points, or four rows of four.
raster::Patch read_patch(const TomlNode& node, const Names& names) {
    constexpr std::array<std::string_view, 2> keys{"control", "material"};
    const TableReader in(node, "[[patch]]", keys);
    const TomlNode& control = in.need("control", "[16 points [x, y, z]]");
    raster::Patch patch;
    std::size_t count = 0;
    const auto add = [&](const TomlNode& point) {
        const raster::World world =
            read_point(point, fmt::format("point {} of {}", count, in.called("control")));
        if (count < patch.control.size()) patch.control[count] = world;
        ++count;
    };
    for (const TomlNode& row : control.children) {
        const bool is_row = row.kind == Kind::array && !row.children.empty() &&
                            row.children.front().kind == Kind::array;
        if (is_row && row.children.size() != 4)
            fail(row, fmt::format("a row of {} holds {} points; write 16 points, or 4 rows of 4",
                                  in.called("control"), row.children.size()));
        if (is_row) {
            for (const TomlNode& point : row.children) add(point);
        } else {
            add(row);
        }
    }
    if (count != patch.control.size())
        fail(control, fmt::format("{} holds {} points; write 16, or 4 rows of 4",
                                  in.called("control"), count));
    patch.material = read_material(in, names);
    return patch;
}

}  // namespace

void append_closed_forms(LoadedScene& scene) {
    for (const raster::Sphere& sphere : scene.spheres) {
        std::array<raster::Patch, raster::patches_per_sphere> made;
        raster::sphere_patches(sphere, made);
        scene.patches.insert(scene.patches.end(), made.begin(), made.end());
    }
    for (const raster::Plane& plane : scene.planes)
        scene.patches.push_back(raster::plane_patch(plane));
}

void read_surfaces(const TomlNode& root, LoadedScene& scene) {
    const Names names = read_materials(root, scene.materials);
    for (const TomlNode& node : tables(root, "sphere"))
        scene.spheres.push_back(read_sphere(node, names));
    for (const TomlNode& node : tables(root, "plane"))
        scene.planes.push_back(read_plane(node, names));
    append_closed_forms(scene);
    for (const TomlNode& node : tables(root, "patch"))
        scene.patches.push_back(read_patch(node, names));
    scene.free_patches = scene.patches.size() - scene.spheres.size() * raster::patches_per_sphere -
                         scene.planes.size();
}

}  // namespace umbra78::tools
