#include "tools/io/json_text.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools {

using nlohmann::ordered_json;

ordered_json parse_json(std::string_view text) { return ordered_json::parse(text); }

std::string print(const ordered_json& json) { return json.dump(2) + "\n"; }

// What a file name holds may be no UTF-8.
std::string print_line(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace umbra78::tools
