// The frame: its memory, the order of its stages, and what must not change any of its bits.
#include "shadow/frame/frame.hpp"

#include "raster/sinks.hpp"
#include "shadow/filters/composite.hpp"
#include "shadow/filters/low_pass.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/frame/equal_frames.hpp"
#include "tests/shadow/frame/figure_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using raster::Patch;
using test::expect_equal_frames;
using test::FigureScene;
using test::Frame;
using umbra78::test::expect_equal_buffers;

void expect_equal_counts(const FrameCounts& a, const FrameCounts& b) {
    const auto drawn = [](const raster::DrawCounts& x, const raster::DrawCounts& y) {
        EXPECT_EQ(x.patches, y.patches);
        EXPECT_EQ(x.blocks, y.blocks);
        EXPECT_EQ(x.samples, y.samples);
        EXPECT_EQ(x.hidden_blocks, y.hidden_blocks);
        EXPECT_EQ(x.unresolved, y.unresolved);
    };
    drawn(a.lights[0].map, b.lights[0].map);
    drawn(a.observer, b.observer);
    const LightCounts &x = a.lights[0], &y = b.lights[0];
    EXPECT_EQ(x.post_process.visible, y.post_process.visible);
    EXPECT_EQ(x.post_process.shadowed, y.post_process.shadowed);
    EXPECT_EQ(x.chain_steps, y.chain_steps);
}

// --- memory -------------------------------------------------------------------------------------

TEST(FrameMemory, IsUnderThreeAndFourTenthsMebibytes) {
    const std::size_t bytes = frame_bytes<hw::Depth16>(hw::MachineSpec{}, FigurePatches{}.size());
    std::printf("a 512 x 512 frame of %zu patches: %zu bytes\n", FigurePatches{}.size(), bytes);
    EXPECT_EQ(bytes, 3489664u);  // the README's number
    EXPECT_LT(bytes, (34u << 20) / 10);
    EXPECT_LT(frame_bytes<hw::Depth16>(hw::MachineSpec{}, 10000), 14u << 18);
}

// Buffers lie within the memory, aligned, apart from each other, and nothing lies beyond.
TEST(FrameMemory, IsCarvedWithoutOverlap) {
    for (const int xy : {4, 5, 9}) {
        hw::MachineSpec spec;
        spec.xy_bits = xy;
        const std::size_t patches = 7, bytes = frame_bytes<hw::Depth16>(spec, patches);
        test::Memory memory(bytes);
        const FrameBuffers<hw::Depth16> f = carve<hw::Depth16>(memory.span(), spec, patches);
        std::vector<std::pair<const std::byte*, const std::byte*>> pieces;
        const auto add = [&](const auto& span) {
            const auto raw = std::as_bytes(std::span(span.data(), span.size()));
            pieces.push_back({raw.data(), raw.data() + raw.size()});
        };
        add(f.observer.depth);
        add(f.observer.intensity);
        add(f.observer.direct);
        add(f.lights[0].map.depth);
        add(f.lights[0].mask);
        add(f.lights[0].edges);
        add(f.lights[0].filtered);
        add(f.picture);
        add(f.edge_memory.visited);
        add(f.edge_memory.coverage);
        add(f.order);
        add(f.nearest);
        add(std::span(f.draw, 1));
        add(std::span(f.rows, 1));
        EXPECT_TRUE(f.lights[0].map.intensity.empty());
        EXPECT_EQ(f.lights[0].mask.size(), spec.xy_bits == 9 ? 262144u : 1u << (2 * xy));
        EXPECT_EQ(f.order.size(), patches);
        std::sort(pieces.begin(), pieces.end());
        EXPECT_GE(pieces.front().first, memory.span().data());
        EXPECT_LE(pieces.back().second, memory.span().data() + bytes);
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pieces[k].first) % 64, 0u);
            EXPECT_TRUE(k == 0 || pieces[k - 1].second <= pieces[k].first) << k;
        }
    }
}

TEST(FrameMemoryDeathTest, TooLittleTraps) {
    const hw::MachineSpec spec;
    const std::size_t bytes = frame_bytes<hw::Depth16>(spec, 128);
    test::Memory memory(bytes);
    EXPECT_DEATH(carve<hw::Depth16>(memory.span().first(bytes - 1), spec, 128), "");
    EXPECT_DEATH(carve<hw::Depth16>(memory.span(), spec, 129 + 64), "");
    EXPECT_DEATH(carve<hw::Depth32>(memory.span(), spec, 128), "");
}

