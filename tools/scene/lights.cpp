#include "tools/scene/lights.hpp"

#include "fixed/noise.hpp"
#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace umbra78::tools {
namespace {

using raster::Projection;
using raster::View;

enum class LightKind { directional, point, area, sectors };  // as the key's choices

// The views of the lights on an area, each fitted to the scene where the file gives nothing.
void read_area(const TableReader& in, const raster::World& origin, ScenePoints& points,
               SceneLight& light) {
    const auto size = static_cast<std::int32_t>(in.needed_number("size"));
    const auto n = static_cast<int>(in.number("samples"));
    const bool noisy = in.choice("places") == 1;
    fixed::NoiseRegister noise(static_cast<std::uint32_t>(in.number("seed")));
    const raster::World middle = less(in.needed_point("position"), origin);
    if (in.error().any()) return;
    light.side = size;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            View view = light.view;
            const auto u = static_cast<std::uint8_t>(noise.take(8));
            const auto v = static_cast<std::uint8_t>(noise.take(8));
            const raster::World from = raster::place_on_area(
                middle, light.view.axes, size,
                noisy ? raster::noise_in_cell(n, i, j, u, v) : raster::middle_of_cell(n, i, j));
            const raster::World& to = view.target;
            view.distance = raster::distance_between(from, to);
            if (view.distance == 0 || !raster::axes_from_points(from, to, view.axes)) {
                in.report(in.need("size"),
                          fmt::format("{} puts a point of the area on its target, or beyond "
                                      "32767 of it; make it smaller", in.called("size")));
                return;
            }
            fit_view(in, view, points);
            if (in.error().any()) return;
            light.parts.push_back(view);
        }
    }
}

// The six views of a light that shines in all directions: a quarter turn each, as far away as the
// target is, in the order of hw/sectors.hpp.
void read_sectors(const TableReader& in, const raster::World& origin, ScenePoints& points,
                  SceneLight& light) {
    const raster::World from = less(in.needed_point("position"), origin);
    light.sectored = true;
    for (const auto axis : {&raster::World::x, &raster::World::y, &raster::World::z}) {
        for (const int sign : {1, -1}) {
            View view = light.view;
            const std::int64_t to = std::int64_t{from.*axis} + std::int64_t{sign} * view.distance;
            if (std::abs(to) > raster::max_world) {
                in.report(in.need("position"),
                          fmt::format("{} lies so far out that its sectors look beyond 32766; "
                                      "bring its target nearer to it", in.called("position")));
                return;
            }
            view.target = from;
            view.target.*axis = static_cast<std::int32_t>(to);
            raster::axes_from_points(from, view.target, view.axes);
            fit_view(in, view, points);
            view.extent = view.distance;
            if (in.error().any()) return;
            light.parts.push_back(view);
        }
    }
    light.view = light.parts.front();
}

SceneLight read_light(const TomlNode& node, ScenePoints& points, const raster::World& origin,
                      FirstError& error) {
    SceneLight light;
    View& view = light.view;
    const TableReader in(node, scene_table("light"), error);
    view.target = read_target(in, points, origin);
    const auto kind = static_cast<LightKind>(in.choice("kind"));
    light.level_q8 = in.levels("level");
    if (kind != LightKind::area) {
        refuse(in, "size", "kind", "area");
        for (const char* key : {"samples", "places", "seed"}) refuse(in, key, "kind", "area");
    }
    light.ramp_px = static_cast<int>(in.number("ramp"));
    if (kind == LightKind::directional) {
        refuse(in, "position", "kind", "point");
        in.need("azimuth");
        look_by_angles(in, view);
    } else {
        refuse(in, "azimuth", "kind", "directional");
        refuse(in, "elevation", "kind", "directional");
        view.projection = Projection::perspective;
        look_from_position(in, view, origin);
    }
    if (kind == LightKind::sectors) {
        if (const TomlNode* given = in.find("extent"))
            in.report(*given, fmt::format("{} is a quarter turn of each sector; leave it out, or "
                                          "set kind = \"point\"", in.called("extent")));
        if (!error.any()) read_sectors(in, origin, points, light);
        return light;
    }
    fit_view(in, view, points);
    if (kind == LightKind::area && !error.any()) read_area(in, origin, points, light);
    if (light.ramp_px > 0 && light.views().size() > 1)
        in.report(in.need("ramp"),
                  fmt::format("{} is for one hard shadow; set samples = 1, or leave it out",
                              in.called("ramp")));
    return light;
}

}  // namespace

std::vector<SceneLight> read_lights(const TomlNode& root, ScenePoints& points,
                                    const raster::World& origin, FirstError& error) {
    std::vector<SceneLight> lights;
    std::size_t maps = 0;
    for (const TomlNode* node : light_nodes(root)) {
        if (error.any()) break;
        lights.push_back(read_light(*node, points, origin, error));
        maps += lights.back().views().size();
        if (lights.size() > shadow::max_sources)
            report(error, *node, fmt::format("there are more than {} lights; leave some out",
                                             shadow::max_sources));
        else if (maps > shadow::max_lights)
            report(error, *node,
                   fmt::format("the lights have {} depth maps up to this one, and {} are possible; "
                               "lower 'samples'", maps, shadow::max_lights));
    }
    if (lights.empty()) {
        report(error, root, "there is no [light]; add [light] and azimuth = -100, or another");
        lights.resize(1);
    }
    return lights;
}

}  // namespace umbra78::tools
