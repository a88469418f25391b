// What is a sink and what is not; when a footprint is hidden; and what a sink is given.
#include "raster/sinks.hpp"
#include "tests/support/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace umbra78::raster {
namespace {

using umbra78::test::Drawing;
using umbra78::test::Patches;

struct Plain {
    static constexpr bool shades = false;
    bool hidden(const Footprint&) const { return false; }
    void sample(const Sample&, std::uint32_t, const auto*) {}
};
struct WithoutShades {
    bool hidden(const Footprint&) const { return false; }
    void sample(const Sample&, std::uint32_t, const auto*) {}
};
struct ShadesAtRunTime : WithoutShades {
    bool shades = false;
};
struct HidesByChanging : Plain {
    bool hidden(const Footprint&) { return false; }
};
struct HidesByNumber : Plain {
    int hidden(const Footprint&) const { return 0; }
};
struct HidesByWindow : Plain {
    bool hidden(int, int, int, int, std::uint32_t) const { return false; }
};
struct AnswersSamples : Plain {
    bool sample(const Sample&, std::uint32_t, const auto*) { return true; }
};
struct WantsShadingAlways : Plain {
    void sample(const Sample&, std::uint32_t, const BlockShading&) {}
};

static_assert(Sink<Plain>);
static_assert(Sink<DepthSink<hw::Depth16>> && Sink<PictureSink<hw::Depth32>>);
static_assert(Sink<umbra78::test::Unhiding<Plain>>);
static_assert(!Sink<int>);
static_assert(!Sink<WithoutShades>);
static_assert(!Sink<ShadesAtRunTime>);
static_assert(!Sink<HidesByChanging>);
static_assert(!Sink<HidesByNumber>);
static_assert(!Sink<HidesByWindow>);
static_assert(!Sink<AnswersSamples>);
static_assert(!Sink<WantsShadingAlways>);

// Nearer in every pixel of the footprint and in no other one hides; equal depth does not.
TEST(Sinks, HideOnlyWhatIsBehindEveryPixelOfTheFootprint) {
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    Drawing<> stage(spec);
    auto store = stage.store();
    const Footprint f{3, 5, 9, 8, 1000, 2000};
    const auto fill = [&](std::uint16_t inside, std::uint16_t outside) {
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                store.depth[store.address(x, y)] =
                    x >= f.x0 && x <= f.x1 && y >= f.y0 && y <= f.y1 ? inside : outside;
    };
    fill(999, 65535);
    EXPECT_TRUE(all_nearer(store, f));
    EXPECT_TRUE(DepthSink<hw::Depth16>{store}.hidden(f));
    EXPECT_TRUE(PictureSink<hw::Depth16>{store}.hidden(f));
    for (const auto& [x, y] : {std::pair{3, 5}, {9, 5}, {3, 8}, {9, 8}, {6, 6}}) {
        fill(999, 0);
        store.depth[store.address(x, y)] = 1000;
        EXPECT_FALSE(all_nearer(store, f)) << "as near at " << x << ", " << y;
    }
    fill(0, 0);
    EXPECT_FALSE(all_nearer(store, Footprint{3, 5, 9, 8, 0, 0})) << "nothing is nearer than 0";
}

// A sample's level and normal, as a block's or facet's shading gives them.
struct GivenShading {
    std::uint8_t level;
    UnitVector kept;
    Shades shade(const Sample&, Shadowed) const {
        Shades all{};
        all[0].intensity = level;
        return all;
    }
    UnitVector normal(const Sample&) const { return kept; }
};

// The normal is the last part of the record: it goes with the nearest sample, the darkest of the
// nearest, and decides by its x, then y, then z alone where all else is equal.
TEST(Sinks, TheNormalIsTheRecordsLastPart) {
    const std::array<std::pair<std::uint32_t, GivenShading>, 6> in_order{
        {{100, {10, {-16384, 0, 0}}},
         {100, {10, {-16384, 0, 1}}},
         {100, {10, {-16384, 1, -9}}},
         {100, {10, {5, -7, 0}}},
         {100, {11, {-16384, -9, -9}}},
         {101, {9, {-16384, -9, -9}}}}};
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    for (std::size_t first = 0; first < in_order.size(); ++first)
        for (std::size_t second = 0; second < in_order.size(); ++second) {
            std::vector<hw::Depth16> depth(256);
            std::vector<std::uint8_t> intensity(256), direct(256);
            std::vector<hw::NormalWord> normal(3 * 256);
            hw::FrameStore<hw::Depth16> store{4, depth, intensity, direct, normal};
            store.clear(spec);
            EXPECT_EQ(store.normal_at(17, 2), 0) << "none";
            PictureSink<hw::Depth16> sink{store};
            const Sample s{1, 1, 0, 0, 0, 0, 0};
            for (const std::size_t k : {first, second})
                sink.sample(s, in_order[k].first, &in_order[k].second);
            const auto& [code, kept] = in_order[std::min(first, second)];
            EXPECT_EQ(store.depth[17], code);
            EXPECT_EQ(store.intensity[17], kept.level);
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_EQ(store.normal_at(17, axis), kept.kept[axis])
                    << first << " then " << second;
        }
}

// Every sample lies in its block's footprint, in pixels and in depth, and its shading is that of
// its block where the sink shades.
struct Watcher {
    static constexpr bool shades = true;
    Footprint current{};
    int samples = 0, astray = 0, unshaded = 0;
    std::uint32_t nearest = UINT32_MAX, farthest = 0;
    mutable Footprint next{};
    bool hidden(const Footprint& f) const {
        next = f;
        return false;
    }
    void sample(const Sample& s, std::uint32_t code, const auto* shading) {
        ++samples;
        const bool in = s.px >= next.x0 && s.px <= next.x1 && s.py >= next.y0 &&
                        s.py <= next.y1 && code >= next.nearest && code <= next.farthest;
        astray += in ? 0 : 1;
        unshaded += shading == nullptr ? 1 : 0;
    }
};
struct DepthWatcher : Watcher {
    static constexpr bool shades = false;
};

TEST(Footprint, HoldsEverySampleOfItsBlock) {
    const hw::MachineSpec spec;
    Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(-1.6, 1.5, 0, 0.8));
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0.6, -0.5, 0.7, 0.7));
    patches.push_back(plane_patch(umbra78::test::plane({-3, -1, -3}, {6, 0.3, 0}, {0, 0.2, 6})));
    const auto memory = std::make_unique<DrawMemory>();
    const std::vector<Material> materials(1);
    for (const View& view : {umbra78::test::orthographic(15, 20, 1.5),
                             umbra78::test::perspective(15, 20, 1.5, 6, 1, 12)}) {
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
            const hw::WordFormat object = object_format(patches);
            DrawSetup setup{spec, {}, object, sampling, materials, {}};
            ASSERT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
            Watcher watcher;
            const DrawCounts counts = draw(patches, {}, setup, *memory, watcher);
            EXPECT_GT(watcher.samples, 10000);
            EXPECT_EQ(counts.samples, static_cast<std::uint64_t>(watcher.samples));
            EXPECT_EQ(watcher.astray, 0);
            EXPECT_EQ(watcher.unshaded, 0);
            DepthWatcher depth;
            draw(patches, {}, setup, *memory, depth);
            EXPECT_EQ(depth.unshaded, watcher.samples) << "no shading where the sink has no use";
            for (const Patch& p : patches) {
                Footprint f{-1, -1, -1, -1, 0, 0};
                Watcher alone;
                draw(std::span(&p, 1), {}, setup, *memory, alone);
                const Visibility v = patch_footprint(p, setup.matrix, spec, object, f);
                if (v != Visibility::outside) continue;
                EXPECT_EQ(alone.samples, 0);
            }
        }
    }
}

