// --vary: the values a key takes, "key=first:last:step" or "key=value,value,...".
#pragma once

#include "tools/study/request.hpp"

namespace umbra78::tools::study {

// A range is exact and holds both ends (tools/scene/decimal_range.hpp): "bias=0:1:0.25" is 0, 0.25,
// 0.5, 0.75, 1. In a list commas between brackets belong to the value:
// "light.target=[0,0,0],[0,1,0]". Throws SceneError, one line with the remedy.
GridKey parse_vary(const std::string& text);

// Checks that the scene takes each value, with the first values of the other keys: a perspective
// view needs its distance. Throws SceneError, one line.
void check_vary(const Request&);

}  // namespace umbra78::tools::study
