// Facets on their way to the screen: against patches of the same shape, cut by the guard band
// without cracks, shaded by their normals.
#include "raster/facet.hpp"
#include "raster/sinks.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/trapped.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace umbra78::raster {
namespace {

using umbra78::test::Drawing;
using umbra78::test::q16;

struct OwnedMesh {
    std::vector<World> vertices;
    std::vector<std::array<std::int32_t, 3>> normals;
    std::vector<Facet> facets;

    Mesh mesh() const { return {vertices, normals, facets}; }
    Surfaces surfaces() const { return {{}, mesh()}; }
    void add(double x, double y, double z) { vertices.push_back({q16(x), q16(y), q16(z)}); }
};

// The parallelogram of a plane as two facets.
OwnedMesh quad(const Plane& p) {
    const auto at = [&](int s, int t) {
        return World{p.origin.x + s * p.u.x + t * p.v.x, p.origin.y + s * p.u.y + t * p.v.y,
                     p.origin.z + s * p.u.z + t * p.v.z};
    };
    return {{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, {}, {{{0, 1, 2}}, {{0, 2, 3}}}};
}

// The same with an inner vertex: four facets and other seams.
OwnedMesh fan(const Plane& p, double s, double t) {
    OwnedMesh m = quad(p);
    const auto at = [&](std::int32_t o, std::int32_t u, std::int32_t v) {
        return static_cast<std::int32_t>(o + s * u + t * v);
    };
    m.vertices.push_back({at(p.origin.x, p.u.x, p.v.x), at(p.origin.y, p.u.y, p.v.y),
                          at(p.origin.z, p.u.z, p.v.z)});
    m.facets = {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}};
    return m;
}

// How often each pixel is sampled.
struct CountSink {
    static constexpr bool shades = false;
    std::vector<int> times;
    int size_px;
    bool hidden(const Footprint&) const { return false; }
    void sample(const Sample& s, std::uint32_t, const void*) {
        ++times[static_cast<std::size_t>(s.py * size_px + s.px)];
    }
};

std::vector<int> coverage(const OwnedMesh& m, const View& view, const hw::MachineSpec& spec,
                          DrawCounts* counts = nullptr) {
    const hw::WordFormat object{16, 10};
    DrawSetup setup{spec, {}, object, Sampling::centre, {}, {}};
    EXPECT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
    const auto memory = std::make_unique<DrawMemory>();
    CountSink sink{std::vector<int>(std::size_t{1} << (2 * spec.xy_bits)), spec.size_px()};
    const DrawCounts counted = draw(m.surfaces(), {}, setup, *memory, sink);
    if (counts != nullptr) *counts = counted;
    return sink.times;
}

TEST(Facet, HasThePlanePatchsDepth) {
    Drawing<> patch, facets;
    const Plane plane = umbra78::test::plane({-1.4, -1.1, -0.6}, {2.6, 0.4, 0.9}, {-0.3, 2.2, 0.7});
    const View view = umbra78::test::orthographic(20, 30, 2);
    patch.draw(umbra78::test::Patches{plane_patch(plane)}, view, Sampling::centre);
    const OwnedMesh mesh = quad(plane);
    const DrawCounts counts = facets.draw(mesh.surfaces(), view, Sampling::centre);
    EXPECT_EQ(counts.facets, 2u);
    EXPECT_EQ(counts.triangles, 2u);
    EXPECT_EQ(counts.samples, counts.facet_samples);
    int both = 0, rim = 0, apart = 0;
    for (std::size_t k = 0; k < patch.depth().size(); ++k) {
        const bool a = patch.depth()[k] != 65535, b = facets.depth()[k] != 65535;
        rim += a != b ? 1 : 0;  // the patch covers 1/64 pixel more
        if (!a || !b) continue;
        ++both;
        // Where a centre lies in two leaves by their slack of 1/64 pixel the patch has the nearer.
        const int nearer = facets.depth()[k] - patch.depth()[k];
        EXPECT_TRUE(nearer >= -1 && nearer <= 6) << k << ": " << nearer;
        apart += nearer > 1 ? 1 : 0;
    }
    EXPECT_GT(both, 50000);
    EXPECT_LT(apart, both / 100);
    EXPECT_LT(rim, 60);
}

// The outline is the same, so are the pixels, wherever inner seams run and are cut.
TEST(Facet, SeamsLeaveNoCrackAndNoPixelTwice) {
    std::mt19937_64 bits(43);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) / 9007199254740992.0;
    };
    const hw::MachineSpec spec{.xy_bits = 7, .coefficient_bits = 24};
    int cut = 0, whole = 0, samples = 0;
    for (int n = 0; n < umbra78::test::effort(400); ++n) {
        const bool from_near = n % 2 == 0;  // an eye above a floor that reaches behind it
        const View view = from_near
                              ? umbra78::test::perspective(number(-180, 180), number(2, 60), 1,
                                                           number(0.5, 3), 0.05, 60)
                              : umbra78::test::orthographic(number(-180, 180), number(5, 60), 1);
        const double reach = n % 3 == 0 ? 28 : 2;
        const Plane plane = umbra78::test::plane(
            {-reach, number(-0.4, 0), -reach}, {2 * reach, 0, 0}, {0, 0, 2 * reach});
        DrawCounts counts;
        const std::vector<int> two = coverage(quad(plane), view, spec, &counts);
        const std::vector<int> four =
            coverage(fan(plane, number(0.1, 0.9), number(0.1, 0.9)), view, spec);
        cut += counts.cut_facets > 0 ? 1 : 0;
        whole += counts.cut_facets == 0 ? 1 : 0;
        samples += static_cast<int>(counts.samples);
        EXPECT_LE(*std::max_element(two.begin(), two.end()), 1) << n;
        EXPECT_EQ(two, four) << n;
        EXPECT_EQ(counts.unresolved_facets, 0u) << n;
    }
    EXPECT_GT(cut, umbra78::test::effort(60));
    EXPECT_GT(whole, umbra78::test::effort(40));
    EXPECT_GT(samples, umbra78::test::effort(400) * 1000);
}

