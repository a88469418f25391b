// Volumes counted in a frame store: z-pass and z-fail have one number in every pixel, and where it
// is not that of the polygons the codes are to blame.
#include "tests/shadow/rivals/class3.hpp"
#include "tests/shadow/rivals/named_scenes.hpp"

#include <gtest/gtest.h>

#include <map>

namespace umbra78::shadow::rivals::test {
namespace {

// The pixels that differ from brute force; both passes must have the same numbers.
template <class Scene>
std::size_t wrong_pixels(const Scene& scene, const std::string& name, const DepthScale& scale,
                         StencilCounts& counts) {
    const Setting& s = scene.setting();
    const Stenciled pass(s, scene.shown(), scale, z_pass), fail(s, scene.shown(), scale, z_fail);
    EXPECT_EQ(pass.numbers, fail.numbers) << name;
    EXPECT_EQ(pass.codes, fail.codes) << name;
    counts.far_ends += fail.counts.far_ends;
    counts.start_tests += pass.counts.start_tests > pass.counts.facets ? 1 : 0;
    return differing(mask_of(s, scene.shown(), pass.numbers), scene.brute_mask());
}
template <class Scene>
std::size_t wrong_pixels(const Scene& scene, const std::string& name, int bits = 16) {
    StencilCounts counts;
    return wrong_pixels(scene, name, scale_of(scene.setting(), bits), counts);
}

TEST(Stencil, PassAndFailHaveOneNumberInRandomScenes) {
    StencilCounts all;
    std::size_t wrong = 0;
    for (std::uint32_t seed = 0; seed < random_scenes && !testing::Test::HasFailure(); ++seed) {
        const Scene scene(random_polygons(seed));
        for (const int bits : {16, 4})
            wrong += wrong_pixels(scene, "seed " + std::to_string(seed),
                                  scale_of(scene.setting(), bits), all);
    }
    EXPECT_GT(all.far_ends, enough(10'000));
    EXPECT_GT(all.start_tests, enough(200)) << "eyes on a volume's border";
    EXPECT_GT(wrong, enough(1'000)) << "16 codes are too few";
}

TEST(Stencil, PassAndFailHaveOneNumberInTheNamedScenes) {
    std::map<std::string, std::size_t> wrong;
    for (const Polygons& p : named_scenes())
        if (const std::size_t n = wrong_pixels(Scene(p), p.name); n > 0) wrong[p.name] = n;
    // A sheet reaches behind the eye, so that the near plane is at a word's depth and the codes of
    // what is far lie 7 words apart.
    EXPECT_EQ(wrong, (std::map<std::string, std::size_t>{{"eye_in_shadow", 12}}));
}

TEST(Stencil, EyesAtAPlaceHaveCoarserCodesFarAway) {
    const FiguresScene scene(2, 8, -100, 3);
    for (const auto& [bits, wrong] : {std::pair{16, 0u}, {10, 1u}, {8, 7u}})
        EXPECT_EQ(wrong_pixels(scene, "an eye at a place", bits), wrong) << bits;
}

TEST(Stencil, PassAndFailHaveOneNumberInTheFiguresScene) {
    for (const int levels : {1, 2, 4}) wrong_pixels(FiguresScene(levels, 7), "an eye far away");
    for (const int elevation : {0, 60})
        wrong_pixels(FiguresScene(2, 8, 40, 3, elevation), "an eye and a light at places");
}

// 256 sheets lie before one another: a counter of 8 bits comes to 0 there.
TEST(Stencil, ANarrowCounterWraps) {
    for (const Polygons& p : named_scenes()) {
        if (p.name != "nested_256") continue;
        const Scene scene(p);
        const Setting& s = scene.setting();
        for (const StencilPass pass : {StencilPass::z_pass, StencilPass::z_fail}) {
            const auto mask_with = [&](int counter_bits) {
                const Stenciled counted(s, scene.shown(), scale_of(s), {pass, counter_bits});
                return mask_of(s, scene.shown(), counted.numbers);
            };
            EXPECT_EQ(mask_with(16), scene.brute_mask());
            EXPECT_EQ(mask_with(9), scene.brute_mask());
            const std::vector<std::uint8_t> wrapped = mask_with(8), right = scene.brute_mask();
            int lit_again = 0;
            for (std::size_t at = 0; at < right.size(); ++at)
                lit_again += right[at] == dark && wrapped[at] == lit ? 1 : 0;
            EXPECT_EQ(lit_again, 6 * 8) << "the wall behind all of them";
            EXPECT_EQ(differing(wrapped, right), 6u * 8u);
        }
    }
}

// The rule of hw/MACHINE.md, sections 4 and 7, from places whose depth is known.
TEST(Stencil, CodesAreTheMachines) {
    Polygons p = named("a sheet", from_left);
    const auto code = [&](int z, const DepthScale& scale) {
        Polygons q = p;
        const Scene scene(with_wall(q, z));
        const Setting& s = scene.setting();
        return PlaneCodes(s.planes[0], s.space, scale).at(s.space.centre(16), s.space.centre(9));
    };
    const DepthScale level{-100, 300, 1, 1, 4};  // 25 words a code
    EXPECT_EQ(code(-100, level), 0u);
    EXPECT_EQ(code(-88, level), 0u);
    EXPECT_EQ(code(-87, level), 1u) << "13 of 25";
    EXPECT_EQ(code(0, level), 4u);
    EXPECT_EQ(code(-300, level), 0u) << "before the near plane";
    EXPECT_EQ(code(262, level), 14u);
    EXPECT_EQ(code(300, level), 14u) << "15 is the background's";
    EXPECT_EQ(code(900, level), 14u);
    EXPECT_EQ(code(25, {-200, 600, 2, 1, 4}), 5u) << "a word is two of near's units";
    EXPECT_EQ(code(12, {-50, 150, 1, 2, 4}), 4u) << "half of one: 56 of 200, 4.48";
    p.eye = {0, 0, -512, 1};
    const DepthScale eye{256, 1024, 1, 1, 8};  // 256 * 1024 (d - 256) / (768 d)
    EXPECT_EQ(code(-256, eye), 0u);
    EXPECT_EQ(code(0, eye), 171u) << "170.67";
    EXPECT_EQ(code(171, eye), 213u) << "341.33 - 87381.33 / 683 = 213.39";
    EXPECT_EQ(code(512, eye), 254u);
}

// What the eye sees has no code behind another facet of its pixel, or z-fail would miss its end.
TEST(Stencil, NoFacetHasACodeBeforeTheSeenOne) {
    std::uint64_t pixels = 0;
    for (std::uint32_t seed = 0; seed < random_scenes; seed += 4) {
        const Scene scene(random_polygons(seed));
        const Setting& s = scene.setting();
        const DepthScale scale = scale_of(s, 8);
        const Stenciled seen(s, scene.shown(), scale, z_pass);
        for (std::size_t f = 0; f < s.mesh.facets.size(); ++f) {
            if (s.eye.sides[f] == 0) continue;
            const PlaneCodes codes(s.planes[f], s.space, scale);
            for (int row = 0; row < 8; ++row) {
                const auto run = s.covered_run(f, row);
                for (int column = run.from; column < run.to; ++column, ++pixels)
                    ASSERT_GE(codes.at(s.space.centre(column), s.space.centre(row)),
                              seen.codes[static_cast<std::size_t>(8 * row + column)])
                        << "seed " << seed;
            }
        }
    }
    EXPECT_GT(pixels, enough(50'000));
}

}  // namespace
}  // namespace umbra78::shadow::rivals::test
