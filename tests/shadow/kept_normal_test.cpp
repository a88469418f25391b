// Receivers by the normals that the store keeps: slopes against geometry, and against the
// differences of depths on a plane, at a crease and at a silhouette.
#include "shadow/kept_normal.hpp"

#include "shadow/bias.hpp"
#include "shadow/pixel_darkness.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/trapped.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace umbra78::shadow {
namespace {

constexpr std::int32_t world_one = 1 << 16;

// --- against geometry ----------------------------------------------------------------------------

// A light's screen in doubles: a place right, down and away to X and Y in texels and Z in quanta.
struct ExactLight {
    bool lamp;
    double focal = 400, reach = 1 << 20, quanta = 900;

    std::array<double, 3> result(const std::array<double, 3>& p) const {
        if (!lamp) return {p[0], p[1], quanta * p[2]};
        return {p[0] * focal / p[2], p[1] * focal / p[2], reach - reach * focal / p[2]};
    }
    LightScale words() const {
        if (!lamp) return {std::llround(65536 * quanta)};
        return {0, std::llround(256 * reach), std::llround(256 * focal)};
    }
};

// The slopes are those of the plane's image: of two places on it, both in the light's screen.
TEST(KeptNormal, SlopesAreThoseOfThePlanesImage) {
    fixed::test::Random random;
    const auto real = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.between(0, 1 << 20)) / (1 << 20);
    };
    const LightAxes own{{{{1 << 14, 0, 0}, {0, 1 << 14, 0}, {0, 0, 1 << 14}}}};
    for (int k = 0; k < 4000; ++k) {
        const ExactLight light{k % 2 == 1};
        const std::array<double, 3> p{real(-150, 150), real(-150, 150), real(300, 600)};
        std::array<double, 3> n{real(-1, 1), real(-1, 1), real(0.3, 1) * (k % 4 < 2 ? 1 : -1)};
        const double size = std::hypot(n[0], n[1], n[2]);
        std::array<std::int32_t, 3> words{};
        for (std::size_t a = 0; a < 3; ++a)
            words[a] = static_cast<std::int32_t>(std::lround(16384 * n[a] / size));
        const double along = (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / p[2] / size;
        if (light.lamp && std::abs(along) < 0.2) continue;  // nearly edge-on
        const auto r = light.result(p);
        const hw::Point at{std::llround(128 * r[0]), std::llround(128 * r[1]), std::llround(r[2]),
                           hw::DivideStatus::ok};
        const ReceiverPlane plane =
            plane_of_normal(at, in_light(words, own), light.words(), 7, INT64_MAX);
        // A step to the right or down in the plane, and what it does to X, Y and Z.
        const auto image = [&](double x, double y) {
            const double step = 1e-3;
            const auto q = light.result({p[0] + step * x, p[1] + step * y,
                                         p[2] - step * (n[0] * x + n[1] * y) / n[2]});
            return std::array{(q[0] - r[0]) / step, (q[1] - r[1]) / step, (q[2] - r[2]) / step};
        };
        const auto u = image(1, 0), v = image(0, 1);
        const double d = u[0] * v[1] - v[0] * u[1];
        const double slope_x = (u[2] * v[1] - v[2] * u[1]) / d / 128;
        const double slope_y = (v[2] * u[0] - u[2] * v[0]) / d / 128;
        const double off = 0.002 * (light.quanta / 128 + std::abs(slope_x) + std::abs(slope_y));
        EXPECT_NEAR(std::ldexp(static_cast<double>(plane.slope_x), -12), slope_x, off) << k;
        EXPECT_NEAR(std::ldexp(static_cast<double>(plane.slope_y), -12), slope_y, off) << k;
    }
}

