// Prints the C++ source of exact::scenes (scene_words.hpp), from scene files.
//   umbra78_exact_words FOLDER CASES
// A line of CASES is "name file overrides ...", the overrides as `--set` takes them.
#include "shadow/frame/settings.hpp"
#include "tools/scene/scene_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace umbra78;

std::string text(const raster::World& w) { return fmt::format("{{{}, {}, {}}}", w.x, w.y, w.z); }
std::string text(const raster::Axis& a) { return fmt::format("{{{}, {}, {}}}", a[0], a[1], a[2]); }
std::string text(const raster::Levels& l) { return text(raster::Axis{l[0], l[1], l[2]}); }
std::string text(const raster::Material& m) {
    return fmt::format("{{{}, {}, {}}}", text(m.diffuse), text(m.specular), m.shininess);
}
std::string text(const raster::Ellipse& e) {
    return fmt::format("{{{}, {}, {}}}", text(e.centre), text(e.a), text(e.b));
}
std::string text(const raster::Facet& f) {
    return fmt::format("{{{{{}u, {}u, {}u}}, {{{}u, {}u, {}u}}, {}}}", f.vertex[0], f.vertex[1],
                       f.vertex[2], f.normal[0], f.normal[1], f.normal[2], f.material);
}
std::string text(const raster::Patch& p) {
    std::string made = "{{{";
    for (const raster::World& w : p.control) made += text(w) + ",";
    return made + fmt::format("}}}}, {}}}", p.material);
}
std::string text(const raster::View& v) {
    return fmt::format("{{static_cast<raster::Projection>({}), {{{}, {}, {}}}, {}, {}, {}, "
                       "INT64_C({}), INT64_C({})}}",
                       static_cast<int>(v.projection), text(v.axes.right), text(v.axes.up),
                       text(v.axes.back), text(v.target), v.extent, v.distance, v.near_depth,
                       v.far_depth);
}
std::string text(const shadow::Source& s) {
    return fmt::format("{{{}, {}, {}, {}, {}, {}}}", s.first_light, s.lights, text(s.place),
                       text(s.level_q8), s.sectored, s.ramp_px);
}

// Each table once, whichever cases have it.
class Tables {
public:
    template <class Item>
    std::string name(const char* type, std::span<const Item> items) {
        if (items.empty()) return "{}";
        std::string body;
        for (const Item& item : items) body += "    " + text(item) + ",\n";
        const auto [at, added] = names_.try_emplace(type + body, fmt::format("t{}", names_.size()));
        if (added) fmt::print("constexpr {} {}[] = {{\n{}}};\n", type, at->second, body);
        return at->second;
    }

private:
    std::map<std::string, std::string> names_;
};

// A view that is not the default, one by one: most of the 64 are not used.
void print_scene(const shadow::Scene& scene, const std::string& name, Tables& tables) {
    const std::string patches = tables.name("raster::Patch", scene.patches);
    const std::string materials = tables.name("raster::Material", scene.materials);
    const std::string vertices = tables.name("raster::World", scene.mesh.vertices);
    const std::string normals = tables.name("std::array<std::int32_t, 3>", scene.mesh.normals);
    const std::string facets = tables.name("raster::Facet", scene.mesh.facets);
    const std::string blobs = tables.name("raster::Ellipse", scene.blobs);
    fmt::print("shadow::Scene scene_{}() {{\n    shadow::Scene s{{}};\n"
               "    s.patches = {};\n    s.materials = {};\n    s.mesh = {{{}, {}, {}}};\n"
               "    s.blobs = {};\n    s.observer = {};\n    s.channels = {};\n",
               name, patches, materials, vertices, normals, facets, blobs, text(scene.observer),
               scene.channels);
    if (scene.ground != shadow::Scene::no_ground) fmt::print("    s.ground = {};\n", scene.ground);
    fmt::print("    s.light_count = {};\n", scene.light_count);
    for (std::size_t l = 0; l < scene.light_count; ++l)
        fmt::print("    s.lights[{}] = {};\n", l, text(scene.lights[l]));
    fmt::print("    s.source_count = {};\n", scene.source_count);
    for (std::size_t k = 0; k < scene.source_count; ++k)
        fmt::print("    s.sources[{}] = {};\n", k, text(scene.sources[k]));
    fmt::print("    return s;\n}}\nconstexpr SettingWord settings_{}[] = {{\n", name);
}

void print_settings(const shadow::Settings& settings) {
    for (const shadow::Setting& s : shadow::settings_table())
        if (s.get(settings) != s.get(shadow::Settings{}))
            fmt::print("    {{\"{}\", {}}},\n", s.key, s.get(settings));
    fmt::print("}};\n");
}

int print_all(const std::string& folder, std::istream& cases) {
    fmt::print("#include \"tests/exact/scene_words.hpp\"\n\n"
               "namespace umbra78::exact {{\nnamespace {{\n\n");
    Tables tables;
    std::string list, line;
    while (std::getline(cases, line)) {
        std::istringstream words(line);
        std::string name, file;
        if (!(words >> name >> file) || name.front() == '#') continue;
        const std::vector<std::string> overrides{std::istream_iterator<std::string>(words), {}};
        const tools::LoadedScene scene = tools::load_scene(folder + "/" + file, overrides);
        print_scene(scene.view(), name, tables);
        print_settings(scene.settings);
        list += fmt::format("    {{\"{}\", settings_{}, scene_{}}},\n", name, name, name);
    }
    fmt::print("constexpr SceneWords all[] = {{\n{}}};\n\n}}  // namespace\n\n"
               "const std::span<const SceneWords> scenes = all;\n\n"
               "}}  // namespace umbra78::exact\n", list);
    return list.empty() ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::fprintf(stderr, "usage: umbra78_exact_words FOLDER CASES\n");
        return 2;
    }
    std::ifstream cases(arguments[2]);
    try {
        return print_all(arguments[1], cases);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "umbra78_exact_words: %s\n", e.what());
        return 1;
    }
}
