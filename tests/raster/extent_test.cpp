// The box of a scene's points: its middle is rounded down and moves with the points.
#include "raster/extent.hpp"

#include <gtest/gtest.h>

namespace umbra78::raster {
namespace {

TEST(Extent, TheMiddleOfABoxMovesWithIt) {
    Box none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.largest(), 0u);
    for (const std::int32_t off : {0, 1, -1, 1000, -1000000}) {
        Box box;
        box.add({off - 3, off, off + 7});
        EXPECT_FALSE(box.empty()) << "one point";
        box.add({off + 4, off - 5, off + 8});
        const World c = box.centre();
        EXPECT_EQ(c.x, off);
        EXPECT_EQ(c.y, off - 3);
        EXPECT_EQ(c.z, off + 7);
    }
    Box widest;
    widest.add({INT32_MIN, 0, 0});
    widest.add({INT32_MAX, 0, 0});
    EXPECT_EQ(widest.centre().x, -1);
    EXPECT_EQ(widest.largest(), std::uint32_t{1} << 31);
}

}  // namespace
}  // namespace umbra78::raster
