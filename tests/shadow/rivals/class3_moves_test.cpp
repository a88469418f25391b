// Class 3 does not depend on the order of the facets, nor on where in the frame they are.
#include "tests/shadow/rivals/class3.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace umbra78::shadow::rivals::test {
namespace {

// The masks of each form.
std::vector<std::vector<std::uint8_t>> masks_of_class3(const Polygons& p) {
    const Scene scene(p);
    const Setting& s = scene.setting();
    const auto mask = [&](const Numbers& n) { return mask_of(s, scene.shown(), n); };
    const auto stenciled = [&](const StencilOptions& options) {
        return mask(Stenciled(s, scene.shown(), scale_of(s, 10), options).numbers);
    };
    OrderedCounts counts;
    return {mask(summed(s, scene.shown())), mask(ordered(s, scene.shown(), counts)),
            stenciled(z_pass), stenciled(z_fail)};
}

Polygons permuted(Polygons p, std::uint32_t seed) {
    std::mt19937 random(seed);
    for (std::size_t n = p.facets.size(); n > 1; --n)
        std::swap(p.facets[n - 1], p.facets[random() % n]);
    for (Triangle& f : p.facets)  // another first vertex, or another winding
        for (std::size_t n = 3; n > 1; --n) std::swap(f.vertex[n - 1], f.vertex[random() % n]);
    return p;
}

TEST(Class3, TheOrderOfFacetsDoesNotMatter) {
    for (const Polygons& p : named_scenes())
        EXPECT_EQ(masks_of_class3(permuted(p, 78)), masks_of_class3(p)) << p.name;
    for (std::uint32_t seed = 0; seed < random_scenes / 4; ++seed) {
        const Polygons p = random_polygons(seed);
        ASSERT_EQ(masks_of_class3(permuted(p, seed)), masks_of_class3(p)) << p.name;
    }
}

// By whole pixels, with an eye far away and a frame that is wide enough for both.
TEST(Class3, WholePixelsMoveTheMask) {
    constexpr int right = 3, down = 2;
    int scenes = 0;
    const auto expect_moved = [&](Polygons p) {
        if (p.eye.w != 0) return;
        ++scenes;
        const auto before = masks_of_class3(p);
        const int pixel = 1 << p.fraction, size = 1 << p.xy_bits;
        for (Point& v : p.vertices) v = {v.x + right * pixel, v.y + down * pixel, v.z};
        if (p.light.w != 0) p.light.x += right * pixel, p.light.y += down * pixel;
        const auto after = masks_of_class3(p);
        for (std::size_t form = 0; form < before.size(); ++form)
            for (int row = 0; row < size - down; ++row)
                for (int column = 0; column < size - right; ++column)
                    ASSERT_EQ(
                        after[form][static_cast<std::size_t>(size * (row + down) + column + right)],
                        before[form][static_cast<std::size_t>(size * row + column)])
                        << p.name << ", form " << form << ", pixel " << column << ',' << row;
    };
    for (const Polygons& p : named_scenes()) expect_moved(p);
    for (std::uint32_t seed = 0; seed < random_scenes / 4; ++seed)
        expect_moved(random_polygons(seed));
    EXPECT_GT(scenes, 100);
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
