// The correct form: each generated point tested before it is shaded, order-free, and free of
// highlights in shadow; beside the post-process, with the numbers of both.
#include "shadow/correct_form.hpp"

#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/slow_lookup.hpp"
#include "tests/shadow/slow_point.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::FigureScene;
using test::Frame;
using test::Random;
using test::describe;

// The level of the figures' material without direct light: 215 x 90 / 256, rounded half up.
constexpr int ambient_level = (215 * 90 + 128) / 256;

Settings with_form(Settings s, Form form, raster::Sampling sampling) {
    s.form = form;
    s.sampling = sampling;
    return s;
}

std::size_t differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t n = 0;
    for (std::size_t k = 0; k < a.size(); ++k) n += a[k] != b[k];
    return n;
}

// With centre sampling a point is its pixel's centre, so both forms ask the same question of the
// same words: the masks are equal with no exception, dither and registration included.
TEST(CorrectForm, MaskIsThePostProcessesWhereSamplesLieAtCentres) {
    const FigureScene figures;
    for (const int figure : {3, 4})
        for (const Registration registration : {Registration::centre, Registration::index}) {
            Settings s = figure_settings(figure);
            s.registration = registration;
            const Frame<> post(figures.scene(),
                               with_form(s, Form::post_process, raster::Sampling::centre));
            const Frame<> correct(figures.scene(),
                                  with_form(s, Form::correct, raster::Sampling::centre));
            umbra78::test::expect_equal_buffers("observer_z", 512, post.buffers.observer.depth,
                                                correct.buffers.observer.depth);
            umbra78::test::expect_equal_buffers("mask", 512, post.buffers.lights[0].mask,
                                                correct.buffers.lights[0].mask);
            // Where it is lit, the shading is the same as well.
            for (std::size_t a = 0; a < post.buffers.lights[0].mask.size(); ++a) {
                if (post.buffers.lights[0].mask[a] != 0) continue;
                ASSERT_EQ(correct.buffers.picture[a], post.buffers.observer.intensity[a]) << a;
            }
        }
}

// With leaf centres the correct form uses a leaf's own x and y, the post-process its pixel's
// centre, and the masks differ in a few per cent of the pixels. Depth does not.
TEST(CorrectForm, MaskDiffersWithLeafSampling) {
    const FigureScene figures;
    for (const int figure : {3, 4}) {
        const Settings s = figure_settings(figure);
        const Frame<> post(figures.scene(),
                           with_form(s, Form::post_process, raster::Sampling::leaf));
        const Frame<> correct(figures.scene(),
                              with_form(s, Form::correct, raster::Sampling::leaf));
        umbra78::test::expect_equal_buffers("observer_z", 512, post.buffers.observer.depth,
                                            correct.buffers.observer.depth);
        const std::size_t n = differing(post.buffers.lights[0].mask,
                                        correct.buffers.lights[0].mask);
        const auto visible = post.counts.lights[0].post_process.visible;
        std::printf("leaf sampling, figure %d: %zu of %zu visible pixels differ by form\n",
                    figure, n, static_cast<std::size_t>(visible));
        EXPECT_GT(n, visible / 100);
        EXPECT_LT(n, visible / 10);
    }
}