TEST(Draw, TrapsOnAnOrderOrAMaterialThatIsNotThere) {
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    const Patches patches{plane_patch(umbra78::test::plane({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}))};
    const View view = umbra78::test::orthographic(0, 0, 2);
    Drawing<> stage(spec);
    const std::array<std::uint32_t, 2> order{0, 0};
    EXPECT_DEATH(stage.draw(patches, view, Sampling::centre, nullptr, order), "");
    stage.materials.clear();
    EXPECT_DEATH(stage.draw(patches, view, Sampling::centre, &view), "");
    EXPECT_GT(stage.draw(patches, view, Sampling::centre).samples, 0u) << "no material is needed";
}

Bounds between(std::int64_t min, std::int64_t max) { return {min, max, 0, 0, 0, 0}; }

// The definition, at the ends of pixels and quanta: a slack of 128 units and a quantum.
TEST(Footprint, IsTheBoundsWithTheSlackAndAQuantum) {
    hw::MachineSpec spec;  // 256 pixels are half the frame; a quantum is 64 units
    const auto of = [&](std::int64_t min, std::int64_t max, std::int64_t z0, std::int64_t z1) {
        return footprint({between(min, max), between(min - 8192, max + 8192), between(z0, z1)},
                         spec);
    };
    Footprint f = of(128, 8191 - 128, 0, 0);
    EXPECT_EQ(f.x0, 256) << "the pixel right of the centre";
    EXPECT_EQ(f.x1, 256);
    EXPECT_EQ(f.y0, 255);
    EXPECT_EQ(f.y1, 257);
    EXPECT_EQ(f.nearest, 32767u) << "a quantum nearer";
    EXPECT_EQ(f.farthest, 32769u) << "a quantum farther";
    f = of(127, 8191 - 127, 31, 32);
    EXPECT_EQ(f.x0, 255) << "the slack reaches the pixel before";
    EXPECT_EQ(f.x1, 257);
    EXPECT_EQ(f.nearest, 32767u);
    EXPECT_EQ(f.farthest, 32770u) << "half a quantum rounds up";
    f = of(-256 * 8192 - 9000, 256 * 8192 + 9000, -32768 * 64, 32767 * 64);
    EXPECT_EQ(f.x0, 0);
    EXPECT_EQ(f.x1, 511);
    EXPECT_EQ(f.nearest, 0u) << "before the near plane";
    EXPECT_EQ(f.farthest, 65534u) << "beyond the far plane";
    f = of(0, 0, -32767 * 64, 32765 * 64);
    EXPECT_EQ(f.nearest, 0u);
    EXPECT_EQ(f.farthest, 65534u);
    f = of(0, 0, -32766 * 64, 32764 * 64);
    EXPECT_EQ(f.nearest, 1u);
    EXPECT_EQ(f.farthest, 65533u);
}