// Far out of the picture an orthographic vertex is cut, too; what is in the picture stays.
TEST(Facet, TheGuardBandCutsWithoutMovingThePicture) {
    const hw::MachineSpec spec{.xy_bits = 6, .z_bits = 12};
    OwnedMesh m;
    m.add(-20000, -0.5, 0);
    m.add(20000, -0.5, 0);
    m.add(0, 20000, 0);
    m.facets = {{{0, 1, 2}}};
    const hw::WordFormat object{16, 0};
    DrawSetup setup{spec, {}, object, Sampling::centre, {}, {}};
    View view = umbra78::test::orthographic(0, 0, 8);
    ASSERT_EQ(load_view(view, spec, object, setup.matrix), hw::LoadStatus::ok);
    const auto memory = std::make_unique<DrawMemory>();
    CountSink sink{std::vector<int>(64 * 64), 64};
    const DrawCounts counts = draw(m.surfaces(), {}, setup, *memory, sink);
    EXPECT_EQ(counts.cut_facets, 1u);
    EXPECT_GT(counts.triangles, 1u);
    // The lower side lies at y = 0 (object words are whole units and -0.5 rounds up), so the upper
    // half of the frame is covered: 32 lines.
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(sink.times[static_cast<std::size_t>(64 * y + x)], y < 32 ? 1 : 0)
                << x << " " << y;
}

TEST(Facet, OutsideTheViewHasNoSamples) {
    OwnedMesh m;
    for (const double z : {-5.0, 5.0}) {  // behind the eye, and before it but beside the picture
        m.add(-1 + 40 * z, 0, z);
        m.add(1 + 40 * z, 0, z);
        m.add(0 + 40 * z, 1, z);
    }
    m.facets = {{{0, 1, 2}}, {{3, 4, 5}}};
    DrawCounts counts;
    const View view = umbra78::test::perspective(0, 0, 1, 2, 0.1, 20);
    const auto times = coverage(m, view, {.coefficient_bits = 24}, &counts);
    EXPECT_EQ(counts.facets, 2u);
    EXPECT_EQ(counts.samples, 0u);
    EXPECT_EQ(*std::max_element(times.begin(), times.end()), 0);
}

TEST(Facet, IsShadedAsThePatchOfItsPlane) {
    const Plane plane = umbra78::test::plane({-1.5, -1.5, -0.9}, {3, 0, 1.3}, {0, 3, 0.5});
    for (const bool point : {false, true}) {
        const View view = point ? umbra78::test::perspective(10, 10, 2, 6, 2, 12)
                                : umbra78::test::orthographic(10, 10, 2);
        const View light = point ? umbra78::test::perspective(40, 50, 3, 5, 1, 12)
                                 : umbra78::test::orthographic(40, 50, 3);
        const hw::MachineSpec spec{.coefficient_bits = 24};
        Drawing<> patch(spec), flat(spec), smooth(spec);
        patch.draw(umbra78::test::Patches{plane_patch(plane)}, view, Sampling::centre, &light);
        OwnedMesh mesh = quad(plane);
        flat.draw(mesh.surfaces(), view, Sampling::centre, &light);
        const auto n = unit_vector(cross(WideVector{plane.u.x, plane.u.y, plane.u.z},
                                         WideVector{plane.v.x, plane.v.y, plane.v.z}));
        mesh.normals = {n, {-n[0], -n[1], -n[2]}};  // their sign does not matter
        mesh.facets[0].normal = {0, 0, 0};
        mesh.facets[1].normal = {1, 1, 1};
        smooth.draw(mesh.surfaces(), view, Sampling::centre, &light);
        int shaded = 0;
        for (std::size_t k = 0; k < patch.depth().size(); ++k) {
            if (patch.depth()[k] == 65535 || flat.depth()[k] == 65535) continue;
            ++shaded;
            EXPECT_LE(std::abs(patch.intensity()[k] - flat.intensity()[k]), 1) << k;
            EXPECT_LE(std::abs(patch.direct()[k] - flat.direct()[k]), 1) << k;
            EXPECT_LE(std::abs(flat.intensity()[k] - smooth.intensity()[k]), 1) << k;
        }
        EXPECT_GT(shaded, 50000) << point;
    }
}

