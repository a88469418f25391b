#include "tools/study/truth_cache.hpp"

#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbra78::tools::study {
namespace {

std::string key_of(const raster::World& w) { return fmt::format("{},{},{};", w.x, w.y, w.z); }

std::string key_of(const raster::View& v) {
    std::string key = fmt::format("view {} {} {} {} {};", static_cast<int>(v.projection), v.extent,
                                  v.distance, v.near_depth, v.far_depth) + key_of(v.target);
    for (const raster::Axis& axis : {v.axes.right, v.axes.up, v.axes.back})
        key += fmt::format("{},{},{};", axis[0], axis[1], axis[2]);
    return key;
}

// Two directions along the surface at the pixel.
std::array<Real3, 2> tangents(const Real3& normal) {
    const Real3 aside = std::abs(normal[1]) < std::abs(normal[0]) ? Real3{0, 1, 0}
                                                                  : Real3{1, 0, 0};
    const Real3 first = cross(normal, aside);
    return {first, cross(normal, first)};
}

// A step along either tangent moves the point in the light's image and in depth; the two moves
// give depth's slopes along the image's X and Y.
double slope_sum(const SceneTruth& s, std::size_t at) {
    const TruthView& light = s.light_view;
    const Real3& from = s.truth.position[at];
    const Real3 here = light.project(from);
    std::array<Real3, 2> moved{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Real3 way = tangents(s.truth.normal[at])[k];
        const double step = 1e-5 * light.extent / length(way);
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

}  // namespace

std::string truth_key(const LoadedScene& scene) {
    std::string key = fmt::format("{} {};", scene.settings.machine.xy_bits, scene.free_patches);
    for (const raster::Sphere& s : scene.spheres)
        key += key_of(s.centre) + fmt::format("{};", s.radius);
    for (const raster::Plane& p : scene.planes) key += key_of(p.origin) + key_of(p.u) + key_of(p.v);
    if (scene.free_patches > 0)
        for (const raster::Patch& patch : scene.patches)
            for (const raster::World& w : patch.control) key += key_of(w);
    for (const raster::World& w : scene.vertices) key += key_of(w);
    for (const raster::Facet& f : scene.facets)
        key += fmt::format("{} {} {};", f.vertex[0], f.vertex[1], f.vertex[2]);
    return key + key_of(scene.observer) + key_of(scene.light());
}

std::size_t bytes_of(const Traced& traced) {
    const auto of = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
    const Truth& t = traced.truth.truth;
    return sizeof(Traced) + of(t.visible) + of(t.lit) + of(t.surface) + of(t.depth) +
           of(t.position) + of(t.normal) + of(t.n_dot_l) + of(t.behind) +
           of(traced.truth.unlit_side) + of(traced.band) + of(traced.slope);
}

std::shared_ptr<const Traced> TruthCache::of(const LoadedScene& scene) const {
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<Slot>& there = slots_[truth_key(scene)];
        if (!there) there = std::make_shared<Slot>();
        there->last_asked = ++questions_;
        slot = there;
    }
    std::call_once(slot->once, [&] {
        auto truth = trace(scene);
        if (!truth) return;
        Traced traced{std::move(*truth), {}, {}};
        traced.band = light_texel_band(traced.truth);
        traced.slope = slopes(traced.truth);
        slot->traced = std::make_shared<const Traced>(std::move(traced));
        count(slot);
    });
    return slot->traced;
}

// Adds a new truth's bytes, and drops others until the budget is kept.
void TruthCache::count(const std::shared_ptr<Slot>& slot) const {
    const std::lock_guard lock(mutex_);
    slot->bytes = bytes_of(*slot->traced);
    bytes_ += slot->bytes;
    while (bytes_ > budget_bytes_) {
        auto oldest = slots_.end();
        for (auto at = slots_.begin(); at != slots_.end(); ++at)
            if (at->second != slot && at->second->bytes > 0 &&
                (oldest == slots_.end() || at->second->last_asked < oldest->second->last_asked))
                oldest = at;
        if (oldest == slots_.end()) return;  // the new one alone is over the budget
        bytes_ -= oldest->second->bytes;
        slots_.erase(oldest);
    }
}

std::size_t TruthCache::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

std::shared_ptr<const Traced> TruthCache::needed(const LoadedScene& scene) const {
    auto traced = of(scene);
    if (!traced)
        throw SceneError("the truth of free patches is traced by Embree, without which this "
                         "program is built; install libembree-dev and build it again");
    return traced;
}

}  // namespace umbra78::tools::study
