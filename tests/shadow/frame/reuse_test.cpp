// Reuse: where the plan keeps a buffer of the frame before, a frame drawn anew has the same in it.
#include "shadow/frame/reuse.hpp"

#include "shadow/frame/frame.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/planned_scenes.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace umbra78::shadow {
namespace {

using test::equal_frames;
using test::PlannedFrame;
using test::PlannedScene;

constexpr std::array standing{Omission::same_light_map, Omission::same_depth,
                              Omission::same_observer, Omission::same_mask,
                              Omission::same_picture};

// "LDOMP": light map, depth, observer, mask, picture.
std::string kept(const FramePlan& plan) {
    std::string letters;
    for (std::size_t k = 0; k < standing.size(); ++k)
        if (plan.leaves_out(standing[k])) letters += "LDOMP"[k];
    return letters;
}

// A frame's room for the list of what its observer sees.
struct Listed {
    explicit Listed(PlannedFrame& f)
        : blocks(raster::VisibleList::blocks_for(f.frame.buffers.pixels()) +
                 f.inputs.scene.patches.size()),
          list(blocks) {}
    std::vector<raster::VisibleBlock> blocks;
    raster::VisibleList list;
};

bool shades_anew(const FramePlan& plan) {
    return plan.leaves_out(Omission::same_depth) && !plan.leaves_out(Omission::same_observer);
}

// There and back, and there again, with a list of what is visible.
void draw_with_list(const PlannedScene& before, const PlannedScene& now) {
    PlannedFrame used(before, true), was(before), is(now);
    Listed listed(used);
    used.frame.buffers.visible = &listed.list;
    was.draw(make_plan(was.inputs));
    is.draw(make_plan(is.inputs));
    used.draw(make_plan(used.inputs));
    for (const PlannedFrame* next : {&is, &was, &is}) {
        const FrameInputs old = used.inputs;
        used.inputs = next->inputs;
        used.draw(make_plan(next->inputs, &old));
        EXPECT_TRUE(equal_frames(next->frame.buffers, used.frame.buffers)) << "by a list";
    }
}

// Draws `now` over what `before` left, with all that is kept and with each of it put back, and
// compares with a frame drawn anew. Returns what was kept.
std::string draw_over(const PlannedScene& before, const PlannedScene& now) {
    PlannedFrame fresh(now);
    fresh.draw(make_plan(fresh.inputs));
    PlannedFrame used(before, true);
    const FrameInputs old = used.inputs;
    const FramePlan plan = make_plan(fresh.inputs, &old);
    for (std::size_t k = 0; k <= standing.size(); ++k) {
        FramePlan variant = plan;
        if (k < standing.size() && !plan.leaves_out(standing[k])) continue;
        if (k < standing.size()) variant.at(standing[k]).left_out = false;
        used.inputs = old;
        used.draw(make_plan(old));
        used.inputs = fresh.inputs;
        used.draw(variant);
        EXPECT_TRUE(equal_frames(fresh.frame.buffers, used.frame.buffers))
            << "kept " << kept(variant);
    }
    if (shades_anew(plan)) draw_with_list(before, now);
    return kept(plan);
}

// --- settings -----------------------------------------------------------------------------------

std::int64_t another(const Setting& setting, const Settings& s) {
    const std::int64_t v = setting.get(s);
    if (setting.key == "form" && !is_on_ground(s.form))  // these scenes have none
        return static_cast<std::int64_t>(s.form == Form::post_process ? Form::correct
                                                                      : Form::post_process);
    if (setting.kind == SettingKind::choice) return (v + 1) % (setting.max + 1);
    if (setting.kind == SettingKind::decimal) return v == 0 ? setting.max : v / 2;
    for (const std::int64_t w : {v - 1, v + 1, setting.min, setting.max}) {
        Settings changed = s;
        setting.set(changed, w);
        if (w != v && w >= setting.min && w <= setting.max && can_be_built(changed)) return w;
    }
    return v;
}

using Expected = std::map<std::string_view, std::string>;

// Of the settings of figure 6; what no bit depends on keeps everything.
const Expected post_process_form{
    {"xy_bits", ""}, {"z_bits", ""}, {"coefficient_bits", ""}, {"fraction_bits", "LDO"},
    {"transform_rounding", ""}, {"coefficient_rounding", "DO"}, {"depth_rounding", ""},
    {"depth_store", ""},
    {"surface", ""}, {"sampling", ""}, {"registration", "LDO"}, {"lookup", "LDO"},
    {"background", "LDO"}, {"bias", "LDO"}, {"bias_unit", "LDO"}, {"dither", "LDO"},
    {"map_depth", "DO"}, {"bias_slope", "DO"}, {"receiver", "LDO"},
    {"dither_size", "LDO"},
    {"dither_seed", "LDO"}, {"dequantize", "LDOM"}, {"low_pass", "LDOM"}, {"ambient", "LDM"},
    {"shading", "LDM"},
    {"composite", "LDOM"}, {"density", "LDOM"}, {"form", "L"}, {"arithmetic", "LDO"}};
const Expected correct_form{
    {"xy_bits", ""}, {"z_bits", ""}, {"coefficient_bits", ""}, {"fraction_bits", "L"},
    {"transform_rounding", ""}, {"coefficient_rounding", ""}, {"depth_rounding", ""},
    {"depth_store", ""},
    {"surface", ""}, {"sampling", ""}, {"registration", "L"}, {"lookup", "L"}, {"background", "L"},
    {"map_depth", ""}, {"bias_slope", ""},
    {"bias", "L"}, {"bias_unit", "LD"},  // 192 texels: nothing is tested any more
    {"dither", "L"}, {"dither_size", "L"},
    {"dither_seed", "L"}, {"dequantize", "LDOM"}, {"low_pass", "LDOM"}, {"ambient", "L"},
    {"shading", "L"},
    {"composite", "LDOMP"}, {"density", "LDOMP"}, {"form", "LD"}};

void change_each_setting(PlannedScene base, const Expected& expected) {
    if (umbra78::test::sanitized) base.settings.machine.xy_bits = 5;
    int turn = 0;
    for (const Setting& setting : settings_table()) {
        if (umbra78::test::sanitized && ++turn % 4 != 0) continue;
        if (setting.key == "form" && map_layers(base.settings) == 0) continue;  // other buffers
        SCOPED_TRACE(setting.key);
        PlannedScene changed = base;
        setting.set(changed.settings, another(setting, base.settings));
        ASSERT_NE(setting.get(changed.settings), setting.get(base.settings));
        if (!can_be_built(changed.settings)) continue;  // the AP-120B has no correct form
        const auto found = expected.find(setting.key);
        const std::string keeps = found == expected.end() ? "LDOMP" : found->second;
        const hw::MachineSpec &m = changed.settings.machine, &n = base.settings.machine;
        if (m.xy_bits == n.xy_bits && m.z_bits == n.z_bits) {
            EXPECT_EQ(draw_over(base, changed), keeps);
        } else {  // other buffers altogether
            const PlannedFrame a(base), b(changed);
            EXPECT_EQ(kept(make_plan(b.inputs, &a.inputs)), keeps);
        }
    }
}

TEST(Reuse, EachSettingInTurn) {
    change_each_setting(test::planned_scene("figure 6"), post_process_form);
}

TEST(Reuse, EachSettingInTurnOfTheCorrectForm) {
    change_each_setting(test::planned_scene("correct"), correct_form);
}

// A shadow that is drawn reads none of the settings of a test, and is kept with the picture or not
// at all.
TEST(Reuse, EachSettingInTurnOfAGround) {
    Expected expected;
    for (const char* key : {"xy_bits", "z_bits", "coefficient_bits", "transform_rounding",
                            "coefficient_rounding", "depth_rounding", "depth_store",
                            "surface", "sampling",
                            "ambient", "shading"})
        expected[key] = "";
    for (const char* key : {"dequantize", "low_pass", "composite", "density"})
        expected[key] = "LDOM";
    change_each_setting(test::planned_scene("ground"), expected);
    change_each_setting(test::planned_scene("blob"), expected);
}

// A rival reads polygons: nothing that only a depth map is read with, but how finely it dices.
TEST(Reuse, EachSettingInTurnOfARival) {
    Expected expected;
    for (const char* key : {"xy_bits", "z_bits", "coefficient_bits", "transform_rounding",
                            "depth_rounding", "surface", "sampling"})
        expected[key] = "";
    for (const char* key : {"ambient", "shading"}) expected[key] = "LDM";
    for (const char* key : {"dequantize", "low_pass", "composite", "density"})
        expected[key] = "LDOM";
    expected["dice_levels"] = "LDO";
    PlannedScene planned = test::planned_scene("figure 6");
    planned.settings.form = Form::volumes;
    planned.settings.dice_levels = 2;
    planned.settings.machine.xy_bits = 6;
    change_each_setting(planned, expected);
}

TEST(Reuse, ARivalsLightMoves) {
    PlannedScene base = test::planned_scene("figure 6");
    base.settings.form = Form::volumes;
    PlannedScene moved = base;
    moved.light.axes = raster::axes_from_angles(-80 << 16, 10 << 16);
    EXPECT_EQ(draw_over(base, moved), "LD");
    moved = base;
    moved.light.extent += 1;  // its view is not read
    EXPECT_EQ(draw_over(base, moved), "LDOMP");
}

TEST(Reuse, AGroundTakesNothingFromAnotherForm) {
    const PlannedScene ground = test::planned_scene("ground");
    PlannedScene before = ground;
    before.settings.form = Form::post_process;
    EXPECT_EQ(draw_over(before, ground), "");
    before = ground;
    std::swap(before.patches[0], before.patches[before.ground]);
    before.ground = 0;
    EXPECT_EQ(draw_over(before, ground), "") << "it is another patch";
    PlannedScene moved = ground;
    moved.light.axes = raster::axes_from_angles(-80 << 16, 50 << 16);
    EXPECT_EQ(draw_over(ground, moved), "");
}

// Figure 6's by percentage closer filtering: taps are read, background is not.
TEST(Reuse, EachSettingInTurnOfPercentage) {
    PlannedScene planned = test::planned_scene("percentage, jittered");
    Expected expected = post_process_form;
    expected["taps"] = expected["tap_places"] = "LDO";
    expected["background"] = "LDOMP";
    expected.erase("form");        // cannot be built
    expected.erase("arithmetic");  // likewise
    change_each_setting(planned, expected);
    planned.settings.dither.shape = hw::DitherShape::none;
    PlannedScene changed = planned;
    changed.settings.dither.seed = 99;
    EXPECT_EQ(draw_over(planned, changed), "LDO") << "the taps' own noise";
    planned.settings.tap_places = changed.settings.tap_places = TapPlaces::grid;
    EXPECT_EQ(draw_over(planned, changed), "LDOMP");
    planned.settings.lookup = changed.settings.lookup = Lookup::nearest;
    changed.settings.taps = 5;
    EXPECT_EQ(draw_over(planned, changed), "LDOMP") << "nearest lookup has no window";
}

TEST(Reuse, WhatIsNotReadMayChange) {
    PlannedScene base = test::planned_scene("figure 3"), changed = base;
    changed.settings.background = Background::fall_back;  // nearest lookup does not ask
    changed.settings.dither.seed = 99;                    // dither is off
    changed.settings.machine.divide_order = hw::DivideOrder::round_first;  // nothing divides
    EXPECT_EQ(draw_over(base, changed), "LDOMP");
    changed.settings.dither.shape = hw::DitherShape::uniform;
    changed.settings.dither.size_q8 = 0;
    EXPECT_EQ(draw_over(base, changed), "LDOMP");
    changed = base;
    changed.settings.machine.max_accumulator_bits = 35;  // as many as it has
    changed.settings.machine.product_rounding = fixed::Rounding::half_up;
    EXPECT_EQ(draw_over(base, changed), "LDOMP");
    changed.settings.machine.max_accumulator_bits = 22;
    EXPECT_EQ(draw_over(base, changed), "LDO");
    base = changed;
    base.settings.machine.product_rounding = fixed::Rounding::ceiling;
    EXPECT_EQ(draw_over(base, changed), "LDO");
    base = test::planned_scene("point light");
    base.settings.dither.shape = hw::DitherShape::none;
    changed = base;
    changed.settings.machine.divide_order = hw::DivideOrder::round_first;
    EXPECT_EQ(draw_over(base, changed), "LDO");
}

// --- scene and views ----------------------------------------------------------------------------

// The offset along the normal, and what a texel is worth in Z, change the mask alone.
TEST(Reuse, TheNormalsOffsetIsTheMasks) {
    const PlannedScene base = test::planned_scene("receivers' normals");
    EXPECT_EQ(draw_over(base, base), "LDOMP");
    PlannedScene changed = base;
    changed.settings.normal_offset_q8 /= 2;
    EXPECT_EQ(draw_over(base, changed), "LDO");
    changed = base;
    changed.settings.bias_clamp_q16 = 1 << 16;  // of a plane
    EXPECT_EQ(draw_over(base, changed), "LDOMP");
}

// Normals are drawn with the intensities and decide the mask: they are kept with them or not.
TEST(Reuse, KeptNormalsAreTheObservers) {
    for (const char* name : {"kept normals", "kept, unshaded"}) {
        const PlannedScene base = test::planned_scene(name);
        EXPECT_EQ(draw_over(base, base), "LDOMP") << name;
        PlannedScene changed = base;
        changed.settings.slope_source = SlopeSource::depths;
        EXPECT_EQ(draw_over(base, changed), "LDO") << name;
        EXPECT_EQ(draw_over(changed, base), "LD") << name << ": the normals are still to be drawn";
        changed = base;
        changed.settings.receiver = Receiver::point;
        EXPECT_EQ(draw_over(base, changed), "LDO") << name;
        EXPECT_EQ(draw_over(changed, base), "LD") << name;
        changed = base;
        changed.settings.ambient_q8 /= 2;  // a tie of depths may have another winner
        EXPECT_EQ(draw_over(base, changed), "LD") << name;
        changed = base;
        changed.light.axes = raster::axes_from_angles(-80 << 16, 10 << 16);
        EXPECT_EQ(draw_over(base, changed), "D") << name;
    }
    PlannedScene base = test::planned_scene("kept, unshaded"), changed = base;
    changed.settings.normal_offset_q8 /= 2;
    EXPECT_EQ(draw_over(base, changed), "LDO");
    base = test::planned_scene("kept normals"), changed = base;
    changed.settings.bias_clamp_q16 = 1 << 16;
    EXPECT_EQ(draw_over(base, changed), "LDO");
}

TEST(Reuse, TheLightMoves) {
    for (const char* name : {"figure 6", "point light", "floor"}) {
        const PlannedScene base = test::planned_scene(name);
        PlannedScene moved = base;
        moved.light.axes = raster::axes_from_angles(-80 << 16, 10 << 16);
        EXPECT_EQ(draw_over(base, moved), "D") << name;  // its direction is in the shading
    }
    const PlannedScene base = test::planned_scene("correct");
    PlannedScene moved = base;
    moved.light.axes = raster::axes_from_angles(-80 << 16, 10 << 16);
    EXPECT_EQ(draw_over(base, moved), "");
}

// The list holds what is visible, and no patch is drawn; where it does not fit, all are.
TEST(Reuse, ByAListNothingIsDrawn) {
    const PlannedScene base = test::planned_scene("figure 6");
    for (const bool fits : {true, false}) {
        PlannedFrame used(base);
        Listed listed(used);
        if (!fits) listed.list = raster::VisibleList(std::span(listed.blocks).first(9));
        used.frame.buffers.visible = &listed.list;
        used.draw(make_plan(used.inputs));
        EXPECT_FALSE(listed.list.is_whole());
        std::vector<PlannedScene> scenes(3, base);
        for (int turn = 1; turn <= 3; ++turn) {
            PlannedScene& moved = scenes[static_cast<std::size_t>(turn - 1)];
            moved.light.axes = raster::axes_from_angles((-80 + turn) << 16, 10 << 16);
            PlannedFrame fresh(moved);
            fresh.draw(make_plan(fresh.inputs));
            const FrameInputs old = used.inputs;
            used.inputs = fresh.inputs;
            used.frame.counts.observer = {};
            used.draw(make_plan(used.inputs, &old));
            EXPECT_TRUE(equal_frames(fresh.frame.buffers, used.frame.buffers));
            EXPECT_EQ(used.frame.counts.observer.blocks > 0, turn == 1 || !fits);
            EXPECT_EQ(listed.list.is_whole(), fits);
            std::size_t pixels = 0, samples = 0;
            for (const hw::Depth16 z : fresh.frame.buffers.observer.depth) pixels += z != 0xffff;
            for (const raster::VisibleBlock& b : listed.list.blocks()) samples += b.count;
            if (fits) {
                EXPECT_GE(samples, pixels);
                EXPECT_LT(samples, 2 * pixels);
            }
        }
    }
}

TEST(Reuse, TheLightsWindowChanges) {
    const PlannedScene base = test::planned_scene("figure 6");
    PlannedScene wider = base;
    wider.light.extent = 3 << 16;
    EXPECT_EQ(draw_over(base, wider), "DO");
}

TEST(Reuse, TheObserverMoves) {
    for (const char* name : {"figure 6", "perspective", "correct"}) {
        const PlannedScene base = test::planned_scene(name);
        PlannedScene moved = base;
        moved.observer.axes = raster::axes_from_angles(15 << 16, 0);
        EXPECT_EQ(draw_over(base, moved), "L") << name;
    }
}

TEST(Reuse, SurfacesChange) {
    const PlannedScene base = test::planned_scene("figure 6");
    const raster::Material& was = base.materials[0];
    for (const raster::Material& is :
         {raster::Material{was.diffuse[0] - 1, was.specular, was.shininess},
          raster::Material{was.diffuse, was.specular[0] - 1, was.shininess},
          raster::Material{was.diffuse, was.specular, was.shininess - 1}}) {
        PlannedScene other = base;
        other.materials[0] = is;
        EXPECT_EQ(draw_over(base, other), "LDM");
    }
    PlannedScene dented = base;
    dented.patches[5].control[5].x += 1 << 12;
    EXPECT_EQ(draw_over(base, dented), "");
    PlannedScene fewer = base;
    fewer.patches.pop_back();
    EXPECT_EQ(draw_over(base, fewer), "");
    EXPECT_EQ(draw_over(base, base), "LDOMP");
    PlannedScene two = base;
    two.materials.push_back({50, 0, 0});
    two.patches[7].material = 1;
    EXPECT_EQ(draw_over(base, two), "LDM");
}

// From a scene in which something was left out, and to one: a quarter of all pairs.
TEST(Reuse, BetweenTwoScenes) {
    std::vector<PlannedScene> scenes = test::planned_scenes();
    for (PlannedScene& p : scenes) p.settings.machine.xy_bits = 5;
    int pairs = 0, drawn = 0, keeping = 0;
    for (const PlannedScene& before : scenes)
        for (const PlannedScene& now : scenes) {
            if (now.patches.size() > before.patches.size()) continue;  // carved for fewer
            if (map_layers(now.settings) > map_layers(before.settings) &&
                map_layers(before.settings) == 0)
                continue;  // carved without a map
            if (++pairs % (umbra78::test::sanitized ? 32 : 4) != 0) continue;
            ++drawn;
            SCOPED_TRACE(before.name + " to " + now.name);
            keeping += !draw_over(before, now).empty();
        }
    std::printf("%d of %d pairs of scenes keep something\n", keeping, drawn);
    EXPECT_GT(keeping, drawn / 8);
}

}  // namespace
}  // namespace umbra78::shadow
