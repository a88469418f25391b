#include "tools/scene/views.hpp"

#include "fixed/root.hpp"
#include "tools/scene/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbra78::tools {
namespace {

using raster::Projection;
using raster::View;

constexpr NumberRange azimuth_range{16, -360 * world_one, 360 * world_one};
constexpr NumberRange elevation_range{16, -90 * world_one, 90 * world_one};
constexpr NumberRange depth_range_ortho{16, -4 * world_reach, 4 * world_reach};
constexpr NumberRange depth_range_eye{16, 1, 4 * world_reach};

constexpr std::string_view projections[] = {"orthographic", "perspective"};
constexpr std::string_view light_kinds[] = {"directional", "point"};
constexpr std::string_view observer_keys[] = {"projection", "azimuth", "elevation", "target",
                                              "extent",     "near",    "far",       "distance"};
constexpr std::string_view light_keys[] = {"kind",   "azimuth", "elevation", "target",
                                           "extent", "near",    "far",       "position"};

bool is_override(const TomlNode& node) { return node.where.starts_with("--set "); }

// Refuses a key of another kind of view; where --set chose the kind, the file's key is ignored.
void refuse(const TableReader& in, std::string_view key, std::string_view kind_key,
            std::string_view needed) {
    const TomlNode *node = in.find(key), *kind = in.find(kind_key);
    if (!node || (kind && is_override(*kind) && !is_override(*node))) return;
    fail(*node, fmt::format("{} needs {} = \"{}\"", in.called(key), kind_key, needed));
}

std::int32_t length(const TableReader& in, std::string_view key, std::int64_t otherwise) {
    return static_cast<std::int32_t>(in.number(key, length_range, otherwise));
}

raster::World target(const TableReader& in, Patches patches) {
    const TomlNode* node = in.find("target");
    return node ? read_point(*node, in.called("target")) : box_centre(patches);
}

void look_by_angles(const TableReader& in, View& view) {
    const auto angle = [&](const char* key, const NumberRange& range) {
        return static_cast<std::int32_t>(in.number(key, range, 0));
    };
    view.axes = raster::axes_from_angles(angle("azimuth", azimuth_range),
                                           angle("elevation", elevation_range));
}

// The window and the depth range, given or fitted; everything else of the view stands.
void fit(const TableReader& in, View& view, Patches patches) {
    view.extent = length(in, "extent", 0);
    if (view.extent == 0) view.extent = fitted_extent(view, patches);
    raster::fit_depth(view, raster::depth_range(view, patches));
    const NumberRange& range =
        view.projection == Projection::perspective ? depth_range_eye : depth_range_ortho;
    view.near_depth = in.number("near", range, view.near_depth);
    view.far_depth = in.number("far", range, view.far_depth);
    if (view.near_depth < view.far_depth) return;
    const TomlNode* node = in.find("far") ? in.find("far") : in.find("near");
    const bool both = in.find("far") && in.find("near");
    fail(*node, fmt::format("'near' in {} is not less than 'far'; {}", in.title(),
                            both ? "exchange them, or leave both out to fit them to the scene"
                                 : "give both, or neither to fit them to the scene"));
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

void look_from_position(const TableReader& in, View& view) {
    const TomlNode& node = in.need("position", "[-4, 6, 5]");
    const raster::World from = read_point(node, in.called("position"));
    if (!raster::axes_from_points(from, view.target, view.axes))
        fail(node, fmt::format("{} is its target, {}; move one of them", in.called("position"),
                               in.find("target") ? "as given" : "the middle of the scene"));
    const raster::World& to = view.target;
    view.distance = rounded_length(std::int64_t{from.x} - to.x, std::int64_t{from.y} - to.y,
                                   std::int64_t{from.z} - to.z);
    if (view.distance == 0)
        fail(node, fmt::format("{} is farther than 32767 from its target; use kind = "
                               "\"directional\"", in.called("position")));
}

}  // namespace

raster::View read_observer(const TomlNode& root, Patches patches) {
    const TomlNode none{.where = root.where};
    const TomlNode* table = root.find("observer");
    const TableReader in(table ? *table : none, "[observer]", observer_keys);
    View view;
    view.projection = static_cast<Projection>(in.choice("projection", projections, 0));
    view.target = target(in, patches);
    look_by_angles(in, view);
    if (view.projection == Projection::perspective) {
        in.need("distance", "8");
        view.distance = length(in, "distance", 0);
    } else {
        refuse(in, "distance", "projection", "perspective");
    }
    fit(in, view, patches);
    return view;
}

raster::View read_light(const TomlNode& root, Patches patches) {
    const TomlNode* table = root.find("light");
    if (!table) fail(root, "there is no [light]; add [light] and azimuth = -100, or another");
    const TableReader in(*table, "[light]", light_keys);
    View view;
    view.target = target(in, patches);
    if (in.choice("kind", light_kinds, 0) == 0) {
        refuse(in, "position", "kind", "point");
        in.need("azimuth", "-100");
        look_by_angles(in, view);
    } else {
        refuse(in, "azimuth", "kind", "directional");
        refuse(in, "elevation", "kind", "directional");
        view.projection = Projection::perspective;
        look_from_position(in, view);
    }
    fit(in, view, patches);
    return view;
}

TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides) {
    TomlNode settings;
    for (const std::string& text : overrides) {
        TomlNode node = parse_override(text);
        const std::size_t dot = node.key.find('.');
        const std::string view = node.key.substr(0, dot);
        if (dot == std::string::npos) {
            settings.children.push_back(std::move(node));
            continue;
        }
        if (view != "observer" && view != "light")
            fail(node, fmt::format("unknown key '{}'; set a setting, observer.KEY or light.KEY",
                                   node.key));
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
