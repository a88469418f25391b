// Draws frames of successive cases, and draws again only the views in which they differ.
//
// Each frame is the one that RenderJob::render() would draw: a view is kept only where
// shadow::find_reuse() says that it is the same, and its times are those of when it was drawn.
// Times are the thread's own time on a processor, so other programs and threads do not count.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/scene/scene_file.hpp"

#include <optional>
#include <string>

namespace umbra78::tools::study {

// Of several runs of the same stage: the median, and the maximum minus the minimum.
struct Timed {
    double median_ms = 0, spread_ms = 0;
};

class SharedDraw {
public:
    // Draws the frame, each stage `runs` times. `text` is what the scene was read from. The job is
    // valid until the next draw. Throws SceneError.
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
