// A scene, read from the text of a scene file (TOML) into the machine's fixed-point words.
//
// Every decimal goes from its text to fixed point without passing through floating point. The
// tables and keys are those of scene_keys.hpp, listed in tools/scenes/KEYS.md; an example is
// tools/scenes/figures.toml. Nothing here needs exceptions, files or threads:
// the files that a scene names come from whoever calls.
#pragma once

#include "raster/scene.hpp"
#include "shadow/frame/frame.hpp"
#include "tools/scene/warning.hpp"
#include "tools/stream/stream.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// A [[light]] of a scene: a source, as hw/MACHINE.md, section 23, calls it.
struct SceneLight {
    raster::View view{};              // from its place
    std::vector<raster::View> parts;  // of the lights on its area, or of its sectors; else empty
    std::int32_t side = 0;            // of an area's square, Q15.16
    bool sectored = false;
    int ramp_px = 0;                  // of Crow's ramp around its shadow
    raster::Levels level_q8 = 256;

    bool has_area() const { return side > 0; }
    std::span<const raster::View> views() const {
        return parts.empty() ? std::span(&view, 1) : std::span(parts);
    }
};

// One [[sphere]], [[plane]], [[model]], ...: its patches and facets end before these.
struct SceneObject {
    std::size_t patches_end = 0, facets_end = 0;
};

struct LoadedScene {
    std::string name;
    std::vector<raster::Material> materials;  // the last one is of surfaces that name none
    std::vector<raster::Sphere> spheres;
    std::vector<raster::Plane> planes;
    std::optional<std::size_t> ground{};  // which of the planes form = ground casts shadows on
    std::vector<SceneObject> objects;     // where each surface of the file ends, in its order
    std::vector<raster::Ellipse> blobs;   // beneath the objects, if there is a ground
    std::vector<raster::Patch> patches;  // of all surfaces: the spheres', the planes', free ones
    std::vector<raster::World> vertices;  // of all meshes, and what joins them to triangles
    std::vector<std::array<std::int32_t, 3>> normals;
    std::vector<raster::Facet> facets;
    // Taken from all places above and from the views' targets: observer.recentre.
    raster::World origin{};
    std::size_t free_patches = 0;        // neither spheres' nor planes': truth has no closed form
    raster::View observer;
    std::vector<SceneLight> lights = std::vector<SceneLight>(1);  // at least one
    // The primitives of [stream], which come after those above; null if there is none. All places
    // lie within `largest` of the origin, in each coordinate.
    std::shared_ptr<PrimitiveStream> stream;
    std::uint32_t largest = 0;
    std::vector<raster::World> sample;   // points of the stream, once it has been drawn
    shadow::Settings settings;           // the file's, with the overrides applied
    Warnings warnings;                   // a caster outside the light's volume, ...

    // Whether exact truth has a closed form: spheres and planes alone.
    bool has_closed_form() const { return free_patches == 0 && facets.empty() && !stream; }
    // The view of the first light, which is the only one of most scenes.
    raster::View& light() { return lights.front().view; }
    const raster::View& light() const { return lights.front().view; }
    // Whether the picture needs three channels.
    bool is_coloured() const;
    std::size_t ground_patch() const;  // its number, where there is a ground
    void end_object() { objects.push_back({patches.size(), facets.size()}); }
    raster::Mesh mesh() const { return {vertices, normals, facets}; }
    raster::Surfaces surfaces() const { return {patches, mesh()}; }
    // What the core draws; of a scene with a stream, without any surfaces.
    shadow::Scene view() const;
};

// What its surfaces are called where they are counted: "patches", "patches and triangles", ...
std::string_view kinds_of_surfaces(const LoadedScene&);

struct SceneResult {
    LoadedScene scene;  // whole only if there is no error
    std::string error;  // one line: file and line (or the override), what is wrong, the remedy

    bool ok() const { return error.empty(); }
};

// What a file that a scene names holds.
struct FileText {
    std::string name;     // its path as it was opened, for errors
    std::string text{};
    std::string error{};  // why it cannot be read, and the remedy; else empty
};

// Gives the file that stands in a scene as `path`, which counts from the scene's own folder.
using FileSource = std::function<FileText(const std::string& path)>;

// Opens the packed file that stands in a scene as [stream] file.
using StreamSource = std::function<OpenedStream(const std::string& path)>;

// `name` is the file's, for errors and warnings. `overrides` are "key=value" as --set takes them:
// a setting's key, observer.KEY or light.KEY; of two with the same key the later one counts.
// Without `files` a scene that names files is an error, and without `streams` one with a [stream].
SceneResult read_scene(std::string_view text, const std::string& name,
                       std::span<const std::string> overrides, const FileSource& files = {},
                       const StreamSource& streams = {});

}  // namespace umbra78::tools
