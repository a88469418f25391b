// The pictures that the page shows, in four bytes a pixel.
#include "tools/render/error_map.hpp"
#include "tools/study/moire/frame.hpp"
#include "tools/web/answers.hpp"

namespace umbra78::tools::web {
namespace {

constexpr int spectrum_side_px = 64;

Picture from_gray(int size, std::span<const std::uint8_t> gray) {
    Picture made{size, std::vector<std::uint8_t>(4 * gray.size(), 255)};
    for (std::size_t at = 0; at < gray.size(); ++at)
        for (std::size_t c = 0; c < 3; ++c) made.rgba[4 * at + c] = gray[at];
    return made;
}

Picture from_rgb(int size, std::span<const std::uint8_t> rgb) {
    Picture made{size, std::vector<std::uint8_t>(rgb.size() / 3 * 4, 255)};
    for (std::size_t at = 0; at < rgb.size() / 3; ++at)
        for (std::size_t c = 0; c < 3; ++c) made.rgba[4 * at + c] = rgb[3 * at + c];
    return made;
}

// The observer's view in colour.
Picture from_channels(int size, const RenderJob& job) {
    Picture made{size, std::vector<std::uint8_t>(4 * std::size_t(size) * size, 255)};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::span<const std::uint8_t> channel = job.bytes({Plane::intensity, 0, c});
        for (std::size_t at = 0; at < channel.size(); ++at) made.rgba[4 * at + c] = channel[at];
    }
    return made;
}

Picture from_plane(const Buffer& buffer) {
    if (const auto* bytes = std::get_if<std::span<const std::uint8_t>>(&buffer.values))
        return from_gray(buffer.size_px, *bytes);
    return from_gray(buffer.size_px, depth_as_gray(buffer));
}

}  // namespace

Picture picture_of(Session& session, const std::string& name) {
    const RenderJob& job = session.job();
    const int size = job.settings().machine.size_px();
    if (name == "picture" && job.coloured()) return from_rgb(size, job.rgb());
    if (name == "intensity" && job.coloured()) return from_channels(size, job);
    if (name == "error" || name == "spectrum") {
        const SceneTruth* truth = session.truth();
        if (truth == nullptr) return {};
        if (name == "error") return from_rgb(size, error_map(*truth, job));
        const std::vector<double> power = periodogram(
            study::busiest_window(*truth, session.mask(), spectrum_side_px), spectrum_side_px);
        return from_gray(spectrum_side_px, study::spectrum_picture(power, spectrum_side_px));
    }
    for (const PlaneOf& plane : job.planes()) {
        const Buffer buffer = job.buffer(plane);
        if (buffer.name == name) return from_plane(buffer);
    }
    return {};
}

}  // namespace umbra78::tools::web
