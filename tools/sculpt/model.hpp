// Models: tables of named parts, each a surface of bicubic patches, and their text form.
//
// A .bpt file: the number of patches; then for each patch its degrees "3 3" and 16 lines "x y z",
// row j of the control points after row j - 1. Lines that begin with # are comments.
#pragma once

#include "tools/sculpt/surface.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

// Parts of one group are of one material: the groups of a model can be printed one by one.
struct Part {
    std::string group, name;
    Surface surface;
};

struct Model {
    std::string_view name, meaning;
    std::vector<Part> (*parts)();
};

const std::vector<Model>& models();
const Model* find_model(std::string_view name);  // nullptr: there is none

std::vector<Part> robot_parts();
std::vector<Part> smile_parts();
std::vector<Part> knot_parts();

std::vector<std::string> groups_of(const std::vector<Part>&);
std::vector<Part> only_group(const std::vector<Part>&, std::string_view group);

// Coordinates are rounded to 4 decimals, half away from zero.
std::string to_bpt(std::string_view title, const std::vector<Part>&);
nlohmann::ordered_json model_summary(std::string_view name, const std::vector<Part>&);

}  // namespace umbra78::tools
