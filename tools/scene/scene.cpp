#include "tools/scene/scene.hpp"

#include "tools/scene/checks.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/surfaces.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/scene/views.hpp"

namespace umbra78::tools {
namespace {

// Each step computes with what the steps before it have read, so it is taken only if they found
// no error.
void read(std::string_view text, std::span<const std::string> overrides, const FileSource& files,
          LoadedScene& scene, FirstError& error) {
    TomlNode root = parse_toml(text, scene.name, error);
    if (error.any()) return;
    const TomlNode set = apply_view_overrides(root, overrides, error);
    check_keys(root, "the scene", scene_table_names(), error);
    if (error.any()) return;
    read_surfaces(root, files, scene, error);
    if (error.any()) return;
    take_origin(read_origin(root, scene.surfaces(), error), scene);
    scene.observer = read_observer(root, scene.surfaces(), scene.origin, error);
    if (error.any()) return;
    scene.light = read_light(root, scene.surfaces(), scene.origin, error);
    const bool perspective = scene.observer.projection == raster::Projection::perspective ||
                             scene.light.projection == raster::Projection::perspective;
    scene.settings = read_settings(root.find("settings"), set, perspective, error);
    if (error.any()) return;
    check_matrices(scene, error);
    if (error.any()) return;
    const Warnings found = warnings_of(scene);
    scene.warnings.insert(scene.warnings.end(), found.begin(), found.end());
}

}  // namespace

std::string_view kinds_of_surfaces(const LoadedScene& scene) {
    if (scene.facets.empty()) return "patches";
    return scene.patches.empty() ? "triangles" : "patches and triangles";
}

SceneResult read_scene(std::string_view text, const std::string& name,
                       std::span<const std::string> overrides, const FileSource& files) {
    SceneResult result;
    FirstError error;
    result.scene.name = name;
    read(text, overrides, files, result.scene, error);
    result.error = error.line();
    return result;
}

}  // namespace umbra78::tools
