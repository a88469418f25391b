// The AP-120B's lookup by itself: the ends of the light's volume, the deepest code, the divisor.
#include "shadow/ap120b/post_process.hpp"

#include "tests/shadow/random_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace umbra78::shadow {
namespace {

using fixed::Float38;
using hw::ap120b::Vector;

// A value of 2^fraction-ths.
Float38 parts(std::int64_t v, int fraction) { return Float38::from_scaled(v, -fraction); }
Float38 whole(std::int64_t v) { return parts(v, 0); }

// A 16 x 16 map of one code; a point is (X, Y) in texels from the map's corner and K in codes.
class ArrayLookup : public ::testing::Test {
protected:
    ArrayLookup() : light(4) {
        spec.xy_bits = 4;
        fill(0);
    }
    void fill(int code) {
        std::fill(light.depth.begin(), light.depth.end(), static_cast<hw::Depth16>(code));
    }
    bool shadow(const Float38& x, const Float38& y, const Float38& k,
                hw::DitherWords d = {0, 0}) const {
        return divided({x, y, k, whole(1)}, true, d);
    }
    bool divided(const Vector& p, bool affine, hw::DitherWords d = {0, 0}) const {
        return array_in_shadow(LightMap<hw::Depth16>{light.store, spec, lookup, background}, p,
                               affine, d);
    }

