#include "tools/study/error_time/shared_draw.hpp"

#include "shadow/frame/reuse.hpp"
#include "tools/study/truth_cache.hpp"

#include <fmt/format.h>

#include <time.h>

#include <algorithm>
#include <vector>

namespace umbra78::tools::study {
namespace {

double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

template <class Stage>
Timed timed(int runs, Stage stage) {
    std::vector<double> ms;
    for (int k = 0; k < runs; ++k) {
        const double start_ms = thread_ms();
        stage();
        ms.push_back(thread_ms() - start_ms);
    }
    std::sort(ms.begin(), ms.end());
    return {ms[ms.size() / 2], ms.back() - ms.front()};
}

// What a scene must share with a job to be drawn by it: everything except settings, and the job's
// planes with their widths.
std::string key_of(const std::string& text, const LoadedScene& scene) {
    return fmt::format("{} {} {} {}{}", scene.settings.machine.z_bits,
                       shadow::map_layers(scene.settings), shadow::reads_normals(scene.settings),
                       truth_key(scene), text);
}

}  // namespace

RenderJob& SharedDraw::draw(const std::string& text, const LoadedScene& scene, int runs) {
    const std::string key = key_of(text, scene);
    const bool goes_on = job_ && key == key_;
    key_.clear();  // until all is drawn
    shadow::Reuse kept{};
    if (!goes_on) {
        job_.reset();
        scene_ = scene;
        job_.emplace(scene_->view(), scene.settings);
    } else {
        const shadow::FrameInputs before = job_->inputs();
        job_->use(scene.settings);
        kept = shadow::find_reuse(before, job_->inputs());
    }
    const auto stage = [&](auto run) { return timed(runs, [&] { ((*job_).*run)(); }); };
    if (!kept.light_map[0]) light = stage(&RenderJob::draw_light);
    const bool copies = job_->plan().leaves_out(shadow::Omission::light_drawing);
    if (!kept.observer || (copies && !kept.light_map[0]))
        observer = stage(&RenderJob::draw_observer);
    post_process = stage(&RenderJob::cast_shadows);
    filters = stage(&RenderJob::filter_and_composite);
    key_ = key;
    return *job_;
}

}  // namespace umbra78::tools::study
