// A list of visible samples gives a store the levels of the definition: of one viewer after
// another, of patches with their materials, of blocks that the lanes do not cover, and of several
// samples in a pixel the least.
#include "raster/visible_list.hpp"

#include "tests/fixed/boundary.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace umbra78::raster {
namespace {

using fixed::test::Random;

UnitVector random_unit(Random& random) {
    const auto any = [&] { return random.between(-(1 << 20), 1 << 20); };
    return unit_vector({any(), any(), any()});
}

// As long as the mean of normals of a block that turns little, or shorter.
WideVector random_normal(Random& random, bool in_lanes) {
    const UnitVector unit = random_unit(random);
    const std::int64_t scale = in_lanes ? random.between(900, 1024) : random.between(0, 400);
    return {scale * unit[0], scale * unit[1], scale * unit[2]};
}

struct ListedSample {
    std::size_t pixel;
    std::uint32_t patch;
    WideVector normal;
};

constexpr int shown_bits = 4;
constexpr std::size_t shown_pixels = 1 << (2 * shown_bits);

struct ShownStore {
    std::vector<hw::Depth16> depth = std::vector<hw::Depth16>(shown_pixels, 100);
    std::vector<std::uint8_t> intensity, direct;
    hw::FrameStore<hw::Depth16> store;

    explicit ShownStore(const ShadingSpec& spec)
        : intensity(spec.channels * shown_pixels, 255),
          direct(spec.channels * spec.source_count * shown_pixels, 255),
          store{shown_bits, depth, intensity, direct} {}
};

void expect_defined(VisibleList& list, const std::vector<ListedSample>& samples,
                    const std::vector<Patch>& patches, const std::vector<Material>& materials,
                    const ShadingSpec& spec) {
    ShownStore drawn(spec);
    shade_list(list, patches, materials, spec, drawn.store);
    std::vector<Shades> least(shown_pixels);
    Shade most{255, {}};
    for (std::size_t l = 0; l < spec.source_count; ++l) most.direct[l] = 255;
    for (Shades& s : least)
        for (std::size_t c = 0; c < spec.channels; ++c) s[c] = most;
    for (const ListedSample& s : samples)
        least[s.pixel] = std::min(least[s.pixel],
                                  shade_normal(s.normal, spec,
                                               materials[patches[s.patch].material]));
    const ShadePlanes<hw::Depth16> planes(drawn.store);
    for (std::size_t at = 0; at < shown_pixels; ++at) ASSERT_EQ(planes.at(at), least[at]) << at;
}

TEST(VisibleList, LevelsAreThoseOfTheDefinition) {
    Random random;
    for (int round = 0; round < umbra78::test::effort(160); ++round) {
        ShadingSpec spec;
        spec.source_count = static_cast<std::size_t>(random.between(1, max_sources));
        spec.channels = random.between(0, 1) != 0 ? max_channels : 1;
        spec.rule = static_cast<ShadingRule>(random.between(0, 2));
        const auto level = [&] { return static_cast<std::int32_t>(random.between(0, 255)); };
        std::vector<Material> materials(3);
        for (Material& m : materials)
            m = {{level(), level(), level()}, {level(), level(), level()},
                 static_cast<std::int32_t>(random.between(0, 8))};
        std::vector<Patch> patches(5);
        for (Patch& p : patches) p.material = static_cast<std::uint16_t>(random.between(0, 2));
        std::vector<VisibleBlock> room(shown_pixels);
        VisibleList list(room);
        std::vector<ListedSample> samples;
        for (std::uint32_t patch = 0; patch < patches.size(); ++patch)
            for (auto n = random.between(0, 70); n > 0; --n) {
                const bool in_lanes = random.between(0, 9) != 0;
                const auto pixel = static_cast<std::size_t>(random.between(0, shown_pixels - 1));
                samples.push_back({pixel, patch, random_normal(random, in_lanes)});
                list.add(patch, in_lanes, samples.back().pixel, samples.back().normal);
            }
        list.end();
        ASSERT_TRUE(list.is_whole());
        for (int turn = 0; turn < 3; ++turn) {
            if (turn != 1) spec.viewer.direction = random_unit(random);
            for (std::size_t l = 0; l < spec.source_count; ++l) {
                spec.sources[l].toward.direction = random_unit(random);
                spec.sources[l].level_q8 = {level(), level(), level()};
            }
            expect_defined(list, samples, patches, materials, spec);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(VisibleList, WhatDoesNotFitIsSaid) {
    std::vector<VisibleBlock> room(2);
    VisibleList list(room);
    for (std::size_t n = 0; n < 32; ++n) list.add(7, true, n, {1 << 24, 0, 0});
    EXPECT_FALSE(list.does_not_fit());
    list.end();
    EXPECT_TRUE(list.is_whole());
    EXPECT_EQ(list.blocks().size(), 2u);
    EXPECT_EQ(list.blocks()[1].count, 16);
    list.forget();
    EXPECT_FALSE(list.is_whole());
    for (std::uint32_t n = 0; n < 3; ++n) list.add(n, true, n, {1 << 24, 0, 0});
    EXPECT_TRUE(list.does_not_fit());
    list.end();
    EXPECT_FALSE(list.is_whole());
    list.forget();
    list.fail();  // a triangle's sample came
    list.end();
    EXPECT_FALSE(list.is_whole());
}

TEST(VisibleList, CoversLightsAndViewersAtInfinityAlone) {
    ShadingSpec spec;
    EXPECT_TRUE(lists_cover(spec));
    spec.sources[0].toward.to_point = true;
    EXPECT_FALSE(lists_cover(spec));
    spec = {};
    spec.viewer.to_point = true;
    EXPECT_FALSE(lists_cover(spec));
    spec = {};
    spec.rule = ShadingRule::none;
    EXPECT_FALSE(lists_cover(spec));
    spec = {};
    spec.keeps_normals = true;
    EXPECT_FALSE(lists_cover(spec));
}

}  // namespace
}  // namespace umbra78::raster
