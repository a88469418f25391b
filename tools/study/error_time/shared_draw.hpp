// A frame whose views are drawn once for all cases in a row that share them.
//
// Each case's frame is the one that RenderJob::render() would give: a view is kept only where
// shadow::find_reuse() says so, and its times are those of when it was drawn.
// Times are the thread's own on a processor: what else runs on the computer does not count.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"

#include <optional>
#include <string>

namespace umbra78::tools::study {

// Of several runs of the same stage: their median, and greatest less least.
struct Timed {
    double median_ms = 0, spread_ms = 0;
};

class SharedDraw {
public:
    // Draws the frame, each stage `runs` times. `text` is the one that the scene was read from.
    // Throws SceneError.
    RenderJob& draw(const std::string& text, const LoadedScene&, int runs);

    Timed light, observer, post_process, filters;
    double total_ms() const {
        return light.median_ms + observer.median_ms + post_process.median_ms + filters.median_ms;
    }
    double spread_ms() const {
        return light.spread_ms + observer.spread_ms + post_process.spread_ms + filters.spread_ms;
    }

private:
    std::string key_;
    std::optional<LoadedScene> scene_;  // the job's spans are its
    std::optional<RenderJob> job_;
};

}  // namespace umbra78::tools::study
