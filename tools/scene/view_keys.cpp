#include "tools/scene/view_keys.hpp"

#include "tools/scene/view_fit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {

using raster::Projection;
using raster::View;

namespace {

bool is_override(const TomlNode& node) { return node.where.starts_with("--set "); }

std::int32_t extent_of_all(const View& view, ScenePoints& points) {
    if (view.projection == Projection::orthographic)
        return fitted_extent(view, points.ranges(view.axes));
    PerspectiveFit fit(view);
    points.for_points([&](const raster::World& p) { fit.add(p); });
    return fit.extent();
}

}  // namespace

std::string name_of_light(std::size_t index, std::size_t lights) {
    return lights == 1 ? "light" : fmt::format("light{}", index + 1);
}

std::vector<const TomlNode*> light_nodes(const TomlNode& root) {
    std::vector<const TomlNode*> nodes;
    const TomlNode* node = root.find("light");
    if (node && node->kind != TomlNode::Kind::array) nodes.push_back(node);
    if (node && node->kind == TomlNode::Kind::array)
        for (const TomlNode& child : node->children) nodes.push_back(&child);
    return nodes;
}

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

void fit_view(const TableReader& in, View& view, ScenePoints& points) {
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

raster::World less(const raster::World& a, const raster::World& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

raster::World read_target(const TableReader& in, ScenePoints& points,
                          const raster::World& origin) {
    return in.find("target") ? less(in.point("target", origin), origin) : points.box().centre();
}

void look_from_position(const TableReader& in, View& view, const raster::World& origin) {
    const TomlNode& node = in.need("position");
    const raster::World from = less(in.needed_point("position"), origin);
    if (in.error().any()) return;
    if (!raster::axes_from_points(from, view.target, view.axes))
        in.report(node, fmt::format("{} is its target, {}; move one of them",
                                    in.called("position"),
                                    in.find("target") ? "as given" : "the middle of the scene"));
    view.distance = raster::distance_between(from, view.target);
    if (view.distance == 0)
        in.report(node, fmt::format("{} is farther than 32767 from its target; use kind = "
                                    "\"directional\"", in.called("position")));
}

}  // namespace umbra78::tools
