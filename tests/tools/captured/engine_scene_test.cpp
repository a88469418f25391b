// Buffers as an engine draws them: the machine's mask is that of the same test in double precision
// but where the stated roundings decide, and that of rays but at the shadow's edges.
#include "tests/tools/captured/engine_scene.hpp"
#include "tools/captured/report.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools::captured {
namespace {

using test::Camera;
using test::Real4;

constexpr double far_quanta = 1 << 26;

// A pixel's place in the light in double precision: texels from the left and the top, and quanta.
std::array<double, 3> place_of(const Capture& c, int x, int y, double depth) {
    const Sides from{c.observer.width, c.observer.height};
    const Real4 p{(2 * x + 1.0) / from.width - 1, 1 - (2 * y + 1.0) / from.height, depth, 1};
    Real4 q{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) q[i] += c.matrix[4 * i + j] * p[j];
    return {(q[0] / q[3] + 1) / 2 * c.light.width, (1 - q[1] / q[3]) / 2 * c.light.height,
            q[2] / q[3] * far_quanta};
}

bool is_outside(const Capture& c, const std::array<double, 3>& p) {
    return p[0] < 0 || p[1] < 0 || p[0] >= c.light.width || p[1] >= c.light.height;
}

// Whether rounding may decide: the observer's depth is off by half a quantum, X and Y by half a
// 128th of a texel, both Z by half a quantum each and the point's by half a float's step, which is
// two quanta, too; matrix words of 32 bits by less than one more of each.
bool is_close(const Capture& c, int x, int y, double bias) {
    const double depth = c.observer.at(x, y);
    const auto here = place_of(c, x, y, depth), low = place_of(c, x, y, depth - 0.5 / far_quanta),
               high = place_of(c, x, y, depth + 0.5 / far_quanta);
    for (std::size_t k = 0; k < 2; ++k) {
        const double off = std::abs(high[k] - low[k]) + 1.5 / 128;
        if (std::abs(here[k] - std::round(here[k])) < off) return true;
    }
    if (is_outside(c, here)) return false;
    const auto tx = static_cast<int>(here[0]), ty = static_cast<int>(here[1]);
    const double gap = here[2] - bias - c.light.at(tx, ty) * far_quanta;
    return std::abs(gap) < std::abs(high[2] - low[2]) + 4;
}

bool is_shadowed(const Capture& c, int x, int y, double bias) {
    const auto p = place_of(c, x, y, c.observer.at(x, y));
    if (is_outside(c, p)) return false;
    const double stored = c.light.at(static_cast<int>(p[0]), static_cast<int>(p[1]));
    return stored < 1 && p[2] - bias > stored * far_quanta;
}

struct Compared {
    int visible = 0, close = 0, differ = 0, shadowed = 0;
};
Compared compare(const Camera& light, int bias) {
    Capture capture = capture_of(test::eye(), light);
    capture.set = {"coefficient_bits=32", "bias=" + std::to_string(bias)};
    const CapturedFrame frame(capture);
    const std::vector<std::uint8_t> mask = frame.mask();
    Compared c;
    for (int y = 0; y < capture.observer.height; ++y)
        for (int x = 0; x < capture.observer.width; ++x) {
            if (capture.observer.at(x, y) == 1) continue;
            ++c.visible;
            const bool dark = mask[static_cast<std::size_t>(y) << frame.spec().xy_bits |
                                   static_cast<std::size_t>(x)] != 0;
            c.shadowed += dark;
            if (is_close(capture, x, y, bias))
                ++c.close;
            else
                c.differ += dark != is_shadowed(capture, x, y, bias);
        }
    return c;
}

TEST(EngineScene, TheMaskIsThatOfDoublePrecisionButWhereRoundingDecides) {
    for (const Camera& light : {test::spot(), test::sun()})
        for (const int bias : {0, 8000, 160000}) {
            const Compared c = compare(light, bias);
            EXPECT_EQ(c.differ, 0) << bias;
            EXPECT_GT(c.visible, 29000);
            EXPECT_GT(c.shadowed, 1800);
            EXPECT_LT(c.close, c.visible / 20) << "too much is left out";
        }
}

// Rays say what is in shadow; a bias that the surfaces need, with each pixel's own plane, leaves
// errors at edges alone.
TEST(EngineScene, WithPlanesTheMaskIsThatOfRaysButAtEdges) {
    Capture capture = capture_of(test::eye(), test::spot());
    capture.set = {"receiver=plane", "bias=2400"};
    const CapturedFrame frame(capture);
    const test::Drawn seen = test::draw(test::eye());
    NumberImage truth = capture.observer;
    for (std::size_t at = 0; at < truth.values.size(); ++at) {
        const auto& p = seen.points[at];
        std::array<double, 3> to{};
        for (std::size_t k = 0; k < 3; ++k) to[k] = test::spot_at[k] - p[k];
        const bool dark = capture.observer.values[at] < 1 &&
                          std::isfinite(test::first_hit(p, to, 1e-9, 1));
        truth.values[at] = dark ? 1 : 0;
    }
    Asked asked;
    asked.truth = darkness_of(truth, false, true, frame.spec());
    const Answer answer(capture, frame, asked);
    EXPECT_FALSE(answer.judged.estimated);
    EXPECT_GT(answer.judged.error.shadowed, 2500);
    EXPECT_LT(answer.judged.error.false_shadow_rate(), 0.02);
    EXPECT_LT(answer.judged.error.false_light_rate(), 0.05);
    EXPECT_EQ(answer.outcomes.no_quotient, 0u);
    // The estimate of truth is nearly that of rays.
    const Answer estimated(capture, frame, {});
    EXPECT_TRUE(estimated.judged.estimated);
    EXPECT_NEAR(estimated.judged.error.lit, answer.judged.error.lit, 300);
    // Without planes and bias half of what is lit is not: the acne that engines know.
    Capture bare = capture;
    bare.set = {};
    const CapturedFrame bare_frame(bare);
    const Answer acne(bare, bare_frame, asked);
    EXPECT_GT(acne.judged.error.false_shadow_rate(), 0.3);
    ASSERT_TRUE(acne.judged.window.has_value());
    EXPECT_LT(acne.judged.flatness.median, 0.48);  // a moire, not noise
}

TEST(EngineScene, TheLeastBiasIsFoundAndIsTheLeast) {
    Capture capture = capture_of(test::eye(), test::sun());
    capture.format = *find_depth_format("d16");  // floats are rounded to its codes
    const CapturedFrame frame(capture);
    EXPECT_EQ(frame.spec().z_bits, 16);
    EXPECT_GT(frame.observer().largest_rounding, 0.4);
    EXPECT_LE(frame.observer().largest_rounding, 0.5);
    Asked asked;
    asked.least_bias = true;
    asked.pixel = Pixel{160, 200};
    const Answer answer(capture, frame, asked);
    ASSERT_TRUE(answer.least.has_value());
    // 5/128 of the window a texel and 1/19 of it a quantum's share: at most two texels of slope.
    EXPECT_GT(answer.least->quanta, 10);
    EXPECT_LT(answer.least->quanta, 1500);
    EXPECT_TRUE(answer.judged.estimated);
    ASSERT_TRUE(answer.trace.has_value());
    EXPECT_EQ(answer.trace->outcome, PixelOutcome::compared);
}

// The same buffers as each interface writes them give one mask, bit for bit.
TEST(Conventions, AllSayTheSame) {
    const Capture d3d = capture_of(test::eye(), test::spot());
    const CapturedFrame frame(d3d);
    const auto expect_same = [&](const Capture& other, const char* what) {
        const CapturedFrame same(other);
        EXPECT_EQ(same.mask(), frame.mask()) << what;
    };
    const auto on_both_sides = [](Capture& c, std::size_t axis) {  // negates y, before and after
        for (std::size_t k = 0; k < 4; ++k) {
            c.matrix[4 * axis + k] = -c.matrix[4 * axis + k];
            c.matrix[4 * k + axis] = -c.matrix[4 * k + axis];
        }
    };
    Capture vulkan = d3d;
    on_both_sides(vulkan, 1);
    vulkan.convention = *find_convention("vulkan");
    expect_same(vulkan, "vulkan");

    Capture rows = d3d;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) rows.matrix[4 * i + j] = d3d.matrix[4 * j + i];
    rows.convention.row_vectors = true;
    expect_same(rows, "row vectors");

    // z = 2 d - 1 on both sides, and rows from below.
    Capture opengl = d3d;
    test::Matrix m{}, to{}, from{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) m[i][j] = d3d.matrix[4 * i + j];
        to[i][i] = from[i][i] = 1;
    }
    to[2] = {0, 0, 2, -1};
    from[2] = {0, 0, 0.5, 0.5};
    m = test::product(test::product(to, m), from);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) opengl.matrix[4 * i + j] = m[i][j];
    opengl.convention = *find_convention("opengl");
    for (NumberImage* image : {&opengl.observer, &opengl.light}) {
        NumberImage turned = *image;
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x)
                turned.values[static_cast<std::size_t>(y * image->width + x)] =
                    image->at(x, image->height - 1 - y);
        *image = turned;
    }
    expect_same(opengl, "opengl");
}

}  // namespace
}  // namespace umbra78::tools::captured
