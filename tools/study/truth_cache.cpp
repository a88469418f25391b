#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

std::string key_of(const raster::World& w) { return fmt::format("{},{},{};", w.x, w.y, w.z); }

std::string key_of(const raster::View& v) {
    std::string key = fmt::format("view {} {} {} {} {};", static_cast<int>(v.projection), v.extent,
                                  v.distance, v.near_depth, v.far_depth) + key_of(v.target);
    for (const raster::Axis& axis : {v.frame.right, v.frame.up, v.frame.back})
        key += fmt::format("{},{},{};", axis[0], axis[1], axis[2]);
    return key;
}

// Z as the machine's word, before it is rounded: 0 at the near plane, 2^bits at the far one.
double exact_code(const LoadedScene& scene, double depth) {
    const raster::View& view = scene.observer;
    const double near = std::ldexp(static_cast<double>(view.near_depth), -16);
    const double far = std::ldexp(static_cast<double>(view.far_depth), -16);
    const double in_range = (depth - near) / (far - near);
    const bool perspective = view.projection == raster::Projection::perspective;
    return std::ldexp(perspective ? in_range * far / depth : in_range,
                      scene.settings.machine.z_bits);
}

// Whether the pixel lies inside its surface's image, away from every silhouette.
bool inside(const Truth& truth, std::size_t at) {
    const auto size = static_cast<std::size_t>(truth.size);
    const std::size_t x = at % size, y = at / size;
    if (!truth.visible[at] || x == 0 || y == 0 || x + 1 == size || y + 1 == size) return false;
    for (const std::size_t beside : {at - 1, at + 1, at - size, at + size})
        if (truth.surface[beside] != truth.surface[at]) return false;
    return true;
}

}  // namespace

std::string truth_key(const LoadedScene& scene) {
    std::string key = fmt::format("{} {};", scene.settings.machine.xy_bits, scene.free_patches);
    for (const raster::Sphere& s : scene.spheres)
        key += key_of(s.centre) + fmt::format("{};", s.radius);
    for (const raster::Plane& p : scene.planes) key += key_of(p.origin) + key_of(p.u) + key_of(p.v);
    return key + key_of(scene.observer) + key_of(scene.light);
}

std::shared_ptr<const TruthCache::Entry> TruthCache::of(const LoadedScene& scene) const {
    std::shared_ptr<Slot> slot;
    {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<Slot>& there = slots_[truth_key(scene)];
        if (!there) there = std::make_shared<Slot>();
        slot = there;
    }
    std::call_once(slot->once, [&] {
        auto made = std::make_shared<Entry>();
        made->truth = trace(scene);
        if (made->truth) made->band = light_texel_band(*made->truth);
        slot->entry = std::move(made);
    });
    return slot->entry;
}

DepthError depth_error(const LoadedScene& scene, const Truth& truth, const Buffer& observer_z) {
    DepthError error;
    double sum = 0, squares = 0;
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        const std::uint32_t code = observer_z.at(at);
        if (code == observer_z.maxval || !inside(truth, at)) continue;
        const double off = code - exact_code(scene, truth.depth[at]);
        error.least = error.pixels ? std::min(error.least, off) : off;
        error.greatest = error.pixels ? std::max(error.greatest, off) : off;
        sum += off;
        squares += off * off;
        ++error.pixels;
    }
    if (error.pixels == 0) return error;
    const auto pixels = static_cast<double>(error.pixels);
    error.mean = sum / pixels;
    error.rms = std::sqrt(squares / pixels);
    return error;
}

}  // namespace umbra78::tools::study
