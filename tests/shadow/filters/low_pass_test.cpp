// The low-pass: its impulse response, its borders, and every pixel against a slow model.
#include "shadow/filters/low_pass.hpp"

#include "shadow/filters/low_pass_form.hpp"

#include "tests/shadow/random_frames.hpp"
#include "tests/support/buffers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::Random;

constexpr hw::Depth16 empty = 65535;

struct FilteredPicture {
    explicit FilteredPicture(int bits)
        : size(1 << bits), observer(bits), mask(observer.depth.size()), out(mask.size(), 99) {
        std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{0});
    }
    std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * size + x); }
    void filter() { low_pass<hw::Depth16>(mask, observer.store, empty, out); }

    int size;
    test::OwnedStore<hw::Depth16> observer;
    std::vector<std::uint8_t> mask, out;
};

// The definition: 9 weights of 1, 2, 4 sixteenths; what is not seen is the pixel itself.
std::uint8_t slow_pixel(const FilteredPicture& p, int x, int y) {
    constexpr std::array<std::array<int, 3>, 3> weight{{{1, 2, 1}, {2, 4, 2}, {1, 2, 1}}};
    if (p.observer.depth[p.at(x, y)] == empty) return 0;
    int sum = 0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const int u = x + i - 1, v = y + j - 1;
            const bool seen = u >= 0 && v >= 0 && u < p.size && v < p.size &&
                              p.observer.depth[p.at(u, v)] != empty;
            sum += weight[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] *
                   p.mask[seen ? p.at(u, v) : p.at(x, y)];
        }
    return static_cast<std::uint8_t>((2 * sum + 16) / 32);  // half up
}

TEST(LowPass, WeightsThatAreToldAreThoseThatAreUsed) {
    constexpr std::array<std::array<int, 3>, 3> weight{{{1, 2, 1}, {2, 4, 2}, {1, 2, 1}}};
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            EXPECT_EQ(low_pass_weight(dx, dy), weight[static_cast<std::size_t>(dy + 1)]
                                                     [static_cast<std::size_t>(dx + 1)]);
}

TEST(LowPass, AConstantStaysConstant) {
    Random random;
    for (const int level : {0, 1, 127, 128, 254, 255}) {
        FilteredPicture p(5);
        std::fill(p.mask.begin(), p.mask.end(), static_cast<std::uint8_t>(level));
        p.filter();
        EXPECT_EQ(p.out, p.mask);
        // With holes in the surface as well: a shadow does not fade toward a silhouette.
        for (hw::Depth16& z : p.observer.depth) z = random.bits() % 3 == 0 ? empty : hw::Depth16{5};
        p.filter();
        for (std::size_t a = 0; a < p.out.size(); ++a)
            ASSERT_EQ(p.out[a], p.observer.depth[a] == empty ? 0 : level);
    }
}

TEST(LowPass, AnImpulseBecomesTheWeights) {
    for (const int level : {255, 16, 8, 7, 1}) {
        FilteredPicture p(4);
        p.mask[p.at(6, 9)] = static_cast<std::uint8_t>(level);
        p.filter();
        const auto share = [&](int weight) { return (level * weight + 8) / 16; };
        int total = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const int dx = std::abs(x - 6), dy = std::abs(y - 9);
                const int weight = dx > 1 || dy > 1 ? 0 : (2 - dx) * (2 - dy);
                ASSERT_EQ(p.out[p.at(x, y)], share(weight)) << x << " " << y;
                total += p.out[p.at(x, y)];
            }
        EXPECT_EQ(total, share(4) + 4 * share(2) + 4 * share(1));
    }
}

TEST(LowPass, BeyondTheFrameAndBackgroundIsThePixelItself) {
    FilteredPicture p(4);
    p.mask[p.at(0, 0)] = 255;
    p.filter();
    EXPECT_EQ(p.out[p.at(0, 0)], (255 * (4 + 1 + 2 + 1 + 2 + 1) + 8) / 16)
        << "its own weight, and those that fall outside";
    EXPECT_EQ(p.out[p.at(1, 0)], (255 * 2 + 8) / 16);
    EXPECT_EQ(p.out[p.at(1, 1)], (255 * 1 + 8) / 16);
    p.observer.depth[p.at(0, 0)] = empty;  // what is not seen gives nothing to its neighbours
    p.filter();
    for (const std::uint8_t v : p.out) EXPECT_EQ(v, 0);
}

// By every form that this machine has; a wide frame takes several strips.
TEST(LowPass, IsTheSlowModel) {
    Random random;
    for (int round = 0; round < 40; ++round) {
        FilteredPicture p(round == 39 ? 10 : 4 + round % 3);
        const std::uint64_t holes = random.bits() % 4;
        for (std::size_t a = 0; a < p.mask.size(); ++a) {
            p.mask[a] = random.bits() % 2 == 0 ? static_cast<std::uint8_t>(random.bits())
                                               : test::pick(random, {std::uint8_t{0},
                                                                     std::uint8_t{255}});
            p.observer.depth[a] = random.bits() % 8 < holes ? empty : hw::Depth16{65534};
        }
        std::vector<std::uint8_t> expected;
        for (int y = 0; y < p.size; ++y)
            for (int x = 0; x < p.size; ++x) expected.push_back(slow_pixel(p, x, y));
        for (const LowPassForm& form : low_pass_forms()) {
            if (!form.supported()) continue;
            SCOPED_TRACE(form.name);
            std::fill(p.out.begin(), p.out.end(), std::uint8_t{99});
            low_pass<hw::Depth16>(p.mask, p.observer.store, empty, p.out,
                                  LineSet::all(p.size), form);
            umbra78::test::expect_equal_buffers("low_pass", p.size, expected, p.out);
        }
    }
}

// Lines that are left out, in any pattern, do not upset the others.
TEST(LowPass, OfSomeLinesIsThatOfAll) {
    Random random;
    FilteredPicture p(5);
    for (std::size_t a = 0; a < p.mask.size(); ++a) {
        p.mask[a] = static_cast<std::uint8_t>(random.bits());
        p.observer.depth[a] = random.bits() % 4 == 0 ? empty : hw::Depth16{1};
    }
    p.filter();
    const std::vector<std::uint8_t> all = p.out;
    for (int round = 0; round < 100; ++round) {
        LineSet lines(p.size);
        for (int y = 0; y < p.size; ++y)
            if (random.bits() % 2 == 0) lines.add(y);
        std::fill(p.out.begin(), p.out.end(), std::uint8_t{99});
        low_pass<hw::Depth16>(p.mask, p.observer.store, empty, p.out, lines);
        for (int y = 0; y < p.size; ++y)
            for (int x = 0; x < p.size; ++x)
                ASSERT_EQ(p.out[p.at(x, y)], lines.has(y) ? all[p.at(x, y)] : 99);
    }
}

}  // namespace
}  // namespace umbra78::shadow
