#include "tools/scene/scene_file.hpp"

#include "tools/scene/azimuth_sweep.hpp"
#include "tools/scene/toml_text.hpp"

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

void throw_if_any(const FirstError& error) {
    if (error.any()) throw SceneError(error.line());
}

}  // namespace

LoadedScene parse_scene(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides) {
    SceneResult result = read_scene(text, name, overrides);
    if (!result.ok()) throw SceneError(result.error);
    return std::move(result.scene);
}

LoadedScene load_scene(const std::string& path, std::span<const std::string> overrides) {
    return parse_scene(read_text_file(path), path, overrides);
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
