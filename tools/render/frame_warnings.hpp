// What a drawn frame lacks: the scene's own warnings, and those that only a drawn frame can give.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/truth/scene_truth.hpp"

#include <nlohmann/json_fwd.hpp>

namespace umbra78::tools {

// The scene's warnings (tools/scene/checks.hpp), and, with the key and the measured figure:
//   dropped_blocks   blocks that the machine dropped because no split was left for them
//   nothing_visible  no pixel of the picture shows a surface (0)
//   missing          pixels that truth sees and the machine does not draw
//   extra, misplaced the reverse; and those drawn at another depth (tools/truth/coverage.hpp)
// Needs a job that has been rendered from this scene.
Warnings frame_warnings(const LoadedScene&, const RenderJob&,
                        const std::optional<ShadowReport>&);

// [{"key": ..., "measured": ..., "line": ...}, ...]
nlohmann::ordered_json to_json(const Warnings&);

// "umbra78: warning: ..." on standard error, a line each.
void print_warnings(const Warnings&);

}  // namespace umbra78::tools
