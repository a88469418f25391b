#include "tools/watched_frame.hpp"

#include "tools/scene_error.hpp"

namespace umbra78::tools {
namespace {

std::vector<hw::Depth32> copy_of(const Buffer& plane) {
    std::vector<hw::Depth32> codes(plane.pixels());
    for (std::size_t k = 0; k < codes.size(); ++k) codes[k] = plane.at(k);
    return codes;
}

}  // namespace

WatchedFrame::WatchedFrame(const RenderJob& job)
    : settings_(job.settings()), matrix_(job.matrices().observer_to_light),
      observer_depth_(copy_of(job.buffer(Plane::observer_z))),
      light_depth_(copy_of(job.buffer(Plane::light_z))),
      intensity_(job.bytes(Plane::intensity).begin(), job.bytes(Plane::intensity).end()),
      mask_(observer_depth_.size()),
      observer_{settings_.machine.xy_bits, observer_depth_, intensity_},
      light_{settings_.machine.xy_bits, light_depth_, {}} {
    if (settings_.form == shadow::Form::correct)
        throw SceneError("the correct form has no post-process to watch; give --set "
                         "form=post_process");
}

std::unique_ptr<WatchedFrame::Machine> WatchedFrame::machine() {
    return std::make_unique<Machine>(observer_, light_, matrix_, settings_, mask_);
}

}  // namespace umbra78::tools