TEST(KeptNormal, WithoutADirectionThePixelIsComparedAsItIs) {
    const LightScale light{128 << 16};
    const hw::Point at{100, 200, 300, hw::DivideStatus::ok};
    for (const LightNormal& m : {LightNormal{}, LightNormal{1 << 22, 5, 0}}) {  // and edge-on
        const ReceiverPlane plane = plane_of_normal(at, m, light, 7, INT64_MAX);
        EXPECT_EQ(plane.slope_x, 0);
        EXPECT_EQ(plane.slope_y, 0);
    }
    EXPECT_EQ(moved_along(at, {}, 256, light.at(at, 7), 7).z, at.z);
    hw::Point lost = at;
    lost.status = hw::DivideStatus::overflow;
    const LightNormal m{1 << 20, 1 << 20, -(1 << 21)};
    EXPECT_EQ(plane_of_normal(lost, m, light, 7, INT64_MAX).slope_x, 0);
    EXPECT_NE(plane_of_normal(at, m, light, 7, INT64_MAX).slope_x, 0);
    EXPECT_EQ(moved_along(lost, m, 256, light.at(at, 7), 7).x, at.x);
    EXPECT_NE(moved_along(at, m, 256, light.at(at, 7), 7).x, at.x);
    // The other side of a surface has the same plane.
    const ReceiverPlane one = plane_of_normal(at, m, light, 7, INT64_MAX);
    const ReceiverPlane other = plane_of_normal(at, {-m[0], -m[1], -m[2]}, light, 7, INT64_MAX);
    EXPECT_EQ(one.slope_x, other.slope_x);
    EXPECT_EQ(one.slope_y, other.slope_y);
}

// --- both sources in a frame ---------------------------------------------------------------------

struct Slopes {
    double x, y;
};
Slopes slopes_of(const ReceiverPlane& p) {
    return {std::ldexp(static_cast<double>(p.slope_x), -12),
            std::ldexp(static_cast<double>(p.slope_y), -12)};
}

// A frame that keeps normals, and for each pixel its plane from either source.
struct TwoSources {
    TwoSources(std::vector<raster::Patch> surfaces, int elevation, int light_azimuth)
        : patches(std::move(surfaces)) {
        scene = {patches, material, view(0, elevation), {{view(light_azimuth, 30)}}};
        s.machine.xy_bits = 6;
        s.machine.z_bits = 13;
        s.machine.coefficient_bits = 24;
        s.receiver = Receiver::plane;
        s.slope_source = SlopeSource::normals;
        frame.emplace(scene, s);
        EXPECT_EQ(frame->status, FrameStatus::ok);
    }
    static raster::View view(int azimuth, int elevation) {
        raster::View v;
        v.axes = raster::axes_from_angles(azimuth * world_one, elevation * world_one);
        v.extent = 2 * world_one;
        v.near_depth = -4 * world_one;
        v.far_depth = 4 * world_one;
        return v;
    }
    hw::FrameStore<const hw::Depth16> store() const { return frame->buffers.observer; }
    hw::TransformUnit unit() const {
        return {s.machine, frame->matrices.lights[0].observer_to_light};
    }
    bool visible(int x, int y) const {
        return store().depth[store().address(x, y)] != s.machine.background();
    }
    hw::Point result(int x, int y) const {
        return unit()(pixel_words(x, y, store().depth[store().address(x, y)], s));
    }
    ReceiverPlane by_normal(int x, int y) const {
        const LightMatrices& m = frame->matrices.lights[0];
        return plane_of_normal(result(x, y),
                               kept_normal(store(), store().address(x, y), m.axes), m.scale,
                               s.machine.fraction_bits, INT64_MAX);
    }
    std::optional<Neighbours> neighbours(int x, int y) const {
        WalkedPixel p{};
        p.x = x, p.y = y;
        return neighbours_of(store(), unit(), s, p);
    }
    ReceiverPlane by_depths(int x, int y) const {
        const auto by = neighbours(x, y);
        return by ? receiver_plane(result(x, y), by->beside, by->below, INT64_MAX)
                  : ReceiverPlane{result(x, y), 0, 0};
    }
    template <class Visit>
    void for_visible(Visit&& visit) const {
        for (int y = 0; y < s.machine.size_px(); ++y)
            for (int x = 0; x < s.machine.size_px(); ++x)
                if (visible(x, y)) visit(x, y);
    }

