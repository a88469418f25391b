// The columns of a row on one side of a line, against the line's sign at each of them.
#include "shadow/rivals/planes.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals {
namespace {

// Every line of small numbers, whose change lies within the frame, at its ends or beyond.
TEST(Planes, RunOfIsTheColumnsOfThatSign) {
    const Space space(4, 2, {0, 0, -1, 0});
    int changes = 0;
    for (int x = -3; x <= 3; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int c = -120; c <= 120; ++c) {
                const ScreenLine line{x, y, c};
                if (line.tie() == 0) continue;  // is the same everywhere, or none
                for (const int row : {0, 7, 15})
                    for (const int wanted : {-1, 1}) {
                        const auto run = run_of(line, wanted, space, row);
                        EXPECT_TRUE(run.empty() || (run.from >= 0 && run.to <= space.size_px()));
                        for (int column = 0; column < space.size_px(); ++column) {
                            const int is = line.sign_at(space.centre(column), space.centre(row));
                            ASSERT_EQ(is == wanted, column >= run.from && column < run.to)
                                << x << ' ' << y << ' ' << c << ", column " << column;
                        }
                        changes += run.from > 0 || run.to < space.size_px() ? 1 : 0;
                    }
            }
    EXPECT_GT(changes, 1000);
}

}  // namespace
}  // namespace umbra78::shadow::rivals
