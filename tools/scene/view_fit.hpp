// Fitting a view to what it must hold: the control points and vertices of all surfaces, by exact
// comparisons.
#pragma once

#include "raster/extent.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::tools {

using raster::Surfaces;

// The least extent, rounded up, whose window holds every point: orthographic, or in
// perspective by the points' places at the target's depth. A perspective window is at most four
// distances wide (76 degrees to either side), so what is beside or behind the eye stays outside.
// 1 where there are no points.
std::int32_t fitted_extent(const raster::View&, const Surfaces&);

// The same point by point, for points that are not held. An orthographic view needs only how far
// they lie along its axes.
std::int32_t fitted_extent(const raster::View&, const raster::ViewRanges&);

class PerspectiveFit {
public:
    explicit PerspectiveFit(const raster::View&);  // which outlives it
    void add(const raster::World&);
    std::int32_t extent() const;

private:
    const raster::View& view_;
    std::int64_t side_ = 0, depth_ = 1;  // of the point that is seen farthest from the middle
    bool any_ = false;
};

// Patches and facets with a point outside a view's window, or outside its near .. far.
struct Outside {
    std::size_t window = 0, depth = 0;

    Outside& operator+=(const Outside& more) {
        window += more.window;
        depth += more.depth;
        return *this;
    }
};
Outside count_outside(const raster::View&, const Surfaces&);

}  // namespace umbra78::tools
