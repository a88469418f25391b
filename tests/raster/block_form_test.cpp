// Every form of a block's work that this machine has gives what the definitions give: the same
// corners, the same samples in any order with as many tested centres, the same levels. They are
// compared on random blocks, larger and stranger than those that the block rule draws, and on
// every block of a frame; so frames and counts are the same, too.
#include "raster/block_form.hpp"

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

std::vector<const BlockForm*> supported() {
    std::vector<const BlockForm*> forms;
    for (const BlockForm& form : block_forms())
        if (form.supported()) forms.push_back(&form);
    return forms;
}

// A block's samples by the definition and by each form; returns how many there are, and in `ahead`
// whether the forms gave them.
std::size_t expect_same_samples(const Corners& g, const hw::MachineSpec& spec, Sampling sampling,
                                bool& ahead) {
    std::vector<Sample> plain;
    std::uint64_t tested = 0;
    const auto add = [&](const Sample& s) { plain.push_back(s); };
    const bool centres = sampling == Sampling::centre;
    if (centres) {
        tested = sample_centres(g, spec, add);
    } else {
        sample_leaves(g, spec, add);
    }
    const auto before = [](const Sample& a, const Sample& b) { return words(a) < words(b); };
    std::sort(plain.begin(), plain.end(), before);
    const auto list = std::make_unique<BlockSamples>();
    for (const BlockForm* form : supported()) {
        ahead = (centres ? form->centres : form->leaves)(g, spec.half_px(), *list);
        if (!ahead) continue;
        EXPECT_EQ(list->tested, tested) << "tested centres, " << form->name;
        EXPECT_EQ(list->count, plain.size()) << form->name;
        std::vector<Sample> drawn;
        for (std::size_t k = 0; k < list->count; ++k)
            drawn.push_back(detail::sample_of(list->sample[k], spec.half_px()));
        std::sort(drawn.begin(), drawn.end(), before);
        for (std::size_t k = 0; k < std::min(plain.size(), drawn.size()); ++k) {
            const Sample& s = drawn[k];
            if (words(plain[k]) == words(s)) continue;
            ADD_FAILURE() << "sample " << k << ": " << plain[k] << "; by " << form->name << ' '
                          << s;
            break;
        }
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

class BlockSamplesOf : public testing::TestWithParam<Sampling> {};

TEST_P(BlockSamplesOf, RandomBlocksAreThoseOfTheDefinition) {
    Random random;
    std::size_t samples = 0, back = 0, forward = 0;
    const int blocks = umbra78::test::sanitized ? 100 : 4000;  // of a kind
    for (const Kind& kind : kinds) {
        for (int n = 0; n < blocks; ++n) {
            hw::MachineSpec spec;
            spec.xy_bits = static_cast<int>(random.between(4, 12));
            bool ahead = false;
            samples += expect_same_samples(random_block(random, kind, spec.half_px()), spec,
                                           GetParam(), ahead);
            ++(ahead ? forward : back);
            if (HasFailure()) FAIL() << "block " << n << ", " << kind.name;
        }
    }
    EXPECT_GT(samples, 50u * static_cast<std::size_t>(blocks));
    EXPECT_GT(back, static_cast<std::size_t>(blocks / 2));
    EXPECT_GT(forward, 2u * static_cast<std::size_t>(blocks));
    std::cout << "[ measured ] " << samples << " samples; " << forward << " blocks by the forms, "
              << back << " left to the definition\n";
}

INSTANTIATE_TEST_SUITE_P(Sampling, BlockSamplesOf,
                         testing::Values(Sampling::centre, Sampling::leaf));

TEST(BlockForm, CornersAreThoseOfTheDefinition) {
    Random random;
    for (int n = 0; n < effort(4000); ++n) {
        std::array<Component, 3> block{};
        for (Component& c : block) {
            const std::int64_t bend = std::int64_t{1} << random.between(0, 25);
            for (std::size_t k = 0; k < 4; ++k) {
                c.f[k] = random.between(-(1 << 28), 1 << 28);
                c.gu[k] = random.between(-bend, bend);
                c.gv[k] = random.between(-bend, bend);
                c.guv[k] = random.between(-bend, bend);
            }
        }
        Corners plain, drawn;
        expand<std::int32_t, 3>(block, plain);
        for (const BlockForm* form : supported()) {
            form->expand(block, drawn);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t v = 0; v < corners; ++v)
                    for (std::size_t u = 0; u < corners; ++u)
                        ASSERT_EQ(plain[c][v][u], drawn[c][v][u])
                            << form->name << ", axis " << c << ", corner " << u << ", " << v;
        }
    }
}

UnitVector random_direction(Random& random) {
    const auto any = [&] { return random.between(-(1 << 20), 1 << 20); };
    return unit_vector({any(), any(), any()});
}

// A block whose corners' normals lie about one direction, by up to `spread` of 2^20.
std::array<Component, 3> random_surface(Random& random, std::int64_t spread) {
    std::array<Component, 3> world{};
    const UnitVector u = random_direction(random), v = random_direction(random);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto off = [&] { return random.between(-spread, spread); };
        world[k].f = {0, 64 * u[k] + off(), 64 * v[k] + off(), 64 * (u[k] + v[k]) + off()};
        for (auto* g : {&world[k].gu, &world[k].gv, &world[k].guv})
            for (std::int64_t& word : *g) word = off() / 4;
    }
    return world;
}

