// Scene files: TOML, short enough to write by hand, read exactly into the machine's words.
//
// Every decimal goes from its text to fixed point without passing through floating point. Whatever
// is wrong is one line: file, line, what, and the remedy. tools/scenes/figures.toml is the
// documented example.
//
//   [observer]     projection, azimuth, elevation, target, extent, near, far, distance
//   [light]        kind, azimuth, elevation, position, target, extent, near, far
//   [[material]]   name, diffuse, specular, shininess
//   [[sphere]]     centre, radius, material
//   [[plane]]      origin, u, v, material
//   [[patch]]      control, material
//   [settings]     profile, and the keys of shadow::settings_table()
#pragma once

#include "raster/scene.hpp"
#include "shadow/frame/frame.hpp"
#include "tools/scene/scene_error.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct LoadedScene {
    std::string name;
    std::vector<raster::Material> materials;  // the last: of surfaces that name none
    std::vector<raster::Sphere> spheres;
    std::vector<raster::Plane> planes;
    std::vector<raster::Patch> patches;  // all surfaces, spheres' and planes' first
    std::size_t free_patches = 0;        // patches that are neither, so truth has no closed form
    raster::View observer, light;
    shadow::Settings settings;           // the file's, with the overrides applied
    std::vector<std::string> warnings;   // a caster outside the light's volume, ...

    shadow::Scene view() const { return {patches, materials, observer, {{light}}}; }
};

// `overrides` are "key=value" as --set takes them: a setting's key, observer.KEY or light.KEY.
// Throws SceneError.
LoadedScene load_scene(const std::string& path, std::span<const std::string> overrides);
LoadedScene parse_scene(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides);

}  // namespace umbra78::tools
