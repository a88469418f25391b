// All that a study's rows depend on, as JSON, so that it can be run on another computer; and a hash
// of it, so that files of different runs are not mixed.
//
// The hash is FNV-1a-64 over the inputs (without the scene's path), the cases and the program's
// version. A partial run, a shard and a summary carry it; rows of different hashes never meet.
#pragma once

#include "tools/study/study.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::study {

// A study, what it was asked, and the cases that follow from both.
struct Asked {
    const Study* study = nullptr;
    Request request;
    std::vector<Case> cases;
    nlohmann::ordered_json inputs;
    std::string hash;
};

// Throws SceneError if the scene does not take a value of --vary, or if there are no cases.
Asked ask(const Study&, Request);

// The same from the inputs that a file holds; `path` is for the error. Throws std::runtime_error.
// If another version of the program made the file, the hash differs from the file's.
Asked ask_again(const nlohmann::ordered_json& inputs, const std::string& path, Studies);

// The study of that name. Throws std::runtime_error if there is none.
const Study& study_of(const std::string& name, const std::string& path, Studies);

}  // namespace umbra78::tools::study