// A frame carved for more patches than are drawn has room to spare; for fewer it traps.
TEST(FrameMemory, MayBeCarvedForMorePatches) {
    const FigureScene figures;
    const Settings s = figure_settings(6);
    const Frame<> exact(figures.scene(), s);
    Frame<> roomy(s.machine, figures.patches.size() + 1000);
    ASSERT_EQ(roomy.draw(figures.scene(), s), FrameStatus::ok);
    expect_equal_frames(exact.buffers, roomy.buffers);
    expect_equal_counts(exact.counts, roomy.counts);
}

TEST(FrameMemoryDeathTest, MorePatchesThanCarvedForTrap) {
    const FigureScene figures;
    Settings s;
    s.machine.xy_bits = 4;
    Frame<> frame(s.machine, figures.patches.size() - 1);
    EXPECT_DEATH(frame.draw(figures.scene(), s), "");
}

// --- stages -------------------------------------------------------------------------------------

Settings filtered_settings() {
    Settings s = figure_settings(6);
    s.low_pass_passes = 2;
    return s;
}

TEST(Frame, StagesOneByOneAreRender) {
    const FigureScene figures;
    for (Settings s : {figure_settings(3), figure_settings(6), filtered_settings()})
        for (const Form form : {Form::post_process, Form::correct}) {
            s.form = form;
            s.machine.xy_bits = 8;
            const Frame<> whole(figures.scene(), s);
            Frame<> parts(s.machine, figures.patches.size());
            const Scene scene = figures.scene();
            ASSERT_EQ(load_matrices(scene, s, parts.matrices), FrameStatus::ok);
            const FrameInputs in{scene, s, parts.matrices};
            const FramePlan plan = make_plan(in);
            draw_light(in, plan, parts.buffers, parts.counts);
            draw_observer(in, plan, parts.buffers, parts.counts);
            cast_shadows(in, plan, parts.buffers, parts.counts);
            filter_and_composite(in, plan, parts.buffers, parts.counts);
            expect_equal_frames(whole.buffers, parts.buffers);
            expect_equal_counts(whole.counts, parts.counts);
            // A stage that runs again on its own results changes nothing.
            cast_shadows(in, plan, parts.buffers, parts.counts);
            filter_and_composite(in, plan, parts.buffers, parts.counts);
            expect_equal_frames(whole.buffers, parts.buffers);
        }
}

// Each filter's buffer is the filter's, of the buffer before it.
TEST(Frame, FiltersFollowEachOther) {
    const FigureScene figures;
    const Settings s = filtered_settings();
    const Frame<> frame(figures.scene(), s);
    const auto none = static_cast<hw::Depth16>(s.machine.background());
    const std::size_t n = frame.buffers.lights[0].mask.size();
    std::vector<std::uint8_t> edges(n), once(n), twice(n), picture(n);
    std::vector<std::uint32_t> visited(edge_visited_words(9));
    std::vector<std::int16_t> coverage(edge_coverage_words(9));
    const std::span<const std::uint8_t> mask = frame.buffers.lights[0].mask;
    const std::uint64_t steps = dequantize(mask, frame.buffers.observer, none, s.dequantize_passes,
                                           {visited, coverage}, edges);
    low_pass<hw::Depth16>(edges, frame.buffers.observer, none, once);
    low_pass<hw::Depth16>(once, frame.buffers.observer, none, twice);
    const hw::FrameStore<hw::Depth16>& drawn = frame.buffers.observer;
    composite(drawn.intensity, drawn.direct, twice, s.density_q8, picture);
    expect_equal_buffers("edges", 512, edges, frame.buffers.lights[0].edges);
    expect_equal_buffers("filtered", 512, twice, frame.buffers.lights[0].filtered);
    expect_equal_buffers("picture", 512, picture, frame.buffers.picture);
    EXPECT_EQ(steps, frame.counts.lights[0].chain_steps);
    EXPECT_GT(steps, 1000u);

    Settings darkens_all = s;
    darkens_all.composite = Composite::whole;
    composite(drawn.intensity, drawn.intensity, twice, s.density_q8, picture);
    expect_equal_buffers("picture darkened as a whole", 512, picture,
                         Frame<>(figures.scene(), darkens_all).buffers.picture);

    const Frame<> bare(figures.scene(), figure_settings(4));
    expect_equal_buffers("edges off", 512, bare.buffers.lights[0].mask,
                         bare.buffers.lights[0].edges);
    expect_equal_buffers("low-pass off", 512, bare.buffers.lights[0].mask,
                         bare.buffers.lights[0].filtered);
    EXPECT_EQ(bare.counts.lights[0].chain_steps, 0u);
}

