#include "tools/watch/watched_frame.hpp"

#include "tools/scene/scene_error.hpp"

#include <algorithm>
#include <utility>

namespace umbra78::tools {
namespace {

// A method without a trace may have no map, and then no memory for one.
void check_is_traced(const RenderJob& job) {
    const shadow::Method& method = shadow::method_of(job.inputs());
    if (method.trace != shadow::Trace::clocked_post_process)
        throw SceneError(std::string(method.no_trace));
    if (job.settings().receiver != shadow::Receiver::point)
        throw SceneError("the clocked machine has no stage for the receiver's plane or normal; "
                         "give --set receiver=point");
}

std::vector<hw::Depth32> copy_of(const RenderJob& job, Plane name) {
    check_is_traced(job);
    const Buffer plane = job.buffer(name);
    std::vector<hw::Depth32> codes(plane.pixels());
    for (std::size_t k = 0; k < codes.size(); ++k) codes[k] = plane.at(k);
    return codes;
}

}  // namespace

WatchedFrame::WatchedFrame(const shadow::Settings& settings,
                           const hw::MatrixWords& observer_to_light,
                           std::vector<hw::Depth32> observer, std::vector<hw::Depth32> light)
    : settings_(settings), matrix_(observer_to_light), observer_depth_(std::move(observer)),
      light_depth_(std::move(light)), intensity_(observer_depth_.size()),
      direct_(observer_depth_.size()), mask_(observer_depth_.size()),
      observer_{settings_.machine.xy_bits, observer_depth_, intensity_, direct_},
      light_{settings_.machine.xy_bits, light_depth_, {}} {}

WatchedFrame::WatchedFrame(const RenderJob& job)
    : WatchedFrame(job.settings(), job.matrices().lights[0].observer_to_light,
                   copy_of(job, Plane::observer_z), copy_of(job, Plane::light_z)) {
    const std::span<const std::uint8_t> drawn = job.bytes(Plane::intensity);
    std::copy(drawn.begin(), drawn.end(), intensity_.begin());
    const std::span<const std::uint8_t> direct = job.bytes(Plane::direct);
    std::copy(direct.begin(), direct.end(), direct_.begin());
}

std::unique_ptr<WatchedFrame::Machine> WatchedFrame::machine() {
    return std::make_unique<Machine>(
        shadow::DepthMaps<hw::Depth32>{.observer = observer_, .light = light_}, matrix_, settings_,
        mask_);
}

}  // namespace umbra78::tools
