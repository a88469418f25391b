// Facets drawn many at a time are the facets drawn one by one, bit for bit and count for count: by
// every form that this machine has, with every sink that takes batches, for meshes of triangles
// from a fraction of a pixel to far out of the frame.
#include "raster/draw.hpp"
#include "raster/sinks.hpp"
#include "tests/fixed/boundary.hpp"
#include "tests/support/buffers.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <vector>

namespace umbra78::raster {
namespace {

using fixed::test::Random;
using umbra78::test::Constant;
using umbra78::test::effort;
using umbra78::test::expect_equal_buffers;

struct RandomMesh {
    std::vector<World> vertices;
    std::vector<std::array<std::int32_t, 3>> normals;
    std::vector<Facet> facets;

    Surfaces surfaces() const { return {{}, {vertices, normals, facets}}; }
};

// A height field of `side` by `side` quads whose vertices are jittered, with normals about their
// facets' own or about any direction, or none; and some facets of vertices that lie anywhere.
RandomMesh random_mesh(Random& random, int side, std::int64_t step, std::int64_t jitter,
                       std::int64_t spread, int loose) {
    RandomMesh m;
    const auto any = [&](std::int64_t reach) {
        return static_cast<std::int32_t>(random.between(-reach, reach));
    };
    // In halves of a pixel, so that a straight view may meet pixels' centres.
    const std::int32_t tilt = any(step / 2);
    const std::int32_t x = any(1 << 7) * (1 << 10), y = any(1 << 7) * (1 << 10);
    for (int v = 0; v <= side; ++v) {
        for (int u = 0; u <= side; ++u) {
            const auto at = [&](int k) {
                return static_cast<std::int32_t>((k - side / 2) * step) + any(jitter);
            };
            m.vertices.push_back({at(u) + x, at(v) + y, any(step) + u * tilt});
            const UnitVector n =
                unit_vector({any(spread), any(spread), (1 << 14) + any(spread)});
            m.normals.push_back({n[0], n[1], n[2]});
        }
    }
    const auto count = static_cast<std::int64_t>(m.vertices.size());
    const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
        Facet f;
        const auto number = [](std::int64_t k) { return static_cast<std::uint32_t>(k); };
        f.vertex = {number(a), number(b), number(c)};
        if (random.between(0, 7) != 0) f.normal = f.vertex;
        f.material = static_cast<std::uint16_t>(random.between(0, 30) == 0 ? 1 : 0);
        m.facets.push_back(f);
    };
    for (int v = 0; v < side; ++v) {
        for (int u = 0; u < side; ++u) {
            const std::int64_t a = v * (side + 1) + u, b = a + 1, c = a + side + 1, d = c + 1;
            random.between(0, 1) != 0 ? add(a, b, d) : add(a, d, b);
            add(d, c, a);
        }
    }
    for (int k = 0; k < loose; ++k) {
        const auto vertex = [&] { return random.between(0, count - 1); };
        add(vertex(), vertex(), vertex());
    }
    return m;
}

// Step and jitter of a quad in world words; a pixel of the views below is 2^11 of them.
struct MeshKind {
    const char* name;
    std::int64_t step, jitter, spread;
    int loose;
};
constexpr MeshKind mesh_kinds[] = {
    {"a sixteenth of a pixel", 1 << 7, 1 << 6, 1 << 14, 0},
    {"a fraction of a pixel", 1 << 9, 1 << 8, 1 << 12, 0},
    {"about a pixel", 1 << 11, 1 << 11, 1 << 13, 4},
    {"some pixels", 1 << 13, 1 << 12, 1 << 11, 20},
    {"on pixels' centres", 1 << 11, 0, 1 << 14, 20},
    {"tiles", 1 << 15, 1 << 14, 1 << 12, 20},
    {"any normals", 1 << 13, 1 << 12, 1 << 20, 20},
    {"as large as the frame", 1 << 18, 1 << 17, 1 << 12, 20},
    {"far out of the frame", 1 << 23, 1 << 22, 1 << 12, 20},
};

struct MeshCase {
    hw::MachineSpec spec;
    View view, light;
    ShadingSpec shading;
    Facing facing;
    Drawn drawn;
    WordFormat object;
    MatrixWords matrix;
};

void expect_same_facet_counts(const DrawCounts& one_by_one, const DrawCounts& batched) {
    EXPECT_EQ(one_by_one.facets, batched.facets);
    EXPECT_EQ(one_by_one.cut_facets, batched.cut_facets);
    EXPECT_EQ(one_by_one.unresolved_facets, batched.unresolved_facets);
    EXPECT_EQ(one_by_one.turned_triangles, batched.turned_triangles);
    EXPECT_EQ(one_by_one.triangles, batched.triangles);
    EXPECT_EQ(one_by_one.triangle_lines, batched.triangle_lines);
    EXPECT_EQ(one_by_one.samples, batched.samples);
    EXPECT_EQ(one_by_one.facet_samples, batched.facet_samples);
}

template <class Depth>
struct MeshStores {
    std::vector<Depth> depth;
    std::vector<std::uint8_t> intensity, direct;
    hw::FrameStore<Depth> store;

