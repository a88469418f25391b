// The paper's sentence about figure 3's two bands, asked of every azimuth, registration and
// sampling: false shadow greatest at the shadow line, and in "a dark curved band to the left of
// it", which is "the right edge of the spheres in the untransformed observer's view".
//
// Only what is measured is asserted. With exact centres there is never a band at the limb, at any
// azimuth. With the pixel's index for its coordinate (half a pixel of misregistration) and the
// light on the right, the limb is all dark, while the other end is dark as ever.
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace umbra78::claims {
namespace {

using raster::Sampling;
using shadow::figure_settings;
using shadow::Lookup;
using shadow::Registration;

constexpr int bins = 8;

struct Bands {
    double limb, middle, line;
};

Bands bands(int azimuth, Registration registration, Sampling sampling, int bias = 64) {
    Settings s = with(figure_settings(3), Lookup::nearest, bias);
    s.registration = registration;
    s.sampling = sampling;
    const Ground g(azimuth);
    const Machine machine(s, azimuth);
    const auto rates = profile(g, machine.compared(), bins);
    std::printf("azimuth %4d, %-6s registration, %-6s sampling, bias %2d:", azimuth,
                registration == Registration::centre ? "centre" : "index",
                sampling == Sampling::centre ? "centre" : "leaf", bias);
    for (const ShadowError& e : rates) std::printf(" %.3f", e.false_shadow_rate());
    std::printf("\n");
    return {rates.front().false_shadow_rate(), rates[bins / 2].false_shadow_rate(),
            rates.back().false_shadow_rate()};
}

TEST(Bands, WithCentresFalseShadowRisesToTheLineAtEveryAzimuth) {
    for (const int azimuth : {-100, -80, 80, 100}) {
        const Bands b = bands(azimuth, Registration::centre, Sampling::centre);
        EXPECT_LT(b.limb, 0.002) << azimuth;
        EXPECT_LT(b.middle, 0.2) << azimuth;
        EXPECT_GT(b.line, 0.4) << azimuth;
    }
}

TEST(Bands, LeafSamplingRaisesTheLineNotTheLimb) {
    for (const int azimuth : {-100, -80, 80, 100}) {
        const Bands b = bands(azimuth, Registration::centre, Sampling::leaf);
        EXPECT_LT(b.limb, 0.03) << azimuth;
        EXPECT_GT(b.line, 0.8) << azimuth;
    }
}

// Half a pixel to the left and above, which is toward a light on the left: less false shadow.
TEST(Bands, IndexRegistrationUnderALightOnTheLeftMakesNoLimb) {
    for (const int azimuth : {-100, -80})
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
            const Bands b = bands(azimuth, Registration::index, sampling);
            EXPECT_LT(b.limb, 0.005) << azimuth;
            EXPECT_LT(b.middle, 0.03) << azimuth;
            EXPECT_GT(b.line, 0.3) << azimuth;
        }
}

// Away from a light on the right: the limb darkens with the rest. At figure 3's bias it is as dark
// as the line; at half of it, it is wholly dark, and darker than the line.
TEST(Bands, IndexRegistrationUnderALightOnTheRightMakesADarkLimb) {
    const Bands at_64 = bands(100, Registration::index, Sampling::centre);
    EXPECT_GT(at_64.limb, 0.4);
    EXPECT_GT(at_64.line, 0.5);
    const Bands at_32 = bands(100, Registration::index, Sampling::centre, 32);
    EXPECT_GT(at_32.limb, 0.98);
    EXPECT_LT(at_32.line, 0.7);
    EXPECT_GT(at_32.line, 0.5);
    const Bands centred = bands(100, Registration::centre, Sampling::centre, 32);
    EXPECT_LT(centred.limb, 0.05) << "the misregistration makes it, not the bias";
    EXPECT_GT(bands(80, Registration::index, Sampling::centre, 32).limb, 0.98);
    EXPECT_GT(bands(80, Registration::index, Sampling::centre).limb, 0.1);
    // With leaf centres a light on the right leaves a paler limb.
    EXPECT_LT(bands(100, Registration::index, Sampling::leaf).limb, 0.1);
    EXPECT_LT(bands(80, Registration::index, Sampling::leaf).limb, 0.1);
}

}  // namespace
}  // namespace umbra78::claims
