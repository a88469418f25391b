#include "tools/scene/scene_points.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

bool same(const raster::ViewAxes& a, const raster::ViewAxes& b) {
    return a.right == b.right && a.up == b.up && a.back == b.back;
}

// Words of places less the origin; what leaves a word is reported where a place is read.
raster::World saturated_difference(const raster::World& p, const raster::World& origin) {
    const auto word = [](std::int64_t v) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, INT32_MIN, INT32_MAX));
    };
    return {word(std::int64_t{p.x} - origin.x), word(std::int64_t{p.y} - origin.y),
            word(std::int64_t{p.z} - origin.z)};
}

}  // namespace

void ScenePoints::promise(std::int32_t largest) {
    promised_.add({-largest, -largest, -largest});
    promised_.add({largest, largest, largest});
    held_.for_points([&](const raster::World& p) { promised_.add(p); });
}

bool ScenePoints::rewind() {
    if (error_->any()) return false;
    if (!stream_->can_rewind()) {
        error_->report(fmt::format("{} cannot be read twice, so the scene needs {}; give all of "
                                   "them, or --spool", stream_->name(), lacks_));
        return false;
    }
    ++passes_;
    return stream_->rewind();
}

void ScenePoints::measure() {
    raster::Box box;
    for (raster::ViewRanges& r : ranges_) r = {r.axes};
    for_points([&](const raster::World& p) {
        box.add(p);
        for (raster::ViewRanges& r : ranges_) r.add(p);
    });
    box_ = box;
    measured_ = true;
}

const raster::Box& ScenePoints::box() {
    if (!measured_) measure();
    return box_;
}

const raster::Box& ScenePoints::reach() { return promised_.empty() ? box() : promised_; }

const raster::ViewRanges& ScenePoints::ranges(const raster::ViewAxes& axes) {
    auto found = std::ranges::find_if(
        ranges_, [&](const raster::ViewRanges& r) { return same(r.axes, axes); });
    if (found == ranges_.end()) {
        ranges_.push_back({axes});
        found = ranges_.end() - 1;
        measured_ = false;
    }
    if (!measured_) measure();
    return *found;
}

void ScenePoints::take_origin(const raster::World& origin, const raster::Surfaces& held) {
    held_ = held;
    if (origin == raster::World{}) return;
    for (raster::Box* box : {&box_, &promised_}) {
        if (box->empty()) continue;
        box->min = saturated_difference(box->min, origin);
        box->max = saturated_difference(box->max, origin);
    }
    for (raster::ViewRanges& r : ranges_) {
        const auto move = [&](raster::AxisRange& range, const raster::Axis& axis) {
            if (range.min > range.max) return;
            range.min -= raster::along(axis, origin);
            range.max -= raster::along(axis, origin);
        };
        move(r.right, r.axes.right);
        move(r.up, r.axes.up);
        move(r.back, r.axes.back);
    }
}

}  // namespace umbra78::tools
