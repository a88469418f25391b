// The reference of a scene file's tables and keys, printed from the tables that the reader uses:
// scene_tables() and, for [settings], shadow::settings_table() and the profiles.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools {

std::string scene_keys_markdown();  // tools/scenes/KEYS.md
nlohmann::ordered_json scene_keys_json();

}  // namespace umbra78::tools