    std::vector<raster::Patch> patches;
    std::array<raster::Material, 1> material{};
    Scene scene;
    Settings s;
    std::optional<test::Frame<>> frame;
};

raster::Patch parallelogram(raster::World o, raster::World u, raster::World v) {
    return raster::plane_patch({o, u, v, 0});
}

raster::Patch wide_floor() {
    return parallelogram({-3 * world_one, -world_one, 3 * world_one}, {6 * world_one, 0, 0},
                         {0, 0, -6 * world_one});
}

// On a plane the sources differ by what the words of the differences can be wrong by: a code by
// half a quantum at either pixel, which moves its result along the column of Z, and each result by
// half a word; and by the normal's and the axes' own roundings.
TEST(KeptNormal, HasTheSlopeOfTheDifferencesOnAPlane) {
    for (const int elevation : {15, 40, 80})
        for (const int azimuth : {-70, 20, 150}) {
            const TwoSources f({wide_floor()}, elevation, azimuth);
            const hw::TransformUnit unit = f.unit();
            const hw::Point zero = unit({0, 0, 0}), deep = unit({0, 0, 1 << 12});
            const auto column = [&](std::int64_t a, std::int64_t b) {  // for a quantum
                return static_cast<double>(b - a) / 4096 *
                       (1 << (f.s.machine.input_fraction() - f.s.machine.depth_fraction()));
            };
            int compared = 0;
            double most = 0;
            f.for_visible([&](int x, int y) {
                const auto by = f.neighbours(x, y);
                if (!by) return;
                const NeighbourSteps step =
                    neighbour_steps(f.result(x, y), by->beside, by->below);
                const Slopes s = slopes_of(f.by_normal(x, y)), d = slopes_of(f.by_depths(x, y));
                const double wrong =
                    std::abs(column(zero.z, deep.z) - s.x * column(zero.x, deep.x) -
                             s.y * column(zero.y, deep.y)) + 1 + std::abs(s.x) + std::abs(s.y);
                const double turned = 1e-4 * 2 * (1 + s.x * s.x + s.y * s.y);  // roundings of N
                const auto real = [](std::int64_t v) { return static_cast<double>(v); };
                const double area = std::abs(real(step.u[0]) * real(step.v[1]) -
                                             real(step.v[0]) * real(step.u[1]));
                const auto bound = [&](std::size_t axis) {
                    return wrong * (std::abs(real(step.u[axis])) + std::abs(real(step.v[axis]))) /
                               area + turned + 2.0 / 4096;
                };
                EXPECT_LE(std::abs(s.x - d.x), bound(1)) << x << " " << y;
                EXPECT_LE(std::abs(s.y - d.y), bound(0)) << x << " " << y;
                most = std::max({most, std::abs(s.x - d.x), std::abs(s.y - d.y)});
                ++compared;
            });
            EXPECT_GT(compared, 1000);
            std::printf("observer at %d, light at %d degrees: %d pixels, at most %.4f quanta a "
                        "step apart\n", elevation, azimuth, compared, most);
        }
}

// Pixels whose slopes are off those of every surface in the scene by more than 1/4 of a quantum a
// step: 32 quanta a texel.
struct Strays {
    int depths = 0, normals = 0, pixels = 0;
};
Strays strays(const TwoSources& f, const std::vector<Slopes>& surfaces) {
    Strays n;
    f.for_visible([&](int x, int y) {
        const auto astray = [&](const Slopes& s) {
            for (const Slopes& of : surfaces)
                if (std::abs(s.x - of.x) < 0.25 && std::abs(s.y - of.y) < 0.25) return false;
            return true;
        };
        ++n.pixels;
        n.depths += astray(slopes_of(f.by_depths(x, y)));
        n.normals += astray(slopes_of(f.by_normal(x, y)));
    });
    return n;
}

