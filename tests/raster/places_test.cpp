// Sampling at places: at the pixels' centres it gives what centre sampling gives, and elsewhere
// what the rules say, place by place.
#include "raster/places.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/inputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

namespace umbra78::raster {
namespace {

using umbra78::test::effort;
using umbra78::test::Inputs;

constexpr hw::MachineSpec small{.xy_bits = 4};

struct Listed {
    explicit Listed(std::size_t places)
        : room(places), heads(16 * 16), list(small, room, heads) {}
    std::vector<Place> room;
    std::vector<std::uint32_t> heads;
    Places list;
};

std::unique_ptr<Listed> at_centres() {
    auto places = std::make_unique<Listed>(16 * 16);
    for (int py = 0; py < 16; ++py)
        for (int px = 0; px < 16; ++px)
            places->list.add(pixel_centre(px, 8), pixel_centre(py, 8), px, py);
    return places;
}

auto words_of(const Sample& s) {
    return std::tuple(s.py, s.px, s.leaf_j, s.leaf_i, s.second, s.z, s.x, s.y);
}
using SampleWords = std::vector<decltype(words_of(Sample{}))>;

auto into(SampleWords& all) {
    return [&all](const Sample& s) { all.push_back(words_of(s)); };
}

std::int32_t random_within(Inputs& random, std::int64_t reach) {
    return static_cast<std::int32_t>(random.between(-reach, reach));
}

Corner random_place(Inputs& random, std::int64_t reach) {
    const std::int32_t x = random_within(random, reach), y = random_within(random, reach);
    return {x, y, random_within(random, 1 << 22)};
}

// Corners on the places themselves, so that edges pass through many: each belongs to the triangle
// whose left or top edge it lies on, as a pixel's centre does.
TEST(Places, OnEdgesBelongAsCentresDo) {
    Inputs random(62);
    const auto places = at_centres();
    const auto on_a_place = [&] {
        const auto pixel = [&] { return static_cast<int>(random.between(0, 15)); };
        const std::int32_t x = pixel_centre(pixel(), 8), y = pixel_centre(pixel(), 8);
        return Corner{x, y, random_within(random, 1 << 22)};
    };
    std::size_t samples = 0;
    for (int n = 0; n < effort(1000); ++n) {
        const Corner a = on_a_place(), b = on_a_place(), c = on_a_place();
        SampleWords plain, at;
        sample_triangle(a, b, c, small, into(plain));
        sample_triangle_places(a, b, c, places->list, into(at));
        std::ranges::sort(plain);
        std::ranges::sort(at);
        ASSERT_EQ(at, plain) << n;
        samples += at.size();
    }
    EXPECT_GT(samples, static_cast<std::size_t>(effort(1000)));
}

TEST(Places, AtCentresSampleTrianglesAsCentresDo) {
    Inputs random(61);
    const auto places = at_centres();
    std::size_t samples = 0;
    for (int n = 0; n < effort(3000); ++n) {
        const std::int64_t reach = n % 3 == 0 ? 200 << 13 : 12 << 13;
        const Corner a = random_place(random, reach), b = random_place(random, reach),
                     c = n % 5 == 0 ? Corner{a.x, b.y, a.z} : random_place(random, reach);
        SampleWords plain, at;
        sample_triangle(a, b, c, small, into(plain));
        sample_triangle_places(a, b, c, places->list, into(at));
        std::ranges::sort(plain);
        std::ranges::sort(at);
        ASSERT_EQ(at, plain) << n;
        samples += at.size();
    }
    EXPECT_GT(samples, std::size_t{10} * effort(3000));
}

// A bent sheet of leaves of about a pixel.
Corners random_block(Inputs& random) {
    Corners g{};
    const std::int32_t x = random_within(random, 6 << 13), y = random_within(random, 6 << 13);
    const std::int32_t step = random_within(random, 8000), other = random_within(random, 8000);
    for (int v = 0; v < corners; ++v)
        for (int u = 0; u < corners; ++u) {
            const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
            g[0][j][i] = x + u * step - v * other + random_within(random, 900);
            g[1][j][i] = y + v * step + u * other + random_within(random, 900);
            g[2][j][i] = u * 300 - v * 200 + random_within(random, 90);
        }
    return g;
}

TEST(Places, AtCentresSampleBlocksAsCentresDo) {
    Inputs random(62);
    const auto places = at_centres();
    std::size_t samples = 0;
    for (int n = 0; n < effort(600); ++n) {
        const Corners g = random_block(random);
        SampleWords plain, at;
        const std::uint64_t tested = sample_centres(g, small, into(plain));
        EXPECT_EQ(sample_block_places(g, places->list, into(at)), tested) << n;
        std::ranges::sort(plain);
        std::ranges::sort(at);
        ASSERT_EQ(at, plain) << n;
        samples += at.size();
    }
    EXPECT_GT(samples, std::size_t{50} * effort(600));
}

// Anywhere: each place by itself, several in a pixel and none in others.
TEST(Places, AreAskedOneByOneByTheRules) {
    Inputs random(63);
    std::size_t samples = 0;
    for (int n = 0; n < effort(300); ++n) {
        Listed places(40);
        for (int k = 0; k < 40; ++k) {
            const std::int32_t x = random_within(random, (8 << 13) - 1),
                               y = random_within(random, k < 20 ? 9000 : (8 << 13) - 1);
            places.list.add(x, y, 300 + k, 500 - k);
        }
        const Corners g = random_block(random);
        SampleWords expected, at;
        for (const Place& p : places.room)
            for (int j = 0; j < leaves; ++j)
                for (int i = 0; i < leaves; ++i) {
                    const Corner a = corner_at(g, i, j), c = corner_at(g, i + 1, j + 1);
                    const auto ask = [&](const Corner& b, const Corner& d, bool second) {
                        std::int64_t z = 0;
                        const bool hit = second ? triangle_depth(a, c, d, p.x, p.y, z)
                                                : triangle_depth(a, b, c, p.x, p.y, z);
                        if (hit)
                            expected.push_back(words_of({p.px, p.py, p.x, p.y, z, i, j, second}));
                    };
                    ask(corner_at(g, i + 1, j), corner_at(g, i, j + 1), false);
                    ask(corner_at(g, i + 1, j), corner_at(g, i, j + 1), true);
                }
        sample_block_places(g, places.list, into(at));
        std::ranges::sort(expected);
        std::ranges::sort(at);
        ASSERT_EQ(at, expected) << n;
        samples += at.size();
    }
    EXPECT_GT(samples, std::size_t{2} * effort(300));
}

}  // namespace
}  // namespace umbra78::raster
