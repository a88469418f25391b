// The pipeline cycle by cycle: which pixel is in which stage, for a page that steps through it.
#pragma once

#include "tools/render/render_job.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>

namespace umbra78::tools::web {

// `count` cycles of the clocked post-process over the frame, from cycle `from` on:
//   {"stages": ["multiply", ...], "pixels_read": ..., "done": false,
//    "cycles": [{"cycle": 7030, "reader": ["read", x, y, "visible"],
//                "stages": [["work", 12, x, y], null, ...], "released": 13}, ...]}
// A stage's entry is what it did, the point's number, and its pixel; null is a bubble. Throws
// SceneError for a frame that is not clocked.
nlohmann::ordered_json cycles_json(const RenderJob&, std::uint64_t from, int count);

}  // namespace umbra78::tools::web
