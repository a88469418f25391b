// How much bias a depth map needs by its geometry alone, in the quantities that all units are made
// of (tools/bias/UNITS.md derives them).
//
//   t   a texel, world units         R   from near to far      q   one depth step, world units
//   s   tan of the angle between the surface's normal and the light; zx, zy its parts along the
//       map's axes
//   h   how far a tap lies from the point that it is compared with, in texels along an axis
//
//   least constant       b = h t (|zx| + |zy|) + q
//   least slope factor   f = h (|zx| + |zy|) / m,  m = max(|zx|, |zy|) or the root of their squares
//   least normal offset  n = h t (|Nx| + |Ny|) = (b - q) cos
#pragma once

#include "tools/bias/depth_format.hpp"

#include <optional>
#include <string_view>

namespace umbra78::tools::bias {

enum class Filter : std::uint8_t { nearest, bilinear, pcf3, pcf5 };
std::string_view name_of(Filter);
std::optional<Filter> filter(std::string_view name);
// h. bilinear is the hardware's: four texels are compared and the answers are averaged. pcf is a
// window of k x k texels, each compared.
double reach(Filter);
int taps_a_side(Filter);

// A depth map and the steepest surface that is to be free of false shadow.
struct MapSetup {
    int map_px = 2048;
    double extent = 0;  // world units from edge to edge of the map
    double range = 0;   // from near to far
    DepthFormat format = DepthFormat::d16;
    bool reversed = false;
    Filter filter = Filter::nearest;
    double slope_deg = 0;    // between normal and light
    double azimuth_deg = 45;  // of the slope, from an axis of the map; 45 is the worst
    double depth = 0.75;     // 0 near .. 1 far: where the surface lies, for a float's exponent
    double pixel = 0;        // world units of a pixel of the picture; 0: a texel

    double texel() const { return extent / map_px; }
    double pixel_world() const { return pixel > 0 ? pixel : texel(); }
    double tangent() const;
    double along_x() const, along_y() const;  // zx, zy
    double largest_slope() const;             // m of Direct3D: max(|zx|, |zy|)
    double step() const;                      // q: of a float the step at the stored depth
    int exponent() const;                     // of the stored depth
};

struct Need {
    double geometry;  // b - q, world units
    double step;      // q
    double slope_euclidean, slope_max;  // f for either m
    double normal;    // n

    double constant() const { return geometry + step; }
};
Need need_of(const MapSetup&);

}  // namespace umbra78::tools::bias
