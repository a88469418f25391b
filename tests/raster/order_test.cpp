// The frame is the min (Z, intensity) of its samples: no order of patches or samples, and no
// block left out as hidden, changes a bit.
#include "tests/fixed/boundary.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace umbra78::raster {
namespace {

using fixed::test::Random;
using umbra78::test::expect_equal_buffers;
using umbra78::test::Patches;
using umbra78::test::Drawing;

void shuffle(std::vector<std::uint32_t>& order, Random& random) {
    for (std::size_t k = order.size(); k > 1; --k)
        std::swap(order[k - 1], order[random.bits() % k]);
}

// Spheres that touch, overlap and coincide, and planes through them: many ties in Z.
Patches crowded_scene() {
    Patches p;
    using umbra78::test::plane;
    using umbra78::test::sphere;
    for (const Sphere& s : {sphere(-0.6, 0.3, 0, 0.8), sphere(0.2, 0.3, -0.5, 0.8),
                            sphere(0.2, 0.3, -0.5, 0.8), sphere(0.7, -0.9, 0.6, 0.5)})
        umbra78::test::add_sphere(p, s);
    p.push_back(plane_patch(plane({-2, -1, -2}, {4, 0.3, 0}, {0, 0, 4})));
    p.push_back(plane_patch(plane({-2, -1, -2}, {4, 0.3, 0}, {0, 0, 4})));
    p.push_back(plane_patch(plane({-1, -1.5, 0}, {2, 0, 0}, {0, 3, 0})));
    for (std::size_t k = 0; k < p.size(); ++k) p[k].material = static_cast<std::uint16_t>(k % 3);
    return p;
}

struct Picture {
    std::vector<std::uint16_t> depth;
    std::vector<std::uint8_t> intensity, direct;
};

// In 256 x 256; a view of each kind.
class Order : public testing::TestWithParam<std::tuple<Projection, Sampling>> {
protected:
    const Patches patches = crowded_scene();
    const View light = umbra78::test::orthographic(-60, 40, 2);

    Picture draw(std::span<const std::uint32_t> order, bool may_hide, DrawCounts* counts) const {
        hw::MachineSpec spec;
        spec.xy_bits = 8;
        const auto [projection, sampling] = GetParam();
        View view = umbra78::test::orthographic(15, 20, 2);
        if (projection == Projection::perspective) {
            spec.coefficient_bits = 24;
            view = umbra78::test::perspective(15, 20, 2, 6, 1, 12);
        }
        Drawing<> stage(spec);
        stage.materials = {{215, 90, 5}, {90, 0, 0}, {160, 80, 3}};
        *counts = stage.draw(patches, view, sampling, &light, order, may_hide);
        return {stage.depth(), stage.intensity(), stage.direct()};
    }
    static void expect_equal(const Picture& a, const Picture& b) {
        expect_equal_buffers("depth", 256, a.depth, b.depth);
        expect_equal_buffers("intensity", 256, a.intensity, b.intensity);
        expect_equal_buffers("direct", 256, a.direct, b.direct);
    }
};

TEST_P(Order, OfPatchesChangesNothing) {
    Random random;
    DrawCounts counts;
    const Picture first = draw({}, true, &counts);
    std::vector<std::uint32_t> order(patches.size());
    std::iota(order.begin(), order.end(), 0u);
    for (int n = 0; n < 6; ++n) {
        shuffle(order, random);
        expect_equal(first, draw(order, true, &counts));
    }
}

TEST_P(Order, LeavingOutHiddenBlocksChangesNothing) {
    DrawCounts skipping, all;
    std::vector<std::uint32_t> order(patches.size());
    std::vector<std::int64_t> scratch(patches.size());
    order_front_to_back(patches, umbra78::test::orthographic(15, 20, 2), order, scratch);
    const Picture a = draw(order, true, &skipping), b = draw(order, false, &all);
    expect_equal(a, b);
    EXPECT_GT(skipping.hidden_blocks, all.blocks / 5) << "something is hidden";
    EXPECT_EQ(all.hidden_blocks, 0u);
    EXPECT_EQ(skipping.blocks + skipping.hidden_blocks, all.blocks);
}

// Planes that coincide, drawn bright first: each block of the second is as near as what hides it,
// and its smaller intensities must win. In perspective depths tie as well: it is the same patch.
TEST(HiddenBlocks, AreNotThoseThatTie) {
    for (const bool perspective : {false, true}) {
        for (const double lean : {0.0, 0.3}) {
            for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
                hw::MachineSpec spec;
                spec.xy_bits = 8;
                spec.coefficient_bits = 24;
                const View view = perspective ? umbra78::test::perspective(0, 0, 2, 6, 1, 12)
                                              : umbra78::test::orthographic(0, 0, 2);
                const View light = umbra78::test::orthographic(-20, 10, 2);
                Patches patches(2, plane_patch(umbra78::test::plane({-3, -3, 0.01}, {6, 0, lean},
                                                                    {0, 6, 0})));
                patches[1].material = 1;
                Drawing<> stage(spec), dark(spec);
                stage.materials = dark.materials = {{200, 0, 0}, {100, 0, 0}};
                const DrawCounts both = stage.draw(patches, view, sampling, &light);
                dark.draw(Patches{patches[1]}, view, sampling, &light);
                EXPECT_EQ(both.hidden_blocks, 0u) << "nothing is behind its equal";
                EXPECT_EQ(dark.depth(), stage.depth());
                EXPECT_EQ(dark.intensity(), stage.intensity());
            }
        }
    }
}

