// Volumes counted in a frame store: z-pass and z-fail have one number in every pixel, and where it
// is not that of the polygons the codes are to blame.
#include "shadow/rivals/stencil.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {
namespace {

// From the nearest to the farthest vertex, a word beyond each.
DepthScale scale_of(const Setting& s, int bits = 16) {
    const std::int64_t distance = s.space.eye().w == 0 ? 0 : -std::int64_t{s.space.eye().z};
    std::int64_t near = INT64_MAX, far = INT64_MIN;
    for (const Point& p : s.mesh.vertices) {
        near = std::min(near, p.z + distance - 1);
        far = std::max(far, p.z + distance + 1);
    }
    if (distance != 0) near = std::max<std::int64_t>(near, 1);
    return {near, std::max(far, near + 1), 1, 1, bits};
}

struct Counted {
    std::vector<std::uint32_t> codes;
    std::vector<std::int32_t> numbers;
    StencilCounts counts;

    Counted(const Setting& s, std::span<const std::uint32_t> shown, StencilOptions options,
            int bits = 16)
        : codes(shown.size()), numbers(shown.size(), 77) {
        std::vector<ContourEdge> contour(find_contour(s, {}));
        find_contour(s, contour);
        const StencilStore store{codes, numbers};
        count_stencil(s, shown, contour, scale_of(s, bits), options, store, counts);
    }
    std::vector<std::uint8_t> mask(const Setting& s, std::span<const std::uint32_t> shown) const {
        std::vector<std::uint8_t> out(shown.size());
        mask_of_counts(s, shown, numbers, out);
        return out;
    }
};
constexpr StencilOptions z_pass{StencilPass::z_pass}, z_fail{StencilPass::z_fail};

std::size_t differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t n = 0;
    for (std::size_t at = 0; at < a.size(); ++at) n += a[at] != b[at] ? 1 : 0;
    return n;
}

TEST(Stencil, PassAndFailHaveOneNumberInRandomScenes) {
    std::uint64_t ends = 0, wrong = 0, border = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; ++seed) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const Counted pass(s, scene.shown(), z_pass), fail(s, scene.shown(), z_fail);
        if (pass.numbers != fail.numbers) {
            const Polygons p = random_polygons(seed);
            std::printf("seed %u eye %d %d light %d %d %d %d start %lu\n", seed, p.eye.z, p.eye.w, p.light.x, p.light.y, p.light.z, p.light.w, pass.counts.start_tests);
            for (std::size_t at = 0; at < 64; ++at) if (pass.numbers[at] != fail.numbers[at]) std::printf("  %zu,%zu on %u %d %d codes %u near %u far %u \n", at % 8, at / 8, scene.shown()[at], pass.numbers[at], fail.numbers[at], pass.codes[at], (unsigned)fail.counts.near_ends, (unsigned)fail.counts.far_ends);
            for (std::size_t f = 0; f < s.mesh.facets.size(); ++f) { for (auto q : s.mesh.corners(f)) std::printf(" (%d %d %d)", q.x, q.y, q.z); std::printf(" eye %d light %d\n", s.eye.sides[f], s.light.sides[f]); }
            if (seed > 60) FAIL();
        }
        ends += fail.counts.far_ends;
        wrong += differing(pass.mask(s, scene.shown()), scene.brute_mask());
        border += pass.counts.start_tests > pass.counts.facets ? 1 : 0;
    }
    std::printf("ends %lu wrong %lu border %lu\n", ends, wrong, border);
}
TEST(Stencil, Named) {
    for (const Polygons& p : named_scenes()) {
        const Scene scene(p);
        const Setting& s = scene.setting();
        const Counted pass(s, scene.shown(), z_pass), fail(s, scene.shown(), z_fail);
        ASSERT_EQ(pass.numbers, fail.numbers) << p.name;
    std::printf("%s ends %lu wrong %lu\n", p.name.c_str(), fail.counts.far_ends,
        differing(pass.mask(s, scene.shown()), scene.brute_mask()));
    }
}
TEST(Stencil, Figures) {
    for (const int levels : {1, 2, 3, 4}) 
    for (const int d : {0, 3}) {
        const FiguresScene scene(levels, 9, -100, d);
        const Setting& s = scene.setting();
        const Counted pass(s, scene.shown(), z_pass), fail(s, scene.shown(), z_fail);
        ASSERT_EQ(pass.numbers, fail.numbers);
    std::printf("%d ends %lu wrong %lu\n", levels, fail.counts.far_ends,
        differing(pass.mask(s, scene.shown()), scene.brute_mask()));
    }
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
