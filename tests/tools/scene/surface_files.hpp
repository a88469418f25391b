// Scenes that name files, read with files that the test holds.
#pragma once

#include "tools/scene/scene.hpp"

#include <map>
#include <string>

namespace umbra78::tools::test {

using Files = std::map<std::string, std::string>;

inline SceneResult read_with(const Files& files, const std::string& text) {
    const FileSource source = [&](const std::string& path) {
        const auto found = files.find(path);
        FileText file{.name = "folder/" + path};
        if (found == files.end()) file.error = "cannot read it; name another";
        else file.text = found->second;
        return file;
    };
    return read_scene(text, "a.toml", {}, source);
}

}  // namespace umbra78::tools::test