TEST(Frame, NothingIsLeftFromTheFrameBefore) {
    const FigureScene figures;
    FigureScene other;  // one patch in two, another light, every other choice
    std::vector<Patch> half;
    for (std::size_t k = 0; k < other.patches.size(); k += 2) half.push_back(other.patches[k]);
    Scene between = other.scene(70 << 16);
    between.patches = half;
    Settings odd = filtered_settings();
    odd.form = Form::correct;
    odd.sampling = raster::Sampling::leaf;
    odd.bias_q16 = -(300 << 16);

    for (const Settings& s : {figure_settings(3), figure_settings(6)}) {
        const Frame<> fresh(figures.scene(), s);
        Frame<> used(figures.scene(), s);
        ASSERT_EQ(used.draw(between, odd), FrameStatus::ok);
        EXPECT_FALSE(std::ranges::equal(used.buffers.picture, fresh.buffers.picture));
        ASSERT_EQ(used.draw(figures.scene(), s), FrameStatus::ok);
        expect_equal_frames(fresh.buffers, used.buffers);
        expect_equal_counts(fresh.counts, used.counts);
    }
}

// What the memory held before is of no account.
TEST(Frame, MemoryNeedNotBeCleared) {
    const FigureScene figures;
    const Settings s = figure_settings(6);
    const std::size_t bytes = frame_bytes<hw::Depth16>(s.machine, figures.patches.size());
    const Frame<> expected(figures.scene(), s);
    for (const int fill : {0x00, 0xff, 0x5a}) {
        const test::Memory memory(bytes, static_cast<std::byte>(fill));
        auto buffers = carve<hw::Depth16>(memory.span(), s.machine, figures.patches.size());
        FrameMatrices matrices;
        FrameCounts counts;
        ASSERT_EQ(render(figures.scene(), s, buffers, matrices, counts), FrameStatus::ok);
        expect_equal_frames(expected.buffers, buffers);
    }
}

TEST(Frame, AnEmptySceneIsAllBackground) {
    const FigureScene figures;
    Scene empty = figures.scene();
    empty.patches = {};
    for (const Form form : {Form::post_process, Form::correct}) {
        Settings s = figure_settings(6);
        s.form = form;
        s.machine.xy_bits = 6;
        const Frame<> frame(empty, s);
        ASSERT_EQ(frame.status, FrameStatus::ok);
        const auto all = [](const auto& plane, auto value) {
            return std::all_of(plane.begin(), plane.end(), [&](auto v) { return v == value; });
        };
        EXPECT_TRUE(all(frame.buffers.observer.depth, 65535));
        EXPECT_TRUE(all(frame.buffers.lights[0].map.depth, 65535));
        EXPECT_TRUE(all(frame.buffers.observer.intensity, 0));
        EXPECT_TRUE(all(frame.buffers.lights[0].mask, 0));
        EXPECT_TRUE(all(frame.buffers.lights[0].filtered, 0));
        EXPECT_TRUE(all(frame.buffers.picture, 0));
        EXPECT_EQ(frame.counts.lights[0].post_process.visible, 0u);
        EXPECT_EQ(frame.counts.lights[0].chain_steps, 0u);
    }
}

