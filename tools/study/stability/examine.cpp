// One frame of the study of stability: drawn by the program's job, and checked with truth and with
// the exact matrix.
#include "tools/render/render_job.hpp"
#include "tools/scene/checks.hpp"
#include "tools/study/stability/stability.hpp"
#include "tools/truth/cut_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

const char* name_of(shadow::FrameStatus status) {
    constexpr const char* names[] = {"ok", "spec_out_of_range", "observer_matrix", "light_matrix",
                                     "shadow_matrix", "bias_out_of_range"};
    return names[static_cast<std::size_t>(status)];
}

// The depth, in world units, of a Z code: the inverse of hw/MACHINE.md, section 4.
double depth_of_code(double code, const TruthView& v, const hw::MachineSpec& m) {
    const double half = std::ldexp(1, m.z_bits - 1), z = (code - half) / half;  // -1 .. 1
    if (!v.perspective) return v.near_depth + (z + 1) / 2 * (v.far_depth - v.near_depth);
    return 2 * v.far_depth * v.near_depth /
           (v.far_depth + v.near_depth - z * (v.far_depth - v.near_depth));
}

double code_of_depth(double d, const TruthView& v, const hw::MachineSpec& m) {
    const double half = std::ldexp(1, m.z_bits - 1), range = v.far_depth - v.near_depth;
    const double z = v.perspective
                         ? ((v.far_depth + v.near_depth) * d - 2 * v.far_depth * v.near_depth) /
                               (range * d)
                         : 2 * (d - v.near_depth) / range - 1;
    return half + z * half;
}

// Whether the pixel and its four neighbours are seen and on one surface.
bool inner(const Truth& t, std::size_t at) {
    const std::size_t size = static_cast<std::size_t>(t.size), x = at % size, y = at / size;
    if (x == 0 || y == 0 || x + 1 == size || y + 1 == size || !t.visible[at]) return false;
    for (const std::size_t other : {at - 1, at + 1, at - size, at + size})
        if (t.surface[other] != t.surface[at]) return false;
    return true;
}

// The drawn Z against truth, over pixels whose neighbours are on the same surface. Pixels that
// truth sees there and the machine did not draw are lost, except those whose code is beyond the
// last one: the machine drops them (hw/MACHINE.md, section 7), and the status becomes
// beyond_last_code.
void measure_depths(const RenderJob& job, const SceneTruth& truth, bool far_half, Finding& f) {
    const hw::MachineSpec& m = job.settings().machine;
    const Buffer buffer = job.buffer(Plane::observer_z);
    double quanta = 0, units = 0;
    std::int64_t lost = 0, beyond = 0, measured = 0;
    std::visit(
        [&](const auto& words) {
            for (std::size_t at = 0; at < words.size(); ++at) {
                if (!inner(truth.truth, at)) continue;
                const double d = truth.truth.depth[at];
                if (words[at] == m.background()) {
                    const double code = code_of_depth(d, truth.observer, m);
                    ++(code + 2 > m.background() ? beyond : lost);
                    continue;
                }
                ++measured;
                quanta = std::max(quanta, std::abs(words[at] -
                                                   code_of_depth(d, truth.observer, m)));
                units = std::max(units,
                                 std::abs(depth_of_code(words[at], truth.observer, m) - d));
            }
        },
        buffer.values);
    if (measured > 0) {
        f.depth_error_quanta = quanta;
        f.depth_error_units = units;
    }
    f.lost = lost;
    if (beyond > 0) f.status = "beyond_last_code";
    if (!far_half) return;
    const double end = truth.observer.far_depth, middle = (truth.observer.near_depth + end) / 2;
    f.far_codes = std::llround(code_of_depth(end, truth.observer, m)) -
                  std::llround(code_of_depth(middle, truth.observer, m));
}

void measure_shadow(const RenderJob& job, const SceneTruth& truth, Finding& f) {
    const std::vector<std::uint8_t> visible = job.visible();
    const MachineMask mask{job.bytes(Plane::mask), visible};
    const ShadowReport r = report(truth, mask, light_texel_band(truth));
    f.false_shadow = r.outside_band.false_shadow_rate();
    f.false_light = r.outside_band.false_light_rate();
}

// A mask is 0 or 255, and 0 where nothing was drawn.
bool sane_mask(const RenderJob& job) {
    const std::vector<std::uint8_t> visible = job.visible();
    const auto mask = job.bytes(Plane::mask);
    for (std::size_t at = 0; at < mask.size(); ++at)
        if (mask[at] != 0 && (mask[at] != 255 || !visible[at])) return false;
    return true;
}

// The cases' scenes stand where they are written, and their bias is in quanta.
const std::vector<std::string> as_written{"bias=64", "bias_unit=quanta", "observer.recentre=off"};

