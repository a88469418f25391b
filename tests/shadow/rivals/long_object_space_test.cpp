// Class 2 in the figures' scene with 64 512 facets: the rows of k = 16 in object_space.md
// and atherton.md.
#include "tests/shadow/rivals/object_space_table.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

TEST(LongObjectSpace, CountsOfTheFiguresScene) {
    const FiguresScene scene(4);
    check_split(scene, 16, true);
    check_split(scene, 16, false);
    check_perimeters(scene, 16, false);
    check_perimeters(scene, 16, true);
    check_outlines(scene, 16, true);
    check_outlines(scene, 16, false);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