// What the surface would be without its highlight: the same scene in a matte material.
TEST(CorrectForm, NoHighlightInShadow) {
    const FigureScene glossy;
    FigureScene matte;
    matte.materials[0].specular = 0;
    for (const raster::Sampling sampling : {raster::Sampling::centre, raster::Sampling::leaf})
        for (const Form form : {Form::post_process, Form::correct}) {
            const Settings s = with_form(figure_settings(4), form, sampling);
            const Frame<> a(glossy.scene(), s), b(matte.scene(), s);
            int in_shadow = 0, in_light = 0, highlights = 0, brightest = 0;
            int strongest = 0, undarkened = 0;
            for (std::size_t k = 0; k < a.buffers.lights[0].mask.size(); ++k) {
                const int glow = a.buffers.picture[k] - b.buffers.picture[k];
                if (a.buffers.lights[0].mask[k] == 0) {
                    in_light += glow > 0;
                    continue;
                }
                ++in_shadow;
                highlights += glow > 0;
                strongest = std::max(strongest, glow);
                undarkened = std::max(undarkened, a.buffers.observer.intensity[k] -
                                                      b.buffers.observer.intensity[k]);
                brightest = std::max<int>(brightest, a.buffers.picture[k]);
            }
            std::printf("%s, %s sampling: %d pixels in shadow, %d with a highlight of up to %d "
                        "(%d before it was darkened), brightest %d (ambient %d)\n",
                        form == Form::correct ? "correct form" : "post-process",
                        sampling == raster::Sampling::leaf ? "leaf" : "centre", in_shadow,
                        highlights, strongest, undarkened, brightest, ambient_level);
            EXPECT_GT(in_shadow, 60000);
            EXPECT_GT(in_light, 3000) << "highlights in the light";
            if (form == Form::correct) {
                EXPECT_EQ(highlights, 0);
                EXPECT_EQ(brightest, ambient_level);
            } else {
                EXPECT_GT(highlights, 600) << "darkened, not absent";
                EXPECT_LT(strongest, undarkened / 2 + 1);
                EXPECT_GT(brightest, ambient_level);
            }
        }
}

// Every generated point is transformed, hidden or not; the post-process's, only what is seen.
TEST(CorrectForm, CountsEveryGeneratedPoint) {
    const FigureScene figures;
    const Settings s = figure_settings(3);
    const Frame<> post(figures.scene(), s);
    const Frame<> correct(figures.scene(), with_form(s, Form::correct, s.sampling));
    const auto seen = static_cast<std::uint64_t>(
        std::count_if(post.buffers.observer.depth.begin(), post.buffers.observer.depth.end(),
                      [&](hw::Depth16 z) { return z != s.machine.background(); }));
    EXPECT_EQ(post.counts.lights[0].post_process.visible, seen);
    EXPECT_EQ(correct.counts.observer.hidden_blocks, 0u);
    EXPECT_EQ(correct.counts.lights[0].post_process.visible, correct.counts.observer.samples);
    EXPECT_GT(correct.counts.observer.samples, 2 * seen) << "a sphere's far side is drawn too";
    EXPECT_GT(correct.counts.observer.samples, post.counts.observer.samples);
    EXPECT_EQ(correct.counts.lights[0].post_process.shadowed,
              post.counts.lights[0].post_process.shadowed);
    std::printf("figure 3: %zu visible pixels, %zu generated points\n",
                static_cast<std::size_t>(seen),
                static_cast<std::size_t>(correct.counts.observer.samples));
}

// --- the sink by itself -------------------------------------------------------------------------