std::vector<std::string> overrides(const FrameCase& c, const Effort& effort) {
    std::vector<std::string> set = as_written;
    set.push_back(fmt::format("xy_bits={}", effort.xy_bits()));
    set.insert(set.end(), c.set.begin(), c.set.end());
    return set;
}

void judge(const FrameCase& c, const LoadedScene& scene, Finding& f) {
    RenderJob job(scene.view(), scene.settings);
    job.render();
    const shadow::LightCounts& light = job.counts().lights[0];
    const raster::DrawCounts& seen_by_eye = job.counts().observer;
    f.splits = static_cast<std::int64_t>(light.map.splits + seen_by_eye.splits);
    f.blocks = static_cast<std::int64_t>(light.map.blocks + seen_by_eye.blocks);
    f.unresolved = static_cast<std::int64_t>(light.map.unresolved + seen_by_eye.unresolved);
    f.cycles = static_cast<std::int64_t>(job.ledger().total(true));
    const TransformError t = transform_error(
        raster::observer_to_light(scene.observer, scene.light(), scene.settings.machine,
                                  job.matrices().lights[0].bias_quanta_q16),
        scene.settings.machine);
    f.error = t.worst;
    f.bound = t.bound;
    f.unit = "output LSB";
    if (c.far_over_near != 0) f.far_over_near = c.far_over_near;
    // What near and far cut is not lost: a case may set them so.
    // Free patches are not measured, because what is found must not depend on whether the program
    // is built with Embree.
    if (const auto truth =
            scene.has_closed_form() ? trace_within_depths(scene) : std::nullopt) {
        measure_depths(job, *truth, c.far_over_near != 0, f);
        measure_shadow(job, *truth, f);
    }
    const bool words = t.sound && t.over_bound <= 1, ends = *f.splits <= c.max_splits;
    const bool sane = sane_mask(job);
    // Blocks beyond the last level of subdivision are dropped and counted: then pixels may be
    // missing, and the status says so.
    if (*f.unresolved > 0) f.status = "unresolved";
    const bool whole = f.lost.value_or(0) == 0 || *f.unresolved > 0;
    const bool named = f.status != "unresolved" || c.status == f.status;
    f.holds = words && ends && sane && whole && named;
    const auto seen = job.visible();
    f.observed = fmt::format(
        "{} pixels drawn, {} in shadow, {} splits, {} blocks, {} dropped; transform {:.3g} of its "
        "bound at {} points, {} refused{}{}{}{}",
        std::count(seen.begin(), seen.end(), 1), light.post_process.shadowed, *f.splits, *f.blocks,
        *f.unresolved, t.over_bound, t.points, t.refused, words ? "" : "; BEYOND THE BOUND",
        ends ? "" : "; TOO MANY SPLITS", sane ? "" : "; A MASK THAT IS NO MASK",
        whole ? "" : fmt::format("; {} PIXELS LOST", *f.lost));
}

}  // namespace

std::string frame_status(const std::string& text, const std::vector<std::string>& set) {
    try {
        std::vector<std::string> all = as_written;
        all.insert(all.end(), set.begin(), set.end());
        const LoadedScene scene = parse_scene(text, "case", all);
        shadow::FrameMatrices matrices;
        return name_of(shadow::load_matrices(scene.view(), scene.settings, matrices));
    } catch (const SceneError& refusal) {
        return std::string("refused: ") + refusal.what();
    }
}

LoadedScene scene_of(const FrameCase& c, const Effort& effort) {
    return parse_scene(c.scene, "case", overrides(c, effort));
}

Picture picture_of(const FrameCase& c, const Effort& effort) {
    const LoadedScene scene = scene_of(c, effort);
    RenderJob job(scene.view(), scene.settings);
    job.render();
    const auto gray = job.bytes(Plane::picture);
    return {scene.settings.machine.size_px(), {gray.begin(), gray.end()}};
}

namespace {

Finding refused(const FrameCase& c, std::string status) {
    Finding f;
    f.status = std::move(status);
    f.holds = c.status != "ok" && f.status.starts_with(c.status);
    f.observed = "refused by name, nothing drawn";
    return f;
}

}  // namespace

Finding examine(const FrameCase& c, const LoadedScene& scene) {
    shadow::FrameMatrices matrices;
    const auto status = shadow::load_matrices(scene.view(), scene.settings, matrices);
    if (status != shadow::FrameStatus::ok) return refused(c, name_of(status));
    Finding f;
    f.status = "ok";
    judge(c, scene, f);
    return f;
}

Finding examine(const FrameCase& c, const Effort& effort) {
    try {
        return examine(c, scene_of(c, effort));
    } catch (const SceneError& refusal) {
        return refused(c, std::string("refused: ") + refusal.what());
    }
}

}  // namespace umbra78::tools::study
