#include "tools/truth/patch_truth.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools {

int cells_within_budget(std::size_t patches, int cells, std::size_t facets) {
    const std::size_t left = max_patch_triangles - std::min(facets, max_patch_triangles);
    const double quads = static_cast<double>(left) / 2 /
                         static_cast<double>(std::max<std::size_t>(patches, 1));
    return std::clamp(static_cast<int>(std::sqrt(quads)), 2, cells);
}

}  // namespace umbra78::tools

#ifdef UMBRA78_EMBREE

#if UMBRA78_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include "tools/truth/real_scene.hpp"

#include <memory>
#include <new>

namespace umbra78::tools {
namespace {

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

// The triangles, geometry k being patch k, the last one the mesh.
class Triangles {
public:
    Triangles(const RealScene& real, int cells)
        : cells_(cells), patches_(real.patches.size()), device_(rtcNewDevice(nullptr)) {
        if (!device_) throw std::bad_alloc();
        scene_.reset(rtcNewScene(device_.get()));
        // Rays do not slip through between two triangles.
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
        for (const RealPatch& patch : real.patches) add(patch);
        if (!real.facets.empty()) add(real);
        rtcCommitScene(scene_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) throw std::bad_alloc();
    }

    struct Hit {
        std::size_t surface;  // a patch, or facets after them
        double t, u, v;       // u and v of a patch
        Real3 normal;  // of the triangle, any length
    };

    std::optional<Hit> first(const Ray& ray, double to) const {
        RTCRayHit hit{};
        hit.ray = single(ray, to);
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if UMBRA78_EMBREE == 3
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_.get(), &context, &hit);
#else
        rtcIntersect1(scene_.get(), &hit);
#endif
        if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
        const Real3 normal{hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z};
        if (hit.hit.geomID == patches_)
            return Hit{patches_ + hit.hit.primID, hit.ray.tfar, 0, 0, normal};
        const unsigned cell = hit.hit.primID / 2, columns = static_cast<unsigned>(cells_);
        const double a = hit.hit.u, b = hit.hit.v;
        const bool lower = hit.hit.primID % 2 == 0;
        return Hit{hit.hit.geomID, hit.ray.tfar,
                   (cell % columns + (lower ? a + b : a)) / cells_,
                   (cell / columns + (lower ? b : a + b)) / cells_, normal};
    }

    bool blocked(const Ray& ray, double to) const {
        RTCRay shadow = single(ray, to);
#if UMBRA78_EMBREE == 3
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded1(scene_.get(), &context, &shadow);
#else
        rtcOccluded1(scene_.get(), &shadow);
#endif
        return shadow.tfar < 0;
    }

private:
    static RTCRay single(const Ray& ray, double to) {
        const auto f = [](double x) { return static_cast<float>(x); };
        RTCRay made{};
        made.org_x = f(ray.origin[0]);
        made.org_y = f(ray.origin[1]);
        made.org_z = f(ray.origin[2]);
        made.dir_x = f(ray.direction[0]);
        made.dir_y = f(ray.direction[1]);
        made.dir_z = f(ray.direction[2]);
        made.tfar = f(to);
        made.mask = ~0u;
        return made;
    }

    // A cell's triangles: (0,0) (1,0) (1,1) and (0,0) (1,1) (0,1).
    void add(const RealPatch& patch) {
        const std::size_t side = static_cast<std::size_t>(cells_) + 1;
        const std::size_t quads = static_cast<std::size_t>(cells_) * cells_;
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* place = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), side * side));
        auto* corner = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), 2 * quads));
        if (!place || !corner) throw std::bad_alloc();
        for (int j = 0; j <= cells_; ++j)
            for (int i = 0; i <= cells_; ++i)
                for (const double x : patch.point(double(i) / cells_, double(j) / cells_).at)
                    *place++ = static_cast<float>(x);
        const auto columns = static_cast<unsigned>(side);
        for (unsigned j = 0; j + 1 < columns; ++j) {
            for (unsigned i = 0; i + 1 < columns; ++i) {
                const unsigned at = j * columns + i, above = at + columns;
                for (const unsigned k : {at, at + 1, above + 1, at, above + 1, above})
                    *corner++ = k;
            }
        }
        attach(geometry);
    }

    void add(const RealScene& real) {
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* place = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), real.vertices.size()));
        auto* corner = static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(unsigned), real.facets.size()));
        if (!place || !corner) throw std::bad_alloc();
        for (const Real3& v : real.vertices)
            for (const double x : v) *place++ = static_cast<float>(x);
        for (const raster::Facet& facet : real.facets)
            for (const std::uint32_t k : facet.vertex) *corner++ = k;
        attach(geometry);
    }

    void attach(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
    }

    int cells_;
    std::size_t patches_;
    std::unique_ptr<RTCDeviceTy, Release> device_;
    std::unique_ptr<RTCSceneTy, Release> scene_;
};

struct Seen {
    double t;
    Real3 normal;  // any length, never zero
};

