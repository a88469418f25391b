// Several lights, lights with area, colour (hw/MACHINE.md, section 23): each light's map and mask
// are those of a frame in which it is alone, and what the sources share follows from the formulas.
#include "shadow/frame/costs.hpp"
#include "shadow/frame/plan.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/frame/variant_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::Frame;
using test::VariantScene;
using umbra78::test::expect_equal_buffers;

Settings small(int figure = 6) {
    Settings s = figure_settings(figure);
    s.machine.xy_bits = 6;
    s.machine.z_bits = 13;
    s.machine.coefficient_bits = 24;
    return s;
}

std::vector<std::uint8_t> copy(std::span<const std::uint8_t> plane) {
    return {plane.begin(), plane.end()};
}

struct DrawnLights {
    VariantScene made;
    Scene scene;
    Settings settings;
    Frame<> frame;

    DrawnLights(const std::string& of, const std::string& observer, const std::string& lights,
          const Settings& s)
        : made(of), scene(made.scene(observer, lights)), settings(s), frame(scene, s) {
        EXPECT_EQ(frame.status, FrameStatus::ok);
    }
    explicit DrawnLights(const Scene& of, const Settings& s)
        : made("spheres"), scene(of), settings(s), frame(scene, s) {
        EXPECT_EQ(frame.status, FrameStatus::ok);
    }
    FrameInputs inputs() const { return {scene, settings, frame.matrices}; }
    const FrameBuffers<hw::Depth16>& buffers() const { return frame.buffers; }
};

TEST(Lights, EachHasTheMapAndTheMasksOfAFrameInWhichItIsAlone) {
    const std::vector<std::string> names{"left", "lamp", "sun", "right"};
    Settings s = small();
    s.bias_q16 = 3 << 15;
    s.bias_unit = BiasUnit::texels;
    const DrawnLights all("floor", "oblique", "left + lamp + sun + right", s);
    for (std::size_t l = 0; l < names.size(); ++l) {
        SCOPED_TRACE(names[l]);
        const DrawnLights one("floor", "oblique", names[l], s);
        const auto &a = one.buffers().lights[0], &b = all.buffers().lights[l];
        expect_equal_buffers("observer_z", 64, one.buffers().observer.depth,
                             all.buffers().observer.depth);
        expect_equal_buffers("light_z", 64, a.map.depth, b.map.depth);
        expect_equal_buffers("mask", 64, a.mask, b.mask);
        expect_equal_buffers("edges", 64, a.edges, b.edges);
        expect_equal_buffers("filtered", 64, a.filtered, b.filtered);
    }
}

// Shares are what remains of the intensity after the ambient level, and the first source's share is
// the one it has alone; but where samples have one Z, another may have the smaller record.
TEST(Lights, SharesAddUpToTheIntensity) {
    const Settings s = small();
    const DrawnLights two("floor", "oblique", "lamp + sun", s), one("floor", "oblique", "lamp", s);
    int both = 0, at_255 = 0, others = 0;
    for (std::size_t a = 0; a < two.buffers().pixels(); ++a) {
        if (two.buffers().observer.depth[a] == s.machine.background()) continue;
        const int first = two.buffers().direct(0, 0)[a], second = two.buffers().direct(0, 1)[a];
        ASSERT_EQ(two.buffers().observer.intensity[a] - first - second,
                  one.buffers().observer.intensity[a] - one.buffers().observer.direct[a]) << a;
        others += first != one.buffers().observer.direct[a] ? 1 : 0;
        both += first > 0 && second > 0 ? 1 : 0;
        at_255 += two.buffers().observer.intensity[a] == 255 ? 1 : 0;
    }
    EXPECT_GT(both, 200);
    EXPECT_GT(at_255, 0);  // there the second source loses
    EXPECT_LE(others, 8);
}

// Two sources of half the level at one place light as one whole source does.
TEST(Lights, TwoHalvesAreOneWhole) {
    const Settings s = small(3);
    const VariantScene made("floor");
    const Scene whole = made.scene("oblique", "lamp");
    Scene halves = made.scene("oblique", "lamp + lamp");
    halves.sources[0].level_q8 = halves.sources[1].level_q8 = 128;
    const DrawnLights a(whole, s), b(halves, s);
    expect_equal_buffers("intensity", 64, a.buffers().observer.intensity,
                         b.buffers().observer.intensity);
    for (std::size_t p = 0; p < a.buffers().pixels(); ++p)
        ASSERT_EQ(a.buffers().observer.direct[p],
                  b.buffers().direct(0, 0)[p] + b.buffers().direct(0, 1)[p]) << p;
}