    MeshStores(const MeshCase& c, bool shades) {
        const std::size_t pixels = std::size_t{1} << (2 * c.spec.xy_bits);
        depth.resize(pixels);
        if (shades) {
            intensity.resize(pixels * c.shading.channels);
            direct.resize(pixels * c.shading.channels * c.shading.source_count);
        }
        store = {c.spec.xy_bits, depth, intensity, direct, {}};
        store.clear(c.spec);
    }
};

template <class Depth>
DrawCounts draw_into(MeshStores<Depth>& s, const MeshCase& c, const RandomMesh& mesh, bool shades,
                     const BlockForm* form, DrawMemory& memory) {
    static const std::vector<Material> materials{Material{}, Material{120, {200, 90, 10}, 2}};
    DrawSetup setup{c.spec, c.matrix, c.object, Sampling::centre, materials, c.shading};
    setup.facing = c.facing;
    setup.drawn = c.drawn;
    setup.blocks = form;
    setup.batches_facets = form != nullptr;
    if (shades) {
        PictureSink<Depth> sink{s.store};
        return draw(mesh.surfaces(), {}, setup, memory, sink);
    }
    DepthSink<Depth> sink{s.store};
    return draw(mesh.surfaces(), {}, setup, memory, sink);
}

MeshCase random_case(Random& random, const RandomMesh& mesh) {
    MeshCase c;
    c.spec.xy_bits = static_cast<int>(random.between(4, 8));
    c.spec.z_bits = static_cast<int>(random.between(0, 3) == 0 ? random.between(8, 20) : 16);
    c.spec.coefficient_bits = random.between(0, 1) != 0 ? 16 : 24;
    c.spec.transform_rounding = static_cast<fixed::Rounding>(random.between(0, 6));
    if (random.between(0, 3) != 0) c.spec.transform_rounding = fixed::Rounding::half_up;
    if (random.between(0, 3) == 0)
        c.spec.depth_rounding = static_cast<fixed::Rounding>(random.between(0, 6));
    // So that a pixel is 2^11 world words.
    const double extent = 1.0 / 32 * (1 << (c.spec.xy_bits - 1));
    const bool straight = random.between(0, 2) == 0;
    const double turn = straight ? 0 : static_cast<double>(random.between(-40, 40));
    const bool point = random.between(0, 3) == 0;
    c.view = point ? umbra78::test::perspective(turn, turn / 2, extent, 4 * extent, extent,
                                                8 * extent)
                   : umbra78::test::orthographic(turn, turn / 2, extent);
    if (straight) c.view = umbra78::test::orthographic(0, 0, extent);
    c.light = umbra78::test::orthographic(static_cast<double>(random.between(-90, 90)), 40, extent);
    c.facing = static_cast<Facing>(random.between(0, 2));
    c.drawn = static_cast<Drawn>(random.between(0, 2));
    c.object = object_format(mesh.surfaces());
    EXPECT_EQ(load_view(c.view, c.spec, c.object, c.matrix), hw::LoadStatus::ok);
    ShadingSpec& s = c.shading;
    s = {static_cast<std::int32_t>(random.between(0, 256)), toward_eye(c.light, c.object),
         toward_eye(c.view, c.object)};
    s.rule = static_cast<ShadingRule>(random.between(0, 3));
    s.channels = random.between(0, 3) == 0 ? max_channels : 1;
    s.source_count = static_cast<std::size_t>(random.between(1, 3));
    for (std::size_t l = 1; l < s.source_count; ++l) {
        s.sources[l] = s.sources[0];
        s.sources[l].toward.direction[l] += 3000;
    }
    return c;
}

template <class Depth>
std::uint64_t expect_same_frames(const MeshCase& c, const RandomMesh& mesh, bool shades,
                                 DrawMemory& memory) {
    MeshStores<Depth> one_by_one(c, shades);
    const DrawCounts plain = draw_into(one_by_one, c, mesh, shades, nullptr, memory);
    for (const BlockForm& form : block_forms()) {
        if (!form.supported()) continue;
        SCOPED_TRACE(form.name);
        MeshStores<Depth> batched(c, shades);
        expect_same_facet_counts(plain, draw_into(batched, c, mesh, shades, &form, memory));
        const int size = c.spec.size_px();
        const auto equal = [&](const char* name, const auto& a, const auto& b) {
            expect_equal_buffers(name, size, a, b, Constant::expected);
        };
        equal("depth", one_by_one.depth, batched.depth);
        if (shades) equal("intensity", one_by_one.intensity, batched.intensity);
        if (shades) equal("direct", one_by_one.direct, batched.direct);
    }
    return plain.samples;
}

TEST(FacetBatch, IsTheFacetsOneByOne) {
    Random random;
    const auto memory = std::make_unique<DrawMemory>();
    std::uint64_t samples = 0;
    for (const MeshKind& kind : mesh_kinds) {
        std::uint64_t of_kind = 0;
        const int rounds = effort(kind.step < 1 << 9 ? 600 : 60);
        for (int n = 0; n < rounds; ++n) {
            SCOPED_TRACE(kind.name);
            // The smallest hold no centre unless there are many.
            const auto side = static_cast<int>(random.between(kind.step < 1 << 9 ? 24 : 1, 24));
            const RandomMesh mesh = random_mesh(random, side, kind.step, kind.jitter, kind.spread,
                                                kind.loose);
            const MeshCase c = random_case(random, mesh);
            of_kind += expect_same_frames<hw::Depth32>(c, mesh, n % 2 == 0, *memory);
            if (c.spec.z_bits <= 16)
                of_kind += expect_same_frames<hw::Depth16>(c, mesh, n % 2 == 0, *memory);
            if (HasFailure()) FAIL() << "mesh " << n;
        }
        // Far out of the frame most meshes are out of its depth, too, and so may be a few.
        if (kind.step < 1 << 20 && !umbra78::test::sanitized) {
            EXPECT_GT(of_kind, 60u) << kind.name;
        }
        samples += of_kind;
    }
    EXPECT_GT(samples, static_cast<std::uint64_t>(effort(80000)));
    std::cout << "[ measured ] " << samples << " samples\n";
}

}  // namespace
}  // namespace umbra78::raster
