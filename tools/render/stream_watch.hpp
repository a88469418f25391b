// A stream as it is drawn, watched: how far it has come, and what the views lose of it.
//
// The drawing is the only pass in which the views are known and all primitives are seen, so the
// warnings that a held scene has beforehand are made here, batch by batch, in the same words.
#pragma once

#include "tools/scene/checks.hpp"
#include "tools/scene/scene.hpp"
#include "tools/stream/held_first.hpp"

#include <chrono>
#include <cstdint>

namespace umbra78::tools {

class StreamWatch final : public raster::PrimitiveSource {
public:
    // Its surfaces and its stream; the scene outlives it. Progress is printed on a terminal.
    explicit StreamWatch(const LoadedScene&);

    bool rewind() override;
    Next next(raster::Surfaces& batch) override;

    const StreamSeen& seen() const { return seen_; }
    std::uint64_t patches() const { return patches_; }
    std::uint64_t triangles() const { return seen_.primitives - patches_; }
    // At most 8192 points, evenly spaced in the order in which they came.
    const std::vector<raster::World>& sample() const { return sample_; }

private:
    void note(const raster::Surfaces& batch);
    void note(const raster::World& point);
    void show_progress(bool at_end);

    const LoadedScene& scene_;
    HeldFirst source_;
    StreamSeen seen_;
    std::uint64_t patches_ = 0, points_ = 0, step_ = 1;
    std::vector<raster::World> sample_;
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point next_shown_;
};

}  // namespace umbra78::tools