    hw::MachineSpec spec;
    test::OwnedStore<hw::Depth16> light;
    Lookup lookup = Lookup::nearest;
    Background background = Background::blend;
};

// In codes, between which K may lie: 0 and 65534 are inside, and nothing beyond them is.
TEST_F(ArrayLookup, TheDepthsEnds) {
    const Float38 middle = whole(8);
    for (const Lookup form : {Lookup::nearest, Lookup::bilinear}) {
        lookup = form;
        EXPECT_TRUE(shadow(middle, middle, whole(65534))) << "the deepest that is drawn";
        EXPECT_TRUE(shadow(middle, middle, parts(65534 * 256 - 1, 8)));
        EXPECT_FALSE(shadow(middle, middle, parts(65534 * 256 + 1, 8))) << "just beyond it";
        EXPECT_FALSE(shadow(middle, middle, whole(65535)));
        EXPECT_FALSE(shadow(middle, middle, whole(70000)));
        EXPECT_FALSE(shadow(middle, middle, whole(0))) << "equal is lit";
        EXPECT_TRUE(shadow(middle, middle, parts(1, 8))) << "K is not rounded to a code";
        EXPECT_FALSE(shadow(middle, middle, parts(-1, 8))) << "in front of the near plane";
    }
    fill(65533);
    EXPECT_TRUE(shadow(middle, middle, whole(65534)));
    EXPECT_FALSE(shadow(middle, middle, whole(65533)));
    for (spec.z_bits = 4; spec.z_bits < 16; ++spec.z_bits) {
        fill(0);
        const int deepest = (1 << spec.z_bits) - 2;
        EXPECT_TRUE(shadow(middle, middle, whole(deepest))) << spec.z_bits;
        EXPECT_FALSE(shadow(middle, middle, parts(2 * deepest + 1, 1))) << spec.z_bits;
    }
}

TEST_F(ArrayLookup, TheWidthsEnds) {
    const Float38 middle = whole(8), k = whole(30000);
    for (const int in : {0, 1, 4095}) {  // in 256ths of a texel
        EXPECT_TRUE(shadow(parts(in, 8), middle, k)) << in;
        EXPECT_TRUE(shadow(middle, parts(in, 8), k)) << in;
    }
    for (const int out : {-1, 4096, 4097}) {
        EXPECT_FALSE(shadow(parts(out, 8), middle, k)) << out;
        EXPECT_FALSE(shadow(middle, parts(out, 8), k)) << out;
    }
    // At the right and lower edge half the weight is the background's, so the blend would be
    // 32767.5 and a deep point in shadow: but the edge itself is outside.
    lookup = Lookup::bilinear;
    EXPECT_FALSE(shadow(whole(16), middle, whole(65534)));
    EXPECT_FALSE(shadow(middle, whole(16), whole(65534)));
    EXPECT_TRUE(shadow(parts(16 * 256 - 1, 8), middle, whole(65534)));
    EXPECT_TRUE(shadow(middle, parts(16 * 256 - 1, 8), whole(65534)));
    lookup = Lookup::nearest;
    // Dither comes before the test, and may lead out of the map or back; Q.7 texels.
    EXPECT_FALSE(shadow(whole(0), middle, k, {-1, 0}));
    EXPECT_FALSE(shadow(middle, whole(0), k, {0, -1}));
    EXPECT_TRUE(shadow(parts(-1, 7), parts(-1, 7), k, {1, 1}));
    EXPECT_FALSE(shadow(parts(16 * 128 - 1, 7), middle, k, {1, 0}));
    EXPECT_TRUE(shadow(whole(16), whole(16), k, {-1, -1}));
}

// Texel (5, 3) alone is far: its own ends, in either lookup.
TEST_F(ArrayLookup, TheTexelsEnds) {
    fill(1000);
    light.depth[3 * 16 + 5] = 2000;
    const Float38 y = parts(7, 1);
    for (const int x : {5 * 256, 5 * 256 + 255}) EXPECT_FALSE(shadow(parts(x, 8), y, whole(2000)));
    for (const int x : {5 * 256 - 1, 6 * 256}) EXPECT_TRUE(shadow(parts(x, 8), y, whole(2000)));
    const Float38 x = parts(11, 1);
    for (const int v : {3 * 256, 3 * 256 + 255}) EXPECT_FALSE(shadow(x, parts(v, 8), whole(2000)));
    for (const int v : {3 * 256 - 1, 4 * 256}) EXPECT_TRUE(shadow(x, parts(v, 8), whole(2000)));
    lookup = Lookup::bilinear;
    // A quarter of the way from the centre of (4, 3) to that of (5, 3): 1250.
    EXPECT_FALSE(shadow(parts(19, 2), y, whole(1250)));
    EXPECT_TRUE(shadow(parts(19, 2), y, parts(1250 * 256 + 1, 8)));
    EXPECT_FALSE(shadow(x, parts(15, 2), whole(1750)));
    EXPECT_TRUE(shadow(x, parts(15, 2), parts(1750 * 256 + 1, 8)));
    // A hole among the four sends it back to the texel that the point lies in.
    light.depth[3 * 16 + 6] = 65535;
    EXPECT_FALSE(shadow(parts(23, 2), y, whole(10000))) << "a quarter of 65535 blends in";
    background = Background::fall_back;
    EXPECT_TRUE(shadow(parts(23, 2), y, whole(2001)));
    EXPECT_FALSE(shadow(parts(23, 2), y, whole(2000)));
}

// The blend is lerp(a, b, t) = a + t (b - a), each operation rounded once to a word: K at the blend
// is lit, one unit in K's last place above it is in shadow. On rationals, rounded step by step.
TEST_F(ArrayLookup, TheBlendIsRoundedStepByStep) {
    using fixed::Rational;
    test::Random random;
    const auto power = [](int n) {
        const Rational p(std::int64_t{1} << std::abs(n));
        return n < 0 ? Rational(1) / p : p;
    };
    const auto value = [&](const Float38& f) {
        return f.is_zero() ? Rational(0)
                           : Rational(f.mantissa()) * power(f.biased_exponent() - 512 - 27);
    };
    const auto kept = [&](const Rational& exact) {
        return value(Float38::from_rational(exact)).reduced();
    };
    const auto lerp = [&](const Rational& a, const Rational& b, const Rational& t) {
        return kept(a + kept(t * kept(b - a)));
    };
    lookup = Lookup::bilinear;
    for (int round = 0; round < 3000; ++round) {
        std::array<Rational, 4> z;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::int64_t code = random.between(0, 65534);
            light.depth[(3 + k / 2) * 16 + 5 + k % 2] = static_cast<hw::Depth16>(code);
            z[k] = code;
        }
        // From the centre of texel (5, 3) on; 20 fraction bits.
        const std::int64_t fx = random.between(0, (1 << 20) - 1);
        const std::int64_t fy = random.between(0, (1 << 20) - 1);
        const Rational tx(fx, 1 << 20), ty(fy, 1 << 20);
        const Float38 blend =
            Float38::from_rational(lerp(lerp(z[0], z[1], tx), lerp(z[2], z[3], tx), ty));
        if (blend.is_zero()) continue;
        const Float38 above =
            Float38::from_rational(value(blend) + power(blend.biased_exponent() - 512 - 27));
        const Float38 x = parts((std::int64_t{11} << 19) + fx, 20);
        const Float38 y = parts((std::int64_t{7} << 19) + fy, 20);
        ASSERT_FALSE(shadow(x, y, blend)) << round;
        ASSERT_TRUE(shadow(x, y, above)) << round;
    }
}

// W <= 0 has no quotient: lit. Else X, Y and K are divided by it, and by an affine matrix's not.
TEST_F(ArrayLookup, TheDivisor) {
    const auto point = [](int scale_16ths) {
        const auto times = [&](int v) { return parts(std::int64_t{v} * scale_16ths, 4); };
        return Vector{times(8), times(8), times(30000), parts(scale_16ths, 4)};
    };
    for (const int w : {1, 16, 160}) EXPECT_TRUE(divided(point(w), false)) << w;
    EXPECT_FALSE(divided(point(0), false));
    for (const int w : {-1, -16}) EXPECT_FALSE(divided(point(w), false)) << w;
    EXPECT_FALSE(divided({whole(8), whole(8), whole(30000), Float38()}, false)) << "W = 0";
    EXPECT_TRUE(divided({whole(8), whole(8), whole(30000), Float38()}, true)) << "W is not read";
    EXPECT_FALSE(divided(point(160), true)) << "X and Y are out of the map as they are";
}

}  // namespace
}  // namespace umbra78::shadow
