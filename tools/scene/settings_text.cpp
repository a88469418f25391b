#include "tools/scene/settings_text.hpp"

#include "fixed/decimal.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/profiles.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/scene/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace umbra78::tools {
namespace {

using nlohmann::ordered_json;
using shadow::Setting;
using shadow::SettingKind;
using shadow::Settings;

constexpr std::string_view title = "[settings]";

std::int64_t read(const Setting& setting, const TomlNode& node, const std::string& called,
                  FirstError& error) {
    if (setting.kind == SettingKind::choice)
        return read_choice(node, called, setting.names, error);
    return read_number(node, called, {setting.fraction, setting.min, setting.max}, error);
}

std::int64_t default_of(const Setting& setting) { return setting.get(scene_defaults()); }

ordered_json json_value(const Setting& setting, std::int64_t word) {
    if (setting.kind == SettingKind::whole) return word;
    if (setting.kind == SettingKind::decimal)
        return static_cast<double>(word) / static_cast<double>(std::int64_t{1} << setting.fraction);
    return setting.names[static_cast<std::size_t>(word)];
}

// Why no machine has these settings, as far as the table of settings does not say it.
std::string why_not_built(const Settings& s, const Setting& setting) {
    const auto name = [&](std::string_view key, std::int64_t word) {
        return shadow::find_setting(key)->names[static_cast<std::size_t>(word)];
    };
    const auto called = [&](std::string_view key) {
        const Setting& of = *shadow::find_setting(key);
        return fmt::format("{} = {}", key, name(key, of.get(s)));
    };
    if (const shadow::Method* method = shadow::method_of(s)) {
        if (!method->takes_floats && s.machine.depth_store != hw::DepthStore::fixed)
            return fmt::format("{} with {} has depth_store = fixed alone", called("form"),
                               called("arithmetic"));
        if (s.machine.z_bits > method->max_z_bits)
            return fmt::format("{} with {} has z_bits up to {}", called("form"),
                               called("arithmetic"), method->max_z_bits);
        if (method->takes(s.receiver, s.lookup)) return std::string(setting.meaning);
        const bool normal = method->takes(shadow::Receiver::normal, s.lookup);
        return fmt::format("{} with {} has receiver = point{}",
                           normal ? called("lookup") : called("form"), called("arithmetic"),
                           normal ? " or normal" : " alone");
    }
    std::vector<std::string_view> lookups;
    for (const shadow::Method& m : shadow::methods())
        if (m.form == s.form && m.arithmetic == s.arithmetic)
            for (const shadow::Lookup lookup : m.lookups)
                lookups.push_back(name("lookup", static_cast<std::int64_t>(lookup)));
    if (lookups.empty())
        return fmt::format("there is no {} with {}", called("form"), called("arithmetic"));
    return fmt::format("{} with {} has lookup = {}", called("form"), called("arithmetic"),
                       fmt::join(lookups, ", "));
}

}  // namespace