// One pixel of a light map that is split down the middle: points left of the pixel's centre are
// in shadow, points right of it are lit. The identity matrix leads from the observer to the light.
class Sink : public ::testing::Test {
protected:
    Sink() : observer(4), light(4), mask(256, mask_lit) {
        settings.machine.xy_bits = 4;
        settings.ambient_q8 = 90;
        matrix.word = {{{1 << 14, 0, 0, 0},
                        {0, 1 << 14, 0, 0},
                        {0, 0, 1 << 14, 0},
                        {0, 0, 0, 1 << 14}}};
        shading.ambient_q8 = settings.ambient_q8;
        shading.sources[0].toward.direction = {0, 0, 1 << raster::unit_fraction};
        shading.viewer.direction = shading.sources[0].toward.direction;
        for (std::size_t k = 0; k < 4; ++k) {  // a square that faces light and viewer
            facing[0].f[k] = k % 2 == 0 ? -1000 : 1000;
            facing[1].f[k] = k < 2 ? -1000 : 1000;
        }
        observer.store.clear(settings.machine);
        for (std::size_t a = 0; a < 256; ++a)
            light.depth[a] = static_cast<hw::Depth16>(a % 16 < 5 ? 0 : 65535);
    }
    // A sample in pixel (5, 5), left or right of the texel's edge between columns 4 and 5.
    static raster::Sample sample(bool shadowed) {
        const std::int32_t x = -3 * (1 << raster::raster_fraction) + (shadowed ? -64 : 64);
        return {5, 5, x, -2 * (1 << raster::raster_fraction), 0, 8, 8};
    }
    struct Result {
        int depth, intensity, direct, mask;
        bool operator==(const Result&) const = default;
    };
    struct Point {
        std::uint32_t code;
        bool shadowed, unlit;  // unlit: faces away from the light, so its level is ambient
    };
    Result draw(std::span<const Point> points) {
        observer.store.clear(settings.machine);
        std::fill(mask.begin(), mask.end(), mask_lit);
        TestedLights<hw::Depth16> lights;
        lights[0].emplace(TestedLight<hw::Depth16>{
            {light.store, settings.machine, settings.lookup, settings.background},
            hw::TransformUnit(settings.machine, matrix), mask});
        CorrectSink<hw::Depth16> sink(observer.store, lights, settings,
                                      needed_work(settings).noise);
        raster::ShadingSpec behind = shading;
        raster::UnitVector& to_light = behind.sources[0].toward.direction;
        to_light[2] = -to_light[2];
        const raster::BlockShading lit(facing, shading, material), away(facing, behind, material);
        for (const Point& p : points)
            sink.sample(sample(p.shadowed), p.code, p.unlit ? &away : &lit);
        const std::size_t a = observer.store.address(5, 5);
        return {observer.depth[a], observer.intensity[a], observer.direct[a], mask[a]};
    }

    Settings settings;
    raster::Material material{215, 0, 0};
    raster::ShadingSpec shading;
    std::array<raster::Component, 3> facing{};
    hw::MatrixWords matrix;
    test::OwnedStore<hw::Depth16> observer, light;
    std::vector<std::uint8_t> mask;
};

TEST_F(Sink, APointGoesToTheLightWithItsOwnPlace) {
    const std::array lit{Point{900, false, false}}, shadowed{Point{900, true, false}};
    EXPECT_EQ(draw(lit), (Result{900, 215, 215 - ambient_level, 0}));
    EXPECT_EQ(draw(shadowed), (Result{900, ambient_level, 0, 255}));
}

TEST_F(Sink, NearerReplacesThenTheSmallerIntensityThenTheSmallerMask) {
    const Point lit{900, false, false}, shadowed{900, true, false};
    const Point nearer{899, false, false}, ambient{900, false, true}, dark{900, true, true};
    const auto both_ways = [&](const Point& a, const Point& b, const Result& expected) {
        EXPECT_EQ(draw(std::array{a, b}), expected);
        EXPECT_EQ(draw(std::array{b, a}), expected);
    };
    both_ways(lit, shadowed, {900, ambient_level, 0, 255});
    both_ways(nearer, shadowed, {899, 215, 215 - ambient_level, 0});
    both_ways(ambient, dark, {900, ambient_level, 0, 0});
    both_ways(ambient, shadowed, {900, ambient_level, 0, 0});
}

TEST_F(Sink, OrderChangesNothing) {
    Random random;
    for (int round = 0; round < 200; ++round) {
        std::vector<Point> points;
        for (std::uint64_t n = 2 + random.bits() % 8; n > 0; --n)
            points.push_back({static_cast<std::uint32_t>(900 + random.bits() % 3),
                              random.bits() % 2 == 0, random.bits() % 2 == 0});
        const Result first = draw(points);
        for (int again = 0; again < 5; ++again) {
            for (std::size_t k = points.size(); k > 1; --k)
                std::swap(points[k - 1], points[random.bits() % k]);
            ASSERT_EQ(draw(points), first) << "round " << round;
        }
    }
}