// Nearest control points decide; equal ones keep the order of their indices.
TEST(FrontToBack, OrdersByTheNearestControlPointAndThenByIndex) {
    Random random;
    const View view = umbra78::test::orthographic(33, 21, 2);
    for (int n = 0; n < 200; ++n) {
        Patches patches(1 + random.bits() % 40);
        for (Patch& p : patches)
            for (World& c : p.control)
                c = {static_cast<std::int32_t>(random.between(-2, 2)) * 65536,
                     static_cast<std::int32_t>(random.between(-2, 2)) * 65536, 65536};
        std::vector<std::uint32_t> order(patches.size());
        std::vector<std::int64_t> scratch(patches.size());
        order_front_to_back(patches, view, order, scratch);
        const auto nearest = [&](std::uint32_t k) {
            std::int64_t near = INT64_MIN;
            for (const World& c : patches[k].control)
                near = std::max(near, std::int64_t{view.axes.back[0]} * c.x +
                                          std::int64_t{view.axes.back[1]} * c.y +
                                          std::int64_t{view.axes.back[2]} * c.z);
            return near;
        };
        std::vector<bool> seen(patches.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            seen[order[k]] = true;
            if (k == 0) continue;
            const std::int64_t a = nearest(order[k - 1]), b = nearest(order[k]);
            ASSERT_TRUE(a > b || (a == b && order[k - 1] < order[k]));
        }
        ASSERT_EQ(std::count(seen.begin(), seen.end(), true),
                  static_cast<std::ptrdiff_t>(seen.size()));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Views, Order,
    testing::Combine(testing::Values(Projection::orthographic, Projection::perspective),
                     testing::Values(Sampling::centre, Sampling::leaf)));

// Samples of few places, few depths and three levels, in two orders, into both sinks.
TEST(Sinks, KeepTheMinWhateverTheOrder) {
    Random random;
    constexpr std::size_t count = 5000;
    hw::MachineSpec spec;
    spec.xy_bits = 4;
    const std::array<Component, 3> world{};
    ShadingSpec ambient_only;
    ambient_only.ambient_q8 = 256;  // so a level is the material's diffuse
    const std::array<Material, 3> materials{{{10, 0, 0}, {20, 0, 0}, {30, 0, 0}}};
    const BlockShading levels[] = {{world, ambient_only, materials[0]},
                                   {world, ambient_only, materials[1]},
                                   {world, ambient_only, materials[2]}};
    struct Drawn {
        Sample sample;
        std::uint32_t code;
        std::size_t level;
    };
    std::vector<Drawn> drawn(count);
    std::vector<std::uint16_t> depth(256, 0xffff);
    std::vector<std::uint8_t> intensity(256, 0);
    for (Drawn& d : drawn) {
        d = {{static_cast<int>(random.bits() % 16), static_cast<int>(random.bits() % 16), 0, 0, 0,
              0, 0}, static_cast<std::uint32_t>(random.between(65520, 65534)), random.bits() % 3};
        const std::size_t a = static_cast<std::size_t>(16 * d.sample.py + d.sample.px);
        const auto level = static_cast<std::uint8_t>(10 * (d.level + 1));
        if (d.code < depth[a] || (d.code == depth[a] && level < intensity[a])) {
            depth[a] = static_cast<std::uint16_t>(d.code);
            intensity[a] = level;
        }
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (int n = 0; n < 20; ++n) {
        Drawing<> picture(spec), light(spec);
        auto store = picture.store(), map = light.store();
        PictureSink<hw::Depth16> picture_sink{store};
        DepthSink<hw::Depth16> depth_sink{map};
        for (const std::uint32_t k : order) {
            picture_sink.sample(drawn[k].sample, drawn[k].code, &levels[drawn[k].level]);
            depth_sink.sample(drawn[k].sample, drawn[k].code, nullptr);
        }
        expect_equal_buffers("depth", 16, depth, picture.depth());
        expect_equal_buffers("intensity", 16, intensity, picture.intensity());
        expect_equal_buffers("light", 16, depth, light.depth());
        shuffle(order, random);
    }
}

}  // namespace
}  // namespace umbra78::raster
