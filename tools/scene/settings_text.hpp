// Settings as text: read from a scene file or --set, and printed, all from the one table.
#pragma once

#include "shadow/frame/profiles.hpp"
#include "tools/scene/toml_text.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>

namespace umbra78::tools {

// "bilinear", "192", "0.3515625": exact.
std::string print(const shadow::Setting&, std::int64_t word);
std::string print_source(const shadow::ProfileValue&);  // "assumed: ...", or the source
std::string print_range(const shadow::Setting&);  // "4 .. 12", "nearest | bilinear"

// Applies a table's `profile` first and then its keys in their order. Throws SceneError.
void apply_settings(const TomlNode& table, shadow::Settings&);

// The [settings] of a file and the values of --set, which win. A perspective view takes the
// profile perspective24 unless a profile or coefficient_bits is given.
shadow::Settings read_settings(const TomlNode* file, const TomlNode& overrides,
                               bool perspective);

std::string settings_help();      // for --help: a line a setting
std::string settings_markdown();  // the table and the profiles, for documents
nlohmann::ordered_json settings_json();
nlohmann::ordered_json settings_json(const shadow::Settings&);  // key: value

}  // namespace umbra78::tools
