// The manual page and the completion for bash, made of the commands' own tables and the settings'.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace umbra78::tools {

std::string manual_page(const CLI::App&);      // roff, section 1
std::string bash_completion(const CLI::App&);  // a script that bash sources

}  // namespace umbra78::tools
