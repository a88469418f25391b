#include "tools/scene/view_overrides.hpp"

#include "tools/scene/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

// In place of the key that the table has.
void put(TomlNode& table, TomlNode node) {
    std::erase_if(table.children, [&](const TomlNode& t) { return t.key == node.key; });
    table.children.push_back(std::move(node));
}

// The table that an override's view names: 0, 1, 2, ... among the lights; or what is wrong.
struct NamedLight {
    std::size_t index = 0;
    std::string wrong{};
};
NamedLight named_light(const std::string& name, std::size_t lights) {
    const std::string number = name.substr(5);
    if (number.empty() && lights > 1)
        return {0, fmt::format("the scene has {0} lights; set light1.KEY .. light{0}.KEY", lights)};
    if (number.empty()) return {};
    if (number.size() == 1 && number[0] >= '1' && std::size_t(number[0] - '0') <= lights)
        return {std::size_t(number[0] - '1')};
    return {0, fmt::format("there is no {}; the scene has {} {}", name, lights,
                           lights == 1 ? "light: set light.KEY" : "lights")};
}

// Puts an override into the light that it names. Of a scene without a light it makes one.
void set_light(TomlNode& root, const std::string& name, TomlNode node, FirstError& error) {
    auto& tables = root.children;
    auto table = std::ranges::find(tables, "light", &TomlNode::key);
    if (table == tables.end())
        table = tables.insert(table, TomlNode{.where = node.where, .key = "light"});
    const bool many = table->kind == TomlNode::Kind::array;
    const NamedLight light = named_light(name, many ? table->children.size() : 1);
    if (!light.wrong.empty()) return report(error, node, light.wrong);
    put(many ? table->children[light.index] : *table, std::move(node));
}

}  // namespace

TomlNode apply_view_overrides(TomlNode& root, std::span<const std::string> overrides,
                              FirstError& error) {
    TomlNode settings;
    for (const std::string& text : overrides) {
        TomlNode node = parse_override(text, error);
        const std::size_t dot = node.key.find('.');
        const std::string view = node.key.substr(0, dot);
        if (dot == std::string::npos) {
            settings.children.push_back(std::move(node));
            continue;
        }
        if (view != "observer" && !view.starts_with("light")) {
            report(error, node,
                   fmt::format("unknown key '{}'; set a setting, observer.KEY or light.KEY",
                               node.key));
            continue;
        }
        node.key.erase(0, dot + 1);
        if (view != "observer") {
            set_light(root, view, std::move(node), error);
            continue;
        }
        auto& tables = root.children;
        auto table = std::find_if(tables.begin(), tables.end(),
                                  [&](const TomlNode& t) { return t.key == view; });
        if (table == tables.end())
            table = tables.insert(table, TomlNode{.where = node.where, .key = view});
        put(*table, std::move(node));
    }
    return settings;
}

}  // namespace umbra78::tools