// One after the other, each from what the one before left.
TEST(Lights, TheCompositeGoesThroughTheSourcesInOrder) {
    for (const Composite kind : {Composite::direct, Composite::whole}) {
        Settings s = small();
        s.composite = kind;
        const DrawnLights d("floor", "oblique", "lamp + sun + dim", s);
        for (std::size_t a = 0; a < d.buffers().pixels(); ++a) {
            std::uint8_t level = d.buffers().observer.intensity[a];
            for (std::size_t l = 0; l < 3; ++l)
                level = composite(level,
                                  kind == Composite::whole ? level : d.buffers().direct(0, l)[a],
                                  d.buffers().lights[l].filtered[a], s.density_q8);
            ASSERT_EQ(d.buffers().picture[a], level) << a;
        }
    }
}

std::size_t differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t n = 0;
    for (std::size_t k = 0; k < a.size(); ++k) n += a[k] != b[k] ? 1 : 0;
    return n;
}

// Each channel of a coloured frame is a grey frame with its levels; Z and masks know no colour. Of
// samples at one Z the record decides, red before the others: there they may be another sample's.
TEST(Colour, EachChannelIsTheGreyFrameOfItsLevels) {
    const Settings s = small();
    const DrawnLights d("floor", "oblique", "red + lamp", s);
    ASSERT_EQ(d.scene.channels, 3u);
    for (std::size_t c = 0; c < 3; ++c) {
        Scene grey = d.scene;
        grey.channels = 1;
        const raster::Material m = grey.materials[0];
        const std::array<raster::Material, 1> levels{
            {{m.diffuse[c], m.specular[c], m.shininess}}};
        grey.materials = levels;
        for (Source& source : grey.sources) source.level_q8 = source.level_q8[c];
        const DrawnLights g(grey, s);
        const std::size_t ties = c == 0 ? 0 : 12;  // of 4096 pixels
        EXPECT_LE(differing(g.buffers().observer.intensity, d.buffers().intensity(c)), ties) << c;
        for (std::size_t l = 0; l < 2; ++l)
            EXPECT_LE(differing(g.buffers().direct(0, l), d.buffers().direct(c, l)), ties) << c;
        EXPECT_LE(differing(g.buffers().picture, d.buffers().picture_of(c)), ties) << c;
        expect_equal_buffers("observer_z", 64, g.buffers().observer.depth,
                             d.buffers().observer.depth);
        expect_equal_buffers("mask", 64, g.buffers().lights[1].mask, d.buffers().lights[1].mask);
    }
    EXPECT_GT(differing(d.buffers().picture_of(0), d.buffers().picture_of(2)), 1000u);
}

TEST(Area, DarknessIsTheShareOfItsLightsInWhoseShadowAPixelIs) {
    const Settings s = small(4);
    const DrawnLights d("floor", "oblique", "panel + left", s);
    ASSERT_EQ(d.scene.light_count, 5u);
    std::array<int, 5> seen{};
    for (std::size_t a = 0; a < d.buffers().pixels(); ++a) {
        int shadowed = 0;
        for (std::size_t l = 0; l < 4; ++l) shadowed += d.buffers().lights[l].mask[a] / 255;
        constexpr int expected[] = {0, 64, 128, 191, 255};
        ASSERT_EQ(d.buffers().lights[0].joined[a], expected[shadowed]) << a;
        ++seen[static_cast<std::size_t>(shadowed)];
    }
    for (const int n : seen) EXPECT_GT(n, 0);  // umbra, lit, and each step of the penumbra
    // The other source is what it is alone.
    const DrawnLights left("floor", "oblique", "left", s);
    expect_equal_buffers("mask", 64, left.buffers().lights[0].mask, d.buffers().lights[4].mask);
}

// A graded darkness has no edge to follow; the low-pass takes it as it takes any mask.
TEST(Area, IsNotDequantized) {
    Settings s = small();
    ASSERT_GT(s.dequantize_passes, 0);
    const DrawnLights d("floor", "oblique", "panel + left", s);
    expect_equal_buffers("edges", 64, d.buffers().lights[0].joined, d.buffers().lights[0].edges);
    EXPECT_NE(copy(d.buffers().lights[4].mask), copy(d.buffers().lights[4].edges));
    EXPECT_EQ(make_plan(d.inputs()).at(Omission::dequantize, 0).reason, Reason::graded);
    EXPECT_NE(copy(d.buffers().lights[0].edges), copy(d.buffers().lights[0].filtered));
    test::Frame<> everything(s.machine, d.scene.patches.size(), FrameShape(d.scene));
    draw_frame(d.inputs(), FramePlan{}, everything.buffers, everything.counts);
    test::expect_equal_frames(d.buffers(), everything.buffers);
}

