#include "tools/scene/views.hpp"

#include "fixed/root.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/scene/view_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbra78::tools {
namespace {

using raster::Projection;
using raster::View;

bool is_override(const TomlNode& node) { return node.where.starts_with("--set "); }

// Reports a key that only another kind of view has. Where --set chose the kind, a key of the file
// is ignored.
void refuse(const TableReader& in, std::string_view key, std::string_view kind_key,
            std::string_view needed) {
    const TomlNode *node = in.find(key), *kind = in.find(kind_key);
    if (!node || (kind && is_override(*kind) && !is_override(*node))) return;
    in.report(*node, fmt::format("{} needs {} = \"{}\"", in.called(key), kind_key, needed));
}

void look_by_angles(const TableReader& in, View& view) {
    const auto azimuth = static_cast<std::int32_t>(in.number("azimuth"));
    const auto elevation = static_cast<std::int32_t>(in.number("elevation"));
    view.axes = raster::axes_from_angles(azimuth, elevation);
}

std::int32_t extent_of_all(const View& view, ScenePoints& points) {
    if (view.projection == Projection::orthographic)
        return fitted_extent(view, points.ranges(view.axes));
    PerspectiveFit fit(view);
    points.for_points([&](const raster::World& p) { fit.add(p); });
    return fit.extent();
}

// The window and the depth range, as given or fitted. The view's other members are read.
void fit(const TableReader& in, View& view, ScenePoints& points) {
    view.extent = static_cast<std::int32_t>(in.number("extent", 0));
    if (in.error().any()) return;
    if (view.extent == 0) view.extent = extent_of_all(view, points);
    const bool perspective = view.projection == Projection::perspective;
    if (!in.find("near") || !in.find("far"))
        raster::fit_depth(view, raster::depth_range_of(view, points.ranges(view.axes).back));
    view.near_depth = in.number("near", view.near_depth, perspective);
    view.far_depth = in.number("far", view.far_depth, perspective);
    if (in.error().any() || view.near_depth < view.far_depth) return;
    const TomlNode* node = in.find("far") ? in.find("far") : in.find("near");
    const bool both = in.find("far") && in.find("near");
    const std::string what =
        fmt::format("'near' in {} is not less than 'far'; {}", in.title(),
                    both ? "exchange them, or leave both out to fit them to the scene"
                         : "give both, or neither to fit them to the scene");
    in.report(*node, what);
}

// floor(|v| + 1/2), 0 if it does not fit a word.
std::int32_t rounded_length(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t max = world_reach;
    if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > max) return 0;
    const auto sum = static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y) +
                     static_cast<std::uint64_t>(z * z);
    const std::uint64_t root = fixed::isqrt(sum);
    const std::uint64_t rounded = root + (sum - root * root > root ? 1 : 0);
    return rounded > max ? 0 : static_cast<std::int32_t>(rounded);
}

raster::World less(const raster::World& a, const raster::World& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// A point as given, less the origin; left out, it is the middle of the scene.
raster::World read_target(const TableReader& in, ScenePoints& points,
                          const raster::World& origin) {
    return in.find("target") ? less(in.point("target", origin), origin) : points.box().centre();
}

bool reaches(const raster::World& from, const raster::World& to) {
    const auto within = [](std::int64_t a, std::int64_t b) {
        return std::abs(a - b) <= raster::max_world;
    };
    return within(from.x, to.x) && within(from.y, to.y) && within(from.z, to.z);
}

void look_from_position(const TableReader& in, View& view, const raster::World& origin) {
    const TomlNode& node = in.need("position");
    const raster::World from = less(in.needed_point("position"), origin);
    if (in.error().any()) return;
    if (!raster::axes_from_points(from, view.target, view.axes))
        in.report(node, fmt::format("{} is its target, {}; move one of them",
                                    in.called("position"),
                                    in.find("target") ? "as given" : "the middle of the scene"));
    const raster::World& to = view.target;
    view.distance = rounded_length(std::int64_t{from.x} - to.x, std::int64_t{from.y} - to.y,
                                   std::int64_t{from.z} - to.z);
    if (view.distance == 0)
        in.report(node, fmt::format("{} is farther than 32767 from its target; use kind = "
                                    "\"directional\"", in.called("position")));
}

}  // namespace

