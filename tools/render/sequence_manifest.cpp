#include "tools/render/sequence_manifest.hpp"

#include "fixed/fnv.hpp"
#include "tools/io/buffer_files.hpp"
#include "tools/render/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;

constexpr const char* manifest_name = "frames.json";

class InputHash {
public:
    template <class... Word>
    void add(Word... words) {
        (add_word(static_cast<std::int64_t>(words)), ...);
    }
    void add(const raster::Levels& l) { add(l[0], l[1], l[2]); }
    void add(const raster::World& p) { add(p.x, p.y, p.z); }
    void add(const raster::View& v) {
        add(v.projection, v.extent, v.distance, v.near_depth, v.far_depth);
        add(v.target);
        for (const raster::Axis& axis : {v.axes.right, v.axes.up, v.axes.back})
            add(axis[0], axis[1], axis[2]);
    }
    std::string text() const { return fmt::format("fnv1a64:{:016x}", hash_.value()); }

private:
    void add_word(std::int64_t word) {
        hash_.u32be(static_cast<std::uint32_t>(static_cast<std::uint64_t>(word) >> 32));
        hash_.u32be(static_cast<std::uint32_t>(word));
    }
    fixed::Fnv1a64 hash_;
};

std::string text_of(const Path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string hash_inputs(const LoadedScene& scene) {
    InputHash hash;
    hash.add(scene.patches.size(), scene.materials.size());
    for (const raster::Patch& patch : scene.patches) {
        hash.add(patch.material);
        for (const raster::World& p : patch.control) hash.add(p);
    }
    hash.add(scene.facets.size(), scene.vertices.size(), scene.normals.size());
    for (const raster::World& p : scene.vertices) hash.add(p);
    for (const auto& n : scene.normals) hash.add(n[0], n[1], n[2]);
    for (const raster::Facet& f : scene.facets) {
        hash.add(f.material);
        for (std::size_t k = 0; k < 3; ++k) hash.add(f.vertex[k], f.normal[k]);
    }
    for (const raster::Material& m : scene.materials) {
        hash.add(m.diffuse);
        hash.add(m.specular);
        hash.add(m.shininess);
    }
    hash.add(scene.observer);
    for (const SceneLight& light : scene.lights) {
        hash.add(light.views().size());
        hash.add(light.level_q8);
        hash.add(light.ramp_px);
        hash.add(light.view);
        for (const raster::View& v : light.parts) hash.add(v);
    }
    for (const shadow::Setting& s : shadow::settings_table()) hash.add(s.get(scene.settings));
    return hash.text();
}

SequenceManifest read_manifest(const Path& folder) {
    const Path path = folder / manifest_name;
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return {};
    try {
        SequenceManifest manifest;
        const ordered_json json = parse_json(text_of(path));
        for (const ordered_json& row : json.at("frames"))
            manifest.push_back({row.at("file"), row.at("inputs"), row.at("picture")});
        return manifest;
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(fmt::format("'{}' is not a list of frames; remove it, or name "
                                             "another folder with --out", path.string()));
    }
}

void write_manifest(const Path& folder, const SequenceManifest& manifest, FileSet& files) {
    ordered_json json{{"frames", ordered_json::array()}};
    for (const ManifestEntry& e : manifest)
        json["frames"].push_back({{"file", e.file}, {"inputs", e.inputs}, {"picture", e.picture}});
    const std::string text = print(json);
    write_file(folder / manifest_name, std::as_bytes(std::span(text)), &files);
}

const ManifestEntry* find_drawn(const SequenceManifest& manifest, const Path& folder,
                                const std::string& file, const std::string& inputs) {
    for (const ManifestEntry& e : manifest) {
        if (e.file != file || e.inputs != inputs) continue;
        const std::optional<GrayPng> png = read_png_gray(folder / file);
        if (!png || png->width != png->height) return nullptr;
        const Buffer buffer{"picture", png->width, 255, std::span(std::as_const(png->samples))};
        return hash_of(buffer) == e.picture ? &e : nullptr;
    }
    return nullptr;
}

}  // namespace umbra78::tools