// Lights that stand at one place have one mask, so that their mean is a mask.
TEST(Area, OfNoSizeIsAPoint) {
    const Settings s = small(4);
    const VariantScene made("floor");
    const Scene point = made.scene("oblique", "lamp");
    Scene area = point;
    area.light_count = area.sources[0].lights = 9;
    std::ranges::fill(std::span(area.lights).first(9), point.lights[0]);
    const DrawnLights a(point, s), b(area, s);
    expect_equal_buffers("darkness", 64, a.buffers().lights[0].mask, b.buffers().lights[0].joined);
    expect_equal_buffers("picture", 64, a.buffers().picture, b.buffers().picture);
}

// A ramp is around the mask that the source has without it, and the plan leaves out the rest.
TEST(CrowsRamp, IsTheDarknessOfItsSource) {
    const Settings s = small();
    const DrawnLights hard("floor", "oblique", "left + bulb", s), soft("floor", "oblique",
                                                                 "left ramp 5 + bulb ramp 3", s);
    for (const std::size_t l : {0u, 1u}) {
        const auto &a = hard.buffers().lights[l], &b = soft.buffers().lights[l];
        expect_equal_buffers("mask", 64, a.mask, b.mask);
        int grey = 0;
        for (std::size_t p = 0; p < b.joined.size(); ++p) {
            ASSERT_GE(b.joined[p], b.mask[p]);
            grey += b.joined[p] > 0 && b.joined[p] < 255 ? 1 : 0;
        }
        EXPECT_GT(grey, 100);
        expect_equal_buffers("edges", 64, b.joined, b.edges);  // not dequantized
    }
    EXPECT_EQ(make_plan(soft.inputs()).at(Omission::dequantize, 0).reason, Reason::graded);
    test::Frame<> everything(s.machine, soft.scene.patches.size(), FrameShape(soft.scene));
    draw_frame(soft.inputs(), FramePlan{}, everything.buffers, everything.counts);
    test::expect_equal_frames(soft.buffers(), everything.buffers);
    // Another width changes the picture, and keeps the mask.
    FrameInputs now = soft.inputs();
    now.scene.sources[0].ramp_px = 6;
    const FrameInputs before = soft.inputs();
    const FramePlan plan = make_plan(now, &before);
    EXPECT_TRUE(plan.leaves_out(Omission::same_mask, 0));
    EXPECT_FALSE(plan.leaves_out(Omission::same_picture));
}

TEST(Area, TheCorrectFormRefusesIt) {
    Settings s = small();
    s.form = Form::correct;
    const VariantScene made("floor");
    FrameMatrices matrices;
    EXPECT_EQ(load_matrices(made.scene("oblique", "panel"), s, matrices),
              FrameStatus::area_when_drawn);
    EXPECT_EQ(load_matrices(made.scene("oblique", "left ramp 2"), s, matrices),
              FrameStatus::area_when_drawn);
    EXPECT_EQ(load_matrices(made.scene("oblique", "left + lamp"), s, matrices), FrameStatus::ok);
}

// A point is in a light's shadow or not, whatever the other lights do: with each light's share
// apart, a frame of two lights has the levels of the two frames of one.
TEST(CorrectForm, TestsEachLightByItself) {
    Settings s = small(4);
    s.form = Form::correct;
    s.machine.z_bits = 16;  // so that no two samples have one Z
    const DrawnLights both("spheres", "front", "left + dim", s);
    const DrawnLights left("spheres", "front", "left", s);
    expect_equal_buffers("mask", 64, left.buffers().lights[0].mask, both.buffers().lights[0].mask);
    expect_equal_buffers("direct", 64, left.buffers().observer.direct, both.buffers().direct(0, 0));
    int in_one = 0, in_both = 0;
    for (std::size_t a = 0; a < both.buffers().pixels(); ++a) {
        const bool first = both.buffers().lights[0].mask[a] != 0;
        const bool second = both.buffers().lights[1].mask[a] != 0;
        ASSERT_TRUE(!first || both.buffers().direct(0, 0)[a] == 0) << a;
        ASSERT_TRUE(!second || both.buffers().direct(0, 1)[a] == 0) << a;
        in_one += first != second ? 1 : 0;
        in_both += first && second ? 1 : 0;
    }
    EXPECT_GT(in_one, 100);
    EXPECT_GT(in_both, 0);
    expect_equal_buffers("picture", 64, both.buffers().observer.intensity,
                         both.buffers().picture);
}