// Of three normals 120 degrees apart about the viewer's direction the middle one faces the viewer.
TEST(Facet, MixesItsCornersNormals) {
    OwnedMesh m;
    m.add(-1, -0.8, 0);
    m.add(1, -0.8, 0);
    m.add(0, 1.2, 0);
    const std::int32_t aside = 11585, ahead = 11585;  // 45 degrees
    m.normals = {{-aside, 0, ahead}, {aside, 0, ahead}, {0, aside, ahead}};
    m.facets = {{{0, 1, 2}, {0, 1, 2}}};
    const View view = umbra78::test::orthographic(0, 0, 2);
    Drawing<> d;
    d.materials = {{200, 0, 0}};
    d.ambient_q8 = 0;
    d.draw(m.surfaces(), view, Sampling::centre, &view);
    const auto at = [&](double x, double y) {
        return d.intensity_at(static_cast<int>(256 + 128 * x), static_cast<int>(256 - 128 * y));
    };
    EXPECT_NEAR(at(-0.98, -0.79), 200 * 0.7071, 3);
    EXPECT_NEAR(at(0.98, -0.79), 200 * 0.7071, 3);
    EXPECT_NEAR(at(0, -0.79), 200, 2);  // the mean of two has no component aside
    // The mean of all three: (0, 1/3, 1) of equal lengths.
    EXPECT_NEAR(at(0, -0.133), 200 * 0.9487, 2);
}

// A crossing in the middle of an edge: what lies at a half goes up, whichever way the edge runs.
TEST(Facet, ACutAtAHalfRoundsUp) {
    for (const std::int64_t way : {3, -3}) {
        FacetPolygon p;
        p.count = 3;
        p.vertex[0].screen = {0, 0, 9, 1};  // within by 1
        p.vertex[1].screen = {way, 0, 11, 1};  // beyond by 1
        p.vertex[2].screen = {0, 5, 9, 1};
        bool cut = false;
        ASSERT_TRUE(p.clip({100, 100, 10}, cut));
        EXPECT_TRUE(cut);
        ASSERT_EQ(p.count, 4u);
        EXPECT_EQ(p.vertex[1].screen, (ScreenPlace{way > 0 ? 2 : -1, 0, 10, 1}));
    }
}

// A normal that lies in the facet's plane is on neither side of it, and stays as it is.
TEST(Facet, ANormalInItsPlaneIsNotTurned) {
    constexpr std::int32_t one = 1 << unit_fraction;
    FacetPolygon p;
    FacetTriangle t{{&p.vertex[0], &p.vertex[1], &p.vertex[2]},
                    {Corner{0, 0, 0}, Corner{8192, 0, 0}, Corner{0, 8192, 0}}};
    for (FacetVertex& v : p.vertex) v.normal = {one, 0, 0}, v.screen = {0, 0, 0, 1};
    const std::array<WideVector, 3> facet{{{0, 0, 0}, {640, 0, 0}, {0, 640, 0}}};
    ShadingSpec spec(0, {}, {});
    spec.viewer.direction = {0, 0, one};
    spec.sources[0].toward.direction = {one, 0, 0};
    spec.rule = ShadingRule::lambert;
    Material material{};
    material.diffuse = 200;
    const FacetShading shading(t, facet, false, spec, material);
    EXPECT_EQ(shading.shade(Sample{0, 0, 1000, 1000, 0, 0, 0}, 0)[0].intensity, 200);
}

// What is cut to the guard band may still lie outside the cube.
TEST(Facet, IsUnseenCutOrNot) {
    OwnedMesh m;
    m.add(20, 0, 0), m.add(200, 0, 0), m.add(20, 100, 0);
    m.facets = {{{0, 1, 2}}};
    const View view = umbra78::test::orthographic(0, 0, 1);
    const MachineSpec spec;
    const WordFormat object = object_format(m.surfaces());
    MatrixWords matrix;
    ASSERT_EQ(load_view(view, spec, object, matrix), hw::LoadStatus::ok);
    FacetWalk walk(spec, matrix, object, {}, false);
    walk.begin(m.mesh());
    const FacetWalk::Outcome outcome = walk.project(m.facets[0]);
    ASSERT_EQ(outcome, FacetWalk::Outcome::cut);
    EXPECT_TRUE(walk.unseen(outcome));
}

TEST(Facet, RefusesNumbersThatAreNotThere) {
    OwnedMesh m = quad(umbra78::test::plane({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    const View view = umbra78::test::orthographic(0, 0, 2);
    Drawing<> d;
    throw_when_trapped = true;
    const auto refused = [&](auto change) {
        OwnedMesh wrong = m;
        change(wrong.facets[1]);
        EXPECT_THROW(d.draw(wrong.surfaces(), view, Sampling::centre, &view), std::logic_error);
    };
    refused([](Facet& f) { f.vertex[2] = 4; });
    refused([](Facet& f) { f.normal = {0, 0, 0}; });
    refused([](Facet& f) { f.material = 1; });
    throw_when_trapped = false;
}

}  // namespace
}  // namespace umbra78::raster
