// Views: where the observer or the light is, and the exact matrices that follow from it.
//
// A view looks along -back at `target`. Its axes, with azimuth a to the right about the vertical
// axis and elevation b above the horizon:
//
//   right = (cos a, 0, -sin a)
//   up    = (-sin a sin b, cos b, -cos a sin b)
//   back  = (sin a cos b, sin b, cos a cos b)          toward the viewer
//
// Screen space: x right, y down, z away, in pixels from the centre of the cube. An orthographic
// view shows `extent` world units from the centre to the frame's edge; a perspective one does so
// at the target, from an eye `distance` in front of it. Depth is measured along -back, from the
// target (orthographic) or from the eye (perspective); near maps to the first Z code, far to 2^z.
//
// Matrices are exact rationals of the scene's words (sines are Q2.30 words); the only rounding is
// hw::load_matrix's. The formulas and their roundings are those of hw/MACHINE.md, section 4.
// Not emulated: how a host of 1978 made the matrices, and in what precision.
#pragma once

#include "hw/features.hpp"
#include "hw/transform_unit.hpp"
#include "raster/scene.hpp"
#include "raster/vector.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::raster {

using hw::MachineSpec;
using hw::Rational;
using hw::RationalMatrix;

enum class Projection : std::uint8_t { orthographic, perspective };

struct ViewAxes {
    Axis right, up, back;
    constexpr bool operator==(const ViewAxes&) const = default;
};

// Angles in degrees, Q15.16. Products of sines are rounded half even to Q2.30.
ViewAxes axes_from_angles(std::int32_t azimuth_q16, std::int32_t elevation_q16);

// The axes of a view that looks from `from` to `to`, for lights that are given by position.
// Straight down or up, right is (1, 0, 0). False, and `out` as it was, if the points coincide.
bool axes_from_points(const World& from, const World& to, ViewAxes& out);

// The distance of two points, rounded half up; 0 if it is beyond max_distance.
inline constexpr std::int32_t max_distance = 32767 << world_fraction;
std::int32_t distance_between(const World& a, const World& b);

// Where light (i, j) of n x n stands on a square source: so many `over`ths of its side to the right
// and up from its middle (hw/MACHINE.md, section 23). In the middle of its cell, or where two bytes
// of noise put it.
struct AreaPlace {
    int right, up, over;
};
constexpr AreaPlace middle_of_cell(int n, int i, int j) {
    return {2 * i + 1 - n, 2 * j + 1 - n, 2 * n};
}
constexpr AreaPlace noise_in_cell(int n, int i, int j, std::uint8_t u, std::uint8_t v) {
    return {512 * i - 256 * n + 2 * u + 1, 512 * j - 256 * n + 2 * v + 1, 512 * n};
}

// In the plane of a view's right and up about `middle`. World words; the sum must fit them.
World place_on_area(const World& middle, const ViewAxes& axes, std::int32_t side, AreaPlace at);

// How far a point lies along an axis from the world's origin, exactly, with 46 fraction bits.
// |p| < 2^31 and an axis of length 1 leave it in 63 bits.
constexpr std::int64_t along(const Axis& axis, const World& p) {
    return dot(WideVector{axis[0], axis[1], axis[2]}, WideVector{p.x, p.y, p.z});
}

// The least and the greatest of such distances; min > max where there are none.
struct AxisRange {
    std::int64_t min = INT64_MAX, max = INT64_MIN;

    void add(std::int64_t v) {
        min = v < min ? v : min;
        max = v > max ? v : max;
    }
};

struct View {
    Projection projection = Projection::orthographic;
    ViewAxes axes{};
    World target{};
    std::int32_t extent = 0;       // Q15.16, > 0
    std::int32_t distance = 0;     // Q15.16, perspective only, > 0
    std::int64_t near_depth = 0;   // Q.16
    std::int64_t far_depth = 0;    // Q.16, > near_depth (> 0 in perspective)
};

constexpr bool has_eye(const View& v) {
    return hw::built(hw::Feature::perspective) && v.projection == Projection::perspective;
}

// The min and max depth of all control points and vertices in the view, Q.16, rounded outward.
struct DepthRange {
    std::int64_t min, max;
};
// {0, 0} without any.
DepthRange depth_range(const View& view, const Surfaces& surfaces);
// The same of points that lie so along view.axes.back.
DepthRange depth_range_of(const View& view, const AxisRange& back);

// Near and far where the scene file gives none. Orthographic: the cube, +-extent, so that a Z
// quantum is 2^-depth_fraction pixel; if the scene reaches out of it, the smallest symmetric range
// that holds the scene. Perspective: 63/64 of the scene's min depth to 65/64 of its max depth, but
// near is at least far / 1024.
void fit_depth(View& view, const DepthRange& scene);

// An axis, and the point that matrices measure from: the target, or the eye of a perspective view.
Vector<Rational> exact(const Axis& axis);
Vector<Rational> origin(const View& view);  // world units

// World units (not words) to homogeneous screen pixels, and back.
RationalMatrix world_to_screen(const View& view, const MachineSpec& spec);
RationalMatrix screen_to_world(const View& view, const MachineSpec& spec);
RationalMatrix multiply(const RationalMatrix& a, const RationalMatrix& b);

// The one matrix of the shadow post-process: observer's screen to light's screen, with the bias
// (in the light's Z quanta, 16 fraction bits) taken from Z.
RationalMatrix observer_to_light(const View& observer, const View& light, const MachineSpec& spec,
                                 std::int64_t bias_q16);

}  // namespace umbra78::raster
