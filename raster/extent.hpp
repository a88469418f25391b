// The extent of a scene: what a pass over its points finds out before the scene can be drawn.
//
// The largest word decides the format of all object words (projection.hpp); the box and the ranges
// along a view's axes decide what a view is fitted to. All are minima and maxima: points of many
// batches add up, in any order.
#pragma once

#include "raster/view.hpp"

#include <cstdint>

namespace umbra78::raster {

// Of control points and vertices.
struct Box {
    World min{INT32_MAX, INT32_MAX, INT32_MAX}, max{INT32_MIN, INT32_MIN, INT32_MIN};

    bool empty() const { return min.x > max.x; }
    void add(const World&);
    std::uint32_t largest() const;  // the greatest magnitude of a coordinate; 0 if empty
    // The middle, rounded down, so that it moves with the points; the origin if empty.
    World centre() const;
};

struct ViewRanges {
    ViewAxes axes{};
    AxisRange right{}, up{}, back{};

    void add(const World&);
};

}  // namespace umbra78::raster
