// Whether a scene can be drawn, and what its user should know before it is.
#pragma once

#include "tools/scene/first_error.hpp"
#include "tools/scene/scene.hpp"

namespace umbra78::tools {

// Reports an error if the scene's matrices do not fit the machine's words.
void check_matrices(const LoadedScene&, FirstError&);

// A line each for: nothing to draw, casters outside the light's volume, surfaces that the
// observer's near and far cut off, a picture that shows nothing.
std::vector<std::string> warnings_of(const LoadedScene&);

// Why a frame cannot be drawn and the remedy, in a line; "" for FrameStatus::ok.
std::string explain(shadow::FrameStatus);

}  // namespace umbra78::tools
