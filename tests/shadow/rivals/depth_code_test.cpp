// The Z codes of planes that face the eye, against the quotient that defines a code.
#include "shadow/rivals/depth_code.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals {
namespace {

constexpr std::int64_t one = 1 << 16;

raster::View view_of(raster::Projection projection) {
    raster::View v;
    v.projection = projection;
    v.axes = raster::axes_from_angles(0, 0);
    v.extent = 4 * one;
    v.distance = 8 * one;
    v.near_depth = projection == raster::Projection::perspective ? 4 * one : -4 * one;
    v.far_depth = 12 * one;
    return v;
}

std::uint32_t code_at(const raster::View& view, const Space& space, std::int32_t z, int bits) {
    const Plane plane = plane_of({-900, -900, z}, {900, -900, z}, {0, 900, z});
    const PlaneCodes codes(seen(plane, space.eye()), space, depth_scale(view, space, bits));
    return codes.at(100, -300);
}

// Words of 2^-7 pixel of 512: 4 units of extent are 256 pixels, so a word is 2^-13 unit.
TEST(DepthCode, OfAPlaneThatFacesAnOrthographicEye) {
    const raster::View view = view_of(raster::Projection::orthographic);
    const Space space(9, 7, {0, 0, -1, 0});
    for (const int bits : {8, 16, 24})
        for (std::int32_t z = -4 * 8192; z < 12 * 8192; z += 1234) {
            // half_up(2^bits (z / 2^13 + 4) / 16), exactly
            const std::int64_t whole = (std::int64_t{1} << bits) * (z + 4 * 8192) + 8 * 8192;
            const std::int64_t code = whole / (16 * 8192);
            const std::int64_t most = (std::int64_t{1} << bits) - 2;
            ASSERT_EQ(code_at(view, space, z, bits), code < most ? code : most) << z;
        }
}

// The eye 8 units before the target: a depth of (z / 2^13 + 8) units between 4 and 12.
TEST(DepthCode, OfAPlaneThatFacesAnEyeAtAPlace) {
    const raster::View view = view_of(raster::Projection::perspective);
    const Space space(9, 7, {0, 0, -8 * 8192, 1});
    for (std::int32_t z = -4 * 8192; z < 4 * 8192; z += 1234) {
        const std::int64_t depth = z + 8 * 8192;  // half_up(2^16 12 (depth - 4) / (8 depth))
        const std::int64_t above = 2 * 65536 * 12 * (depth - 4 * 8192) + 8 * depth;
        const std::int64_t code = above / (16 * depth);
        ASSERT_EQ(code_at(view, space, z, 16), code < 65534 ? code : 65534) << z;
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals
