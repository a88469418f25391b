// form = ground: exact areas on scenes made by hand. The floor is y = 0, seen from straight above
// by an orthographic view of 64 x 64 pixels, 8 pixels a unit, so that the pixel of a place on it,
// and whether a shadow covers its centre, can be counted.
#include "shadow/frame/ledger.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/trapped.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace umbra78::shadow {
namespace {

constexpr std::int32_t one = 65536;

// A rectangle parallel to the floor, [x0, x1] x [z0, z1] at a height, in eighths of a unit: pixels.
struct Slab {
    int x0, x1, z0, z1, y;
};

raster::Patch patch_of(const Slab& s) {
    const auto at = [](int eighths) { return eighths * (one / 8); };
    return raster::plane_patch(
        {{at(s.x0), at(s.y), at(s.z0)}, {at(s.x1 - s.x0), 0, 0}, {0, 0, at(s.z1 - s.z0)}, 0});
}

struct GroundScene {
    std::vector<raster::Patch> patches;
    raster::View light{};
    std::size_t ground = 0;

    // The ground first: [-24, 24] x [-24, 24] pixels of the 64.
    explicit GroundScene(const std::vector<Slab>& slabs, Slab floor = {-24, 24, -24, 24, 0}) {
        patches.push_back(patch_of(floor));
        for (const Slab& slab : slabs) patches.push_back(patch_of(slab));
    }
    // At infinity, so that a height of one unit moves a shadow by so many units; atan 1 is 45.
    void sun(int azimuth, int elevation) {
        light.projection = raster::Projection::orthographic;
        light.axes = raster::axes_from_angles(azimuth * one, elevation * one);
        light.extent = 8 * one;
        light.near_depth = -8 * one;
        light.far_depth = 8 * one;
    }
    // A lamp over the origin, so many eighths of a unit high.
    void lamp(int height) {
        light.projection = raster::Projection::perspective;
        light.extent = 8 * one;
        light.distance = height * (one / 8);
        ASSERT_TRUE(raster::axes_from_points({0, light.distance, 0}, {0, 0, 0}, light.axes));
        light.near_depth = one / 16;
        light.far_depth = 16 * one;
    }
    Scene scene() const {
        static constexpr std::array<raster::Material, 1> material{};
        raster::View observer;
        observer.axes = raster::axes_from_angles(0, 90 * one);
        observer.extent = 4 * one;
        observer.near_depth = -4 * one;
        observer.far_depth = 4 * one;
        Scene made{patches, material, observer, {{light}}};
        made.ground = ground;
        return made;
    }
    static Settings settings() {
        Settings s;
        s.form = Form::ground;
        s.machine.xy_bits = 6;
        s.machine.z_bits = 13;
        return s;
    }
};

using Dark = std::function<bool(int x, int z)>;

// The mask is dark where `expected` says, of the pixel whose middle is (x + 1/2, z + 1/2) pixels
// from the origin; prints the first that is not. Returns how many are dark.
int expect_mask(const GroundScene& scene, const Dark& expected) {
    const Settings s = GroundScene::settings();
    const test::Frame<> f(scene.scene(), s);
    EXPECT_EQ(f.status, FrameStatus::ok);
    int dark = 0;
    for (int py = 0; py < 64; ++py)
        for (int px = 0; px < 64; ++px) {
            const int value = f.buffers.lights[0].mask[static_cast<std::size_t>(64 * py + px)];
            const int wanted = expected(px - 32, py - 32) ? 255 : 0;
            EXPECT_EQ(value, wanted) << "pixel " << px << ", " << py;
            if (value != wanted) return -1;
            dark += value == 255;
        }
    const PostProcessCounts& counted = f.counts.lights[0].post_process;
    EXPECT_EQ(counted.shadowed, static_cast<std::uint64_t>(dark));
    const auto& depth = f.buffers.observer.depth;
    const auto none = std::count(depth.begin(), depth.end(), s.machine.background());
    if (counted.visible != 0) {  // nothing is counted where the plan leaves the shadow out
        EXPECT_EQ(counted.visible, depth.size() - static_cast<std::size_t>(none));
    }
    EXPECT_LE(counted.shadowed, counted.visible);
    return dark;
}

bool inside(int v, int from, int to) { return v >= from && v < to; }
Dark rectangle(int x0, int x1, int z0, int z1) {
    return [=](int x, int z) { return inside(x, x0, x1) && inside(z, z0, z1); };
}

// From azimuth -90 (the left) at 45 degrees the shadow of what is h high lies h to the right.
TEST(Ground, ASquaresShadowUnderADirectionalLight) {
    GroundScene scene({{-8, 0, -4, 4, 16}});
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, rectangle(8, 16, -4, 4)), 64);
    // Half as steep again from behind: the square hides a part of it.
    scene = GroundScene({{-8, 0, -4, 4, 6}});
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, rectangle(0, 6, -4, 4)), 48);
}

// At half the lamp's height all is twice as large: similar triangles.
TEST(Ground, ASquaresShadowUnderALamp) {
    GroundScene scene({{2, 6, 1, 5, 16}});
    scene.lamp(32);
    EXPECT_EQ(expect_mask(scene, [](int x, int z) {
                  const bool shadow = inside(x, 4, 12) && inside(z, 2, 10);
                  return shadow && !(inside(x, 2, 6) && inside(z, 1, 5));
              }),
              64 - 2 * 3);
}

TEST(Ground, WhatIsBehindTheLampCastsNothing) {
    GroundScene scene({{2, 6, 1, 5, 40}, {-4, -2, -4, -2, 32}});
    scene.lamp(32);
    EXPECT_EQ(expect_mask(scene, [](int, int) { return false; }), 0);
    // A wall from the floor to above the lamp casts by its lower part: the shadow goes to the edge,
    // and there is no anti-shadow on the lamp's other side.
    scene.patches[1] = raster::plane_patch({{one, 0, -one / 2}, {0, 6 * one, 0}, {0, 0, one}, 0});
    scene.patches.resize(2);
    const test::Frame<> f(scene.scene(), GroundScene::settings());
    int right = 0, left = 0;
    for (std::size_t a = 0; a < 64 * 64; ++a)
        (a % 64 < 32 ? left : right) += f.buffers.lights[0].mask[a] == 255;
    EXPECT_EQ(left, 0);
    EXPECT_GT(right, 8 * 16);
    // Along the axis it is dark from the wall's foot to the ground's edge.
    for (std::size_t x = 41; x < 56; ++x)
        EXPECT_EQ(f.buffers.lights[0].mask[64 * 32 + x], 255) << x;
}

TEST(Ground, WhatIsBelowItCastsNothing) {
    GroundScene scene({{-8, 0, -4, 4, -8}});
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, [](int, int) { return false; }), 0);
    // Of a wall through the ground the upper part casts, 8 pixels of its 16.
    scene.patches[1] =
        raster::plane_patch({{0, -one, -one / 2}, {0, 2 * one, 0}, {0, 0, one}, 0});
    EXPECT_EQ(expect_mask(scene, rectangle(0, 8, -4, 4)), 64);
}

// The mask is filled once, so the picture is as dark under both as under one.
TEST(Ground, TwoCastersDarkenOnce) {
    GroundScene scene({{-8, 0, -4, 4, 16}, {-12, -4, -2, 2, 20}});
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, rectangle(8, 16, -4, 4)), 64);
    const test::Frame<> f(scene.scene(), GroundScene::settings());
    const FrameBuffers<hw::Depth16>& b = f.buffers;
    EXPECT_EQ(b.picture[64 * 32 + 32 + 10], b.picture[64 * 28 + 32 + 10]) << "both, and one";
    EXPECT_LT(b.picture[64 * 32 + 32 + 10], b.picture[64 * 32 + 32 + 20]);
}

TEST(Ground, NoShadowLeavesIt) {
    GroundScene scene({{8, 16, -4, 4, 12}});  // shadow 20 .. 28, ground to 24
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, rectangle(20, 24, -4, 4)), 32);
    scene.ground = 1;  // another plane is the ground, above all else: it is lit
    EXPECT_EQ(expect_mask(scene, [](int, int) { return false; }), 0);
}

// Nothing but the ground is dark: not what stands before its shadow, and not another plane.
TEST(Ground, WhatIsBeforeAShadowIsLit) {
    GroundScene scene({{-8, 0, -4, 4, 16}, {10, 12, -1, 1, 2}});
    scene.sun(-90, 45);
    EXPECT_EQ(expect_mask(scene, [](int x, int z) {
                  return inside(x, 8, 16) && inside(z, -4, 4) &&
                         !(inside(x, 10, 12) && inside(z, -1, 1));
              }),
              64 - 4);
}

// The picture's other planes are those of any other form, whichever patch is the ground; and the
// mask does not depend on the order of the others.
TEST(Ground, TheOrderOfTheOthersDoesNotMatter) {
    GroundScene scene({{-8, 0, -4, 4, 16}, {10, 12, -1, 1, 2}, {-20, -10, -20, 20, 8}});
    scene.sun(-70, 40);
    Settings s = GroundScene::settings();
    const test::Frame<> f(scene.scene(), s);
    GroundScene turned = scene;
    std::reverse(turned.patches.begin(), turned.patches.end());
    turned.ground = 3;
    const test::Frame<> g(turned.scene(), s);
    test::expect_equal_frames(f.buffers, g.buffers);
    s.form = Form::post_process;
    const test::Frame<> p(scene.scene(), s);
    const auto equal = [](auto a, auto b) { return std::ranges::equal(a, b); };
    EXPECT_TRUE(equal(f.buffers.observer.depth, p.buffers.observer.depth));
    EXPECT_TRUE(equal(f.buffers.observer.intensity, p.buffers.observer.intensity));
    EXPECT_TRUE(equal(f.buffers.observer.direct, p.buffers.observer.direct));
}

TEST(Ground, EachLightHasItsOwnShadow) {
    GroundScene scene({{-4, 4, -4, 4, 12}});
    scene.sun(-90, 45);
    Scene two = scene.scene();
    scene.sun(90, 45);
    two.lights[1] = scene.light;
    two.light_count = 2;
    const test::Frame<> f(two, GroundScene::settings());
    ASSERT_EQ(f.status, FrameStatus::ok);
    for (int x = -32; x < 32; ++x) {
        const auto a = static_cast<std::size_t>(64 * 32 + 32 + x);
        EXPECT_EQ(f.buffers.lights[0].mask[a], inside(x, 8, 16) ? 255 : 0) << x;
        EXPECT_EQ(f.buffers.lights[1].mask[a], inside(x, -16, -8) ? 255 : 0) << x;
    }
}

