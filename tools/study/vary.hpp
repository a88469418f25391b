// --vary: the values a key takes, "key=a:b:step" or "key=v1,v2,...".
#pragma once

#include "tools/study/study.hpp"

namespace umbra78::tools::study {

// A range is exact in decimals and holds both ends: "bias=0:1:0.25" is 0, 0.25, 0.5, 0.75, 1.
// Commas between brackets belong to the value. Throws SceneError, one line with the remedy.
GridKey parse_vary(const std::string& text);

// That the scene takes each value, beside the first values of the other keys: a perspective view
// needs its distance. Throws SceneError, one line.
void check_vary(const Request&);

}  // namespace umbra78::tools::study