// --- what a frame leaves out and keeps -----------------------------------------------------------

// Every buffer of two frames that were drawn from one scene.
void expect_all_equal(const DrawnLights& a, const FrameBuffers<hw::Depth16>& b, int size) {
    test::expect_equal_frames(a.buffers(), b, umbra78::test::Constant::expected);
    for (std::size_t l = 1; l < a.scene.light_count; ++l) {
        expect_equal_buffers("light_z", size, a.buffers().lights[l].map.depth,
                             b.lights[l].map.depth, umbra78::test::Constant::expected);
        expect_equal_buffers("mask", size, a.buffers().lights[l].mask, b.lights[l].mask,
                             umbra78::test::Constant::expected);
    }
    for (std::size_t k = 0; k < a.scene.sources_used(); ++k) {
        const std::size_t l = a.scene.source(k).first_light;
        expect_equal_buffers("filtered", size, a.buffers().lights[l].filtered,
                             b.lights[l].filtered, umbra78::test::Constant::expected);
    }
}

// One of the lights has nothing in its volume, one sees what the observer sees.
Scene with_idle_lights(const VariantScene& made) {
    Scene scene = made.scene("front", "left + sun + front + dim");
    scene.lights[1].target = {0, 20 << 16, 0};
    scene.sources[1].place = scene.lights[1];
    return scene;
}

TEST(LightsPlan, LeavesOutByLightAndChangesNoBit) {
    const Settings s = small();
    const VariantScene made("spheres");
    const DrawnLights all(with_idle_lights(made), s);
    const FramePlan plan = make_plan(all.inputs());
    EXPECT_FALSE(plan.leaves_out(Omission::light_map, 0));
    EXPECT_TRUE(plan.leaves_out(Omission::light_map, 1));
    EXPECT_EQ(plan.at(Omission::post_process, 1).reason, Reason::no_caster);
    EXPECT_EQ(plan.at(Omission::composite, 1).reason, Reason::nothing_shadowed);
    EXPECT_TRUE(plan.leaves_out(Omission::light_drawing, 2));
    EXPECT_FALSE(plan.leaves_out(Omission::light_drawing, 3));
    Frame<> everything(s.machine, all.scene.patches.size(), FrameShape(all.scene));
    draw_frame(all.inputs(), FramePlan{}, everything.buffers, everything.counts);
    expect_all_equal(all, everything.buffers, 64);
}

TEST(LightsPlan, AMapIsKeptWhileItsLightStandsStill) {
    const Settings s = small();
    const VariantScene made("floor");
    DrawnLights frame(made.scene("front", "left + sun"), s);
    const FrameInputs before = frame.inputs();
    Scene moved = frame.scene;
    moved.lights[1].axes = raster::axes_from_angles(-60 << 16, 40 << 16);
    moved.sources[1].place = moved.lights[1];
    FrameInputs now{moved, s, {}};
    ASSERT_EQ(load_matrices(moved, s, now.matrices), FrameStatus::ok);
    const FramePlan plan = make_plan(now, &before);
    EXPECT_TRUE(plan.leaves_out(Omission::same_light_map, 0));
    EXPECT_TRUE(plan.leaves_out(Omission::same_mask, 0));
    EXPECT_FALSE(plan.leaves_out(Omission::same_light_map, 1));
    EXPECT_FALSE(plan.leaves_out(Omission::same_mask, 1));
    EXPECT_TRUE(plan.leaves_out(Omission::same_depth));
    EXPECT_FALSE(plan.leaves_out(Omission::same_observer));  // its shares have changed
    draw_frame(now, plan, frame.frame.buffers, frame.frame.counts);
    const DrawnLights anew(moved, s);
    expect_all_equal(anew, frame.frame.buffers, 64);
}

