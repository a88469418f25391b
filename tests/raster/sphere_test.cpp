// No pixel missed and none too many: spheres at random places, sizes and attitudes, against the
// exact disc and the exact depth. This is the block rule's promise (block_rule.hpp).
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

// How far a sample may lie from its pixel's centre, in pixels. Coefficients and object words of
// 16 bits move a surface by up to 0.06. Centre sampling reaches past its triangle by the slack,
// 1/64 pixel in x and in y; a leaf's centre lies anywhere in its pixel.
constexpr double words = 0.06;
constexpr double reach_of_centres = words + 0.0221;
constexpr double reach_of_leaves = words + 0.7072;

struct Statistics {
    double min = 0, max = 0, sum = 0;
    std::int64_t count = 0;
    void add(double v) {
        min = std::min(min, v);
        max = std::max(max, v);
        sum += v;
        ++count;
    }
    double mean() const { return sum / static_cast<double>(count); }
    void print() const {
        std::cout << "[ measured ] depth error over " << count << " pixels: " << min << " .. "
                  << max << " quanta, mean " << mean() << '\n';
    }
};

struct Tally {
    std::int64_t pixels = 0, missed = 0, stray = 0, deep = 0, unresolved = 0;
    Statistics depth;
};

struct Placement {
    Sphere sphere;
    View view;
    double x, y, z, radius;  // pixels from the frame's centre
};

// 128 pixels a world unit, radius 2 to 200 pixels with every octave as likely, any attitude; the
// sphere stays within the cube in depth and may reach out of the frame.
Placement place(Random& random) {
    const auto fraction = [&] { return static_cast<double>(random.bits() >> 40) / (1 << 24); };
    Placement p{};
    p.radius = 2 * std::pow(100.0, fraction());
    p.x = 500 * fraction() - 250;
    p.y = 500 * fraction() - 250;
    p.z = (2 * fraction() - 1) * (250 - p.radius);
    p.view = umbra78::test::orthographic(360 * fraction(), 180 * fraction() - 90, 2);
    const Camera camera(p.view, {});
    Vector3 at = along({}, p.x / 128, camera.right);
    at = along(at, -p.y / 128, camera.up);
    at = along(at, -p.z / 128, camera.back);
    p.sphere = umbra78::test::sphere(at[0], at[1], at[2], p.radius / 128);
    return p;
}

// Z code at `rho` pixels from the centre of the disc, or at the centre for less than none.
double truth(const Placement& p, double rho) {
    rho = std::max(rho, 0.0);
    return 32768 + 128 * (p.z - std::sqrt(p.radius * p.radius - rho * rho));
}

struct Rule {
    Sampling sampling;
    double stray_px;  // how far outside the disc a pixel may be drawn
    double place_px;  // how far from the pixel's centre its depth may be taken, and 3 quanta
};

void tally(const Placement& p, const Drawing<>& stage, const Rule& rule, Tally& t) {
    std::int64_t drawn = 0;
    const auto from = [](double v) { return std::clamp(static_cast<int>(v) + 256 - 3, 0, 511); };
    const auto to = [](double v) { return std::clamp(static_cast<int>(v) + 256 + 3, 0, 511); };
    for (int py = from(p.y - p.radius); py <= to(p.y + p.radius); ++py) {
        for (int px = from(p.x - p.radius); px <= to(p.x + p.radius); ++px) {
            const double dx = px - 255.5 - p.x, dy = py - 255.5 - p.y;
            const double rho = std::sqrt(dx * dx + dy * dy);
            const bool is_drawn = stage.drawn(px, py);
            drawn += is_drawn ? 1 : 0;
            if (rho < p.radius - words) {
                ++t.pixels;
                if (!is_drawn && t.missed++ == 0)
                    ADD_FAILURE() << "pixel " << px << ", " << py << " is missed, "
                                  << p.radius - rho << " px within radius " << p.radius;
            }
            if (is_drawn && rho > p.radius + rule.stray_px && t.stray++ == 0)
                ADD_FAILURE() << "pixel " << px << ", " << py << " is drawn, "
                              << rho - p.radius << " px outside radius " << p.radius;
            if (!is_drawn || rho + rule.place_px >= p.radius) continue;
            const double code = stage.depth_at(px, py);
            if (rho < 0.95 * p.radius) t.depth.add(code - truth(p, rho));
            if ((code < truth(p, rho - rule.place_px) - 3 ||
                 code > truth(p, rho + rule.place_px) + 3) && t.deep++ == 0)
                ADD_FAILURE() << "pixel " << px << ", " << py << " is " << code - truth(p, rho)
                              << " quanta deep, " << rho << " px from the centre, radius "
                              << p.radius;
        }
    }
    const auto all = std::count_if(stage.depth().begin(), stage.depth().end(),
                                   [](std::uint16_t z) { return z != 0xffff; });
    EXPECT_EQ(all, drawn) << "something is drawn far from the sphere";
}

