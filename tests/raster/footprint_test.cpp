// The footprint of a patch whose bounds no quotient gives is the whole frame.
#include "raster/footprint.hpp"
#include "raster/draw_setup.hpp"
#include "raster/scene.hpp"
#include "tests/support/drawing.hpp"

#include <gtest/gtest.h>

#include <array>

namespace umbra78::raster {
namespace {

TEST(Footprint, OfAPatchThroughTheEyeIsTheWholeFrame) {
    View view;
    view.projection = Projection::perspective;
    view.axes = axes_from_angles(0, 0);
    view.extent = 2 << 16;
    view.distance = 4 << 16;
    view.near_depth = 1 << 15;
    view.far_depth = 8 << 16;
    const MachineSpec spec;
    // A floor below the axis, from before the target to behind the eye.
    const std::array<Patch, 1> floor{
        plane_patch(umbra78::test::plane({-1, -1, -2}, {2, 0, 0}, {0, 0, 8}))};
    const WordFormat object = object_format(Surfaces{floor, {}});
    MatrixWords matrix;
    ASSERT_EQ(load_view(view, spec, object, matrix), hw::LoadStatus::ok);
    Footprint out{1, 2, 3, 4, 5, 6};
    ASSERT_EQ(patch_footprint(floor[0], matrix, spec, object, out), Visibility::unknown);
    EXPECT_EQ(out.x0, 0);
    EXPECT_EQ(out.y0, 0);
    EXPECT_EQ(out.x1, spec.size_px() - 1);
    EXPECT_EQ(out.y1, spec.size_px() - 1);
    EXPECT_EQ(out.nearest, 0u);
    EXPECT_EQ(out.farthest, spec.deepest_drawn());
}

}  // namespace
}  // namespace umbra78::raster
