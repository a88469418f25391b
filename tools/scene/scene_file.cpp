#include "tools/scene/scene_file.hpp"

#include "tools/scene/checks.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/scene/surfaces.hpp"
#include "tools/scene/table_reader.hpp"
#include "tools/scene/views.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace umbra78::tools {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 28;

std::string read_text_file(const std::string& path) {
    const auto fail_to_read = [&](const std::string& why) {
        throw SceneError(fmt::format("cannot read '{}': {}; give the path of a scene file", path,
                                     why));
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) fail_to_read(std::generic_category().message(errno));
    std::string text;
    std::array<char, 1 << 16> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), file.get())) {
        text.append(block.data(), got);
        if (text.size() > max_bytes) fail_to_read("it is larger than 256 MiB");
    }
    if (std::ferror(file.get())) fail_to_read(std::generic_category().message(errno));
    return text;
}

}  // namespace

LoadedScene parse_scene(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides) {
    constexpr std::array<std::string_view, 7> keys{"observer", "light", "material", "sphere",
                                                   "plane",    "patch", "settings"};
    TomlNode root = parse_toml(text, name);
    const TomlNode set = apply_view_overrides(root, overrides);
    const TableReader in(root, "the scene", keys);

    LoadedScene scene;
    scene.name = name;
    read_surfaces(root, scene);
    scene.observer = read_observer(root, scene.patches);
    scene.light = read_light(root, scene.patches);
    const bool perspective = scene.observer.projection == raster::Projection::perspective ||
                             scene.light.projection == raster::Projection::perspective;
    scene.settings = read_settings(in.find("settings"), set, perspective);
    check_matrices(scene);
    scene.warnings = warnings_of(scene);
    return scene;
}

LoadedScene load_scene(const std::string& path, std::span<const std::string> overrides) {
    return parse_scene(read_text_file(path), path, overrides);
}

}  // namespace umbra78::tools