Tally draw_placements(int count, const Rule& rule) {
    Random random;
    Tally t;
    Drawing<> stage;
    for (int n = 0; n < count; ++n) {
        const Placement p = place(random);
        Patches patches;
        umbra78::test::add_sphere(patches, p.sphere);
        stage.clear();
        t.unresolved += static_cast<std::int64_t>(
            stage.draw(patches, p.view, rule.sampling).unresolved);
        tally(p, stage, rule, t);
        if (testing::Test::HasFailure()) {
            ADD_FAILURE() << "placement " << n << ": centre " << p.x << ", " << p.y;
            break;
        }
    }
    t.depth.print();
    EXPECT_EQ(t.unresolved, 0);
    return t;
}

TEST(Sphere, NoPixelIsMissedInAThousandPlacementsByCentres) {
    const int count = umbra78::test::effort(1000);
    const Tally t = draw_placements(count, {Sampling::centre, reach_of_centres, reach_of_centres});
    EXPECT_GT(t.pixels, 4000 * count);
    EXPECT_NEAR(t.depth.mean(), 0, 0.2);
}

TEST(Sphere, NoPixelIsMissedInAThousandPlacementsByLeaves) {
    const int count = umbra78::test::effort(1000);
    const Tally t = draw_placements(count, {Sampling::leaf, reach_of_leaves, reach_of_leaves});
    EXPECT_GT(t.pixels, 4000 * count);
    EXPECT_LT(t.depth.mean(), -20) << "the nearest of several leaves wins";
}

// Where the matrix is exact, as in the figures' own view, only object words of 2^-14 and the code
// round; toward the limb the slack shows, 0.022 px of a slope of 3, and errs to the near side.
TEST(Sphere, DepthsOfTheFiguresOwnView) {
    for (const double within : {0.5, 0.95}) {
        Statistics depth;
        Drawing<> stage;
        Placement p{umbra78::test::sphere(0.3, -0.2, 0.1, 0.72), {}, 38.4, 25.6, -12.8, 92.16};
        p.view = umbra78::test::orthographic(0, 0, 2);
        Patches patches;
        umbra78::test::add_sphere(patches, p.sphere);
        stage.draw(patches, p.view, Sampling::centre);
        for (int py = 0; py < 512; ++py) {
            for (int px = 0; px < 512; ++px) {
                const double rho = std::hypot(px - 255.5 - p.x, py - 255.5 - p.y);
                if (rho < within * p.radius) depth.add(stage.depth_at(px, py) - truth(p, rho));
            }
        }
        depth.print();
        EXPECT_GT(depth.min, within == 0.5 ? -1.5 : -1.5 - 0.0221 * 3.04 * 128);
        EXPECT_LT(depth.max, within == 0.5 ? 1 : 2);
        EXPECT_NEAR(depth.mean(), 0, 0.2);
    }
}

}  // namespace
}  // namespace umbra78::raster
