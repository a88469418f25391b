// Highlights in shadow: the post-process darkens them, the correct form has none (Williams 1978,
// p. 272). Truth says which pixels are in shadow; a matte copy of the scene, what is highlight.
#include "tests/claims/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace umbra78::claims {
namespace {

using shadow::figure_settings;
using shadow::Form;

struct Highlights {
    int pixels = 0;        // in the mask's shadow with a highlight left in the picture
    int strongest = 0;     // levels
    int mean_q8 = 0;       // mean level of those pixels' highlight, Q.8
    int in_truth = 0;      // of them, in shadow in truth as well
    int ambient_only = 0;  // pixels in shadow at the ambient level exactly
    int in_shadow = 0;
};

Highlights highlights(const char* what, Form form) {
    Settings s = figure_settings(6);
    s.form = form;
    shadow::test::FigureScene matte;
    matte.materials[0].specular = 0;
    const Machine glossy(s);
    const shadow::test::Frame<> dull(matte.scene(), s);
    const int ambient = (shadow::figure_material.diffuse[0] * s.ambient_q8 + 128) / 256;
    Highlights h;
    int sum = 0;
    for (std::size_t a = 0; a < glossy.visible.size(); ++a) {
        if (glossy.buffers().lights[0].filtered[a] != shadow::mask_shadow) continue;
        ++h.in_shadow;
        h.ambient_only += glossy.buffers().picture[a] == ambient;
        const int glow = glossy.buffers().picture[a] - dull.buffers.picture[a];
        if (glow == 0) continue;
        ++h.pixels;
        sum += glow;
        h.strongest = std::max(h.strongest, glow);
        h.in_truth += ground().truth.visible[a] != 0 && ground().truth.lit[a] == 0;
    }
    h.mean_q8 = h.pixels == 0 ? 0 : sum * 256 / h.pixels;
    std::printf("figure 6, %s: %d pixels wholly in shadow, %d with a highlight (%d of them in "
                "truth's shadow), of %.1f levels on the mean and %d at most; %d at the "
                "ambient level %d\n",
                what, h.in_shadow, h.pixels, h.in_truth, h.mean_q8 / 256.0, h.strongest,
                h.ambient_only, ambient);
    return h;
}

TEST(Highlights, AreDarkenedInThePostProcessAndAbsentInTheCorrectForm) {
    const Highlights post = highlights("post-process", Form::post_process);
    const Highlights correct = highlights("correct form", Form::correct);
    EXPECT_GT(post.pixels, 500);
    EXPECT_GT(post.in_truth, 9 * post.pixels / 10);
    EXPECT_GT(post.strongest, 8);
    EXPECT_EQ(correct.pixels, 0);
    EXPECT_EQ(correct.ambient_only, correct.in_shadow);
    EXPECT_GT(correct.in_shadow, 60000);
}

}  // namespace
}  // namespace umbra78::claims