TEST(Footprint, OfAPatchIsItsBlocksOrTheFrame) {
    hw::MachineSpec spec;
    spec.coefficient_bits = 24;
    const View view = umbra78::test::perspective(0, 0, 2, 5, 1, 20);
    const auto of = [&](const Patch& p, const View& v, Footprint& f) {
        const hw::WordFormat object = object_format(std::span(&p, 1));
        MatrixWords m;
        EXPECT_EQ(load_view(v, spec, object, m), hw::LoadStatus::ok);
        return patch_footprint(p, m, spec, object, f);
    };
    using umbra78::test::plane;
    Footprint f{};
    const Patch through = plane_patch(plane({-1, 0, 9}, {2, 0, 0}, {0, 0, -9}));
    EXPECT_EQ(of(through, view, f), Visibility::unknown) << "it passes the eye";
    const Footprint whole = whole_frame(spec);
    EXPECT_TRUE(f.x0 == 0 && f.y0 == 0 && f.x1 == 511 && f.y1 == 511);
    EXPECT_TRUE(f.nearest == 0 && f.farthest == 65534);
    EXPECT_TRUE(whole.x1 == 511 && whole.y1 == 511 && whole.farthest == 65534);
    EXPECT_EQ(of(plane_patch(plane({-1, 0, 9}, {2, 0, 0}, {0, 2, 0})), view, f),
              Visibility::outside) << "behind the eye";
    EXPECT_EQ(of(plane_patch(plane({9, 0, 0}, {2, 0, 0}, {0, 2, 0})), view, f),
              Visibility::outside) << "right of the frame";
    EXPECT_EQ(of(plane_patch(plane({0.5, 0.5, 0}, {0.5, 0, 0}, {0, 0.5, 0})), view, f),
              Visibility::bounded);
    // Pixels 320 to 384; the bounds lie equally far to either side of the first corner.
    EXPECT_TRUE(f.x0 >= 254 && f.x0 <= 256 && f.x1 >= 384 && f.x1 <= 386) << f.x0 << ", " << f.x1;
    const View flat = umbra78::test::orthographic(0, 0, 2);
    EXPECT_EQ(of(plane_patch(plane({0.5, 0.5, 0}, {0.5, 0, 0}, {0, 0.5, 0})), flat, f),
              Visibility::bounded);
    EXPECT_TRUE(f.x0 == 319 && f.x1 == 384 && f.y0 == 127 && f.y1 == 192);
    EXPECT_TRUE(f.nearest == 32767 && f.farthest == 32769);
    EXPECT_EQ(of(plane_patch(plane({2.1, 0, 0}, {1, 0, 0}, {0, 1, 0})), flat, f),
              Visibility::outside);
}

}  // namespace
}  // namespace umbra78::raster
