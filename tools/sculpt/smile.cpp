#include "tools/sculpt/model.hpp"
namespace umbra78::tools {
std::vector<Part> smile_parts() { return {{"lips", "lip", ellipsoid(1,1,1)}}; }
}
