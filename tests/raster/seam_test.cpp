// Two planes that share an edge leave no hole along it, at any angle, size and attitude, however
// each is laid out and however deep its blocks are split; nor is anything drawn outside them.
#include "tests/fixed/boundary.hpp"
#include "tests/raster/truth.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbra78::raster {
namespace {

using namespace test;
using fixed::test::Random;
using umbra78::test::Patches;
using umbra78::test::Drawing;

struct Place {
    double x, y;  // pixels from the frame's centre
};

// The directed line from a to b; `left` is how far p lies to its left, in pixels.
struct Line {
    double nx = 0, ny = 0, offset = 0;
    Line() = default;
    Line(const Place& a, const Place& b) {
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        nx = (a.y - b.y) / length;
        ny = (b.x - a.x) / length;
        offset = nx * a.x + ny * a.y;
    }
    double left(const Place& p) const { return nx * p.x + ny * p.y - offset; }
};

// A wing: shared edge from corner 0 to corner 1, then round. `side` is +1 if it lies to the left.
struct Wing {
    std::array<Place, 4> corner;
    std::array<Line, 4> edge;
    double side;
    double within(std::size_t k, const Place& p) const { return side * edge[k].left(p); }
    double within_outer(const Place& p) const {
        return std::min({within(1, p), within(2, p), within(3, p)});
    }
};

struct Fold {
    std::array<Vector3, 4> vectors;  // a corner, the shared edge, and the two wings
    std::array<Wing, 2> wing;
};

// How well outlines are known, in pixels, with what the slack adds outside.
constexpr double seam_margin = 0.1;

Place project(const Camera& c, const Vector3& p) {
    const Vector3 from = along(p, -1, c.is_perspective() ? c.eye() : c.target);
    const double scale =
        c.half_px / c.extent *
        (c.is_perspective() ? c.distance / -dot3(c.back, from) : 1.0);
    return {dot3(c.right, from) * scale, -dot3(c.up, from) * scale};
}

// A random fold whose wings lie on opposite sides of the shared edge and are not edge-on.
Fold random_fold(Random& random, const Camera& camera) {
    const auto draw = [&](double reach) {
        return reach * (static_cast<double>(random.bits() >> 40) / (1 << 23) - 1);
    };
    const auto vector = [&](double reach) {
        return Vector3{draw(reach), draw(reach), draw(reach)};
    };
    while (true) {
        Fold f{{vector(0.6), vector(0.9), vector(0.9), vector(0.9)}, {}};
        const auto& [o, u, a, b] = f.vectors;
        bool usable = true;
        for (std::size_t w = 0; w < 2; ++w) {
            const Vector3& v = w == 0 ? a : b;
            const std::array<Vector3, 4> world{o, along(o, 1, u), along(along(o, 1, u), 1, v),
                                               along(o, 1, v)};
            for (std::size_t k = 0; k < 4; ++k) f.wing[w].corner[k] = project(camera, world[k]);
            const auto& c = f.wing[w].corner;
            for (std::size_t k = 0; k < 4; ++k) f.wing[w].edge[k] = Line(c[k], c[(k + 1) % 4]);
            f.wing[w].side = f.wing[w].edge[0].left(c[2]) > 0 ? 1 : -1;
            for (std::size_t k = 0; k < 4; ++k)
                usable = usable && f.wing[w].within(k, c[(k + 2) % 4]) > 4 &&
                         std::hypot(c[k].x - c[(k + 1) % 4].x, c[k].y - c[(k + 1) % 4].y) > 4;
        }
        if (usable && f.wing[0].side != f.wing[1].side) return f;
    }
}

// The parallelogram o, u, v laid out from any of its corners, either way round.
Patch laid_out(Random& random, Vector3 o, Vector3 u, Vector3 v) {
    for (Vector3* edge : {&u, &v}) {
        if (random.bits() % 2 == 0) continue;
        o = along(o, 1, *edge);
        *edge = along({}, -1, *edge);
    }
    if (random.bits() % 2 == 0) std::swap(u, v);
    return plane_patch(umbra78::test::plane(o, u, v));
}

void expect_no_hole(const Fold& fold, const Drawing<>& stage, int number, std::int64_t& pixels) {
    for (int py = 0; py < 512; ++py) {
        for (int px = 0; px < 512; ++px) {
            const Place p{px - 255.5, py - 255.5};
            bool must = false, may = false;
            for (const Wing& w : fold.wing) {
                const double outer = w.within_outer(p), shared = w.within(0, p);
                must = must || (outer > seam_margin && shared >= 0);
                may = may || (outer > -seam_margin && shared >= -seam_margin);
            }
            pixels += must ? 1 : 0;
            const bool drawn = stage.drawn(px, py);
            if ((!must || drawn) && (may || !drawn)) continue;
            ADD_FAILURE() << "fold " << number << ": pixel " << px << ", " << py
                          << (drawn ? " is drawn outside" : " is a hole") << ", "
                          << fold.wing[0].within(0, p) << " px from the shared edge";
            return;
        }
    }
}

void fold_planes(const MachineSpec& spec, const View& view) {
    Random random;
    const Camera camera(view, spec);
    Drawing<> stage(spec);
    std::int64_t pixels = 0;
    const int count = umbra78::test::effort(200);
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
        const Fold fold = random_fold(random, camera);
        const auto& [o, u, a, b] = fold.vectors;
        const Patches patches{laid_out(random, o, u, a), laid_out(random, o, u, b)};
        stage.clear();
        EXPECT_EQ(stage.draw(patches, view, Sampling::centre).unresolved, 0u);
        expect_no_hole(fold, stage, n, pixels);
    }
    EXPECT_GT(pixels, 3000 * count);
}

TEST(Seam, OfTwoPlanesHasNoHole) {
    View view = umbra78::test::orthographic(33, 21, 2);
    view.near_depth *= 4;  // all of any fold
    view.far_depth *= 4;
    fold_planes({}, view);
}

TEST(Seam, OfTwoPlanesInPerspectiveHasNoHole) {
    MachineSpec spec;
    spec.coefficient_bits = 24;
    fold_planes(spec, umbra78::test::perspective(33, 21, 2, 6, 1, 12));
}

}  // namespace
}  // namespace umbra78::raster