TEST(LightsPlan, ALevelChangesTheShadingAlone) {
    const Settings s = small();
    const VariantScene made("floor");
    DrawnLights frame(made.scene("front", "left + sun"), s);
    const FrameInputs before = frame.inputs();
    FrameInputs now = before;
    now.scene.sources[1].level_q8 = 200;
    const FramePlan plan = make_plan(now, &before);
    for (std::size_t l = 0; l < 2; ++l) EXPECT_TRUE(plan.leaves_out(Omission::same_mask, l));
    EXPECT_FALSE(plan.leaves_out(Omission::same_observer));
    draw_frame(now, plan, frame.frame.buffers, frame.frame.counts);
    expect_all_equal(DrawnLights(now.scene, s), frame.frame.buffers, 64);
    now.scene.channels = 3;  // other planes: nothing is kept
    EXPECT_FALSE(make_plan(now, &before).leaves_out(Omission::same_mask, 0));
}

// --- what they cost ------------------------------------------------------------------------------

std::vector<FrameLedger> ledgers(const DrawnLights& d) {
    std::vector<FrameLedger> all{frame_ledger(d.inputs(), d.buffers(), d.frame.counts)};
    for (std::size_t l = 1; l < d.scene.light_count; ++l)
        all.push_back(frame_ledger(d.inputs(), d.buffers(), d.frame.counts, l,
                                   KnownCounts{&all[0], nullptr}));
    return all;
}

// A light costs what it costs alone: the paper's "about one more rendering" each. The observer's
// view is drawn once, and each of its samples is shaded by one source more.
TEST(LightsLedger, IsLinearInTheLights) {
    const Settings s = small();
    const std::vector<std::string> names{"left", "lamp", "sun", "right"};
    std::string list;
    std::uint64_t apart = 0, observer = 0;
    for (std::size_t n = 0; n < names.size(); ++n) {
        list += (n == 0 ? "" : " + ") + names[n];
        const std::vector<FrameLedger> one = ledgers(DrawnLights("floor", "oblique", names[n], s));
        const DrawnLights several("floor", "oblique", list, s);
        const std::vector<FrameLedger> all = ledgers(several);
        ASSERT_EQ(all.size(), n + 1);
        apart += one[0].total(false) - FrameLedger::cycles(one[0].observer, false);
        const std::uint64_t view = FrameLedger::cycles(all[0].observer, false);
        EXPECT_EQ(total(all, false), apart + view) << list;
        EXPECT_GT(view, observer) << list;
        observer = view;
    }
}

// A plan's costs are the sum over the lights, and the savings add up to what is left out.
TEST(LightsLedger, SavingsAddUp) {
    for (const char* lights : {"left + sun + dim", "panel + left", "left ramp 7"}) {
        const DrawnLights d("floor", "oblique", lights, small());
        const FrameInputs in = d.inputs();
        const std::vector<FrameLedger> all = ledgers(d);
        const DrawnFrame drawn{in, all};
        const FramePlan plan = make_plan(in);
        std::uint64_t saved = 0;
        for (std::size_t k = 0; k < omission_count; ++k)
            saved += saving(static_cast<Omission>(k), plan, drawn).cycles;
        EXPECT_EQ(total(cycles_of(FramePlan{}, drawn)) - total(cycles_of(plan, drawn)), saved);
        EXPECT_EQ(cycles_of(plan, drawn)[static_cast<std::size_t>(FrameStage::join)].total() > 0,
                  std::string(lights) != "left + sun + dim");
    }
}

// --- what is refused -----------------------------------------------------------------------------

using LightsDeathTest = ::testing::Test;

TEST(LightsDeathTest, LightsThatNoSourceHas) {
    const VariantScene made("spheres");
    const Settings s = small();
    FrameMatrices matrices;
    Scene scene = made.scene("front", "left + sun");
    scene.source_count = 1;
    EXPECT_DEATH(load_matrices(scene, s, matrices), "lights that no source has");
    scene = made.scene("front", "left + sun");
    scene.sources[1].first_light = 0;
    EXPECT_DEATH(load_matrices(scene, s, matrices), "lights that no source has");
    scene.light_count = max_lights + 1;
    EXPECT_DEATH(load_matrices(scene, s, matrices), "too many lights");
}

TEST(LightsDeathTest, BuffersOfAnotherShape) {
    const VariantScene made("spheres");
    const Settings s = small();
    Frame<> one(made.scene("front", "left"), s);
    const DrawnLights two("spheres", "front", "left + sun", s);
    EXPECT_DEATH(draw_frame(two.inputs(), FramePlan{}, one.buffers, one.counts),
                 "carved for other");
}

}  // namespace
}  // namespace umbra78::shadow