// From the triangle's point to the patch's, by Newton's steps for  patch(u, v) = o + t d. Where
// they leave the triangle's neighbourhood, at a silhouette, the triangle's point stays.
Seen on_patch(const RealPatch& patch, const Triangles::Hit& hit, const Ray& ray, int cells) {
    double t = hit.t, u = hit.u, v = hit.v;
    Real3 normal = hit.normal;
    for (int step = 0; step < 3; ++step) {
        const PatchPoint p = patch.point(u, v);
        const Real3 n = cross(p.along_u, p.along_v);
        const double nn = dot(n, n), nd = dot(n, ray.direction);
        // A pole has no tangent plane.
        const double longest = dot(p.along_u, p.along_u) * dot(p.along_v, p.along_v);
        if (nn <= 1e-12 * longest || nd == 0) return {hit.t, hit.normal};
        const Real3 off = minus(along(ray.origin, t, ray.direction), p.at);
        const double dt = -dot(n, off) / nd;
        const Real3 in_plane = along(off, dt, ray.direction);
        t += dt;
        u += dot(cross(in_plane, p.along_v), n) / nn;
        v += dot(cross(p.along_u, in_plane), n) / nn;
        normal = n;
        if (!(std::abs(u - hit.u) * cells <= 2 && std::abs(v - hit.v) * cells <= 2))
            return {hit.t, hit.normal};
    }
    return {t, normal};
}

// Where the ray meets the plane of the facet that it hits.
Seen on_facet(const RealScene& real, const Triangles::Hit& hit, const Ray& ray) {
    const auto& [a, b, c] = real.facets[hit.surface - real.patches.size()].vertex;
    const Real3 n = cross(minus(real.vertices[b], real.vertices[a]),
                          minus(real.vertices[c], real.vertices[a]));
    const double nd = dot(n, ray.direction);
    if (nd == 0 || dot(n, n) == 0) return {hit.t, hit.normal};
    return {dot(n, minus(real.vertices[a], ray.origin)) / nd, n};
}

Seen on_surface(const RealScene& real, const Triangles::Hit& hit, const Ray& ray, int cells) {
    return hit.surface < real.patches.size() ? on_patch(real.patches[hit.surface], hit, ray, cells)
                                             : on_facet(real, hit, ray);
}

// How far along the ray to the light the first surface that the light sees there is: the light's
// own ray is met from outside the scene, or from the light.
double distance_behind(const Triangles& triangles, const Ray& to_light, bool point, double reach) {
    const Real3 unit = times(1 / length(to_light.direction), to_light.direction);
    const double away = point ? length(to_light.direction)
                              : 2 * (reach + length(to_light.origin));
    const Ray from_light{along(to_light.origin, away, unit), times(-1, unit)};
    const auto hit = triangles.first(from_light, away);
    return hit ? away - hit->t : 0;
}

PatchTruth trace_once(const RealScene& real, const TruthView& view, const TruthLight& light,
                      int cells, bool measures_area) {
    const Triangles triangles(real, cells);
    const double reach = real.reach();
    double departure = 0;
    for (const RealPatch& patch : real.patches)
        departure = std::max(departure, patch.departure(cells));
    PatchTruth made{Truth(view.size), 0, departure + std::ldexp(reach, -20)};
    Truth& truth = made.truth;
    if (measures_area) truth.measure_area(light);
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        const auto size = static_cast<std::size_t>(view.size);
        Ray sight = view.ray(static_cast<double>(at % size) + 0.5,
                             static_cast<double>(at / size) + 0.5);
        sight.origin = along(sight.origin, view.near_depth, sight.direction);
        const auto hit = triangles.first(sight, view.far_depth - view.near_depth);
        if (!hit) continue;
        const Seen seen = on_surface(real, *hit, sight, cells);
        const Real3 position = along(sight.origin, seen.t, sight.direction);
        const Real3 normal = times(
            (dot(seen.normal, sight.direction) > 0 ? -1 : 1) / length(seen.normal), seen.normal);
        truth.see(at, static_cast<int>(hit->surface), view.near_depth + seen.t, position, normal,
                  light);
        truth.lit[at] =
            truth.n_dot_l[at] > 0 &&
            !triangles.blocked(light.ray(along(position, made.shadow_offset, normal)),
                               light.reach());
        if (measures_area && light.has_area())
            truth.see_area(at, points_seen(light, position, normal, [&](const TruthLight& one) {
                const Real3 start = along(position, made.shadow_offset, normal);
                return triangles.blocked(one.ray(start), one.reach());
            }));
        if (!truth.lit[at])
            truth.behind[at] =
                distance_behind(triangles, light.ray(position), light.point, reach);
    }
    return made;
}

}  // namespace

std::optional<PatchTruth> trace_patches(const raster::Surfaces& surfaces, const TruthView& view,
                                        const TruthLight& light, int cells) try {
    cells = cells_within_budget(surfaces.patches.size(), cells, surfaces.mesh.facets.size());
    const RealScene real(surfaces);
    PatchTruth made = trace_once(real, view, light, cells, true);
    // Of a light with an area the middle tells: lit is compared where it is the same question.
    const Truth coarse = trace_once(real, view, light, std::max(cells / 2, 1), false).truth;
    std::size_t changed = 0;
    for (std::size_t at = 0; at < coarse.visible.size(); ++at)
        changed += coarse.visible[at] != made.truth.visible[at] ||
                   (!light.has_area() && coarse.lit[at] != made.truth.lit[at]);
    made.estimated_error =
        static_cast<double>(changed) / static_cast<double>(coarse.visible.size());
    return made;
} catch (const std::bad_alloc&) {
    return std::nullopt;
}

bool traces_patches() { return true; }

}  // namespace umbra78::tools

#else

namespace umbra78::tools {

std::optional<PatchTruth> trace_patches(const raster::Surfaces&, const TruthView&,
                                        const TruthLight&, int) {
    return std::nullopt;
}

bool traces_patches() { return false; }

}  // namespace umbra78::tools

#endif
