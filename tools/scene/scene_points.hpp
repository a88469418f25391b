// The points of all surfaces of a scene, held and streamed: what its views are fitted to.
//
// A stream is gone through once for its box and for the ranges of those views whose axes were
// expected before; again for a view whose axes follow from the box, and for the extent of a view in
// perspective. What is held costs nothing to go through again, but takes the same way.
#pragma once

#include "raster/extent.hpp"
#include "tools/io/first_error.hpp"
#include "tools/stream/stream.hpp"

#include <string>
#include <utility>
#include <vector>

namespace umbra78::tools {

class ScenePoints {
public:
    // `stream` may be null. After an error all points are as if there were none.
    ScenePoints(const raster::Surfaces& held, PrimitiveStream* stream, FirstError& error)
        : held_(held), stream_(stream), error_(&error) {}

    // The coordinates of a stream lie within `largest` of 0, so that the reach need not be looked
    // for.
    void promise(std::int32_t largest);
    // What a stream that cannot be read twice lacks: for the error.
    void lacks(std::string keys) { lacks_ = std::move(keys); }
    // Before the first pass: axes whose ranges will be asked for.
    void expect(const raster::ViewAxes& axes) { ranges_.push_back({axes}); }

    const raster::Box& box();
    // A box that holds all points: the promised one, if there is one.
    const raster::Box& reach();
    const raster::ViewRanges& ranges(const raster::ViewAxes&);
    template <class Visit>
    void for_points(Visit&& visit);

    // All points were moved by -origin.
    void take_origin(const raster::World& origin, const raster::Surfaces& held);
    int passes() const { return passes_; }  // over the stream

private:
    void measure();
    bool rewind();

    raster::Surfaces held_;
    PrimitiveStream* stream_;
    FirstError* error_;
    raster::Box box_, promised_;
    std::vector<raster::ViewRanges> ranges_;
    std::string lacks_;
    bool measured_ = false;
    int passes_ = 0;
};

template <class Visit>
void ScenePoints::for_points(Visit&& visit) {
    held_.for_points(visit);
    if (stream_ == nullptr || !rewind()) return;
    raster::Surfaces batch;
    auto next = raster::PrimitiveSource::Next::batch;
    while ((next = stream_->next(batch)) == raster::PrimitiveSource::Next::batch)
        batch.for_points(visit);
    if (next == raster::PrimitiveSource::Next::failed) error_->report(stream_->error());
}

}  // namespace umbra78::tools
