// A light inside the view (hw/MACHINE.md, section 25): both of the paper's ways give one mask,
// nothing is lost or doubled at the edges of the cube's faces, and what it costs.
#include "shadow/frame/costs.hpp"
#include "shadow/frame/plan.hpp"
#include "shadow/sectors.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/frame/variant_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::VariantScene;
using umbra78::test::expect_equal_buffers;

TEST(SectorCounts, AreAddedFaceByFace) {
    SectorCounts one{}, more{};
    for (std::size_t k = 0; k < one.size(); ++k) {
        one[k] = {10 + k, k, 1};
        more[k] = {100, 20 * k, 2};
    }
    one += more;
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].visible, 110 + k);
        EXPECT_EQ(one[k].shadowed, 21 * k);
        EXPECT_EQ(one[k].lines, 3u);
    }
}

Settings small_sectored() {
    Settings s;
    s.machine.xy_bits = 6;
    s.machine.z_bits = 16;
    s.machine.coefficient_bits = 24;
    s.bias_q16 = 2 << 16;
    s.bias_unit = BiasUnit::texels;
    return s;
}

struct Lit {
    VariantScene made;
    Scene scene;
    Settings settings;
    test::Frame<> frame;

    Lit(const std::string& of, const std::string& observer, const std::string& lights,
        const Settings& s)
        : made(of), scene(made.scene(observer, lights)), settings(s), frame(scene, s) {
        EXPECT_EQ(frame.status, FrameStatus::ok);
    }
    FrameInputs inputs() const { return {scene, settings, frame.matrices}; }
    std::span<const std::uint8_t> mask() const { return frame.buffers.lights[0].mask; }
    int dark() const {
        return static_cast<int>(std::ranges::count_if(mask(), [](auto m) { return m > 0; }));
    }
    std::uint64_t tested() const {
        std::uint64_t n = 0;
        for (std::size_t l = 0; l < hw::sector_count; ++l)
            n += frame.counts.lights[l].post_process.visible;
        return n;
    }
    std::uint64_t visible() const {
        const std::uint32_t none = settings.machine.background();
        return static_cast<std::uint64_t>(std::ranges::count_if(
            frame.buffers.observer.depth, [&](auto code) { return code != none; }));
    }
    FrameLedger ledger(std::size_t l) const {
        return frame_ledger(inputs(), frame.buffers, frame.counts, l);
    }
};

// Lookups, dithers, accumulators and receivers under which the two ways are compared.
std::vector<Settings> ways_to_look_up() {
    std::vector<Settings> all(9, small_sectored());
    all[1].lookup = Lookup::bilinear;
    all[1].dither.shape = hw::DitherShape::normal;
    all[2].lookup = Lookup::percentage;
    all[2].taps = 5;
    all[2].tap_places = TapPlaces::jittered;
    all[3].machine.max_accumulator_bits = 22;
    all[3].machine.divide_order = hw::DivideOrder::round_first;
    all[4].receiver = Receiver::plane;
    all[6].receiver = Receiver::normal;
    all[7].receiver = Receiver::plane;
    all[8].receiver = Receiver::normal;
    all[7].slope_source = all[8].slope_source = SlopeSource::normals;
    all[5].machine.coefficient_bits = 12;  // few bits: many directions tie
    return all;
}

TEST(SectoredLight, BothWaysGiveOneMask) {
    for (const Settings& s : ways_to_look_up())
        for (const std::string observer : {"front", "oblique"}) {
            SCOPED_TRACE(std::to_string(&s - &*ways_to_look_up().begin()) + observer);
            Settings other = s;
            other.sector_test = SectorTest::every;
            const Lit classified("floor", observer, "bulb", s);
            const Lit every("floor", observer, "bulb", other);
            expect_equal_buffers("mask", 64, classified.mask(), every.mask());
            EXPECT_GT(classified.dark(), 100);
            // Each pixel is sorted into one sector at most, or goes through six.
            EXPECT_LE(classified.tested(), classified.visible());
            EXPECT_EQ(every.tested(), 6 * every.visible());
        }
}

// Walls about a place, at that distance: a cube, or without its front one.
void add_walls(const raster::World& at, std::int32_t r, bool closed,
               std::vector<raster::Patch>& walls) {
    const auto wall = [&](std::int32_t x, std::int32_t y, std::int32_t z, raster::World u,
                          raster::World v) {
        walls.push_back(raster::plane_patch({{at.x + x, at.y + y, at.z + z}, u, v, 0}));
    };
    const raster::World right{2 * r, 0, 0}, up{0, 2 * r, 0}, near{0, 0, 2 * r};
    wall(-r, -r, -r, up, near);
    wall(r, -r, -r, up, near);
    wall(-r, -r, -r, right, near);
    wall(-r, r, -r, right, near);
    wall(-r, -r, -r, right, up);
    if (closed) wall(-r, -r, r, right, up);
}

