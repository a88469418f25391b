// What the study of rivals measures of a frame.
#include "shadow/frame/methods.hpp"
#include "shadow/rivals/dicing.hpp"
#include "tools/render/report.hpp"
#include "tools/study/rivals/rivals.hpp"
#include "tools/truth/scene_truth.hpp"

#include <cmath>

namespace umbra78::tools::study {
namespace {

using shadow::Form;

// Where a surface turns from the light: |cosine| below this, 11.5 degrees, which facets get wrong.
constexpr double terminator_cosine = 0.2;

// Facets that a rival has, before those without three vertices are left out.
std::int64_t facets_of(const LoadedScene& scene) {
    return static_cast<std::int64_t>(
        shadow::rivals::diced_size(scene.surfaces(), scene.settings.dice_levels).facets);
}

BruteMasks::Masks draw_by_brute_force(const LoadedScene& scene) {
    shadow::Settings settings = scene.settings;
    settings.form = Form::brute;
    RenderJob brute(scene.view(), settings);
    draw_mask(brute);
    BruteMasks::Masks masks;
    for (std::size_t l = 0; l < brute.inputs().scene.light_count; ++l) {
        const auto mask = brute.bytes({Plane::mask, l});
        masks.emplace_back(mask.begin(), mask.end());
    }
    return masks;
}

// Pixels that differ from brute force on the same polygons, over all lights.
std::int64_t wrong_on_polygons(const BruteMasks::Masks& right, const RenderJob& job) {
    std::int64_t wrong = 0;
    for (std::size_t l = 0; l < right.size(); ++l) {
        const auto mask = job.bytes({Plane::mask, l});
        for (std::size_t at = 0; at < mask.size(); ++at) wrong += mask[at] != right[l][at] ? 1 : 0;
    }
    return wrong;
}

void set_wrong(Row& row, const SceneTruth& truth, const MachineMask& mask) {
    std::int64_t terminator = 0, cast = 0, compared = 0;
    const Truth& t = truth.truth;
    for (std::size_t at = 0; at < t.visible.size(); ++at) {
        if (!t.visible[at] || !mask.drawn(at) || truth.unlit_side[at]) continue;
        ++compared;
        if (mask.in_shadow(at) != (t.lit[at] != 0)) continue;
        ++(std::abs(t.n_dot_l[at]) < terminator_cosine ? terminator : cast);
    }
    row.set("compared_px", compared);
    row.set("wrong_cast_px", cast);
    row.set("wrong_terminator_px", terminator);
}

// Of the darkness as the filters leave it, which are set to no passes: a ramp is in it.
void set_errors(Row& row, RenderJob& job, const Traced& traced) {
    job.filter_and_composite();
    const std::vector<std::uint8_t> visible = job.visible();
    const MachineMask mask{job.bytes(Plane::filtered), visible};
    set_wrong(row, traced.truth, mask);
    const ShadowReport errors = tools::report(traced.truth, mask, traced.band);
    row.set("false_shadow", errors.all.false_shadow_rate());
    row.set("false_light", errors.all.false_light_rate());
    row.set("mask_error", errors.graded.mean_absolute());
    row.set("edge_mean_px", errors.edge.mean);
}

// Over all lights; the observer's view is drawn once.
void set_cycles(Row& row, const RenderJob& job) {
    std::uint64_t once = 0, map = 0, test = 0, entries = 0;
    const std::vector<shadow::FrameLedger> ledgers = job.ledgers();
    for (std::size_t l = 0; l < ledgers.size(); ++l) {
        once += ledgers[l].scene.units.side_by_side();
        map += shadow::FrameLedger::cycles(ledgers[l].light, true);
        test += ledgers[l].transformation(true);
        entries += job.counts().lights[l].method_entries;
    }
    const auto set = [&](const char* column, std::uint64_t n) {
        row.set(column, static_cast<std::int64_t>(n));
    };
    set("once_cycles", once);
    set("map_cycles", map);
    set("test_cycles", test);
    set("shadow_cycles", map + test);
    set("observer_cycles", shadow::FrameLedger::cycles(ledgers.front().observer, true));
    set("entries", entries);
}

}  // namespace

const BruteMasks::Masks& BruteMasks::of(const Case& c, const LoadedScene& scene) const {
    std::string key = own_scene(c);
    for (const std::string& each : c.set)
        if (!each.starts_with("form=")) key += each + "\n";
    Slot* slot = nullptr;
    {
        const std::lock_guard lock(mutex_);
        slot = &slots_[key];
    }
    std::call_once(slot->once, [&] { slot->masks = draw_by_brute_force(scene); });
    return slot->masks;
}

Row frame_row(const Case& c, const LoadedScene& scene, const Traced* truth,
              const BruteMasks& brute) {
    RenderJob job(scene.view(), scene.settings);
    draw_mask(job);
    Row row;
    row.set("facets", facets_of(scene));
    row.set("mask_hash", hash_of(job.buffer(Plane::mask)));
    if (shadow::is_rival(scene.settings.form))
        row.set("wrong_on_polygons_px", wrong_on_polygons(brute.of(c, scene), job));
    if (truth != nullptr) set_errors(row, job, *truth);
    set_cycles(row, job);
    row.set("frame_bytes", static_cast<std::int64_t>(job.frame_bytes()));
    const StageTimes& t = job.times();
    row.set("shadow_host_ms", t.light_ms + t.post_process_ms);
    return row;
}

}  // namespace umbra78::tools::study