ShadingSpec random_shading(Random& random) {
    ShadingSpec spec;
    spec.ambient_q8 = static_cast<std::int32_t>(random.between(0, 256));
    spec.viewer.direction = random_direction(random);
    spec.rule = static_cast<ShadingRule>(random.between(0, 2));
    spec.source_count = static_cast<std::size_t>(random.between(1, max_sources));
    spec.channels = random.between(0, 1) != 0 ? max_channels : 1;
    const auto level = [&] { return static_cast<std::int32_t>(random.between(0, 256)); };
    for (std::size_t l = 0; l < spec.source_count; ++l) {
        spec.sources[l].toward.direction =
            random.between(0, 9) == 0 ? spec.viewer.direction : random_direction(random);
        spec.sources[l].level_q8 = {level(), level(), level()};
    }
    return spec;
}

// All 256 leaves, and some of them alone.
TEST(BlockForm, LevelsAreThoseOfTheDefinition) {
    Random random;
    const auto levels = std::make_unique<LeafLevels>();
    int covered = 0;
    for (int n = 0; n < effort(1000); ++n) {
        const ShadingSpec spec = random_shading(random);
        const auto level = [&] { return static_cast<std::int32_t>(random.between(0, 255)); };
        const Material material{{level(), level(), level()}, {level(), level(), level()},
                                static_cast<std::int32_t>(random.between(0, 8))};
        const std::int64_t spread = std::int64_t{1} << random.between(0, 19);
        const BlockShading shading(random_surface(random, spread), spec, material);
        ShadeJob job;
        if (!shading.job(job)) continue;
        ++covered;
        const auto first = static_cast<std::size_t>(random.between(0, 255));
        for (const BlockForm* form : supported()) {
            std::array<std::uint8_t, leaves * leaves + 15> numbers{};
            const std::size_t count = leaves * leaves - first;
            for (std::size_t k = 0; k < count; ++k)
                numbers[k] = static_cast<std::uint8_t>(first + k);
            form->shade(job, numbers.data(), count, *levels);
            for (std::size_t leaf = first; leaf < leaves * leaves; ++leaf)
                ASSERT_EQ(levels->of(leaf, spec.channels, spec.source_count),
                          shading.shade(static_cast<int>(leaf % 16), static_cast<int>(leaf / 16),
                                        0))
                    << form->name << ", block " << n << ", leaf " << leaf;
            const std::size_t some = 1 + first % 16;
            SampleNormals normals{};
            for (std::size_t leaf = 0; leaf < some; ++leaf)
                for (std::size_t k = 0; k < 3; ++k)
                    normals.n[k][leaf] = static_cast<std::int32_t>(
                        shading.mean_normal(static_cast<int>(leaf), 5)[k]);
            form->measure_normals(job, normals);
            form->shade_normals(job, normals, some, *levels);
            for (std::size_t leaf = 0; leaf < some; ++leaf)
                ASSERT_EQ(levels->of(leaf, spec.channels, spec.source_count),
                          shading.shade(static_cast<int>(leaf), 5, 0))
                    << form->name << ", block " << n << ", normal " << leaf;
        }
    }
    EXPECT_GT(covered, effort(1000) / 2);
}

