#include "tools/paper/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace umbra78::tools {
namespace {

constexpr std::string_view head = R"(// The figures' scene in the words of the machine, made by
//   umbra78 figures --words >shadow/frame/paper_scene_words.hpp
// from tools/scenes/figures.toml. Do not edit it: a test makes it again and compares.
#pragma once

#include "raster/scene.hpp"
#include "shadow/frame/settings.hpp"

#include <array>
#include <cstdint>

namespace umbra78::shadow::paper_scene {

)";
constexpr std::string_view tail = "\n}  // namespace umbra78::shadow::paper_scene\n";

void require(bool condition, const char* what) {
    if (!condition) throw SceneError(fmt::format("the figures' words hold {}", what));
}

double unit(std::int32_t word) { return static_cast<double>(word) / 65536; }

bool same_axes(const raster::ViewAxes& a, const raster::ViewAxes& b) {
    return a.right == b.right && a.up == b.up && a.back == b.back;
}

// Whole degrees, from the axes that they were made into.
std::int32_t azimuth_q16(const raster::View& view) {
    for (int degrees = -180; degrees <= 180; ++degrees)
        if (same_axes(view.axes, raster::axes_from_angles(degrees * 65536, 0)))
            return degrees * 65536;
    throw SceneError("the figures' words hold azimuths of whole degrees at elevation 0");
}

void check(const LoadedScene& scene) {
    require(scene.planes.empty() && scene.has_closed_form() && !scene.spheres.empty(),
            "spheres alone");
    for (const raster::Sphere& s : scene.spheres) require(s.material == 0, "one material");
    for (const raster::View& v : {scene.observer, scene.light()})
        require(v.projection == raster::Projection::orthographic &&
                    v.target == raster::World{} && v.extent == scene.observer.extent &&
                    v.near_depth == -v.extent && v.far_depth == v.extent,
                "two views of one cube");
    require(azimuth_q16(scene.observer) == 0, "an observer at azimuth 0");
}

// A setting's line: the key in figures.toml, and the declaration its word completes.
struct Line {
    std::string_view key, declaration;
};
constexpr std::array lines{
    Line{"ambient", "std::int32_t ambient_q8 = {}"},
    Line{"density", "std::int32_t density_q8 = {}"},
    Line{"bias", "std::int64_t bias_q16 = {}"},
    Line{"lookup", "auto lookup = static_cast<Lookup>({})"},
    Line{"dither", "auto dither = static_cast<hw::DitherShape>({})"},
    Line{"dequantize", "std::int32_t dequantize_passes = {}"},
    Line{"low_pass", "std::int32_t low_pass_passes = {}"},
};

std::string settings_text(const shadow::Settings& settings) {
    std::string text;
    for (const Line& line : lines)
        text += fmt::format("inline constexpr {};\n",
                            fmt::format(fmt::runtime(line.declaration),
                                        shadow::find_setting(line.key)->get(settings)));
    for (const shadow::Setting& s : shadow::settings_table()) {
        const bool written = std::any_of(lines.begin(), lines.end(),
                                         [&](const Line& line) { return line.key == s.key; });
        require(written || s.get(settings) == s.get(shadow::Settings{}),
                "ambient, density, bias, lookup, dither, dequantize and low_pass alone");
    }
    return text;
}

}  // namespace

std::string paper_scene_words(const LoadedScene& scene) {
    check(scene);
    std::string text(head);
    text += fmt::format("// Places and radii are world words, Q15.16.\n"
                        "inline constexpr std::array<raster::Sphere, {}> spheres{{{{\n",
                        scene.spheres.size());
    for (const raster::Sphere& s : scene.spheres)
        text += fmt::format("    {{{{{}, {}, {}}}, {}, 0}},  // ({:.4g}, {:.4g}, {:.4g}) radius "
                            "{:.4g}\n",
                            s.centre.x, s.centre.y, s.centre.z, s.radius, unit(s.centre.x),
                            unit(s.centre.y), unit(s.centre.z), unit(s.radius));
    const raster::Material& m = scene.materials.front();
    text += fmt::format("}}}};\n"
                        "inline constexpr raster::Material material{{{}, {}, {}}};\n"
                        "inline constexpr std::int32_t light_azimuth_q16 = {};\n"
                        "inline constexpr std::int32_t extent_q16 = {};\n\n",
                        m.diffuse[0], m.specular[0], m.shininess, azimuth_q16(scene.light()),
                        scene.observer.extent);
    return text + settings_text(scene.settings) + std::string(tail);
}

}  // namespace umbra78::tools
