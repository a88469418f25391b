#include "tools/render/stream_watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace umbra78::tools {
namespace {

constexpr std::size_t max_sample = 8192;
constexpr std::chrono::milliseconds progress_interval{500};

}  // namespace

StreamWatch::StreamWatch(const LoadedScene& scene)
    : scene_(scene),
      source_(scene.surfaces(), *scene.stream),
      terminal_(::isatty(STDERR_FILENO) == 1),
      next_shown_(std::chrono::steady_clock::now() + progress_interval) {}

bool StreamWatch::rewind() {
    seen_ = {};
    patches_ = points_ = 0;
    step_ = 1;
    sample_.clear();
    return source_.rewind();
}

StreamWatch::Next StreamWatch::next(raster::Surfaces& batch) {
    const Next next = source_.next(batch);
    if (next == Next::batch) note(batch);
    show_progress(next != Next::batch);
    return next;
}

void StreamWatch::note(const raster::Surfaces& batch) {
    seen_.primitives += batch.count();
    patches_ += batch.patches.size();
    const auto note_view = [&](const raster::View& view, StreamSeen::View& seen) {
        seen.outside += count_outside(view, batch);
        seen.cut += cut_depths(view, batch);
    };
    note_view(scene_.observer, seen_.observer);
    seen_.lights.resize(scene_.lights.size());
    for (std::size_t l = 0; l < seen_.lights.size(); ++l)
        for (const raster::View& view : scene_.lights[l].sectored
                                            ? scene_.lights[l].views()
                                            : std::span(&scene_.lights[l].view, 1))
            note_view(view, seen_.lights[l]);
    batch.for_points([&](const raster::World& p) { note(p); });
}

// Every step-th point; where there are too many, every other one of them is dropped.
void StreamWatch::note(const raster::World& point) {
    if (points_++ % step_ != 0) return;
    sample_.push_back(point);
    if (sample_.size() < max_sample) return;
    for (std::size_t k = 0; 2 * k < sample_.size(); ++k) sample_[k] = sample_[2 * k];
    sample_.resize(sample_.size() / 2);
    step_ *= 2;
}

void StreamWatch::show_progress(bool at_end) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (at_end && shown_) std::fputs("\r\033[K", stderr);
    if (at_end || now < next_shown_) return;
    next_shown_ = now + progress_interval;
    shown_ = true;
    const std::uint64_t all = scene_.stream->count();
    const std::string of = all == unknown_count ? std::string() : fmt::format(" of {}", all);
    fmt::print(stderr, "\rumbra78: {}{} primitives drawn \033[K", seen_.primitives, of);
    std::fflush(stderr);
}

}  // namespace umbra78::tools
