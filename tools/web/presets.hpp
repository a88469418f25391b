// The presets: figures 1 to 8 and the gallery, each a scene with the overrides that make it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace umbra78::tools::web {

class Session;

// [{"name": "figure 3", "shows": ..., "scene": "figures.toml", "set": ["lookup=nearest", ...],
//   "plane": "mask", "golden": "mask3"}, ...]: which plane of the frame is the picture, and the
// golden that it equals. Those whose scene was not handed in are left out. The overrides of figures
// 1 to 6 are the settings in which shadow::figure_settings() differs from the scene file.
nlohmann::ordered_json presets_json(const Session&);

}  // namespace umbra78::tools::web
