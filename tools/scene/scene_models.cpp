#include "tools/scene/scene_models.hpp"

#include "tools/models/place_model.hpp"

#include <fmt/format.h>

namespace umbra78::tools {
namespace {

ModelPlacing read_placing(const TableReader& in) {
    ModelPlacing how;
    how.placing = {in.point("place", {}), raster::rotation_of(read_turn(in))};
    how.scale = in.number("scale");
    how.z_up = in.choice("up") == 1;
    how.smooth = in.choice("shading") == 0;
    return how;
}

ModelData read_file(const TableReader& in, const FileSource& files) {
    const std::string path = in.needed_text("file");
    if (in.error().any()) return {};
    const TomlNode& where = in.need("file");
    if (!files) {
        in.report(where, in.called("file") + " needs a scene that is a file itself; save the "
                                             "scene, and name its path");
        return {};
    }
    const FileText file = files(path);
    if (!file.error.empty()) {
        in.report(where, fmt::format("{}: {}", in.called("file"), file.error));
        return {};
    }
    ModelResult result = read_model(file.text, file.name);
    if (!result.ok()) in.error().report(result.error);
    return std::move(result.model);
}

void append(const PlacedModel& placed, std::uint16_t material, LoadedScene& scene) {
    const auto first_vertex = static_cast<std::uint32_t>(scene.vertices.size());
    const auto first_normal = static_cast<std::uint32_t>(scene.normals.size());
    for (raster::Patch patch : placed.patches) {
        patch.material = material;
        scene.patches.push_back(patch);
    }
    scene.vertices.insert(scene.vertices.end(), placed.vertices.begin(), placed.vertices.end());
    scene.normals.insert(scene.normals.end(), placed.normals.begin(), placed.normals.end());
    for (raster::Facet facet : placed.facets) {
        for (std::uint32_t& v : facet.vertex) v += first_vertex;
        for (std::uint32_t& n : facet.normal)
            if (n != raster::Facet::flat) n += first_normal;
        facet.material = material;
        scene.facets.push_back(facet);
    }
}

void warn_of_model(const ModelData& model, Warnings& warnings) {
    const auto warn = [&](const char* key, std::size_t count, const char* what) {
        if (count == 0) return;
        warnings.push_back({key, static_cast<double>(count),
                            fmt::format("{}: {} {}", model.name, count, what)});
    };
    warn("model_no_area", model.no_area,
         "triangles have no area and are left out; remove them from the file");
    warn("model_lines", model.lines_and_points,
         "lines and points are no surface and are left out; make thin faces of them");
}

}  // namespace

raster::Turn read_turn(const TableReader& in) {
    const raster::World turn = in.point("turn", {});  // Q15.16 degrees
    return {turn.x, turn.y, turn.z};
}

void read_models(const TomlNode& root, const MaterialNames& names, const FileSource& files,
                 LoadedScene& scene, FirstError& error) {
    for (const TomlNode& node : tables_of(root, "model", error)) {
        const TableReader in(node, scene_table("model"), error);
        const ModelPlacing how = read_placing(in);
        const std::uint16_t material = read_material(in, names);
        const ModelData model = read_file(in, files);
        if (error.any()) return;
        const std::string remedy =
            fmt::format("change 'scale' or 'place' of the [[model]] at {}", node.where);
        const PlacedModel placed = place_model(model, how, remedy, error);
        if (error.any()) return;
        append(placed, material, scene);
        scene.end_object();
        warn_of_model(model, scene.warnings);
    }
}

}  // namespace umbra78::tools
