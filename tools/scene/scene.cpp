#include "tools/scene/scene.hpp"

#include "tools/scene/checks.hpp"
#include "tools/scene/lights.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/surfaces.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/scene/view_overrides.hpp"
#include "tools/scene/views.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

// [stream]: opens it, takes its materials and returns the points of all surfaces.
ScenePoints read_stream(const TomlNode& node, const StreamSource& streams, LoadedScene& scene,
                        FirstError& error) {
    const TableReader in(node, scene_table("stream"), error);
    ScenePoints points(scene.surfaces(), nullptr, error);
    const std::string path = in.needed_text("file");
    const std::int64_t largest = in.number("largest", 0);
    if (!error.any() && path.empty())
        in.report(in.need("file"), in.called("file") + " is empty; give a path, or \"-\"");
    if (error.any()) return points;
    if (!streams) {
        in.report(node, "a scene with a [stream] is drawn by umbra78 render alone; give this "
                        "command the scene that the file was packed from");
        return points;
    }
    OpenedStream opened = streams(path);
    if (!opened.stream) {
        in.report(in.need("file"), fmt::format("{}: {}", in.called("file"), opened.error));
        return points;
    }
    const std::span materials = opened.stream->materials();
    if (scene.materials.size() + materials.size() > UINT16_MAX) {
        in.report(node, "the scene and its stream have more than 65535 materials; merge some");
        return points;
    }
    scene.stream = std::move(opened.stream);
    scene.stream->number_materials_from(static_cast<std::uint16_t>(scene.materials.size()));
    scene.materials.insert(scene.materials.end(), materials.begin(), materials.end());
    points = ScenePoints(scene.surfaces(), scene.stream.get(), error);
    if (largest > 0) {
        points.promise(static_cast<std::int32_t>(largest));
        scene.stream->limit(static_cast<std::int32_t>(largest));
    }
    return points;
}

// What only a form on a ground asks for: surfaces that are held, and blobs within the world.
void check_ground(LoadedScene& scene, FirstError& error) {
    const shadow::Form form = scene.settings.form;
    const bool fit = make_blobs(scene);
    if (scene.stream && shadow::is_on_ground(form))
        error.report(scene.name + ": form = \"ground\" and \"blob\" draw the ground before what "
                                  "stands on it, and a [stream] is not held; set form = "
                                  "\"post_process\"");
    else if (!fit && form == shadow::Form::blob)
        error.report(scene.name + ": a blob on the ground reaches out of the world, -32766 .. "
                                  "32766; scale the scene");
}

// Each step computes with what the steps before it have read, so it is taken only if they found
// no error.
void read(std::string_view text, std::span<const std::string> overrides, const FileSource& files,
          const StreamSource& streams, LoadedScene& scene, FirstError& error) {
    TomlNode root = parse_toml(text, scene.name, error);
    if (error.any()) return;
    const TomlNode set = apply_view_overrides(root, overrides, error);
    check_keys(root, "the scene", scene_table_names(), error);
    if (error.any()) return;
    read_surfaces(root, files, scene, error);
    if (error.any()) return;
    ScenePoints points(scene.surfaces(), nullptr, error);
    if (const TomlNode* stream = root.find("stream"))
        points = read_stream(*stream, streams, scene, error);
    points.lacks(keys_left_out(root));
    expect_axes(root, points);
    take_origin(read_origin(root, points, error), scene);
    points.take_origin(scene.origin, scene.surfaces());
    scene.observer = read_observer(root, points, scene.origin, error);
    if (error.any()) return;
    scene.lights = read_lights(root, points, scene.origin, error);
    if (error.any()) return;
    scene.largest = points.reach().largest();
    const auto has_eye = [](const raster::View& v) {
        return v.projection == raster::Projection::perspective;
    };
    bool perspective = has_eye(scene.observer);
    for (const SceneLight& light : scene.lights) perspective = perspective || has_eye(light.view);
    scene.settings = read_settings(root.find("settings"), set, perspective, error);
    if (error.any()) return;
    check_ground(scene, error);
    if (error.any()) return;
    check_matrices(scene, error);
    if (error.any()) return;
    const Warnings found = warnings_of(scene);
    scene.warnings.insert(scene.warnings.end(), found.begin(), found.end());
}

}  // namespace

bool LoadedScene::is_coloured() const {
    const auto grey = [](const raster::Material& m) {
        return m.diffuse.is_grey() && m.specular.is_grey();
    };
    return !std::ranges::all_of(materials, grey) ||
           !std::ranges::all_of(lights, [](const SceneLight& l) { return l.level_q8.is_grey(); });
}

std::size_t LoadedScene::ground_patch() const {
    return raster::patches_per_sphere * spheres.size() + ground.value();
}

shadow::Scene LoadedScene::view() const {
    shadow::Scene made{.patches = {}, .materials = materials, .observer = observer, .lights = {}};
    made.light_count = 0;
    for (const SceneLight& light : lights) {
        made.sources[made.source_count++] = {made.light_count, light.views().size(), light.view,
                                             light.level_q8, light.sectored, light.ramp_px};
        for (const raster::View& v : light.views()) made.lights[made.light_count++] = v;
    }
    made.channels = is_coloured() ? 3 : 1;
    made.streamed = stream != nullptr;
    made.largest_streamed = stream ? largest : 0;
    if (stream) return made;
    made.patches = patches;
    made.mesh = mesh();
    if (ground) made.ground = ground_patch();
    made.blobs = blobs;
    return made;
}

std::string_view kinds_of_surfaces(const LoadedScene& scene) {
    if (scene.stream) return "primitives";
    if (scene.facets.empty()) return "patches";
    return scene.patches.empty() ? "triangles" : "patches and triangles";
}

SceneResult read_scene(std::string_view text, const std::string& name,
                       std::span<const std::string> overrides, const FileSource& files,
                       const StreamSource& streams) {
    SceneResult result;
    FirstError error;
    result.scene.name = name;
    read(text, overrides, files, streams, result.scene, error);
    result.error = error.line();
    return result;
}

}  // namespace umbra78::tools
