// The bands about the shadow's edges, and how far two edges are apart, where the answer is known.
#include "tests/tools/truth/half_lit.hpp"
#include "tests/tools/truth/images.hpp"
#include "tools/truth/edge_bands.hpp"
#include "tools/truth/edge_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace umbra78::tools {
namespace {

using test::Bytes, test::half_lit, test::shadow_from, test::total;
using test::pi, test::seed;

// Light from above onto the floor, seen from above: texel and pixel map to one another.
TEST(LightTexelBand, OfACastShadowIsOneTexelWide) {
    const int size = 200;
    const TruthScene scene{{{{0, 3, 0}, 1.0}}, {{{-4, 0, -4}, {8, 0, 0}, {0, 0, 8}}}};
    const TruthLight light{false, {0, 1, 0}, {}};
    const TruthView above{false, {}, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, 2, 0, 0, 2.5, 25};
    TruthView observer = above;  // below the sphere, so that only the floor is seen
    observer.target = {0, 1, 0};
    observer.near_depth = 0;
    observer.size = size;
    observer.extent = 2;
    observer.far_depth = 3;
    TruthScene floor_seen = scene;
    floor_seen.spheres.clear();
    Truth truth = trace(floor_seen, observer, light);
    for (std::size_t at = 0; at < truth.lit.size(); ++at) {
        truth.surface[at] += 1;  // as numbered in `scene`
        truth.lit[at] = !occluded(truth.position[at], light, scene, 1);
    }
    const double texel = above.pixel();
    for (const double filter_px : {0.0, 3.0}) {
        const Bytes band = light_texel_band(scene, light, above, truth, filter_px);
        const double width = texel + filter_px * observer.pixel();
        for (std::size_t at = 0; at < band.size(); ++at) {
            const double from_edge =
                std::abs(std::hypot(truth.position[at][0], truth.position[at][2]) - 1);
            const double slack = 0.15 * texel + (filter_px > 0 ? observer.pixel() : 0);
            if (std::abs(from_edge - width) <= slack) continue;
            EXPECT_EQ(band[at] != 0, from_edge < width) << at % size << ", " << at / size;
        }
    }
}

TEST(LightTexelBand, AtASpheresShadowLineReachesRootOfTwoRT) {
    const int size = 512;
    const double radius = 92, angle = -100 * pi / 180;
    const TruthScene scene{{{{0, 0, 0}, radius}}, {}};
    const TruthLight light{false, {std::sin(angle), 0, std::cos(angle)}, {}};
    const TruthView observer{false, {}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             size / 2, 0, -size, size, size};
    TruthView map = observer;
    map.rotation[0] = {std::cos(angle), 0, -std::sin(angle)};
    map.rotation[2] = light.direction;
    const Truth truth = trace(scene, observer, light);
    const Bytes band = light_texel_band(scene, light, map, truth, 0);
    // Along the middle row: both sides of the line, where 1 - sin(azimuth from it) < T / r.
    const double reach = std::acos(1 - 1 / radius), line = -10 * pi / 180;
    EXPECT_NEAR(radius * std::sin(reach), std::sqrt(2 * radius), 0.1);  // 13.5 px
    for (int column = 0; column < size; ++column) {
        const std::size_t at = size / 2 * size + column;
        if (!truth.visible[at]) continue;
        const double azimuth = std::atan2(truth.position[at][0], truth.position[at][2]);
        if (std::abs(std::abs(azimuth - line) - reach) <= 0.02) continue;
        EXPECT_EQ(band[at] != 0, std::abs(azimuth - line) < reach) << column;
    }
}

// What the observer sees is enough to find the band, but where the edge itself is out of sight.
TEST(SeenTexelBand, IsTheSlidPointsBand) {
    const int size = 256;
    const TruthScene scene{{{{0, 0, 0}, 40.0}, {{-45, 55, 10}, 20}},
                           {{{-120, -60, 100}, {240, 0, 0}, {0, 0, -200}}}};
    const double angle = -60 * pi / 180;
    const TruthLight light{false, {std::sin(angle) * 0.8, 0.6, std::cos(angle) * 0.8}, {}};
    const TruthView observer{false, {}, {{1, 0, 0}, {0, 0.8, -0.6}, {0, 0.6, 0.8}},
                             128, 0, -400, 400, size};
    TruthView map = observer;
    map.rotation[2] = light.direction;
    map.rotation[0] = {std::cos(angle), 0, -std::sin(angle)};
    map.rotation[1] = cross(map.rotation[2], map.rotation[0]);
    for (const double texel : {1.0, 3.0}) {
        map.size = static_cast<int>(size / texel);
        const Truth truth = trace(scene, observer, light);
        const Bytes slid = light_texel_band(scene, light, map, truth, 0);
        const Bytes seen = seen_texel_band(map, truth);
        const Bytes near_slid = widened(slid, size, 1.5), near_seen = widened(seen, size, 1.5);
        int missed = 0, beside = 0;
        for (std::size_t at = 0; at < seen.size(); ++at) {
            missed += slid[at] && !near_seen[at];
            beside += seen[at] && !near_slid[at];
        }
        std::printf("texels of %g pixels: %d pixels slid, %d seen; %d missed, %d beside\n", texel,
                    total(slid), total(seen), missed, beside);
        EXPECT_GT(total(slid), 1000 * texel);
        EXPECT_LT(missed, total(slid) / 20);
        EXPECT_LT(beside, total(slid) / 30);
    }
}

// Straight edges: a shift is a distance; a lone wrong pixel is as far as it is.
TEST(EdgeDistance, IsTheShift) {
    const int size = 40;
    const Truth truth = half_lit(size, 20);
    for (const int shift : {-7, -1, 0, 3}) {
        const EdgeDistance d = edge_distance(truth, {shadow_from(size, 20 + shift), {}});
        EXPECT_DOUBLE_EQ(d.mean, std::abs(shift));
        EXPECT_DOUBLE_EQ(d.hausdorff, std::abs(shift));
    }
    Bytes acne = shadow_from(size, 20);
    acne[10 * size + 8] = 255;
    const EdgeDistance d = edge_distance(truth, {acne, {}});
    EXPECT_DOUBLE_EQ(d.hausdorff, 12);
    EXPECT_DOUBLE_EQ(d.mean, 12.0 / 81);
    Bytes band(size * size);
    band[10 * size + 8] = 1;
    EXPECT_DOUBLE_EQ(edge_distance(truth, {acne, {}}, band).hausdorff, 0);
    EXPECT_TRUE(std::isnan(edge_distance(truth, {Bytes(size * size, 0), {}}).mean));
}

// Against the nearest of all pairs.
TEST(EdgeDistance, IsThatOfTheNearestPixels) {
    std::mt19937 bits{seed};
    const int size = 24;
    for (int round = 0; round < 20; ++round) {
        Truth truth = half_lit(size, size);
        Bytes mask(size * size);
        for (int at = 0; at < size * size; ++at) {
            truth.lit[at] = bits() % 5 != 0;
            truth.visible[at] = bits() % 7 != 0;
            mask[at] = bits() % 5 == 0 ? 255 : 0;
        }
        const auto edge = [&](auto dark) {
            std::vector<int> places;
            for (int at = 0; at < size * size; ++at) {
                const auto lit_at = [&](int x, int y) {
                    const int other = y * size + x;
                    return x >= 0 && y >= 0 && x < size && y < size && truth.visible[other] &&
                           !dark(other);
                };
                const int x = at % size, y = at / size;
                if (truth.visible[at] && dark(at) &&
                    (lit_at(x - 1, y) || lit_at(x + 1, y) || lit_at(x, y - 1) || lit_at(x, y + 1)))
                    places.push_back(at);
            }
            return places;
        };
        const auto real = edge([&](int at) { return !truth.lit[at]; });
        const auto drawn = edge([&](int at) { return mask[at] != 0; });
        ASSERT_FALSE(real.empty() || drawn.empty());
        double sum = 0, max = 0;
        const auto add = [&](const std::vector<int>& from, const std::vector<int>& to) {
            for (const int a : from) {
                double min = 1e9;
                for (const int b : to)
                    min = std::min(min, std::hypot(a % size - b % size, a / size - b / size));
                sum += min;
                max = std::max(max, min);
            }
        };
        add(real, drawn);
        add(drawn, real);
        const EdgeDistance d = edge_distance(truth, {mask, {}});
        EXPECT_NEAR(d.mean, sum / static_cast<double>(real.size() + drawn.size()), 1e-9);
        EXPECT_NEAR(d.hausdorff, max, 1e-9);
    }
}

}  // namespace
}  // namespace umbra78::tools