TEST(Frame, SaysWhatCannotBeLoaded) {
    const FigureScene figures;
    FrameMatrices matrices;
    const auto status = [&](const Scene& scene, const Settings& s) {
        return load_matrices(scene, s, matrices);
    };
    const Scene scene = figures.scene();
    Settings s;
    EXPECT_EQ(status(scene, s), FrameStatus::ok);
    s.machine.xy_bits = 13;
    EXPECT_EQ(status(scene, s), FrameStatus::spec_out_of_range);
    s = {};
    s.machine.multipliers = 2;
    EXPECT_EQ(status(scene, s), FrameStatus::spec_out_of_range);
    s = {};
    s.bias_q16 = std::int64_t{1} << 40;
    EXPECT_EQ(status(scene, s), FrameStatus::ok);
    s.bias_unit = BiasUnit::world;
    EXPECT_EQ(status(scene, s), FrameStatus::ok) << "2^24 units are 2^38 quanta";
    s.bias_q16 = INT64_MAX / 2;
    EXPECT_EQ(status(scene, s), FrameStatus::bias_out_of_range);
    s = {};
    s.bias_q16 = INT64_MAX;  // 2^47 quanta fit their word, but no row exponent
    EXPECT_EQ(status(scene, s), FrameStatus::shadow_matrix);
    s = {};
    Scene extreme = scene;
    extreme.observer.far_depth = extreme.observer.near_depth + 1;
    extreme.observer.target.z = INT32_MAX;
    EXPECT_EQ(status(extreme, s), FrameStatus::observer_matrix);
    extreme = scene;
    extreme.lights[0].far_depth = extreme.lights[0].near_depth + 1;
    extreme.lights[0].target.x = INT32_MAX;
    EXPECT_EQ(status(extreme, s), FrameStatus::light_matrix);

    // A frame that cannot be loaded is not drawn.
    s.machine.z_bits = 16;
    Frame<> frame(s.machine, figures.patches.size());
    const std::uint8_t before = frame.buffers.picture[0];
    EXPECT_EQ(frame.draw(extreme, s), FrameStatus::light_matrix);
    EXPECT_TRUE(std::ranges::all_of(frame.buffers.picture,
                                    [&](std::uint8_t v) { return v == before; }));
}

// --- what must not change a bit -----------------------------------------------------------------

// 32-bit stores of 16-bit codes, through the plain post-process, hold the same words.
TEST(Frame, Depth32IsDepth16WhereItFits) {
    const FigureScene figures;
    for (const int z_bits : {8, 12, 16})
        for (const Form form : {Form::post_process, Form::correct}) {
            Settings s = figure_settings(6);
            s.machine.xy_bits = 7;
            s.machine.z_bits = z_bits;
            s.bias_unit = BiasUnit::world;
            s.bias_q16 = 3 * 256;
            s.form = form;
            const Frame<hw::Depth16> narrow(figures.scene(), s);
            const Frame<hw::Depth32> wide(figures.scene(), s);
            expect_equal_frames(narrow.buffers, wide.buffers);
            expect_equal_counts(narrow.counts, wide.counts);
        }
    const Frame<hw::Depth16> narrow(figures.scene(), figure_settings(6));
    const Frame<hw::Depth32> wide(figures.scene(), figure_settings(6));
    expect_equal_frames(narrow.buffers, wide.buffers);
}

TEST(Frame, OrderOfPatchesChangesNothing) {
    const FigureScene figures;
    fixed::test::Random random;
    using raster::Sampling;
    for (const Form form : {Form::post_process, Form::correct})
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
            Settings s = figure_settings(6);
            s.form = form;
            s.sampling = sampling;
            s.machine.xy_bits = 8;
            const Frame<> expected(figures.scene(), s);
            FigureScene shuffled = figures;
            for (std::size_t k = shuffled.patches.size(); k > 1; --k)
                std::swap(shuffled.patches[k - 1], shuffled.patches[random.bits() % k]);
            const Frame<> got(shuffled.scene(), s);
            expect_equal_frames(expected.buffers, got.buffers);
        }
}

// A sink that never leaves a hidden block out, and hears of every sample in the given order.
template <class Sink>
struct Eager : Sink {
    bool hidden(const raster::Footprint&) const { return false; }
};