std::string print(const Setting& setting, std::int64_t word) {
    if (setting.kind == SettingKind::choice)
        return std::string(setting.names[static_cast<std::size_t>(word)]);
    std::array<char, fixed::longest_decimal> text;
    const int length = fixed::print_decimal(word, setting.fraction, text);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string print_source(const shadow::ProfileValue& value) {
    const bool assumed = value.confidence == shadow::Confidence::assumed;
    return fmt::format("{}{}", assumed ? "assumed: " : "", value.source);
}

std::string print_range(const Setting& setting) {
    if (setting.kind == SettingKind::choice)
        return fmt::format("{}", fmt::join(setting.names, ", "));
    return print(setting, setting.min) + " .. " + print(setting, setting.max);
}

void apply_settings(const TomlNode& table, Settings& settings, FirstError& error) {
    std::vector<std::string_view> keys{"profile"}, profiles;
    for (const Setting& setting : shadow::settings_table()) keys.push_back(setting.key);
    for (const shadow::Profile& profile : shadow::profiles()) profiles.push_back(profile.name);
    check_keys(table, title, keys, error);
    if (error.any()) return;

    const auto called = [](const TomlNode& node) {
        return fmt::format("'{}' in {}", node.key, title);
    };
    for (const TomlNode& node : table.children) {
        if (node.key != "profile") continue;
        const int number = read_choice(node, called(node), profiles, error);
        shadow::apply(shadow::profiles()[static_cast<std::size_t>(number)], settings);
    }
    for (const TomlNode& node : table.children) {
        const Setting* setting = shadow::find_setting(node.key);
        if (!setting || error.any()) continue;
        setting->set(settings, read(*setting, node, called(node), error));
        if (!shadow::can_be_built(settings))  // a width with gaps in its range
            report(error, node,
                   fmt::format("{} is {}, which the machine cannot be built with ({})",
                               called(node), node.text, why_not_built(settings, *setting)));
    }
}

Settings scene_defaults() {
    Settings settings;
    settings.bias_q16 = 2 << 16;
    settings.bias_unit = shadow::BiasUnit::texels;
    return settings;
}

Settings read_settings(const TomlNode* file, const TomlNode& overrides, bool perspective,
                       FirstError& error) {
    const TomlNode none;
    const TomlNode& first = file ? *file : none;
    const auto given = [&](std::string_view key) {
        return first.find(key) != nullptr || overrides.find(key) != nullptr;
    };
    Settings settings = scene_defaults();
    if (perspective && !given("profile") && !given("coefficient_bits"))
        shadow::apply(*shadow::find_profile("perspective24"), settings);
    apply_settings(first, settings, error);
    apply_settings(overrides, settings, error);
    return settings;
}

std::string settings_help() {
    std::string text = "Settings, for [settings] in a scene file and for --set:\n";
    const auto line = [&](std::string_view key, std::string_view range, std::string_view meaning,
                          std::string_view otherwise) {
        text += fmt::format("  {:<22}{}\n{:24}{}\n", key, meaning, "", range);
        if (!otherwise.empty()) text.insert(text.size() - 1, fmt::format("; {}", otherwise));
    };
    std::vector<std::string_view> names;
    for (const shadow::Profile& profile : shadow::profiles()) names.push_back(profile.name);
    line("profile", fmt::format("{}", fmt::join(names, ", ")),
         "a machine of the time, or (d16_unorm and on) a depth map of today: sets its keys, and "
         "every key that another of its kind sets to its default; a profile in --set comes "
         "after [settings], other keys of --set after it", "");
    for (const Setting& s : shadow::settings_table())
        line(s.key, fmt::format("{}{}{}", print_range(s), s.unit.empty() ? "" : " ", s.unit),
             s.meaning, fmt::format("default {}", print(s, default_of(s))));
    return text + "Views: observer.KEY and light.KEY, such as --set light.azimuth=-80\n";
}

std::string settings_markdown() {
    std::vector<std::vector<std::string>> rows{{"key", "unit", "range", "default", "meaning"}};
    for (const Setting& s : shadow::settings_table())
        rows.push_back({fmt::format("`{}`", s.key), std::string(s.unit), print_range(s),
                        print(s, default_of(s)), std::string(s.meaning)});
    std::vector<std::vector<std::string>> named{{"profile", "sets", "to", "source"}};
    for (const shadow::Profile& p : shadow::profiles()) {
        named.push_back({fmt::format("`{}`", p.name), "", "", std::string(p.meaning)});
        for (const shadow::ProfileValue& v : p.values)
            named.push_back({"", fmt::format("`{}`", v.key),
                             print(*shadow::find_setting(v.key), v.word), print_source(v)});
    }
    return markdown_table(rows) + "\n" + markdown_table(named);
}

ordered_json settings_json() {
    ordered_json settings = ordered_json::array(), profiles = ordered_json::array();
    for (const Setting& s : shadow::settings_table()) {
        ordered_json& row = settings.emplace_back();
        row["key"] = s.key;
        row["unit"] = s.unit;
        if (s.kind == SettingKind::choice) {
            row["choices"] = ordered_json::array();
            for (const std::string_view name : s.names) row["choices"].push_back(name);
        } else {
            row["least"] = json_value(s, s.min);
            row["most"] = json_value(s, s.max);
            row["fraction_bits"] = s.fraction;
        }
        row["default"] = json_value(s, default_of(s));
        row["meaning"] = s.meaning;
    }
    for (const shadow::Profile& p : shadow::profiles()) {
        ordered_json values = ordered_json::array();
        for (const shadow::ProfileValue& v : p.values)
            values.push_back({{"key", v.key},
                              {"value", json_value(*shadow::find_setting(v.key), v.word)},
                              {"assumed", v.confidence == shadow::Confidence::assumed},
                              {"source", v.source}});
        profiles.push_back({{"name", p.name}, {"meaning", p.meaning}, {"values", values}});
    }
    return {{"settings", settings}, {"profiles", profiles}};
}

ordered_json settings_json(const Settings& settings) {
    ordered_json json;
    for (const Setting& s : shadow::settings_table())
        json[std::string(s.key)] = json_value(s, s.get(settings));
    return json;
}

}  // namespace umbra78::tools
