// sample_leaf_centres gives what sample_centres gives: the same samples in the same order, and as
// many tested centres. They are compared on random blocks, larger and stranger than those that the
// block rule draws, and on every block of a frame; so frames and counts are the same, too.
#include "raster/leaf_centres.hpp"

#include "tests/fixed/boundary.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <ostream>
#include <tuple>
#include <utility>
#include <vector>

namespace umbra78::raster {

std::ostream& operator<<(std::ostream& out, const Sample& s) {
    return out << "pixel " << s.px << ", " << s.py << " at " << s.x << ", " << s.y << " depth "
               << s.z << " of leaf " << s.leaf_i << ", " << s.leaf_j
               << (s.second ? ", second triangle" : "");
}

namespace {

using fixed::test::Random;
using umbra78::test::effort;
using umbra78::test::expect_equal_buffers;
using umbra78::test::Patches;
using umbra78::test::Drawing;

auto words(const Sample& s) {
    return std::tuple(s.leaf_j, s.leaf_i, s.py, s.px, s.z, s.x, s.y, s.second);
}

bool steps_back(const Corners& g, const hw::MachineSpec& spec) {
    detail::LeafCentres found;
    return !detail::find_leaf_centres(g, spec.half_px(), found);
}

// The two forms' samples of a block; returns how many there are.
std::size_t expect_same_samples(const Corners& g, const hw::MachineSpec& spec) {
    std::vector<Sample> plain, lone;
    const auto into = [](auto& list) { return [&](const Sample& s) { list.push_back(s); }; };
    const std::uint64_t tested = sample_centres(g, spec, into(plain));
    EXPECT_EQ(sample_leaf_centres(g, spec, into(lone)), tested) << "tested centres";
    EXPECT_EQ(lone.size(), plain.size());
    for (std::size_t k = 0; k < std::min(plain.size(), lone.size()); ++k) {
        if (words(plain[k]) == words(lone[k])) continue;
        ADD_FAILURE() << "sample " << k << ": " << plain[k] << "; by leaf centres " << lone[k];
        break;
    }
    return plain.size();
}

// What a random block may be, beside sheared.
struct Kind {
    const char* name;
    int min_log2_step, max_log2_step;  // a leaf's width and height
    bool jitters;                             // folded, torn and edge-on leaves
    std::int32_t grid;                        // that all corners lie on
    bool far;                                 // from the frame
};

// On a grid that the slack and the pixels' centres share boxes and edges are met exactly; on a
// coarser one many triangles have no area.
constexpr Kind kinds[] = {
    {"as drawn", 5, 12, false, 1, false},
    {"on the grid", 9, 12, false, slack, false},
    {"jittered", 5, 12, true, 1, false},
    {"jittered, on the grid", 9, 12, true, slack, false},
    {"of few corners", 9, 12, true, 2048, false},
    {"up to three pixels a leaf", 12, 13, true, 1, false},
    {"far out", 5, 12, true, 1, true},
};

// Far blocks lie where the low 16 bits of a pixel's number are those of a pixel of the frame.
Corners random_block(Random& random, const Kind& kind, std::int32_t half_px) {
    const auto any = [&](std::int64_t reach) {
        return static_cast<std::int32_t>(random.between(-reach, reach));
    };
    const std::int64_t step =
        std::int64_t{1} << random.between(kind.min_log2_step, kind.max_log2_step);
    const std::int64_t rise = std::int64_t{1} << random.between(0, 27);
    Corners g{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::int32_t out = kind.far ? static_cast<std::int32_t>(random.between(-1, 1)) : 0;
        const std::int32_t at = any(half_px * pixel_units) + out * (1 << 29);
        const std::int32_t along_u = any(step), along_v = any(step);
        for (int v = 0; v < corners; ++v)
            for (int u = 0; u < corners; ++u)
                g[axis][static_cast<std::size_t>(v)][static_cast<std::size_t>(u)] =
                    (at + (u - 8) * along_u + (v - 8) * along_v +
                     (kind.jitters ? any(step / 2) : 0)) / kind.grid * kind.grid;
    }
    for (auto& row : g[2])
        for (std::int32_t& z : row) z = any(rise);
    return g;
}

TEST(LeafCentres, HaveTheSamplesOfRandomBlocks) {
    Random random;
    std::size_t samples = 0, back = 0, ahead = 0;
    const int blocks = effort(4000);  // of a kind
    for (const Kind& kind : kinds) {
        for (int n = 0; n < blocks; ++n) {
            hw::MachineSpec spec;
            spec.xy_bits = static_cast<int>(random.between(4, 12));
            const Corners g = random_block(random, kind, spec.half_px());
            samples += expect_same_samples(g, spec);
            ++(steps_back(g, spec) ? back : ahead);
            if (HasFailure()) FAIL() << "block " << n << ", " << kind.name;
        }
    }
    EXPECT_GT(samples, 50u * static_cast<std::size_t>(blocks));
    EXPECT_GT(back, static_cast<std::size_t>(blocks));
    EXPECT_GT(ahead, 2u * static_cast<std::size_t>(blocks));
    std::cout << "[ measured ] " << samples << " samples; " << ahead << " blocks by leaf centres, "
              << back << " left to the definition\n";
}

// The last corner that 16 bits hold, and the first that they do not, on each side.
TEST(LeafCentres, LeaveFarCornersToTheDefinition) {
    constexpr std::int32_t reach = 1 << 27;
    for (const auto& [at, near] : {std::pair{reach - 1, true}, {reach, false},
                                   {-reach, true}, {-reach - 1, false}}) {
        for (const std::size_t corner : {std::size_t{0}, std::size_t{7}, std::size_t{leaves}}) {
            CornerGrid<std::int32_t> c{};
            c[leaves - corner][corner] = at;
            detail::CornerWindows w;
            EXPECT_EQ(detail::corner_windows(c, 2048, w), near) << at << ", corner " << corner;
        }
    }
}

class DrawnByLeafCentres : public testing::TestWithParam<std::tuple<Projection, int>> {};

void expect_same_counts(const DrawCounts& plain, const DrawCounts& drawn) {
    EXPECT_EQ(plain.patches, drawn.patches);
    EXPECT_EQ(plain.blocks, drawn.blocks);
    EXPECT_EQ(plain.samples, drawn.samples);
    EXPECT_EQ(plain.unresolved, drawn.unresolved);
    EXPECT_EQ(plain.tested_blocks, drawn.tested_blocks);
    EXPECT_EQ(plain.splits, drawn.splits);
    EXPECT_EQ(plain.tested_centres, drawn.tested_centres);
}

// A frame drawn by the definition, a block at a time, is the frame that draw() draws.
TEST_P(DrawnByLeafCentres, IsTheFrameDrawnByTheDefinition) {
    const auto [projection, xy_bits] = GetParam();
    hw::MachineSpec spec;
    spec.xy_bits = xy_bits;
    spec.coefficient_bits = 24;
    Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(-0.9, 0.4, 0, 0.8));
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0.6, -0.5, 0.7, 0.7));
    patches.push_back(plane_patch(umbra78::test::plane({-2, -1, -2}, {4, 0.3, 0}, {0, 0.2, 4})));
    const View view = projection == Projection::perspective
                          ? umbra78::test::perspective(15, 20, 1.5, 6, 1, 12)
                          : umbra78::test::orthographic(15, 20, 1.5);
    const View light = umbra78::test::orthographic(-60, 40, 2);

    Drawing<> drawn(spec), plain(spec);
    const DrawCounts drawn_counts =
        drawn.draw(patches, view, Sampling::centre, &light, {}, false);

    const hw::WordFormat object = object_format(patches);
    DrawSetup setup{spec, {}, object, Sampling::centre, plain.materials, {}};
    ASSERT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
    setup.shading = {plain.ambient_q8, toward_eye(light, object), toward_eye(view, object)};
    const auto memory = std::make_unique<DrawMemory>();
    DrawCounts counts;
    detail::BlockWalk walk(setup, *memory, true, counts);
    hw::FrameStore<hw::Depth16> store = plain.store();
    PictureSink<hw::Depth16> sink{store};
    for (const Patch& patch : patches) {
        ++counts.patches;
        walk.push_patch(patch);
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            ASSERT_TRUE(walk.make_corners());
            ++counts.blocks;
            ASSERT_FALSE(steps_back(memory->corners, spec)) << "a block that the rule draws";
            expect_same_samples(memory->corners, spec);
            ASSERT_FALSE(HasFailure()) << "block " << counts.blocks;
            const BlockShading shading(walk.block().world, setup.shading, plain.materials[0]);
            counts.tested_centres += sample_centres(memory->corners, spec, [&](const Sample& s) {
                std::uint32_t code = 0;
                if (!depth_code(s.z, spec, code)) return;
                ++counts.samples;
                sink.sample(s, code, &shading);
            });
        }
    }
    EXPECT_GT(counts.samples, 1000u);
    expect_same_counts(counts, drawn_counts);
    expect_equal_buffers("depth", spec.size_px(), plain.depth(), drawn.depth());
    expect_equal_buffers("intensity", spec.size_px(), plain.intensity(), drawn.intensity());
}

INSTANTIATE_TEST_SUITE_P(Views, DrawnByLeafCentres,
                         testing::Combine(testing::Values(Projection::orthographic,
                                                          Projection::perspective),
                                          testing::Values(6, 9)));

}  // namespace
}  // namespace umbra78::raster
