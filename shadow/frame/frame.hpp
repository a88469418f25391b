// One frame, from patches and views to a picture with shadows: the whole pipeline in order.
//
//   light's view (Z) -> observer's view (Z, intensity) -> method's test (mask)
//     -> edge dequantizing -> low-pass -> translucent composite
//   or, in the correct form: light's view -> observer's view, tested point by point
//
// The core allocates nothing: the caller hands in one piece of memory of frame_bytes() and finds
// every stage's buffer in it afterwards. What a plan leaves out changes none of them; what it keeps
// must be in the buffers from the frame before. The stages can be run one at a time.
#pragma once

#include "shadow/frame/buffers.hpp"
#include "shadow/frame/inputs.hpp"
#include "shadow/frame/methods.hpp"
#include "shadow/frame/plan.hpp"

namespace umbra78::shadow {

// The stages, each needing those before it; a map that is a copy of the observer's Z is there after
// draw_observer. Each traps if the buffers were carved for other widths
// than the settings have, or for fewer patches than the scene has.
template <class Depth>
void draw_light(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts);
template <class Depth>
void draw_observer(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                   FrameCounts& counts);
template <class Depth>
void cast_shadows(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                  FrameCounts& counts);
template <class Depth>
void filter_and_composite(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                          FrameCounts& counts);

// All of them.
template <class Depth>
void draw_frame(const FrameInputs& in, const FramePlan& plan, FrameBuffers<Depth>& frame,
                FrameCounts& counts);

// Matrices, plan and all stages; nothing is kept of what the buffers held. Draws nothing unless it
// returns ok.
template <class Depth>
FrameStatus render(const Scene& scene, const Settings& settings, FrameBuffers<Depth>& frame,
                   FrameMatrices& matrices, FrameCounts& counts);

}  // namespace umbra78::shadow
