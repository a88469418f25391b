// Which pixels show a scene's ground: how a form that shadows nothing else does where it does.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace umbra78::tools {

// 1 where the frame's code is the ground's own; 0 everywhere if the scene names none.
std::vector<std::uint8_t> ground_pixels(const LoadedScene&, const RenderJob&);

}  // namespace umbra78::tools
