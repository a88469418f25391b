#include "tools/study/traced.hpp"

#include "shadow/bias.hpp"
#include "tools/study/truth_cache.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools::study {
namespace {

// How far along the ray the last crossing before the light is.
double last_crossing(const TruthScene& scene, const Ray& ray, double reach) {
    double last = 0;
    const auto meet = [&](double t) {
        if (t > last && t < reach) last = t;
    };
    for (const TruthSphere& sphere : scene.spheres)
        if (const auto hit = crossings(sphere, ray))
            for (const double t : *hit) meet(t);
    for (const TruthPlane& plane : scene.planes)
        if (const auto hit = crossing(plane, ray); hit && hit->inside) meet(hit->t);
    return last * std::sqrt(dot(ray.direction, ray.direction));
}

std::vector<double> distances_behind(const SceneTruth& s) {
    std::vector<double> behind(s.truth.visible.size());
    for (std::size_t at = 0; at < behind.size(); ++at)
        if (s.truth.visible[at] && !s.truth.lit[at])
            behind[at] =
                last_crossing(s.scene, s.light.ray(s.truth.position[at]), s.light.reach());
    return behind;
}

// Two directions along the surface at the pixel.
std::array<Real3, 2> tangents(const SceneTruth& s, std::size_t at) {
    const int spheres = static_cast<int>(s.scene.spheres.size()), surface = s.truth.surface[at];
    if (surface >= spheres) {
        const TruthPlane& plane = s.scene.planes[surface - spheres];
        return {plane.u, plane.v};
    }
    const Real3 n = along(s.truth.position[at], -1, s.scene.spheres[surface].centre);
    const auto cross = [](const Real3& a, const Real3& b) {
        return Real3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
    };
    const Real3 aside = std::abs(n[1]) < std::abs(n[0]) ? Real3{0, 1, 0} : Real3{1, 0, 0};
    const Real3 first = cross(n, aside);
    return {first, cross(n, first)};
}

// A step along either tangent moves the point in the light's image and in depth; the two moves
// give depth's slopes along the image's X and Y.
double slope_sum(const SceneTruth& s, std::size_t at) {
    const TruthView& light = s.light_view;
    const Real3& from = s.truth.position[at];
    const Real3 here = light.project(from);
    std::array<Real3, 2> moved{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Real3 way = tangents(s, at)[k];
        const double step = 1e-5 * light.extent / std::sqrt(dot(way, way));
        moved[k] = along(light.project(along(from, step, way)), -1, here);
    }
    const auto& [a, b] = moved;
    const double area = a[0] * b[1] - a[1] * b[0];
    const double zu = (a[2] * b[1] - b[2] * a[1]) / area;
    const double zv = (b[2] * a[0] - a[2] * b[0]) / area;
    const double range = light.far_depth - light.near_depth;
    const double codes =  // of the whole range, a unit of depth
        light.perspective ? light.far_depth * light.near_depth / (range * here[2] * here[2])
                          : 1 / range;
    return (std::abs(zu) + std::abs(zv)) * codes;
}

std::vector<double> slopes(const SceneTruth& s) {
    std::vector<double> slope(s.truth.visible.size());
    for (std::size_t at = 0; at < slope.size(); ++at)
        if (s.truth.visible[at] && s.truth.lit[at]) slope[at] = slope_sum(s, at);
    return slope;
}

std::shared_ptr<const Traced> trace_all(const LoadedScene& scene) {
    auto truth = trace(scene);
    if (!truth) return nullptr;
    Traced traced{std::move(*truth), {}, {}, {}};
    traced.band = light_texel_band(traced.truth);
    traced.behind = distances_behind(traced.truth);
    traced.slope = slopes(traced.truth);
    return std::make_shared<const Traced>(std::move(traced));
}

}  // namespace

std::shared_ptr<const Traced> TruthStore::of(const LoadedScene& scene) const {
    if (scene.free_patches > 0) return nullptr;
    std::promise<std::shared_ptr<const Traced>> promise;
    Entry entry;
    bool first = false;
    {
        const std::lock_guard lock(mutex_);
        const auto [place, added] = entries_.try_emplace(truth_key(scene));
        if (added) place->second = promise.get_future().share();
        first = added;
        entry = place->second;
    }
    if (first) {
        try {
            promise.set_value(trace_all(scene));
        } catch (...) {
            promise.set_exception(std::current_exception());
        }
    }
    return entry.get();
}

void draw_mask(RenderJob& job) {
    job.draw_light();
    job.draw_observer();
    job.cast_shadows();
}

double detachment_gap(const Traced& traced, const MachineMask& mask) {
    const Truth& truth = traced.truth.truth;
    std::vector<std::pair<double, bool>> shadowed;  // distance, and whether it is lit
    for (std::size_t at = 0; at < truth.visible.size(); ++at)
        if (truth.visible[at] && !truth.lit[at] && mask.drawn(at) && !traced.truth.unlit_side[at])
            shadowed.emplace_back(traced.behind[at], !mask.in_shadow(at));
    std::sort(shadowed.begin(), shadowed.end());
    std::int64_t more_lit = 0, most = 0;
    double gap = 0;
    for (const auto& [distance, lit] : shadowed) {
        more_lit += lit ? 1 : -1;
        if (more_lit <= most) continue;
        most = more_lit;
        gap = distance;
    }
    return gap;
}

void set_rates(Row& row, const ShadowReport& errors) {
    row.set("false_shadow", errors.all.false_shadow_rate());
    row.set("false_light", errors.all.false_light_rate());
    row.set("false_shadow_outside", errors.outside_band.false_shadow_rate());
    row.set("false_light_outside", errors.outside_band.false_light_rate());
    row.set("isolated_pixels", std::int64_t{errors.isolated_pixels});
}

LightUnits light_units(const LoadedScene& scene) {
    const auto real = [](const hw::Rational& exact) {
        std::int64_t q32 = 0;
        exact.round_scaled(32, fixed::Rounding::half_even, q32);
        return std::ldexp(static_cast<double>(q32), -32);
    };
    const auto units = shadow::bias_units(scene.light, scene.settings.machine);
    return {real(units.quanta_per_world), real(units.texels_per_world)};
}

void set_in_three_units(Row& row, const std::string& column, const LightUnits& units,
                        double quanta) {
    row.set(column + "_quanta", quanta);
    row.set(column + "_texels", units.texels(quanta));
    row.set(column + "_world", units.world(quanta));
}

}  // namespace umbra78::tools::study