class DrawnByForms : public testing::TestWithParam<std::tuple<Projection, int, Sampling>> {};

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
TEST_P(DrawnByForms, IsTheFrameDrawnByTheDefinition) {
    const auto [projection, xy_bits, sampling] = GetParam();
    hw::MachineSpec spec;
    spec.xy_bits = umbra78::test::sanitized ? std::min(xy_bits, 7) : xy_bits;
    spec.coefficient_bits = 24;
    Patches patches;
    umbra78::test::add_sphere(patches, umbra78::test::sphere(-0.9, 0.4, 0, 0.8));
    umbra78::test::add_sphere(patches, umbra78::test::sphere(0.6, -0.5, 0.7, 0.7));
    patches.push_back(plane_patch(umbra78::test::plane({-2, -1, -2}, {4, 0.3, 0}, {0, 0.2, 4})));
    const View view = projection == Projection::perspective
                          ? umbra78::test::perspective(15, 20, 1.5, 6, 1, 12)
                          : umbra78::test::orthographic(15, 20, 1.5);
    const View light = umbra78::test::orthographic(-60, 40, 2);

    Drawing<> plain(spec);
    const hw::WordFormat object = object_format(patches);
    DrawSetup setup{spec, {}, object, sampling, plain.materials, {}};
    ASSERT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
    setup.shading = {plain.ambient_q8, toward_eye(light, object), toward_eye(view, object)};
    const auto memory = std::make_unique<DrawMemory>();
    DrawCounts counts;
    detail::BlockWalk walk(setup, *memory, true, counts);
    hw::FrameStore<hw::Depth16> store = plain.store();
    PictureSink<hw::Depth16> sink{store};
    for (const Patch& patch : patches) {
        walk.push_patch(patch);
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            ASSERT_TRUE(walk.make_corners(block_forms().front()));
            ++counts.blocks;
            bool ahead = false;
            expect_same_samples(memory->corners, spec, sampling, ahead);
            ASSERT_TRUE(ahead) << "a block that the rule draws";
            ASSERT_FALSE(HasFailure()) << "block " << counts.blocks;
            const BlockShading shading(walk.block().world, setup.shading, plain.materials[0]);
            const auto emit = [&](const Sample& s) {
                std::uint32_t code = 0;
                if (!depth_code(s.z, spec, code)) return;
                ++counts.samples;
                sink.sample(s, code, &shading);
            };
            if (sampling == Sampling::leaf) {
                sample_leaves(memory->corners, spec, emit);
            } else {
                counts.tested_centres += sample_centres(memory->corners, spec, emit);
            }
        }
    }
    EXPECT_GT(counts.samples, 1000u);
    for (const BlockForm* form : supported()) {
        SCOPED_TRACE(form->name);
        Drawing<> drawn(spec);
        drawn.blocks = form;
        expect_same_counts(counts, drawn.draw(patches, view, sampling, &light, {}, false));
        expect_equal_buffers("depth", spec.size_px(), plain.depth(), drawn.depth());
        expect_equal_buffers("intensity", spec.size_px(), plain.intensity(), drawn.intensity());
        expect_equal_buffers("direct", spec.size_px(), plain.direct(), drawn.direct());
    }
}

INSTANTIATE_TEST_SUITE_P(Views, DrawnByForms,
                         testing::Combine(testing::Values(Projection::orthographic,
                                                          Projection::perspective),
                                          testing::Values(6, 9),
                                          testing::Values(Sampling::centre, Sampling::leaf)));

}  // namespace
}  // namespace umbra78::raster
