// Reads settings from a scene file's [settings] or from --set, and prints them. Their keys, ranges,
// defaults and meanings are those of shadow::settings_table().
#pragma once

#include "shadow/frame/profiles.hpp"
#include "tools/scene/toml_text.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace umbra78::tools {

// A word of a setting: "bilinear", "192", "0.3515625", in all its decimals.
std::string print(const shadow::Setting&, std::int64_t word);
std::string print_range(const shadow::Setting&);        // "4 .. 12", "nearest, bilinear"
std::string print_source(const shadow::ProfileValue&);  // "assumed: ...", or the source

// Applies a table's `profile` first (the last one, if there are several) and then its keys in their
// order. After an error the settings are not to be used.
void apply_settings(const TomlNode& table, shadow::Settings&, FirstError&);

// What a scene has that sets nothing: the machine's defaults, and a bias of 2 texels of the
// light. In scenes of spheres on a plane under a near lamp that bias keeps false shadow under 1 %
// and false light under 10 % with nearest lookup. Bilinear lookup has more false shadow there at
// every bias, and dither does not change that.
shadow::Settings scene_defaults();

// The scene's defaults, then the [settings] of a file (null: there are none), then the overrides.
// So a profile among the overrides replaces the file's profile and the file's profile keys.
// A perspective view takes the profile perspective24 unless a profile or coefficient_bits is given.
shadow::Settings read_settings(const TomlNode* file, const TomlNode& overrides, bool perspective,
                               FirstError&);

std::string settings_help();      // for --help: a line a setting
std::string settings_markdown();  // the table and the profiles, for documents
nlohmann::ordered_json settings_json();
nlohmann::ordered_json settings_json(const shadow::Settings&);  // key: value

}  // namespace umbra78::tools
