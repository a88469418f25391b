// Whole drawings are, bit for bit, those of hw/MACHINE.md's text: random crumpled patches in small
// frames of every width, both projections, both samplings, materials and lights. So any bound,
// margin, rounding or tie that differs is found where it changes a frame, a level or a count.
#include "tests/raster/exact_frame.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace umbra78::raster {
namespace {

using namespace test;
using umbra78::test::Drawing;
using umbra78::test::effort;
using umbra78::test::expect_equal_buffers;
using umbra78::test::Patches;

std::int32_t word(Random& random, std::int64_t reach) {
    return static_cast<std::int32_t>(random.between(-reach, reach));
}

// Control points about a random place. Some patches are flat, some have doubled control points.
Patch random_patch(Random& random, std::int64_t reach, std::int64_t size) {
    const World at{word(random, reach), word(random, reach), word(random, reach)};
    Patch p;
    const auto kind = random.bits() % 4;
    if (kind == 0) {
        const auto edge = [&] {
            return World{word(random, size), word(random, size), word(random, size)};
        };
        p = plane_patch({at, edge(), edge(), 0});
    } else {
        for (World& c : p.control)
            c = {at.x + word(random, size), at.y + word(random, size), at.z + word(random, size)};
        if (kind == 1) p.control[1] = p.control[2] = p.control[3] = p.control[0];  // a pole
    }
    p.material = static_cast<std::uint16_t>(random.bits() % 3);
    return p;
}

View random_view(Random& random, bool perspective) {
    View v;
    v.projection = perspective ? Projection::perspective : Projection::orthographic;
    v.axes = axes_from_angles(word(random, 180 << 16), word(random, 90 << 16));
    v.target = {word(random, 1 << 14), word(random, 1 << 14), word(random, 1 << 14)};
    v.extent = static_cast<std::int32_t>(random.between(1 << 15, 1 << 17));
    v.distance = static_cast<std::int32_t>(random.between(1 << 15, 1 << 18));
    v.near_depth = perspective ? random.between(1 << 10, 1 << 15) : -random.between(1, 1 << 17);
    v.far_depth = random.between(1 << 16, 1 << 19);
    return v;
}

// What the text's slow form does in a tenth of a second.
constexpr std::uint64_t max_blocks = 60, max_tested_blocks = 2000;

// Draws by draw() without leaving out hidden blocks, with it, and by the text.
void expect_the_texts_frame(const MachineSpec& spec, const Patches& patches, const View& view,
                            const View& light, Sampling sampling, DrawCounts& total) {
    Drawing<hw::Depth32> drawn(spec), skipping(spec);
    const std::vector<Material> materials{{215, 90, 5}, {90, 255, 0}, {160, 80, 8}};
    drawn.materials = skipping.materials = materials;
    const hw::WordFormat object = object_format(patches);
    DrawSetup setup{spec, {}, object, sampling, materials, {}};
    if (load_view(view, spec, object, setup.matrix) != hw::LoadStatus::ok) return;
    setup.shading = {drawn.ambient_q8, toward_eye(light, object), toward_eye(view, object)};
    const DrawCounts counts = drawn.draw(patches, view, sampling, &light, {}, false);
    if (counts.blocks > max_blocks || counts.tested_blocks > max_tested_blocks) return;
    const DrawCounts skipped = skipping.draw(patches, view, sampling, &light, {}, true);
    const ExactFrame expected(patches, setup);
    EXPECT_EQ(counts.blocks, expected.counts.blocks);
    EXPECT_EQ(counts.samples, expected.counts.samples);
    EXPECT_EQ(counts.unresolved, expected.counts.unresolved);
    EXPECT_EQ(counts.tested_blocks, expected.counts.tested_blocks);
    EXPECT_EQ(counts.splits, expected.counts.splits);
    EXPECT_EQ(skipped.blocks + skipped.hidden_blocks + skipped.unresolved,
              counts.blocks + counts.unresolved);
    const auto same = [&](const char* name, const auto& a, const auto& b) {
        if (a != b) expect_equal_buffers(name, spec.size_px(), a, b);  // which says where
    };
    same("depth", expected.depth, drawn.depth());
    same("intensity", expected.intensity, drawn.intensity());
    same("direct", expected.direct, drawn.direct());
    same("depth, hidden blocks left out", expected.depth, skipping.depth());
    same("intensity, hidden blocks left out", expected.intensity, skipping.intensity());
    same("direct, hidden blocks left out", expected.direct, skipping.direct());
    total.patches += counts.patches;
    total.samples += counts.samples;
    total.blocks += counts.blocks;
    total.hidden_blocks += skipped.hidden_blocks;
    total.unresolved += counts.unresolved;
}

class ExactFrames : public testing::TestWithParam<bool> {};

TEST_P(ExactFrames, OfRandomPatches) {
    Random random;
    DrawCounts total;
    const int scenes = effort(120);
    for (int n = 0; n < scenes; ++n) {
        MachineSpec spec;
        spec.xy_bits = static_cast<int>(random.between(4, 5));
        spec.z_bits = static_cast<int>(random.between(4, 24));
        spec.coefficient_bits = static_cast<int>(random.between(10, 24));
        Patches patches;
        const std::int64_t size = std::int64_t{1} << random.between(9, 16);
        const int count = size > 1 << 13 ? 1 : 6;
        for (int k = 0; k < count; ++k) patches.push_back(random_patch(random, 1 << 16, size));
        const View view = random_view(random, GetParam());
        const View light = random_view(random, random.bits() % 2 == 0);
        const Sampling sampling = n % 4 == 0 ? Sampling::leaf : Sampling::centre;
        expect_the_texts_frame(spec, patches, view, light, sampling, total);
        if (HasFailure()) FAIL() << "scene " << n;
    }
    EXPECT_GT(total.samples, 10u * static_cast<unsigned>(scenes));
    std::cout << "[ measured ] " << total.samples << " samples of " << total.patches
              << " patches, " << total.blocks
              << " blocks, hidden " << total.hidden_blocks << ", dropped " << total.unresolved
              << '\n';
}

INSTANTIATE_TEST_SUITE_P(OrthographicAndPerspective, ExactFrames, testing::Bool());

}  // namespace
}  // namespace umbra78::raster
