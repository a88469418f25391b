#include "tools/study/shared_draw.hpp"

#include "shadow/standing.hpp"
#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace umbra78::tools::study {
namespace {

template <class Stage>
Timed timed(int runs, Stage stage) {
    std::vector<double> ms;
    for (int k = 0; k < runs; ++k) ms.push_back(stage());
    std::sort(ms.begin(), ms.end());
    return {ms[ms.size() / 2], ms.back() - ms.front()};
}

// What a job must have in common with a scene to go on with it: all but settings, and the widths
// of its planes.
std::string key_of(const std::string& text, const LoadedScene& scene) {
    return fmt::format("{} {}{}", scene.settings.machine.z_bits, truth_key(scene), text);
}

}  // namespace

RenderJob& SharedDraw::draw(const std::string& text, const LoadedScene& scene, int runs) {
    const std::string key = key_of(text, scene);
    const bool goes_on = job_ && key == key_;
    key_.clear();  // until all is drawn
    shadow::Standing kept{};
    if (!goes_on) {
        job_.reset();
        scene_ = scene;
        job_.emplace(scene_->view(), scene.settings);
    } else {
        const shadow::FrameInputs before = job_->inputs();
        job_->use(scene.settings);
        kept = shadow::what_stands_still(before, job_->inputs());
    }
    const auto stage = [&](auto run, double StageTimes::*ms) {
        return timed(runs, [&] { return ((*job_).*run)(), job_->times().*ms; });
    };
    if (!kept.light_map) light = stage(&RenderJob::draw_light, &StageTimes::light_ms);
    if (!kept.observer) observer = stage(&RenderJob::draw_observer, &StageTimes::observer_ms);
    post_process = stage(&RenderJob::cast_shadows, &StageTimes::post_process_ms);
    filters = stage(&RenderJob::filter_and_composite, &StageTimes::filters_ms);
    key_ = key;
    return *job_;
}

}  // namespace umbra78::tools::study
