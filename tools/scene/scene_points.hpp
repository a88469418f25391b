// The points of all surfaces of a scene, held and streamed: what its views are fitted to.
//
// A stream is gone through once for its box and for the ranges of those views whose axes were
// expected before; again for a view whose axes follow from the box, and for the extent of a view in
// perspective. What is held costs nothing to go through again, but takes the same way.
#pragma once

#include "raster/extent.hpp"
#include "tools/io/first_error.hpp"
#include "tools/stream/stream.hpp"

#include <vector>

namespace umbra78::tools {

class ScenePoints {
public:
    // `stream` may be null. After an error all points are as if there were none.
    ScenePoints(const raster::Surfaces& held, PrimitiveStream* stream, FirstError& error)
        : held_(held), stream_(stream), error_(&error) {}

    // The points of a stream lie within `largest` of the origin, in each coordinate: their box is
    // taken to be that, and not looked for.
    void promise(std::uint32_t largest);
    // Before the first pass: axes whose ranges will be asked for.
    void expect(const raster::ViewAxes& axes) { ranges_.push_back({axes}); }

    const raster::Box& box();
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
    raster::Box box_;
    std::vector<raster::ViewRanges> ranges_;
    bool measured_ = false, promised_ = false;
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
