// A frame of primitives that are never held: they come from a source batch by batch, and each batch
// is drawn into all views at once.
//
// The buffers are those of the same primitives in spans, bit for bit, whatever their order and
// however they are divided into batches: the frame store keeps the least record, not the first. The
// frame's memory does not depend on their number; carve it for 0 patches. A source is gone through
// once, or twice by a method that tests points as they are drawn and needs the light's map before.
//
// A batch is drawn with nothing left out as hidden, so that the counts do not depend on the order
// and the ledger needs no pass of its own.
#pragma once

#include "raster/source.hpp"
#include "shadow/frame/buffers.hpp"
#include "shadow/frame/plan.hpp"

#include <cstdint>

namespace umbra78::shadow {

enum class StreamStatus : std::uint8_t {
    ok,
    source_failed,    // it could not be read to its end
    cannot_rewind,    // it was read before, or the method needs a second pass
    beyond_largest,   // a coordinate exceeds Scene::largest_streamed
};

// The whole frame. `in.scene` is streamed and has no surfaces of its own; `plan` is its plan. The
// buffers hold a frame only if it returns ok. Traps if they were carved for other widths.
template <class Depth>
StreamStatus draw_stream(const FrameInputs& in, const FramePlan& plan, raster::PrimitiveSource&,
                         FrameBuffers<Depth>&, FrameCounts&);

}  // namespace umbra78::shadow
