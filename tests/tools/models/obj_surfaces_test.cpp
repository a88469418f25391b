// Curved surfaces of OBJ: Bezier points as they are, B-splines converted exactly.
#include "tests/tools/models/model_texts.hpp"

#include "tools/models/spline.hpp"

#include <random>

namespace umbra78::tools::test {
namespace {

using fixed::Rational;

// Vertices (i, j, i^2 j) for i < nu, j < nv, u fastest, and their numbers.
std::string grid(int nu, int nv) {
    std::string text;
    for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i)
            text += "v " + std::to_string(i) + " " + std::to_string(j) + " " +
                    std::to_string(i * i * j) + "\n";
    return text;
}

std::string numbers(int from, int to) {
    std::string text;
    for (int k = from; k <= to; ++k) text += " " + std::to_string(k);
    return text;
}

std::string surface(const std::string& type, const std::string& range, int nu, int nv,
                    const std::string& u, const std::string& v) {
    return grid(nu, nv) + "cstype " + type + "\ndeg 3 3\nsurf " + range + numbers(1, nu * nv) +
           "\nparm u" + u + "\nparm v" + v + "\nend\n";
}

ModelData surfaces_of(const std::string& text) {
    ModelResult result = read_model(text, "a.obj");
    EXPECT_EQ(result.error, "") << text;
    return std::move(result.model);
}

std::array<std::int64_t, 3> units(const ModelPoint& p) {
    return {p.word[0] / model_one, p.word[1] / model_one, p.word[2] / model_one};
}

TEST(ObjSurfaces, BezierSurfacesOfSeveralPatches) {
    const ModelData model = surfaces_of(surface("bezier", "0 2 0 1", 7, 4, " 0 1 2", " 0 1"));
    ASSERT_EQ(model.patches.size(), 2u);
    for (std::size_t n = 0; n < 16; ++n) {
        const auto i = static_cast<std::int64_t>(n % 4), j = static_cast<std::int64_t>(n / 4);
        EXPECT_EQ(units(model.patches[0][n]), (std::array{i, j, i * i * j})) << n;
        EXPECT_EQ(units(model.patches[1][n]), (std::array{i + 3, j, (i + 3) * (i + 3) * j})) << n;
    }
    EXPECT_EQ(model.patches[1][15].line, 28);
}

// Ends of knots that are repeated four times make a Bezier surface.
TEST(ObjSurfaces, ABsplineWithRepeatedEndKnotsIsItsBezierSurface) {
    const std::string ends = " 0 0 0 0 7.5 7.5 7.5 7.5";
    const ModelData model = surfaces_of(surface("bspline", "0 7.5 0 7.5", 4, 4, ends, ends));
    const ModelData bezier = surfaces_of(surface("bezier", "0 1 0 1", 4, 4, " 0 1", " 0 1"));
    ASSERT_EQ(model.patches.size(), 1u);
    EXPECT_EQ(model.patches[0], bezier.patches[0]);
}

// Knots a unit apart: the weights are sixths, and those of a patch thirty-sixths.
TEST(ObjSurfaces, UniformBsplinesHaveTheKnownWeights) {
    std::vector<BezierSpan> spans;
    ASSERT_TRUE(bezier_spans(std::vector<std::int64_t>{-4, -2, 0, 2, 4, 6, 8, 10, 12}, spans));
    ASSERT_EQ(spans.size(), 2u);
    const int sixths[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
    for (const BezierSpan& span : spans)
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t m = 0; m < 4; ++m)
                EXPECT_EQ(span.weight[k][m], Rational(sixths[k][m], 6)) << k << " " << m;
    EXPECT_EQ(spans[1].last, 4u);
}

TEST(ObjSurfaces, UniformBsplinesAreRoundedOnce) {
    const std::string knots5 = " 0 1 2 3 4 5 6 7 8", knots4 = " -3 -2 -1 0 1 2 3 4";
    const ModelData model = surfaces_of(surface("bspline", "3 5 0 1", 5, 4, knots5, knots4));
    ASSERT_EQ(model.patches.size(), 2u);
    const int sixths[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
    for (std::size_t patch = 0; patch < 2; ++patch)
        for (std::size_t n = 0; n < 16; ++n) {
            std::array<std::int64_t, 3> sum{};  // of thirty-sixths
            for (int m = 0; m < 16; ++m) {
                const int weight = sixths[n % 4][m % 4] * sixths[n / 4][m / 4];
                const int i = m % 4 + static_cast<int>(patch), j = m / 4;
                sum[0] += weight * i * model_one;
                sum[1] += weight * j * model_one;
                sum[2] += weight * i * i * j * model_one;
            }
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_EQ(model.patches[patch][n].word[axis],
                          fixed::round_divide(sum[axis], 36, fixed::Rounding::half_even))
                    << patch << " " << n << " " << axis;
        }
    // The patches share their edge, word for word.
    for (std::size_t j = 0; j < 4; ++j)
        EXPECT_EQ(model.patches[0][4 * j + 3], model.patches[1][4 * j]);
}

// A tenth has no exact word, but knots a tenth apart are evenly spaced.
TEST(ObjSurfaces, KnotsAreDecimals) {
    const ModelData tenths = surfaces_of(surface("bspline", "-0.1 0.0 0.3 .4", 4, 4,
                                      " -0.4 -0.3 -0.2 -0.1 0 0.1 0.2 0.3",
                                      " 0 0.1 0.2 0.3 0.4 0.5 0.6 0.7"));
    const ModelData ones = surfaces_of(surface("bspline", "3 4 3 4", 4, 4, " 0 1 2 3 4 5 6 7",
                                    " 0 1 2 3 4 5 6 7"));
    ASSERT_EQ(tenths.patches.size(), 1u);
    EXPECT_EQ(tenths.patches[0], ones.patches[0]);
}

// The value at t of a cubic spline's span by de Boor's scheme, and of its Bezier form.
TEST(ObjSurfaces, AnyKnotsGiveTheSameCurve) {
    std::mt19937 random(78);
    for (int n = 0; n < 200; ++n) {
        std::vector<std::int64_t> knots{0};
        while (knots.size() < 9) knots.push_back(knots.back() + static_cast<int>(random() % 4));
        const std::array<std::int64_t, 5> d{5, -3, 8, 1, static_cast<int>(random() % 100)};
        std::vector<BezierSpan> spans;
        ASSERT_TRUE(bezier_spans(knots, spans));
        for (const BezierSpan& span : spans) {
            const std::size_t i = span.last;
            // The knots are counted in their common divisor, which does not change a ratio.
            const Rational third(1, 3);
            const Rational t = Rational(knots[i]) + Rational(knots[i + 1] - knots[i]) * third;
            std::array<Rational, 4> p;
            for (std::size_t m = 0; m < 4; ++m) p[m] = Rational(d[i - 3 + m]);
            for (std::size_t r = 1; r <= 3; ++r)
                for (std::size_t m = 3; m >= r; --m) {
                    const Rational from(knots[i - 3 + m]), to(knots[i + 1 + m - r]);
                    p[m] = p[m - 1] + (p[m] - p[m - 1]) * (t - from) / (to - from);
                }
            // Bernstein's weights at 1/3: 8, 12, 6, 1 in 27.
            const int bernstein[4] = {8, 12, 6, 1};
            Rational bezier(0);
            for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t m = 0; m < 4; ++m)
                    bezier = bezier + Rational(bernstein[k], 27) * span.weight[k][m] *
                                          Rational(d[i - 3 + m]);
            EXPECT_EQ(bezier, p[3]) << "case " << n;
        }
    }
}

TEST(ObjSurfaceErrors, AreOneLineEach) {
    const auto bezier = [](const std::string& range, const std::string& u, const std::string& v) {
        return surface("bezier", range, 4, 4, u, v);
    };
    const std::string head = "cstype bezier\ndeg 3 3\n", uniform = " 0 1 2 3 4 5 6 7";
    expect_messages({
        {"a.obj", "cstype rat bspline\n",
         "a.obj:1: 'cstype rat' is rational: its points have weights, by which the machine would "
         "have to divide; write cstype bezier or bspline"},
        {"a.obj", "cstype cardinal\n",
         "a.obj:1: 'cstype' is 'cardinal'; write cstype bezier or bspline"},
        {"a.obj", "cstype\n", "a.obj:1: 'cstype' is ''; write cstype bezier or bspline"},
        {"a.obj", "cstype bezier\ndeg 2 3\n",
         "a.obj:2: 'deg' is not 3 3: only bicubic surfaces have an exact form here; write deg 3 "
         "3"},
        {"a.obj", "curv 0 1 1 2\n",
         "a.obj:1: 'curv' makes a curve or cuts a surface; give whole surfaces of patches"},
        {"a.obj", "surf 0 1 0 1 1\n",
         "a.obj:1: 'surf' stands before its cstype and deg; write them first"},
        {"a.obj", head + "surf 0 1\n",
         "a.obj:3: 'surf' has no range; write surf s0 s1 t0 t1 and its points"},
        {"a.obj", "end\n", "a.obj:1: 'end' belongs to no surface; begin one with surf"},
        {"a.obj", head + "surf 0 1 0 1 1\nparm w 1\n",
         "a.obj:4: 'parm' is of neither u nor v; write parm u or parm v"},
        {"a.obj", head + "surf 0 1 0 1 1\nparm u 0 1\n",
         "a.obj:3: this surface has no end; add end after its parm"},
        {"a.obj", bezier("0 1 0 1", " 0", " 0 1"),
         "a.obj:19: 'parm u' of this surface has 1 numbers; give at least 2"},
        {"a.obj", bezier("0 1 0 1", " 0 1", " 0 0"),
         "a.obj:19: 'parm v' of this surface falls; put its numbers in order"},
        {"a.obj", bezier("0 0.5 0 1", " 0 1", " 0 1"),
         "a.obj:19: 'parm u' of this surface is not that of the surf statement: only a whole "
         "surface can be taken; give it its whole range"},
        {"a.obj", bezier("0 2 0 1", " 0 1 2", " 0 1"),
         "a.obj:19: this surface has 16 points; its parm ask for 7 by 4"},
        {"a.obj", surface("bspline", "3 4 3 4", 4, 4, uniform, " 0 1 2 3 4 5 6"),
         "a.obj:19: 'parm v' of this surface has 7 numbers; give at least 8"},
        {"a.obj", surface("bspline", "3 4 3 4", 4, 4, uniform, " 0 1 2 3 4 5 7.00001 7.1"),
         "a.obj:19: the knots of this surface differ by more than 65536 of their common divisor; "
         "write them with fewer digits"},
        {"a.obj", head + "surf 0 1 0 1" + repeated(" 5", 16) + "\nparm u 0 1\nparm v 0 1\nend\n",
         "a.obj:3: vertex 5 is named; there are 0: correct the number"},
    });
}

}  // namespace
}  // namespace umbra78::tools::test
