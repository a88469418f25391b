// All that a study's rows depend on, as JSON: to run it elsewhere, and to tell its files apart.
//
// The hash is FNV-1a-64 over the inputs, the cases and the program's version. Rows of another
// hash are never mixed: a partial run, a shard and a summary all carry it.
#pragma once

#include "tools/study/study.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::study {

// A study with what it was asked and the cases that follow.
struct Asked {
    const Study* study = nullptr;
    Request request;
    std::vector<Case> cases;
    nlohmann::ordered_json inputs;
    std::string hash;
};

// Throws SceneError if --vary does not fit the scene, or the grid is empty.
Asked ask(const Study&, Request);

// From the inputs that a file holds; `path` is for the error. Throws std::runtime_error. Where
// another version made the file, its hash is another one.
Asked ask_again(const nlohmann::ordered_json& inputs, const std::string& path, Studies);

// The study of that name; throws where there is none.
const Study& study_of(const std::string& name, const std::string& path, Studies);

}  // namespace umbra78::tools::study
