#include "tools/scene/materials.hpp"

#include "tools/io/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace umbra78::tools {

std::span<const TomlNode> tables_of(const TomlNode& root, std::string_view key, FirstError& error) {
    const TomlNode* node = root.find(key);
    if (!node) return {};
    if (node->kind == TomlNode::Kind::array) return node->children;
    report(error, *node, fmt::format("[{}] must be written [[{}]]: there may be many", key, key));
    return {};
}

MaterialNames read_materials(const TomlNode& root, std::vector<raster::Material>& materials,
                             FirstError& error) {
    MaterialNames names;
    for (const TomlNode& node : tables_of(root, "material", error)) {
        const TableReader in(node, scene_table("material"), error);
        const std::string name = in.needed_text("name");
        if (std::find(names.begin(), names.end(), name) != names.end())
            in.report(in.need("name"),
                      fmt::format("there is a material '{}' already; rename one", name));
        materials.push_back({in.levels("diffuse"), in.levels("specular"),
                             static_cast<std::int32_t>(in.number("shininess"))});
        names.push_back(name);
    }
    if (materials.size() >= std::numeric_limits<std::uint16_t>::max())
        report(error, *root.find("material"), "there are 65535 materials or more; use fewer");
    materials.push_back({});  // of surfaces that name none
    return names;
}

std::uint16_t read_material(const TableReader& in, const MaterialNames& names) {
    const TomlNode* node = in.find("material");
    if (!node) return static_cast<std::uint16_t>(names.size());
    const std::string name = read_text(*node, in.called("material"), in.error());
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const std::vector<std::string_view> known(names.begin(), names.end());
        in.report(*node, fmt::format("unknown material '{}' in {}; {}", name, in.title(),
                                     known.empty() ? "add a [[material]] of that name"
                                                   : suggest(name, known)));
    }
    return static_cast<std::uint16_t>(found - names.begin());
}

}  // namespace umbra78::tools
