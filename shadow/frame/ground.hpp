// The stages of form = ground and of form = blob: rows of shadow/frame/methods.cpp.
#pragma once

#include "shadow/frame/costs.hpp"
#include "shadow/frame/methods.hpp"

namespace umbra78::shadow {

// The ground, the lights' shadows on it, then everything else.
template <class Depth>
void draw_on_ground(const FrameInputs&, const FramePlan&, FrameBuffers<Depth>&, FrameCounts&);
// The masks are there; their dark pixels are counted.
template <class Depth>
void count_on_ground(const FrameInputs&, const FramePlan&, std::size_t light, FrameBuffers<Depth>&,
                     FrameCounts&);
template <class Depth>
void cost_on_ground(const FrameInputs&, std::size_t light, const FrameBuffers<Depth>&,
                    const FrameCounts&, FrameLedger&);

}  // namespace umbra78::shadow
