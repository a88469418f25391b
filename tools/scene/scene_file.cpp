#include "tools/scene/scene_file.hpp"

#include "tools/io/destination.hpp"
#include "tools/scene/azimuth_sweep.hpp"
#include "tools/scene/toml_text.hpp"
#include "tools/stream/packed.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace umbra78::tools {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 28;

// `kind` is what errors ask for: "a scene file".
FileText read_text_file(const std::string& path, const std::string& kind) {
    FileText file_text{.name = path};
    std::string& text = file_text.text;
    const auto fail_to_read = [&](const std::string& why) {
        text.clear();
        file_text.error =
            fmt::format("cannot read '{}': {}; give the path of {}", path, why, kind);
        return file_text;
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               std::fclose);
    if (!file) return fail_to_read(std::generic_category().message(errno));
    std::array<char, 1 << 16> block;
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), file.get())) {
        text.append(block.data(), got);
        if (text.size() > max_bytes) return fail_to_read("it is larger than 256 MiB");
    }
    if (std::ferror(file.get())) return fail_to_read(std::generic_category().message(errno));
    return file_text;
}

LoadedScene scene_or_throw(SceneResult result) {
    if (!result.ok()) throw SceneError(result.error);
    return std::move(result.scene);
}

std::string scene_text(const std::string& path) {
    FileText file = read_text_file(path, "a scene file");
    if (!file.error.empty()) throw SceneError(file.error);
    return std::move(file.text);
}

void throw_if_any(const FirstError& error) {
    if (error.any()) throw SceneError(error.line());
}

}  // namespace

LoadedScene parse_scene(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides, const FileSource& files) {
    return scene_or_throw(read_scene(text, name, overrides, files));
}

LoadedScene load_scene(const std::string& path, std::span<const std::string> overrides) {
    return parse_scene(scene_text(path), path, overrides, files_beside(path));
}

LoadedScene load_streamed_scene(const std::string& path, std::span<const std::string> overrides,
                                bool spool) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const auto open = [&](const std::string& named) {
        if (named == "-") return open_packed(named, spool);
        const std::string file = (folder / named).string();
        note_input(file);
        return open_packed(file, spool);
    };
    return scene_or_throw(
        read_scene(scene_text(path), path, overrides, files_beside(path), open));
}

void require_one_light(const LoadedScene& scene, const std::string& what) {
    const bool one = scene.lights.size() == 1 && scene.lights.front().parts.empty();
    if (!one)
        throw SceneError(fmt::format("{}: {} looks at one light with one depth map, and the scene "
                                     "has more; leave out the others", scene.name, what));
    if (scene.lights.front().ramp_px > 0)
        throw SceneError(fmt::format("{}: {} looks at a hard shadow, and the light has a ramp; "
                                     "leave out ramp", scene.name, what));
    if (scene.is_coloured())
        throw SceneError(fmt::format("{}: {} looks at a grey frame; give materials and lights "
                                     "single levels", scene.name, what));
}

FileSource files_beside(const std::string& path) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return [folder](const std::string& named) {
        return read_text_file((folder / named).string(), "a model, from the scene's folder");
    };
}

TomlNode parse_override(const std::string& key_and_value) {
    FirstError error;
    TomlNode node = parse_override(key_and_value, error);
    throw_if_any(error);
    return node;
}

AzimuthSweep read_sweep(const std::string& view, const std::string& text) {
    FirstError error;
    AzimuthSweep sweep = read_sweep(view, text, error);
    throw_if_any(error);
    return sweep;
}

}  // namespace umbra78::tools
