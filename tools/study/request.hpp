// What is asked of a study, and the cases that follow from it.
#pragma once

#include "tools/scene/scene_file.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

// A key as --set takes it (a setting, profile, observer.KEY, light.KEY) and the values it takes.
using GridKey = std::pair<std::string, std::vector<std::string>>;

// One point of the grid. It is made of nothing but its settings, so that it can be run again alone
// and on another computer.
struct Case {
    std::string name;
    std::vector<std::string> set;  // "key=value" overrides of the scene, in the order of the keys
    // What else distinguishes the case (a unit's name, a kind of search), as columns of its row.
    std::vector<std::pair<std::string, std::string>> extra;
};

struct Request {
    std::string scene_file;     // the path as it was given; "figures.toml" for the paper's scene
    LoadedScene scene;          // with the settings of the file
    std::string scene_text;     // what cases are read from; "" for the paper's scene
    std::map<std::string, std::string> models;  // files that it names, by the path in the scene
    std::vector<GridKey> vary;  // --vary, in the order given
    bool quick = false;         // a small grid, which takes seconds
    bool automatic = false;     // --auto: only the answer for the scene
    bool only = false;          // --only: the product of `vary` and no other case
    bool host_times = true;
};

// Takes text and models from the files of a scene. Throws SceneError for a scene that is wrong.
void take_scene(const std::string& path, Request&);
// The same of a text, whose models count from the folder of `path`.
void take_scene(const std::string& text, const std::string& path, Request&);

// The request's scene with a case's overrides. Throws SceneError.
LoadedScene scene_of(const Request&, const Case&);

}  // namespace umbra78::tools::study
