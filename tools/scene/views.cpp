#include "tools/scene/views.hpp"

#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using raster::Projection;
using raster::View;

// A view and the table that it is read from, if there is one.
struct ViewTable {
    std::string name;  // observer, light, light2
    const TomlNode* node;
};
std::vector<ViewTable> view_tables(const TomlNode& root) {
    std::vector<ViewTable> views{{"observer", root.find("observer")}};
    const std::vector<const TomlNode*> lights = light_nodes(root);
    if (lights.empty()) views.push_back({"light", nullptr});
    for (std::size_t k = 0; k < lights.size(); ++k)
        views.push_back({name_of_light(k, lights.size()), lights[k]});
    return views;
}
const SceneTable& table_of(const ViewTable& view) {
    return scene_table(view.name == "observer" ? "observer" : "light");
}

bool reaches(const raster::World& from, const raster::World& to) {
    const auto within = [](std::int64_t a, std::int64_t b) {
        return std::abs(a - b) <= raster::max_world;
    };
    return within(from.x, to.x) && within(from.y, to.y) && within(from.z, to.z);
}

}  // namespace

std::string keys_left_out(const TomlNode& root) {
    std::string keys;
    const auto need = [&](const std::string& table, const TomlNode* node, const char* key) {
        if (node && node->find(key)) return;
        keys += fmt::format("{}{}.{}", keys.empty() ? "" : ", ", table, key);
    };
    need("stream", root.find("stream"), "largest");
    for (const ViewTable& view : view_tables(root))
        for (const char* key : {"target", "extent", "near", "far"}) need(view.name, view.node, key);
    return keys;
}

void expect_axes(const TomlNode& root, ScenePoints& points) {
    const TomlNode none{.where = root.where};
    FirstError later;
    for (const ViewTable& table : view_tables(root)) {
        const TableReader in(table.node ? *table.node : none, table_of(table), later);
        if (in.find("position") || (in.find("extent") && in.find("near") && in.find("far")))
            continue;
        View view;
        look_by_angles(in, view);
        points.expect(view.axes);
    }
}

raster::World read_origin(const TomlNode& root, ScenePoints& points, FirstError& error) {
    const TomlNode none{.where = root.where};
    const TomlNode* observer = root.find("observer");
    const TableReader in(observer ? *observer : none, scene_table("observer"), error);
    if (in.choice("recentre") != 0) return {};
    const raster::World origin = read_target(in, points, {});
    FirstError later;  // the lights' errors are read_lights()'
    bool holds = true;
    for (const TomlNode* light : light_nodes(root)) {
        const TableReader of_light(*light, scene_table("light"), later);
        for (const char* key : {"target", "position"})
            holds = holds && reaches(of_light.point(key, origin), origin);
    }
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
    fit_view(in, view, points);
    return view;
}

}  // namespace umbra78::tools
