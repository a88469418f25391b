// Whether a scene can be drawn, and what its user should know before it is.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/scene/scene.hpp"
#include "tools/scene/view_fit.hpp"
#include "tools/scene/visible_depths.hpp"

namespace umbra78::tools {

// Reports an error if the scene's matrices do not fit the machine's words.
void check_matrices(const LoadedScene&, FirstError&);

// Needs check_matrices(). Keys and measured figures:
//   empty            nothing to draw
//   light_window     patches that reach out of the light's picture
//   near_plane       patches that a view's near cuts in its window; far_plane: its far
//   open_surfaces    patches and facets with an open border, where the light's map is of backs
//   observer_window  all patches reach out of the picture
//   object_words, view_matrix, shadow_matrix, depth_order, bias   see word_checks.hpp
// What is known only once the frame is drawn is in tools/render/frame_warnings.hpp.
// Of a scene with a [stream] nothing is known before it is drawn.
Warnings warnings_of(const LoadedScene&);

// What was seen of a stream while it was drawn, in both views, and the same warnings from it. The
// scene has a sample of its points.
struct StreamSeen {
    struct View {
        Outside outside;
        CutDepths cut;
    };
    std::uint64_t primitives = 0;
    View observer;
    std::vector<View> lights;  // by the scene's lights
};
Warnings warnings_of_stream(const LoadedScene&, const StreamSeen&);
std::vector<std::string> lines_of(const Warnings&);

// Why a frame cannot be drawn and the remedy, in a line; "" for FrameStatus::ok.
std::string explain(shadow::FrameStatus);

}  // namespace umbra78::tools
