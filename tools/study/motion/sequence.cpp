// The frames of a sequence, drawn one after the other, and the flips between them.
#include "tools/scene/view_fit.hpp"
#include "tools/study/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace umbra78::tools::study {
namespace {

using raster::View;

constexpr double degree = pi / 180;

std::int32_t angle_q16(double radians) {
    return static_cast<std::int32_t>(std::lround(std::ldexp(radians / degree, 16)));
}

double along_axis(const raster::Axis& axis, const raster::World& p) {  // world units
    return std::ldexp(static_cast<double>(raster::along(axis, p)), -46);
}

// The view's axes are made of its angles again, so that frame 0 is not of another kind than the
// others; sines of 30 bits give the angles' 16 bits back exactly.
void turn(View& view, int frame) {
    const raster::Axis& back = view.axes.back;
    const double azimuth = std::atan2(back[0], back[2]);
    const double elevation = std::asin(std::clamp(std::ldexp(back[1], -30), -1.0, 1.0));
    view.axes = raster::axes_from_angles(angle_q16(azimuth + frame * turn_degrees * degree),
                                         angle_q16(elevation));
}

// Moves the target by so many world units along the axes of `by`, rounded to world words.
void move(View& view, const raster::ViewAxes& by, double right, double up) {
    const auto add = [&](std::int32_t& word, std::size_t k) {
        const double moved = right * std::ldexp(by.right[k], -30) + up * std::ldexp(by.up[k], -30);
        word += static_cast<std::int32_t>(std::lround(std::ldexp(moved, 16)));
    };
    add(view.target.x, 0);
    add(view.target.y, 1);
    add(view.target.z, 2);
}

double pixel_of(const View& view, const LoadedScene& scene) {  // world units, at the target
    return std::ldexp(2.0 * view.extent, -16) / scene.settings.machine.size_px();
}

// What takes the origin to the nearest corner along an axis, in texels: -1/2 .. 1/2. The middle of
// the map is a corner.
double to_corner(const raster::Axis& axis, const View& light, double texel) {
    const double at = along_axis(axis, light.target) / texel;
    return std::round(at) - at;
}

bool lamp(const View& light) { return light.projection == raster::Projection::perspective; }

void snap(LoadedScene& scene) {
    View& light = scene.light();
    if (lamp(light))
        throw SceneError("the view of a lamp cannot be snapped, because in perspective a texel has "
                         "no one size; give the light kind = \"directional\"");
    const double texel = pixel_of(light, scene);
    move(light, light.axes, texel * to_corner(light.axes.right, light, texel),
         texel * to_corner(light.axes.up, light, texel));
}

// A job that goes from frame to frame; the last one's scene must live while the next is drawn.
class Drawn {
public:
    void draw(LoadedScene next) {
        auto scene = std::make_unique<LoadedScene>(std::move(next));
        if (job_) {
            job_->advance(scene->view(), scene->settings);
        } else {
            job_ = std::make_unique<RenderJob>(scene->view(), scene->settings);
        }
        scene_ = std::move(scene);
        job_->render();
    }
    const RenderJob& job() const { return *job_; }
    const LoadedScene& scene() const { return *scene_; }

private:
    std::unique_ptr<LoadedScene> scene_;
    std::unique_ptr<RenderJob> job_;
};

SeenFrame seen_frame(const RenderJob& job, Plane plane, std::shared_ptr<const Traced> traced) {
    const auto mask = job.bytes(plane);
    return {std::move(traced), {mask.begin(), mask.end()}, job.visible()};
}

std::size_t outside_light(const LoadedScene& scene) {
    const Outside outside = count_outside(scene.light(), scene.surfaces());
    return outside.window + outside.depth;
}

// What the frame is wrong by: into the sums and the worst.
void judge(const RenderJob& job, const SeenFrame& frame, MotionSeen& seen) {
    const SceneTruth& truth = frame.traced->truth;
    const Buffer depths = job.buffer(Plane::observer_z);
    const Coverage c =
        coverage(truth.truth, depths, coverage_image(truth.truth, depths, truth.observer));
    const auto lost = [](const Coverage& of) { return of.missing + of.extra + of.misplaced; };
    if (lost(c) > lost(seen.worst)) seen.worst = c;
    const ShadowError e = shadow_error(truth.truth, {frame.mask, frame.visible}, truth.unlit_side);
    seen.false_shadow += e.false_shadow_rate();
    seen.false_light += e.false_light_rate();
}

}  // namespace

