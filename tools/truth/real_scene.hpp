// Patches and meshes in double precision: what truth traces.
#pragma once

#include "raster/scene.hpp"
#include "tools/truth/real3.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace umbra78::tools {

// Bernstein's four weights at t, and their derivatives.
struct BernsteinWeights {
    double at[4], slope[4];

    explicit BernsteinWeights(double t)
        : at{(1 - t) * (1 - t) * (1 - t), 3 * t * (1 - t) * (1 - t), 3 * t * t * (1 - t),
             t * t * t},
          slope{-3 * (1 - t) * (1 - t), 3 * (1 - t) * (1 - 3 * t), 3 * t * (2 - 3 * t),
                3 * t * t} {}
};

struct PatchPoint {
    Real3 at, along_u, along_v;
};

inline Real3 real(const raster::World& w) {
    const auto q16 = [](std::int32_t word) { return std::ldexp(word, -raster::world_fraction); };
    return {q16(w.x), q16(w.y), q16(w.z)};
}

struct RealPatch {
    Real3 control[16];  // (i, j) at 4 j + i

    explicit RealPatch(const raster::Patch& patch) {
        for (std::size_t k = 0; k < 16; ++k) control[k] = real(patch.control[k]);
    }

    PatchPoint point(double u, double v) const {
        const BernsteinWeights a(u), b(v);
        PatchPoint made{};
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 4; ++i) {
                const Real3& c = control[4 * j + i];
                made.at = along(made.at, a.at[i] * b.at[j], c);
                made.along_u = along(made.along_u, a.slope[i] * b.at[j], c);
                made.along_v = along(made.along_v, a.at[i] * b.slope[j], c);
            }
        }
        return made;
    }

    // How far triangles with legs 1 / cells in u and v may be from the patch. The second
    // derivatives are within 6 times the second differences of the control points, 9 times the
    // mixed ones.
    double departure(int cells) const {
        double uu = 0, vv = 0, uv = 0;
        const auto second = [&](int at, int step) {
            return length(along(minus(control[at], control[at + step]), 1,
                                minus(control[at + 2 * step], control[at + step])));
        };
        for (int k = 0; k < 4; ++k) {
            for (int from = 0; from < 2; ++from) {
                uu = std::max(uu, 6 * second(4 * k + from, 1));
                vv = std::max(vv, 6 * second(4 * from + k, 4));
            }
        }
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                const Real3* c = control + 4 * j + i;
                uv = std::max(uv, 9 * length(minus(minus(c[5], c[4]), minus(c[1], c[0]))));
            }
        }
        return (uu + 2 * uv + vv) / (8.0 * cells * cells);
    }

    double reach() const {
        double max = 0;
        for (const Real3& c : control)
            for (const double x : c) max = std::max(max, std::abs(x));
        return max;
    }
};

struct RealScene {
    std::vector<RealPatch> patches;
    std::vector<Real3> vertices;
    std::span<const raster::Facet> facets;

    explicit RealScene(const raster::Surfaces& s)
        : patches(s.patches.begin(), s.patches.end()), facets(s.mesh.facets) {
        for (const raster::World& w : s.mesh.vertices) vertices.push_back(real(w));
    }
    double reach() const {
        double max = 0;
        for (const RealPatch& patch : patches) max = std::max(max, patch.reach());
        for (const Real3& v : vertices)
            for (const double x : v) max = std::max(max, std::abs(x));
        return max;
    }
};

}  // namespace umbra78::tools