std::string keys_left_out(const TomlNode& root) {
    std::string keys;
    const auto need = [&](const char* table, const char* key) {
        const TomlNode* node = root.find(table);
        if (node && node->find(key)) return;
        keys += fmt::format("{}{}.{}", keys.empty() ? "" : ", ", table, key);
    };
    need("stream", "largest");
    for (const char* table : {"observer", "light"})
        for (const char* key : {"target", "extent", "near", "far"}) need(table, key);
    return keys;
}

void expect_axes(const TomlNode& root, ScenePoints& points) {
    const TomlNode none{.where = root.where};
    FirstError later;
    for (const char* name : {"observer", "light"}) {
        const TomlNode* node = root.find(name);
        const TableReader in(node ? *node : none, scene_table(name), later);
        if (in.find("position") || (in.find("extent") && in.find("near") && in.find("far")))
            continue;
        View view;
        look_by_angles(in, view);
        points.expect(view.axes);
    }
}

raster::World read_origin(const TomlNode& root, ScenePoints& points, FirstError& error) {
    const TomlNode none{.where = root.where};
    const TomlNode *observer = root.find("observer"), *light = root.find("light");
    const TableReader in(observer ? *observer : none, scene_table("observer"), error);
    if (in.choice("recentre") != 0) return {};
    const raster::World origin = read_target(in, points, {});
    FirstError later;  // the light's errors are read_light()'s
    const TableReader of_light(light ? *light : none, scene_table("light"), later);
    bool holds = true;
    for (const char* key : {"target", "position"})
        holds = holds && reaches(of_light.point(key, origin), origin);
    const raster::Box& box = points.reach();
    if (!box.empty()) holds = holds && reaches(box.min, origin) && reaches(box.max, origin);
    return holds && !error.any() && !later.any() ? origin : raster::World{};
}

raster::View read_observer(const TomlNode& root, ScenePoints& points,
                           const raster::World& origin, FirstError& error) {
    const TomlNode none{.where = root.where};
    const TomlNode* node = root.find("observer");
    const TableReader in(node ? *node : none, scene_table("observer"), error);
    View view;
    view.projection = static_cast<Projection>(in.choice("projection"));
    view.target = read_target(in, points, origin);
    look_by_angles(in, view);
    if (view.projection == Projection::perspective)
        view.distance = static_cast<std::int32_t>(in.needed_number("distance"));
    else
        refuse(in, "distance", "projection", "perspective");
    fit(in, view, points);
    return view;
}

raster::View read_light(const TomlNode& root, ScenePoints& points, const raster::World& origin,
                        FirstError& error) {
    View view;
    const TomlNode* node = root.find("light");
    if (!node) {
        report(error, root, "there is no [light]; add [light] and azimuth = -100, or another");
        return view;
    }
    const TableReader in(*node, scene_table("light"), error);
    view.target = read_target(in, points, origin);
    if (in.choice("kind") == 0) {
        refuse(in, "position", "kind", "point");
        in.need("azimuth");
        look_by_angles(in, view);
    } else {
        refuse(in, "azimuth", "kind", "directional");
        refuse(in, "elevation", "kind", "directional");
        view.projection = Projection::perspective;
        look_from_position(in, view, origin);
    }
    fit(in, view, points);
    return view;
}

TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides,
                              FirstError& error) {
    TomlNode settings;
    for (const std::string& text : overrides) {
        TomlNode node = parse_override(text, error);
        const std::size_t dot = node.key.find('.');
        const std::string view = node.key.substr(0, dot);
        if (dot == std::string::npos) {
            settings.children.push_back(std::move(node));
            continue;
        }
        if (view != "observer" && view != "light") {
            report(error, node,
                   fmt::format("unknown key '{}'; set a setting, observer.KEY or light.KEY",
                               node.key));
            continue;
        }
        node.key.erase(0, dot + 1);
        auto& tables = root.children;
        auto table = std::find_if(tables.begin(), tables.end(),
                                  [&](const TomlNode& t) { return t.key == view; });
        if (table == tables.end())
            table = tables.insert(table, TomlNode{.where = node.where, .key = view});
        std::erase_if(table->children, [&](const TomlNode& t) { return t.key == node.key; });
        table->children.push_back(std::move(node));
    }
    return settings;
}

}  // namespace umbra78::tools