// The slopes of a plane by its own normal, which the test above holds to the differences'.
Slopes slopes_of_plane(const TwoSources& f, int x, int y) { return slopes_of(f.by_normal(x, y)); }

// A roof: two planes that meet in a ridge down the middle of the frame, turned a little, so that
// the ridge crosses pixels everywhere.
TEST(KeptNormal, AtACreaseDifferencesStraddleTwoSurfacesAndNormalsDoNot) {
    const raster::World ridge{world_one / 4, -2 * world_one, 0};
    const raster::World up{-world_one / 2, 4 * world_one, 0};
    const TwoSources f({parallelogram(ridge, {-3 * world_one, 0, -world_one}, up),
                        parallelogram(ridge, {3 * world_one, 0, -2 * world_one}, up)},
                       0, 20);
    const Strays n = strays(f, {slopes_of_plane(f, 4, 32), slopes_of_plane(f, 60, 32)});
    std::printf("crease: of %d pixels %d stray by depths, %d by normals\n", n.pixels, n.depths,
                n.normals);
    EXPECT_EQ(n.normals, 0);
    EXPECT_GT(n.depths, 10);
}

// Slats before a floor, none of them wider than a pixel or two: their pixels' neighbours in X are
// of the floor.
TEST(KeptNormal, AtASilhouetteDifferencesStraddleTwoSurfacesAndNormalsDoNot) {
    std::vector<raster::Patch> surfaces{wide_floor()};
    for (int k = -3; k <= 3; ++k)
        surfaces.push_back(parallelogram({k * world_one / 2, -world_one, world_one / 2},
                                         {world_one / 15, 0, world_one / 40},
                                         {0, world_one, -world_one / 8}));
    const TwoSources f(surfaces, 25, 20);
    std::vector<Slopes> planes;
    f.for_visible([&](int x, int y) {  // every different normal is a surface's
        const Slopes s = slopes_of_plane(f, x, y);
        bool known = false;
        for (const Slopes& of : planes)
            known = known || (std::abs(s.x - of.x) < 0.01 && std::abs(s.y - of.y) < 0.01);
        if (!known) planes.push_back(s);
    });
    EXPECT_EQ(planes.size(), 2u) << "floor and slats";
    const Strays n = strays(f, planes);
    std::printf("silhouettes: of %d pixels %d stray by depths, %d by normals\n", n.pixels, n.depths,
                n.normals);
    EXPECT_EQ(n.normals, 0);
    EXPECT_GT(n.depths, 50);
}

// What is kept is the surface's side that the observer sees.
TEST(KeptNormal, PointsToTheObserver) {
    const TwoSources f({wide_floor()}, 40, 20), below({wide_floor()}, -40, 20);
    const auto up = [](const TwoSources& of) {
        int seen = 0, right = 0;
        of.for_visible([&](int x, int y) {
            ++seen;
            right += of.store().normal_at(of.store().address(x, y), 1);
        });
        return seen == 0 ? 0 : right / seen;
    };
    EXPECT_EQ(up(f), 8192);  // 2^24, cut
    EXPECT_EQ(up(below), -8192);
}

TEST(KeptNormal, AStoreWithoutThemIsRefused) {
    const TwoSources f({wide_floor()}, 40, 20);
    hw::FrameStore<const hw::Depth16> store = f.store();
    store.normal = {};
    std::vector<std::uint8_t> mask(4096);
    const DepthMaps<hw::Depth16> maps{.observer = store,
                                      .light = f.frame->buffers.lights[0].map};
    throw_when_trapped = true;
    EXPECT_THROW(post_process(maps, f.frame->matrices.lights[0].observer_to_light, f.s, mask),
                 std::logic_error);
    throw_when_trapped = false;
}

}  // namespace
}  // namespace umbra78::shadow