LoadedScene motion_frame(const LoadedScene& still, const MotionCase& c, int frame) {
    LoadedScene scene = still;
    View &light = scene.light(), &observer = scene.observer;
    const bool follows = !lamp(light);
    switch (c.motion) {
    case Motion::light_turns: turn(light, frame); break;
    case Motion::observer_turns: turn(observer, frame); break;
    case Motion::light_moves: {
        const double texel = pixel_of(light, scene);
        move(light, light.axes, frame * step_x * texel, frame * step_y * texel);
        break;
    }
    case Motion::observer_moves: {
        const double pixel = pixel_of(observer, scene);
        const raster::ViewAxes by = observer.axes;
        move(observer, by, frame * step_x * pixel, frame * step_y * pixel);
        if (follows) move(light, by, frame * step_x * pixel, frame * step_y * pixel);
        break;
    }
    }
    if (c.snapped) snap(scene);
    // Neighbouring seeds would give shifted streams much alike: multiplied, they lie far apart.
    if (c.renewed) {
        const std::uint64_t period = (std::uint64_t{1} << 31) - 1;
        const std::uint64_t seed = scene.settings.dither.seed;
        scene.settings.dither.seed = static_cast<std::uint32_t>(
            1 + (seed - 1 + static_cast<std::uint64_t>(frame) * 1103515245) % period);
    }
    return scene;
}

double off_corner_texels(const LoadedScene& scene) {
    const View& light = scene.light();
    const double texel = pixel_of(light, scene);
    return std::max(std::abs(to_corner(light.axes.right, light, texel)),
                    std::abs(to_corner(light.axes.up, light, texel)));
}

Flips flips(const SeenFrame& before, const SeenFrame& after, std::span<int> flickers) {
    Flips f;
    for (std::size_t at = 0; at < before.mask.size(); ++at) {
        if (!before.compares(at) || !after.compares(at)) continue;
        const bool truth = before.lit(at) != after.lit(at);
        const bool mask = before.shadowed(at) != after.shadowed(at);
        const bool outside = !before.traced->band[at] && !after.traced->band[at];
        const bool flickered = mask && !truth;
        ++f.compared;
        f.truth += truth;
        f.mask += mask;
        f.rightful += mask && truth;
        f.compared_outside += outside;
        f.flicker_outside += outside && flickered;
        if (flickered && !flickers.empty()) ++flickers[at];
    }
    return f;
}

MotionSeen see_motion(const LoadedScene& still, const MotionCase& c, const TruthCache& truths) {
    MotionSeen seen;
    seen.size_px = still.settings.machine.size_px();
    const auto pixels = static_cast<std::size_t>(seen.size_px) * seen.size_px;
    seen.flickers.assign(pixels, 0);
    seen.seen.assign(pixels, 0);
    const std::size_t outside_still = outside_light(still);
    Drawn drawn;
    SeenFrame mask, filtered;
    for (int frame = 0; frame < c.frames; ++frame) {
        drawn.draw(motion_frame(still, c, frame));
        const auto traced = truths.needed(drawn.scene());
        SeenFrame next = seen_frame(drawn.job(), Plane::mask, traced);
        SeenFrame next_filtered = seen_frame(drawn.job(), Plane::filtered, traced);
        judge(drawn.job(), next, seen);
        const std::size_t outside = outside_light(drawn.scene());
        seen.outside_light = std::max(seen.outside_light, outside - std::min(outside,
                                                                             outside_still));
        seen.off_corner_texels =
            std::max(seen.off_corner_texels, off_corner_texels(drawn.scene()));
        if (frame > 0) {
            seen.compared.push_back(flips(mask, next, seen.flickers));
            seen.filtered.push_back(flips(filtered, next_filtered));
            for (std::size_t at = 0; at < pixels; ++at)
                seen.seen[at] |= mask.compares(at) && next.compares(at);
        }
        mask = std::move(next);
        filtered = std::move(next_filtered);
    }
    seen.false_shadow /= c.frames;
    seen.false_light /= c.frames;
    return seen;
}

}  // namespace umbra78::tools::study