// Leaving out hidden blocks is an omission, not a choice: drawn in full, and back to front, the
// stores are the same.
TEST(Frame, HiddenBlocksChangeNothing) {
    const FigureScene figures;
    const Scene scene = figures.scene();
    const Settings s = figure_settings(3);
    Frame<> expected(scene, s);
    Frame<> eager(s.machine, scene.patches.size());
    ASSERT_EQ(load_matrices(scene, s, eager.matrices), FrameStatus::ok);
    const auto setup = [&](const hw::MatrixWords& matrix) {
        const hw::WordFormat object = eager.matrices.object;
        return raster::DrawSetup{s.machine, matrix, object, s.sampling, scene.materials,
                                 {s.ambient_q8, raster::toward_eye(scene.lights[0], object),
                                  raster::toward_eye(scene.observer, object)}};
    };
    FrameBuffers<hw::Depth16>& b = eager.buffers;
    const auto back_to_front = [&](const raster::View& view) {
        raster::order_front_to_back(scene.patches, view, b.order, b.nearest);
        std::reverse(b.order.begin(), b.order.end());
    };
    b.lights[0].map.clear(s.machine);
    b.observer.clear(s.machine);
    Eager<raster::DepthSink<hw::Depth16>> light{{b.lights[0].map}};
    Eager<raster::PictureSink<hw::Depth16>> picture{{b.observer}};
    back_to_front(scene.lights[0]);
    const raster::DrawCounts a = raster::draw(
        scene.patches, b.order, setup(eager.matrices.lights[0].world_to_light), *b.draw, light);
    back_to_front(scene.observer);
    const raster::DrawCounts c = raster::draw(
        scene.patches, b.order, setup(eager.matrices.world_to_observer), *b.draw, picture);
    expect_equal_buffers("light_z", 512, expected.buffers.lights[0].map.depth,
                         b.lights[0].map.depth);
    expect_equal_buffers("observer_z", 512, expected.buffers.observer.depth, b.observer.depth);
    expect_equal_buffers("intensity", 512, expected.buffers.observer.intensity,
                         b.observer.intensity);
    expect_equal_buffers("direct", 512, expected.buffers.observer.direct, b.observer.direct);
    std::printf("samples drawn: light %zu of %zu, observer %zu of %zu\n",
                static_cast<std::size_t>(expected.counts.lights[0].map.samples),
                static_cast<std::size_t>(a.samples),
                static_cast<std::size_t>(expected.counts.observer.samples),
                static_cast<std::size_t>(c.samples));
    EXPECT_EQ(a.hidden_blocks + c.hidden_blocks, 0u);
    EXPECT_GT(expected.counts.lights[0].map.hidden_blocks, 0u);
    EXPECT_LT(expected.counts.observer.samples, c.samples);
}

// Patches behind others, and patches drawn twice: the same frame.
TEST(Frame, WhatIsNotSeenChangesNothing) {
    const FigureScene figures;
    Settings s = figure_settings(6);
    s.machine.xy_bits = 8;
    const Frame<> expected(figures.scene(), s);
    std::vector<Patch> more(figures.patches.begin(), figures.patches.end());
    const auto add_sphere = [&](raster::Sphere sphere) {
        more.resize(more.size() + raster::patches_per_sphere);
        raster::sphere_patches(
            sphere, std::span<Patch, raster::patches_per_sphere>(
                        more.data() + more.size() - raster::patches_per_sphere,
                        raster::patches_per_sphere));
    };
    for (raster::Sphere sphere : figure_spheres) {
        sphere.radius -= 1 << 13;  // within its own sphere
        add_sphere(sphere);
    }
    more.insert(more.end(), figures.patches.begin(), figures.patches.end());
    Scene scene = figures.scene();
    scene.patches = more;
    const Frame<> got(scene, s);
    ASSERT_EQ(got.matrices.object.fraction, expected.matrices.object.fraction);
    expect_equal_frames(expected.buffers, got.buffers);
    EXPECT_EQ(got.counts.lights[0].post_process.visible,
              expected.counts.lights[0].post_process.visible);
    EXPECT_GT(got.counts.observer.patches, 2 * expected.counts.observer.patches);
}

// A point light runs the plain post-process with a divide a pixel; both depths agree here too.
TEST(Frame, APointLightCastsShadows) {
    const FigureScene figures;
    Scene scene = figures.scene();
    scene.lights[0].projection = raster::Projection::perspective;
    scene.lights[0].distance = 8 << 16;
    raster::fit_depth(scene.lights[0], raster::depth_range(scene.lights[0], scene.patches));
    Settings s = figure_settings(4);
    s.machine.xy_bits = 7;
    s.machine.coefficient_bits = 24;
    s.dither.shape = hw::DitherShape::none;
    const Frame<hw::Depth16> narrow(scene, s);
    const Frame<hw::Depth32> wide(scene, s);
    ASSERT_EQ(narrow.status, FrameStatus::ok);
    EXPECT_FALSE(narrow.matrices.lights[0].observer_to_light.affine);
    expect_equal_frames(narrow.buffers, wide.buffers);
    const PostProcessCounts& c = narrow.counts.lights[0].post_process;
    EXPECT_GT(c.shadowed, c.visible / 3);
    EXPECT_LT(c.shadowed, c.visible);
}

}  // namespace
}  // namespace umbra78::shadow
