// The numbers in shadow/rivals/volumes.md are those that the algorithms count: the figures' scene
// at 512 x 512, its light at -100 degrees, diced into k x k cells a patch.
#include "tests/shadow/rivals/class3.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace umbra78::shadow::rivals::test {
namespace {

void expect_row_of_volumes(const std::string& first, std::vector<std::uint64_t> cells) {
    static const std::string text = [] {
        std::ostringstream out;
        out << std::ifstream(UMBRA78_SOURCE_DIR "/shadow/rivals/volumes.md").rdbuf();
        return out.str();
    }();
    std::string row = first;
    for (const std::uint64_t cell : cells) row += " " + std::to_string(cell) + " |";
    EXPECT_NE(text.find(row + "\n"), std::string::npos) << "volumes.md lacks\n" << row;
}

TEST(VolumesText, HasWhatIsCounted) {
    for (const int levels : {1, 2, 3, 4}) {
        const FiguresScene scene(levels);
        const Setting& s = scene.setting();
        const std::uint64_t k = std::uint64_t{1} << levels;
        OrderedCounts o;
        ordered(s, scene.shown(), o);
        expect_row_of_volumes("|", {k, o.sides, o.inserts, o.compares, o.asked, o.foreseen,
                                    o.crossings, o.stretches});
        EXPECT_EQ(o.swaps, 0u);
        const DepthScale scale = figures_scale(scene);
        const StencilCounts pass = Stenciled(s, scene.shown(), scale, z_pass).counts;
        const StencilCounts fail = Stenciled(s, scene.shown(), scale, z_fail).counts;
        expect_row_of_volumes("|", {k, pass.sides, pass.fills, pass.updates, fail.near_ends,
                                    fail.fills, fail.updates});
        EXPECT_EQ(fail.far_ends, 0u) << "the light is a direction";
    }
}

TEST(VolumesText, HasThePixelsThatNarrowCodesGetWrong) {
    const FiguresScene scene(3);
    const Setting& s = scene.setting();
    const std::vector<std::uint8_t> right = scene.brute_mask();
    std::vector<std::uint64_t> wrong;
    for (const int bits : {16, 12, 10, 8}) {
        const DepthScale scale = figures_scale(scene, bits);
        const Stenciled pass(s, scene.shown(), scale, z_pass);
        const Stenciled fail(s, scene.shown(), scale, z_fail);
        EXPECT_EQ(pass.numbers, fail.numbers) << bits;
        wrong.push_back(differing(mask_of(s, scene.shown(), pass.numbers), right));
    }
    EXPECT_EQ(wrong.front(), 0u) << "the frame store's own width";
    const auto seen = std::ranges::count_if(scene.shown(), [](std::uint32_t f) {
        return f != nothing_seen;
    });
    expect_row_of_volumes("| pixels of " + std::to_string(seen) + " |", wrong);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
