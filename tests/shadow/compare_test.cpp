// Lookup and comparison: the truth table by hand, and every place against the slow model.
#include "shadow/compare.hpp"

#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/slow_lookup.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow {
namespace {

using hw::DivideStatus;
using test::Random;

// A 16 x 16 map of Q.7 texels, all background but what a test sets. Positions are in texels from
// the map's left and top edge, in 1/128.
class Table : public ::testing::Test {
protected:
    Table() : light(4) {
        spec.xy_bits = 4;
        light.store.clear(spec);
    }
    void set(int x, int y, int code) {
        light.depth[static_cast<std::size_t>(16 * y + x)] = static_cast<std::uint16_t>(code);
    }
    void fill(int code) {
        std::fill(light.depth.begin(), light.depth.end(), static_cast<std::uint16_t>(code));
    }
    bool shadow(int x, int y, int code, DivideStatus status = DivideStatus::ok,
                hw::DitherWords d = {0, 0}) const {
        return in_shadow(LightMap<hw::Depth16>{light.store, spec, lookup, background},
                         hw::Point{x - 8 * one, y - 8 * one, code - 32768, status}, d);
    }

    static constexpr int one = 128;
    hw::MachineSpec spec;
    test::OwnedStore<hw::Depth16> light;
    Lookup lookup = Lookup::nearest;
    Background background = Background::blend;
};

TEST_F(Table, NearestGreaterIsShadowEqualIsLit) {
    fill(1000);
    EXPECT_FALSE(shadow(one, one, 999));
    EXPECT_FALSE(shadow(one, one, 1000));
    EXPECT_TRUE(shadow(one, one, 1001));
    set(3, 5, 2000);
    for (const int x : {0, 1, one - 1})
        for (const int y : {0, 1, one - 1}) {
            EXPECT_FALSE(shadow(3 * one + x, 5 * one + y, 2000));
            EXPECT_TRUE(shadow(3 * one + x, 5 * one + y, 2001));
        }
    EXPECT_TRUE(shadow(3 * one - 1, 5 * one, 2000)) << "the texel to the left";
    EXPECT_TRUE(shadow(4 * one, 5 * one, 2000)) << "the texel to the right";
    EXPECT_TRUE(shadow(3 * one, 5 * one - 1, 2000)) << "the texel above";
    EXPECT_TRUE(shadow(3 * one, 6 * one, 2000)) << "the texel below";
}

TEST_F(Table, BackgroundShadowsNothing) {
    for (const Lookup form : {Lookup::nearest, Lookup::bilinear}) {
        lookup = form;
        for (const int code : {0, 1, 32768, 65533, 65534, 65535})
            EXPECT_FALSE(shadow(one, one, code)) << code;
    }
}

TEST_F(Table, OutsideTheVolumeIsLit) {
    fill(0);
    for (const Lookup form : {Lookup::nearest, Lookup::bilinear}) {
        lookup = form;
        EXPECT_TRUE(shadow(8 * one, 8 * one, 30000));
        // The left and top edge are in, the right and bottom edge are out. Beside the edge
        // bilinear lookup blends the background that lies beyond it.
        const int edge_code = form == Lookup::nearest ? 1 : 65534 * 3 / 4 + 100;
        for (const int in : {0, 1, 16 * one - 1}) {
            EXPECT_TRUE(shadow(in, 8 * one, edge_code)) << in;
            EXPECT_TRUE(shadow(8 * one, in, edge_code)) << in;
        }
        for (const int out : {-1, -one, -4096, 16 * one, 16 * one + 1, 1 << 20}) {
            EXPECT_FALSE(shadow(out, 8 * one, 65534)) << out;
            EXPECT_FALSE(shadow(8 * one, out, 65534)) << out;
        }
        EXPECT_FALSE(shadow(8 * one, 8 * one, -1)) << "before the near plane";
        EXPECT_FALSE(shadow(8 * one, 8 * one, -65536)) << "before the near plane";
        EXPECT_FALSE(shadow(8 * one, 8 * one, 0)) << "at it: a tie";
        EXPECT_TRUE(shadow(8 * one, 8 * one, 1));
        EXPECT_TRUE(shadow(8 * one, 8 * one, 65534)) << "the deepest that is drawn";
        EXPECT_FALSE(shadow(8 * one, 8 * one, 65535)) << "the far plane";
        EXPECT_FALSE(shadow(8 * one, 8 * one, 1 << 20)) << "beyond it";
    }
}

// w <= 0, overflow, off-screen: no quotient, no shadow.
TEST_F(Table, WithoutAQuotientItIsLit) {
    fill(0);
    EXPECT_TRUE(shadow(8 * one, 8 * one, 30000, DivideStatus::ok));
    for (const DivideStatus s : {DivideStatus::divisor_not_positive, DivideStatus::overflow})
        EXPECT_FALSE(shadow(8 * one, 8 * one, 30000, s)) << static_cast<int>(s);
}

TEST_F(Table, DitherMovesTheLookupAndMayLeaveTheVolume) {
    fill(0);
    set(5, 5, 60000);
    const auto at = [&](int x, int y, int dx, int dy) {
        return shadow(x, y, 30000, DivideStatus::ok, {dx, dy});
    };
    EXPECT_FALSE(at(5 * one, 5 * one, 0, 0));
    EXPECT_TRUE(at(5 * one, 5 * one, -1, 0));
    EXPECT_TRUE(at(5 * one, 5 * one, 0, -1));
    EXPECT_FALSE(at(5 * one, 5 * one, 127, 127));
    EXPECT_TRUE(at(5 * one, 5 * one, 128, 0));
    EXPECT_TRUE(at(0, 0, 0, 0));
    EXPECT_FALSE(at(0, 0, -1, 0));
    EXPECT_FALSE(at(16 * one - 1, 0, 1, 0));
    EXPECT_TRUE(at(-1, 0, 1, 0)) << "and may come back into it";
}

// Z is interpolated, not the result: between 1000 and 2000, a quarter of the way, 1250.
TEST_F(Table, BilinearBlendsZ) {
    lookup = Lookup::bilinear;
    fill(1000);
    for (int y = 0; y < 16; ++y)
        for (int x = 8; x < 16; ++x) set(x, y, 2000);
    const int centre = 7 * one + one / 2;
    for (const int x : {0, 1, one / 4, one / 2, one - 1, one}) {
        const int blend_128 = 1000 * one + 1000 * x;  // 128 times the blend
        const int below = blend_128 / one;
        EXPECT_FALSE(shadow(centre + x, 5 * one, below)) << x;
        EXPECT_TRUE(shadow(centre + x, 5 * one, below + 1)) << x;
    }
    set(7, 5, 65535);  // a hole in one of the four: it weighs, or sends all back to nearest
    const int y = 5 * one + one / 2;
    background = Background::blend;
    EXPECT_FALSE(shadow(centre + one / 2, y, 33767)) << "(65535 + 2000) / 2 = 33767.5";
    EXPECT_TRUE(shadow(centre + one / 2, y, 33768));
    background = Background::fall_back;
    EXPECT_TRUE(shadow(centre + one / 2, y, 2001)) << "the point lies in the right texel";
    EXPECT_FALSE(shadow(centre + one / 2, y, 2000));
    EXPECT_FALSE(shadow(centre + one / 2 - 1, y, 65534)) << "here in the hole";
    EXPECT_TRUE(shadow(centre, y + one / 2, 1001)) << "one of the four, at weight 1/2: nearest";
    EXPECT_FALSE(shadow(centre, y - 1, 1000)) << "the texel above";
}

// A texel of weight 0 still counts as one of the four.
TEST_F(Table, FallBackLooksAtAllFourWhateverTheirWeights) {
    lookup = Lookup::bilinear;
    background = Background::fall_back;
    fill(1000);
    for (int x = 0; x < 16; ++x) set(x, 5, 3000);
    set(8, 4, 65535);
    const int x = 7 * one + one / 2, y = 4 * one + one / 2 + one / 4;  // between rows 4 and 5
    EXPECT_TRUE(shadow(x, y, 1001)) << "nearest is row 4, not the blend 1500";
    EXPECT_FALSE(shadow(x - 1, y, 1500)) << "a step to the left the hole is none of the four";
    EXPECT_TRUE(shadow(x - 1, y, 1501));
}

TEST_F(Table, WithoutFractionBitsBilinearIsNearest) {
    spec.fraction_bits = 0;
    lookup = Lookup::bilinear;
    for (int i = 0; i < 256; ++i) set(i % 16, i / 16, 100 * i);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            for (const int code : {100 * (16 * y + x), 100 * (16 * y + x) + 1}) {
                const hw::Point p{x - 8, y - 8, code - 32768, DivideStatus::ok};
                EXPECT_EQ(in_shadow(LightMap<hw::Depth16>{light.store, spec, lookup, background},
                                    p, {0, 0}),
                          code > 100 * (16 * y + x));
            }
}

// Every position at 0, 1 and 2 fraction bits, the map's surroundings included.
TEST(Compare, EveryPlaceAgainstTheSlowModel) {
    Random random;
    for (int round = 0; round < 12; ++round) {
        hw::MachineSpec spec;
        spec.xy_bits = 4;
        spec.fraction_bits = round % 3;
        spec.z_bits = round % 2 == 0 ? 16 : 4;
        test::OwnedStore<hw::Depth16> light(4);
        test::fill_depth(random, spec, light.depth);
        const std::int64_t edge = 9 << spec.fraction_bits;
        for (const Lookup lookup : {Lookup::nearest, Lookup::bilinear})
            for (const Background background : {Background::blend, Background::fall_back}) {
                const LightMap<hw::Depth16> map{light.store, spec, lookup, background};
                for (std::int64_t y = -edge; y <= edge; ++y)
                    for (std::int64_t x = -edge; x <= edge; ++x) {
                        const std::int64_t code = random.between(-2, spec.background() + 2);
                        const hw::Point p{x, y, code - spec.depth_offset(), DivideStatus::ok};
                        ASSERT_EQ(in_shadow(map, p, {0, 0}), test::slow_in_shadow(map, p, {0, 0}))
                            << "round " << round << " at " << x << " " << y << " code " << code;
                    }
            }
    }
}

// Random places of random maps at all widths; the code is put where the answer turns.
TEST(Compare, RandomPlacesAgainstTheSlowModel) {
    Random random;
    int shadowed = 0, lit = 0;
    const int rounds = umbra78::test::effort(400);
    for (int round = 0; round < rounds; ++round) {
        Settings s = test::random_settings(random, false);
        s.machine.xy_bits = 4;
        test::OwnedStore<hw::Depth32> light(4);
        test::fill_depth(random, s.machine, light.depth);
        const LightMap<hw::Depth32> map = light_map<hw::Depth32>(light.store, s);
        const std::int64_t edge = std::int64_t{8} << s.machine.fraction_bits;
        for (int k = 0; k < 60; ++k) {
            hw::Point p{random.between(-edge - 2, edge + 2),
                        random.between(-edge - 2, edge + 2), 0, DivideStatus::ok};
            const auto noise = static_cast<std::int32_t>(edge / 8);
            const hw::DitherWords d{static_cast<std::int32_t>(random.between(-noise, noise)),
                                    static_cast<std::int32_t>(random.between(-noise, noise))};
            hw::TapBytes taps;
            for (auto* bytes : {&taps.x, &taps.y})
                for (std::uint8_t& b : *bytes) b = static_cast<std::uint8_t>(random.bits());
            // The least code that is so dark, by bisection on the slow model.
            const auto level = static_cast<int>(random.between(1, 255));
            const std::int64_t min = -s.machine.depth_offset();
            std::int64_t low = min, high = min + s.machine.deepest_drawn();
            while (low < high) {
                p.z = low + (high - low) / 2;
                test::slow_darkness(map, p, d, taps) >= level ? high = p.z : low = p.z + 1;
            }
            for (p.z = low - 2; p.z <= low + 2; ++p.z) {
                const int expected = test::slow_darkness(map, p, d, taps);
                ++(expected != 0 ? shadowed : lit);
                ASSERT_EQ(darkness(map, p, d, taps), expected)
                    << "round " << round << " at " << p.x << " " << p.y << " " << p.z;
            }
        }
    }
    EXPECT_GT(shadowed, 12 * rounds);
    EXPECT_GT(lit, 12 * rounds);
}

}  // namespace
}  // namespace umbra78::shadow