// A sample's x and y as section 12 has them: less half a pixel in index registration, rounded half
// up to the input words' fraction. Samples have 13 fraction bits.
test::SlowWords sample_words(const ShadowTest& s, const raster::Sample& at, std::uint32_t code) {
    const int corner = s.registration == Registration::index ? 1 << 12 : 0;
    const auto word = [&](std::int32_t v) {
        return test::model_round((v - corner) * test::two_to(test::slow_input_fraction(s.machine)),
                                 test::two_to(13), fixed::Rounding::half_up);
    };
    return {word(at.x), word(at.y), test::slow_z_word(s.machine, code)};
}

// Any sample of any pixel, through any matrix, against the slow models: each pixel of a frame gets
// one sample of its own, wherever it lies, at words' ties as well as between them.
TEST(CorrectSink, EverySampleIsTheSlowModels) {
    Random random;
    const int rounds = umbra78::test::effort(200);
    int shadowed = 0, lit = 0;
    for (int round = 0; round < rounds; ++round) {
        Settings s = test::random_settings(random, false);
        if (s.lookup == Lookup::percentage) s.lookup = Lookup::filtered_depth;  // yes or no
        s.machine.xy_bits = std::min(s.machine.xy_bits, 5);
        const hw::MachineSpec& m = s.machine;
        test::OwnedStore<hw::Depth32> observer(m.xy_bits), light(m.xy_bits);
        observer.store.clear(m);
        test::fill_depth(random, m, light.depth);
        std::vector<std::uint8_t> mask(observer.depth.size(), mask_lit);
        const hw::MatrixWords matrix = test::random_matrix(random, m, random.bits() % 2 == 0);
        const LightMap<hw::Depth32> map = light_map<hw::Depth32>(light.store, s);
        TestedLights<hw::Depth32> lights;
        lights[0].emplace(TestedLight<hw::Depth32>{map, hw::TransformUnit(m, matrix), mask});
        CorrectSink<hw::Depth32> sink(observer.store, lights, s, needed_work(s).noise);
        raster::ShadingSpec shading;
        const raster::Material material;  // it must outlive the shading, which refers to it
        const raster::BlockShading flat({}, shading, material);
        const test::SlowNoise noise(s.dither, m);
        const test::SlowTapNoise taps(s);
        const std::int64_t edge = std::int64_t{m.half_px()} << 13;
        for (int n = 0; n < 300; ++n) {
            const auto a = static_cast<std::size_t>(
                random.between(0, static_cast<std::int64_t>(observer.depth.size()) - 1));
            const auto code = static_cast<std::uint32_t>(random.between(0, m.deepest_drawn()));
            const int px = static_cast<int>(a) % m.size_px();
            const int py = static_cast<int>(a) / m.size_px();
            const auto place = [&] {
                const std::int64_t v = random.between(-edge, edge - 1);
                return static_cast<std::int32_t>(random.bits() % 2 == 0 ? v & ~std::int64_t{31}
                                                                        : v);
            };
            const raster::Sample sample{px, py, place(), place(), 0, 8, 8};
            observer.depth[a] = m.background();
            sink.sample(sample, code, &flat);
            const bool expected = test::slow_darkness(
                map, test::slow_transform(matrix, m, sample_words(s, sample, code)),
                noise.words(a), taps.bytes(a)) != 0;
            ASSERT_EQ(mask[a], expected ? 255 : 0) << "round " << round << " " << describe(s);
            ASSERT_EQ(observer.depth[a], code);
            ++(expected ? shadowed : lit);
        }
    }
    EXPECT_GT(shadowed, 25 * rounds);
    EXPECT_GT(lit, 25 * rounds);
}

}  // namespace
}  // namespace umbra78::shadow
