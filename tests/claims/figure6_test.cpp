// Figure 6: "shading the spheres according to the position of the light source casting the shadows
// causes a smooth shadow transition which obscures the quantization error" (Williams 1978, p. 274).
//
// The picture with the machine's mask is held against the picture with the exact mask, in grey
// levels, in the band along the shadow line: visible pixels in no other sphere's shadow with
// |N.L| <= sqrt(2 / r), r the sphere's radius in pixels. That is where a surface turns away from
// the light within about a pixel of its depth, and where the mask's error is greatest.
#include "tests/claims/ground.hpp"

#include "shadow/filters/composite.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace umbra78::claims {
namespace {

using shadow::Composite;
using shadow::figure_settings;
using Plane = std::vector<std::uint8_t>;

// In grey levels.
struct Visibility {
    double rms = 0;  // of the machine's picture less that with the exact mask
    int step = 0;    // the greatest difference of horizontal neighbours in the machine's picture
};

// 1 where pixels count whose cosine N.L lies in a range.
Plane region(double min_cosine, double max_cosine) {
    const Ground& g = ground();
    const tools::Truth& t = g.truth;
    Plane counts(t.visible.size());
    for (std::size_t a = 0; a < counts.size(); ++a)
        counts[a] = t.visible[a] != 0 && t.n_dot_l[a] >= min_cosine &&
                    t.n_dot_l[a] <= max_cosine &&
                    !occluded(t.position[a], g.light, g.scene, t.surface[a]);
    return counts;
}

double band_cosine() {
    return std::sqrt(2 / (ground().scene.spheres.front().radius / ground().observer.pixel()));
}

Visibility compare(const Plane& picture, const Plane& exact, const Plane& counts) {
    Visibility v;
    double sum = 0;
    int pixels = 0;
    for (std::size_t a = 0; a < counts.size(); ++a) {
        if (counts[a] == 0) continue;
        const double error = picture[a] - exact[a];
        sum += error * error;
        ++pixels;
        if (a % 512 != 511 && counts[a + 1] != 0)
            v.step = std::max(v.step, std::abs(picture[a + 1] - picture[a]));
    }
    v.rms = std::sqrt(sum / pixels);
    return v;
}

Plane exact_mask() {
    const tools::Truth& t = ground().truth;
    Plane mask(t.visible.size());
    for (std::size_t a = 0; a < mask.size(); ++a)
        mask[a] = t.visible[a] != 0 && t.lit[a] == 0 ? 255 : 0;
    return mask;
}

Plane copy(std::span<const std::uint8_t> plane) { return {plane.begin(), plane.end()}; }

// The picture that a mask makes of figure 1.
Plane shaded(const Machine& m, const Plane& mask, Composite of) {
    const auto& drawn = m.buffers().observer;
    Plane out(mask.size());
    shadow::composite(drawn.intensity,
                      of == Composite::whole ? drawn.intensity : drawn.direct, mask,
                      m.settings.density_q8, out);
    return out;
}

Visibility report(const std::string& what, const Visibility& v) {
    std::printf("%-54s rms %7.2f, step %3d\n", what.c_str(), v.rms, v.step);
    return v;
}

TEST(Figure6, ShadingHidesTheQuantizationAtTheLine) {
    const Machine six(figure_settings(6));
    ASSERT_EQ(six.settings.density_q8, 218);
    const Plane band = region(-band_cosine(), band_cosine());
    const Plane mask = copy(six.buffers().lights[0].filtered), exact = exact_mask();
    const Plane picture = shaded(six, mask, Composite::direct);
    ASSERT_EQ(picture, copy(six.buffers().picture));
    const auto seen = [&](const char* what, Composite of) {
        return report(what, compare(shaded(six, mask, of), shaded(six, exact, of), band));
    };
    std::printf("at the shadow line, %d pixels with |N.L| <= %.3f:\n",
                static_cast<int>(std::count(band.begin(), band.end(), 1)), band_cosine());
    const Visibility five = report("figure 5's mask as a picture", compare(mask, exact, band));
    const Visibility direct = seen("figure 6", Composite::direct);
    const Visibility whole = seen("figure 6, the ambient term darkened, too", Composite::whole);
    EXPECT_LE(direct.rms, five.rms / 50);
    EXPECT_LE(direct.step, 6);
    EXPECT_GT(whole.rms, five.rms / 50) << "the control";
    EXPECT_GT(whole.step, 6) << "the control";
}

// With figure 3's mask the error shows wherever much direct light falls: shading hides it near the
// line alone. Figure 6's own mask has little of it there.
TEST(Figure6, ShadingHidesNothingWhereMuchLightFalls) {
    const Machine three(figure_settings(3)), six(figure_settings(6));
    const Plane exact = shaded(six, exact_mask(), Composite::direct);
    const Plane coarse = shaded(six, copy(three.buffers().lights[0].mask), Composite::direct);
    const Plane fine = copy(six.buffers().picture);
    const Plane band = region(-band_cosine(), band_cosine());
    const Visibility at_line = report("figure 3's mask, at the line", compare(coarse, exact, band));
    const Visibility lit_side =
        report("figure 3's mask, the lit side", compare(coarse, exact, region(0, 1)));
    const Visibility lit_side6 =
        report("figure 6's mask, the lit side", compare(fine, exact, region(0, 1)));
    std::printf("figure 3's mask by N.L:");
    std::vector<double> rms;
    for (int k = 0; k < 10; ++k) {
        const Visibility v = compare(coarse, exact, region(0.1 * k, 0.1 * (k + 1)));
        std::printf(" %.1f: rms %.1f step %d;", 0.1 * k, v.rms, v.step);
        rms.push_back(v.rms);
    }
    std::printf("\n");
    for (std::size_t k = 1; k < 6; ++k) EXPECT_GT(rms[k], rms[k - 1]) << "more light, more error";
    EXPECT_GT(at_line.rms, 2);
    EXPECT_LT(at_line.rms, 8);
    EXPECT_GT(lit_side.step, 100);
    EXPECT_LT(lit_side6.step, 60);
    EXPECT_LT(lit_side6.rms, lit_side.rms / 4);
}

// Williams compares a shadow's translucency to "the additive ambient term": at density 1 a full
// shadow is that term exactly, highlights included; below it highlights are darkened, not absent.
TEST(Figure6, AFullShadowOfDensityOneIsTheAmbientTerm) {
    Settings s = figure_settings(6);
    s.density_q8 = 256;
    const Machine black(s);
    const int ambient = (shadow::figure_material.diffuse[0] * s.ambient_q8 + 128) / 256;
    int in_shadow = 0;
    for (std::size_t a = 0; a < black.visible.size(); ++a) {
        if (black.buffers().lights[0].filtered[a] != shadow::mask_shadow) continue;
        ASSERT_EQ(black.buffers().picture[a], ambient) << a;
        ++in_shadow;
    }
    EXPECT_GT(in_shadow, 60000);
}

}  // namespace
}  // namespace umbra78::claims