// The bulb in a room that is open toward the observer.
struct Room {
    std::vector<raster::Patch> walls;
    VariantScene lights{"spheres"};
    Scene scene;

    explicit Room(int azimuth) {
        add_walls({}, 3 << 16, false, walls);
        scene = lights.scene("front", "bulb");
        scene.mesh = {};
        scene.observer.axes = raster::axes_from_angles(azimuth << 16, 10 << 16);
        scene.observer.extent = 4 << 16;
        scene.observer.near_depth = -(8 << 16);
        scene.observer.far_depth = 8 << 16;
        for (std::size_t l = 0; l < 6; ++l) scene.lights[l].near_depth = 1 << 14;
        scene.patches = walls;
    }
};

std::vector<Settings> precise_ways() {
    std::vector<Settings> all;
    for (Settings s : ways_to_look_up()) {
        if (s.machine.coefficient_bits < 24 || s.machine.dropped_bits() > 0) continue;
        s.bias_q16 = 4 << 16;
        all.push_back(s);
    }
    return all;
}

// Nothing casts on anything: whatever is dark is a seam.
TEST(SectoredLight, HasNoDarkSeams) {
    for (const int azimuth : {0, 20, -35})
        for (const Settings& s : precise_ways()) {
            const Room room(azimuth);
            const test::Frame<> f(room.scene, s);
            ASSERT_EQ(f.status, FrameStatus::ok);
            EXPECT_EQ(std::ranges::count(f.buffers.lights[0].mask, mask_lit), 64 * 64) << azimuth;
            int seen = 0;
            for (std::size_t k = 0; k < 6; ++k)
                seen += f.counts.lights[k].post_process.visible > 0 ? 1 : 0;
            EXPECT_GE(seen, 5);
        }
}

// The bulb in a closed box: whatever is lit of the room is a seam.
TEST(SectoredLight, HasNoLitSeams) {
    for (const int azimuth : {0, 20, -35})
        for (const Settings& s : precise_ways()) {
            Room room(azimuth);
            const test::Frame<> open(room.scene, s);
            add_walls({10000, 60000, 20000}, 30000, true, room.walls);
            room.scene.patches = room.walls;
            const test::Frame<> f(room.scene, s);
            ASSERT_EQ(f.status, FrameStatus::ok);
            int walls = 0, lit = 0;
            for (std::size_t a = 0; a < f.buffers.pixels(); ++a) {
                const std::uint32_t code = f.buffers.observer.depth[a];
                if (code == s.machine.background() || code != open.buffers.observer.depth[a])
                    continue;
                ++walls;
                lit += f.buffers.lights[0].mask[a] != mask_shadow ? 1 : 0;
            }
            EXPECT_GT(walls, 1000);
            EXPECT_EQ(lit, 0) << azimuth;
        }
}

// With room to the face's edge, a pixel is as a spot light of the sector's view has it.
TEST(SectoredLight, IsASpotLightInEachOfItsViews) {
    Settings s = small_sectored();
    const Lit all("floor", "oblique", "bulb", s);
    int compared = 0, dark = 0;
    for (std::size_t k = 0; k < hw::sector_count; ++k) {
        Scene one = all.scene;
        one.light_count = one.source_count = 1;
        one.lights[0] = all.scene.lights[k];
        one.sources[0] = {0, 1, one.lights[0], 256};
        const test::Frame<> f(one, s);
        ASSERT_EQ(f.status, FrameStatus::ok);
        expect_equal_buffers("map", 64, f.buffers.lights[0].map.depth,
                             all.frame.buffers.lights[k].map.depth,
                             umbra78::test::Constant::expected);
        const hw::TransformUnit unit(s.machine, f.matrices.lights[0].observer_to_light);
        const std::int64_t edge = (s.machine.half_px() - 1) << s.machine.fraction_bits;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const std::size_t a = f.buffers.observer.address(x, y);
                const std::uint32_t code = f.buffers.observer.depth[a];
                if (code == s.machine.background()) continue;
                const hw::Point p = unit(pixel_words(x, y, code, s));
                if (p.status != hw::DivideStatus::ok || std::abs(p.x) > edge ||
                    std::abs(p.y) > edge)
                    continue;
                ++compared;
                dark += all.mask()[a] != f.buffers.lights[0].mask[a] ? 1 : 0;
            }
    }
    EXPECT_GT(compared, 2000);
    EXPECT_LE(dark, compared / 500);  // the shared exponent rounds some coefficients otherwise
}

