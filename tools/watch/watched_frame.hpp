// A drawn frame for the instruments: a copy of its planes, and the clocked post-process that runs
// on them again.
//
// The copy has 32 bits a depth, whatever the frame has; the machine's bits and cycles do not depend
// on that.
#pragma once

#include "tools/render/render_job.hpp"

#include "shadow/clocked/post_process.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace umbra78::tools {

class WatchedFrame {
public:
    using Machine = shadow::ClockedPostProcess<hw::Depth32>;

    // Of a job that is rendered. Throws SceneError for the correct form, which has no
    // post-process.
    explicit WatchedFrame(const RenderJob&);
    // From any two depth planes, without intensity.
    WatchedFrame(const shadow::Settings&, const hw::MatrixWords& observer_to_light,
                 std::vector<hw::Depth32> observer, std::vector<hw::Depth32> light);
    WatchedFrame(const WatchedFrame&) = delete;
    WatchedFrame& operator=(const WatchedFrame&) = delete;

    // A new machine before its first cycle. It writes mask(), so use one at a time.
    std::unique_ptr<Machine> machine();

    const shadow::Settings& settings() const { return settings_; }
    const hw::MatrixWords& matrix() const { return matrix_; }
    const hw::FrameStore<hw::Depth32>& observer() const { return observer_; }
    const hw::FrameStore<hw::Depth32>& light() const { return light_; }
    const std::vector<std::uint8_t>& mask() const { return mask_; }

private:
    shadow::Settings settings_;
    hw::MatrixWords matrix_;
    std::vector<hw::Depth32> observer_depth_, light_depth_;
    std::vector<std::uint8_t> intensity_, direct_, mask_;
    hw::FrameStore<hw::Depth32> observer_, light_;
};

}  // namespace umbra78::tools