// An ellipse of 10 by 6 pixels about the middle, of which a slab before it hides a corner. Centres
// within a twentieth of the rim may go either way (the slack of drawing), and there are none.
TEST(Ground, ABlobIsAnEllipseWhateverTheLight) {
    GroundScene scene({{4, 12, 2, 8, 2}});
    const raster::Ellipse blob{{0, 0, 0}, {10 * one / 8, 0, 0}, {0, 0, -6 * one / 8}};
    Settings s = GroundScene::settings();
    s.form = Form::blob;
    int dark = 0;
    for (const int light : {0, 1, 2}) {
        scene.sun(-90, 45);
        if (light == 1) scene.lamp(1);
        if (light == 2) scene.sun(-90, 0);  // in the ground, and no matter
        Scene made = scene.scene();
        made.blobs = {&blob, 1};
        const test::Frame<> f(made, s);
        ASSERT_EQ(f.status, FrameStatus::ok);
        dark = 0;
        for (int z = -32; z < 32; ++z)
            for (int x = -32; x < 32; ++x) {
                const double u = (x + 0.5) / 10, v = (z + 0.5) / 6, r = u * u + v * v;
                ASSERT_GT(std::abs(r - 1), 0.01) << x << ", " << z;
                const bool wanted = r < 1 && !(inside(x, 4, 12) && inside(z, 2, 8));
                const auto a = static_cast<std::size_t>(64 * (z + 32) + x + 32);
                EXPECT_EQ(f.buffers.lights[0].mask[a], wanted ? 255 : 0) << x << ", " << z;
                dark += wanted;
            }
        const FrameLedger l =
            frame_ledger(FrameInputs{made, s, f.matrices}, f.buffers, f.counts);
        EXPECT_EQ(l.light_counts.patches, 8u);
        EXPECT_EQ(l.light_counts.samples, f.counts.lights[0].map.samples);
    }
    EXPECT_GT(dark, 120);
}

// The light's map is not there, and everything else is; the ledger's drawing is the shadow's.
TEST(Ground, HasNoMapAndPaysForNone) {
    GroundScene scene({{-8, 0, -4, 4, 16}});
    scene.sun(-90, 45);
    Settings s = GroundScene::settings();
    const std::size_t without = frame_bytes<hw::Depth16>(s.machine, 2, FrameShape(map_layers(s)));
    const test::Frame<> f(scene.scene(), s);
    const FrameLedger l = frame_ledger(FrameInputs{scene.scene(), s, f.matrices}, f.buffers,
                                       f.counts);
    EXPECT_EQ(l.light_counts.patches, 1u) << "the ground casts none";
    EXPECT_EQ(l.light_counts.samples, f.counts.lights[0].map.samples);
    EXPECT_EQ(l.observer_counts.patches, 2u);
    EXPECT_EQ(l.test.operations.accesses, l.observer_counts.samples);
    EXPECT_EQ(l.transformation(true), l.observer_counts.samples);
    EXPECT_EQ(l.post_process.total, 0u);
    EXPECT_EQ(l.total(true), FrameLedger::cycles(l.light, true) +
                                 FrameLedger::cycles(l.observer, true) +
                                 l.observer_counts.samples + l.filters(true));
    s.form = Form::post_process;
    EXPECT_EQ(frame_bytes<hw::Depth16>(s.machine, 2, FrameShape(map_layers(s))),
              without + 64 * 64 * sizeof(hw::Depth16));
}

TEST(Ground, IsRefusedWhereThereIsNone) {
    GroundScene scene({{-8, 0, -4, 4, 16}});
    scene.sun(-90, 45);
    FrameMatrices m;
    const Settings s = GroundScene::settings();
    Scene none = scene.scene();
    EXPECT_EQ(load_matrices(none, s, m), FrameStatus::ok);
    none.ground = Scene::no_ground;
    EXPECT_EQ(load_matrices(none, s, m), FrameStatus::no_ground);
    none.ground = 2;
    EXPECT_EQ(load_matrices(none, s, m), FrameStatus::no_ground);
    none.ground = 0;
    none.streamed = true;
    EXPECT_EQ(load_matrices(none, s, m), FrameStatus::no_ground) << "a stream is not held";
    scene.sun(-90, 0);
    EXPECT_EQ(load_matrices(scene.scene(), s, m), FrameStatus::light_in_ground);
    scene.light.axes.back[1] = 1;  // the least elevation there is: its matrix fits no words
    EXPECT_EQ(load_matrices(scene.scene(), s, m), FrameStatus::light_matrix);
    scene.lamp(8);
    scene.light.distance = 0;  // in the ground
    EXPECT_EQ(load_matrices(scene.scene(), s, m), FrameStatus::light_in_ground);
}

}  // namespace
}  // namespace umbra78::shadow