TEST(SectoredLight, IsRefusedWhereItIsNotBuilt) {
    const VariantScene made("spheres");
    FrameMatrices matrices;
    for (const auto change : {+[](Settings& s) { s.form = Form::correct; },
                              +[](Settings& s) { s.arithmetic = Arithmetic::ap120b; }}) {
        Settings s = small_sectored();
        change(s);
        EXPECT_EQ(load_matrices(made.scene("front", "bulb"), s, matrices),
                  FrameStatus::sectors_refused);
        EXPECT_EQ(load_matrices(made.scene("front", "left"), s, matrices), FrameStatus::ok);
    }
    Scene five = made.scene("front", "bulb");
    five.light_count = five.sources[0].lights = 5;
    EXPECT_FALSE(five.in_order());
}

// --- what a frame leaves out and keeps -----------------------------------------------------------

void expect_same_planes(const Lit& a, const FrameBuffers<hw::Depth16>& b) {
    test::expect_equal_frames(a.frame.buffers, b, umbra78::test::Constant::expected);
    for (std::size_t l = 1; l < a.scene.light_count; ++l) {
        expect_equal_buffers("light_z", 64, a.frame.buffers.lights[l].map.depth,
                             b.lights[l].map.depth, umbra78::test::Constant::expected);
        expect_equal_buffers("mask", 64, a.frame.buffers.lights[l].mask, b.lights[l].mask,
                             umbra78::test::Constant::expected);
    }
}

// The observer looks at a corner of the scene: some cones hold nothing that it sees.
TEST(SectoredPlan, LeavesOutSectorsAndChangesNoBit) {
    for (const SectorTest test : {SectorTest::classified, SectorTest::every}) {
        Settings s = small_sectored();
        s.sector_test = test;
        Lit all("floor", "front", "bulb + left", s);
        all.scene.observer.target = {-90000, -70000, 0};
        all.scene.observer.extent = 1 << 15;
        ASSERT_EQ(all.frame.draw(all.scene, s), FrameStatus::ok);
        const FramePlan plan = make_plan(all.inputs());
        int left_out = 0;
        for (std::size_t k = 0; k < 6; ++k)
            left_out += plan.leaves_out(Omission::post_process, k) ? 1 : 0;
        EXPECT_GE(left_out, 2);
        EXPECT_LE(left_out, 5);
        test::Frame<> everything(s.machine, all.scene.patches.size(), FrameShape(all.scene));
        draw_frame(all.inputs(), FramePlan{}, everything.buffers, everything.counts);
        expect_same_planes(all, everything.buffers);
    }
}

TEST(SectoredPlan, TheMaskIsKeptWholeOrNotAtAll) {
    const Settings s = small_sectored();
    Lit frame("floor", "front", "bulb + left", s);
    const FrameInputs before = frame.inputs();
    FrameInputs now = before;
    EXPECT_TRUE(make_plan(now, &before).leaves_out(Omission::same_mask, 0));
    now.scene.lights[3].far_depth += 7;  // one map of the six is another
    ASSERT_EQ(load_matrices(now.scene, s, now.matrices), FrameStatus::ok);
    const FramePlan plan = make_plan(now, &before);
    EXPECT_TRUE(plan.leaves_out(Omission::same_light_map, 0));
    EXPECT_FALSE(plan.leaves_out(Omission::same_light_map, 3));
    for (std::size_t k = 0; k < 6; ++k) EXPECT_FALSE(plan.leaves_out(Omission::same_mask, k));
    EXPECT_TRUE(plan.leaves_out(Omission::same_mask, 6));
    draw_frame(now, plan, frame.frame.buffers, frame.frame.counts);
    const test::Frame<> anew(now.scene, s);
    expect_same_planes(frame, anew.buffers);
}

// --- what it costs -------------------------------------------------------------------------------

TEST(SectoredLedger, SixPassesOrOne) {
    Settings s = small_sectored();
    const Lit one("floor", "oblique", "bulb", s);
    s.sector_test = SectorTest::every;
    const Lit six("floor", "oblique", "bulb", s);
    const std::uint64_t pass = one.ledger(0).transformation(true);
    EXPECT_GT(pass, one.visible());
    for (std::size_t l = 0; l < 6; ++l) {
        EXPECT_EQ(one.ledger(l).transformation(true), l == 0 ? pass : 0);
        EXPECT_EQ(six.ledger(l).transformation(true), pass);
    }
    // The sorting itself: six additions a visible pixel.
    EXPECT_EQ(one.ledger(0).test.operations.adds, 6 * one.visible());
    EXPECT_EQ(one.ledger(0).join.operations.adds, 0u);
}

// Six maps and one mask.
TEST(SectoredLedger, MemoryIsSixMaps) {
    const Settings s = small_sectored();
    const Lit one("floor", "oblique", "left", s), bulb("floor", "oblique", "bulb", s);
    const auto bytes = [&](const Scene& scene) {
        return frame_bytes<hw::Depth16>(s.machine, scene.patches.size(), FrameShape(scene));
    };
    EXPECT_EQ(bytes(bulb.scene) - bytes(one.scene), 5 * 64 * 64 * sizeof(hw::Depth16));
}

}  // namespace
}  // namespace umbra78::shadow
