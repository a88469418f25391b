// The pictures that the page shows, in four bytes a pixel.
#include "tools/render/error_map.hpp"
#include "tools/study/moire/frame.hpp"
#include "tools/web/answers.hpp"

#include <algorithm>
#include <array>

namespace umbra78::tools::web {
namespace {

constexpr int spectrum_side_px = 64;

using Bytes = std::span<const std::uint8_t>;

// A plane `by` times smaller each way: means of by x by bytes.
std::vector<std::uint8_t> shrunk(Bytes plane, int size, int by) {
    const auto n = static_cast<std::size_t>(size), k = static_cast<std::size_t>(by);
    const std::size_t side = n / k;
    std::vector<std::uint8_t> made(side * side);
    std::vector<std::uint16_t> sums(n);
    for (std::size_t y = 0; y < side; ++y) {
        std::fill(sums.begin(), sums.end(), std::uint16_t{0});
        for (std::size_t row = y * k; row < (y + 1) * k; ++row)
            for (std::size_t x = 0; x < n; ++x)
                sums[x] = static_cast<std::uint16_t>(sums[x] + plane[row * n + x]);
        for (std::size_t x = 0; x < side; ++x) {
            std::uint32_t sum = 0;
            for (std::size_t i = x * k; i < (x + 1) * k; ++i) sum += sums[i];
            made[y * side + x] = static_cast<std::uint8_t>(sum / (k * k));
        }
    }
    return made;
}

// Three planes, each its own or all the same.
Picture from_planes(int size, const std::array<Bytes, 3>& plane) {
    Picture made{size, std::vector<std::uint8_t>(4 * plane[0].size())};
    const std::uint8_t *red = plane[0].data(), *green = plane[1].data(), *blue = plane[2].data();
    std::uint8_t* to = made.rgba.data();
    for (std::size_t at = 0; at < plane[0].size(); ++at) {
        to[4 * at] = red[at];
        to[4 * at + 1] = green[at];
        to[4 * at + 2] = blue[at];
        to[4 * at + 3] = 255;
    }
    return made;
}

Picture from_planes(int size, std::array<Bytes, 3> plane, int by) {
    if (by <= 1) return from_planes(size, plane);
    std::array<std::vector<std::uint8_t>, 3> small;
    for (std::size_t c = 0; c < 3; ++c) {
        const bool again = c > 0 && plane[c].data() == plane[0].data();
        if (!again) small[c] = shrunk(plane[c], size, by);
    }
    for (std::size_t c = 0; c < 3; ++c) plane[c] = small[c].empty() ? small[0] : small[c];
    return from_planes(size / by, plane);
}

Picture from_gray(int size, Bytes gray, int by) {
    return from_planes(size, {gray, gray, gray}, by);
}

// The observer's view, or the picture, in colour.
Picture from_channels(const RenderJob& job, Plane plane, int size, int by) {
    const auto channel = [&](std::size_t c) { return job.bytes({plane, 0, c}); };
    return from_planes(size, {channel(0), channel(1), channel(2)}, by);
}

Picture from_rgb(int size, Bytes rgb) {
    Picture made{size, std::vector<std::uint8_t>(rgb.size() / 3 * 4, 255)};
    for (std::size_t at = 0; at < rgb.size() / 3; ++at)
        for (std::size_t c = 0; c < 3; ++c) made.rgba[4 * at + c] = rgb[3 * at + c];
    return made;
}

Picture from_plane(const Buffer& buffer, int by) {
    if (const auto* bytes = std::get_if<Bytes>(&buffer.values))
        return from_gray(buffer.size_px, *bytes, by);
    return from_gray(buffer.size_px, depth_as_gray(buffer), by);
}

}  // namespace

Picture picture_of(Session& session, const std::string& name, int by) {
    const RenderJob& job = session.job();
    const int size = job.settings().machine.size_px();
    by = size % by == 0 ? by : 1;
    if (name == "picture" && job.coloured()) return from_channels(job, Plane::picture, size, by);
    if (name == "intensity" && job.coloured())
        return from_channels(job, Plane::intensity, size, by);
    if (name == "error" || name == "spectrum") {
        const SceneTruth* truth = session.truth();
        if (truth == nullptr) return {};
        if (name == "error") return from_rgb(size, error_map(*truth, job));
        const std::vector<double> power = periodogram(
            study::busiest_window(*truth, session.mask(), spectrum_side_px), spectrum_side_px);
        return from_gray(spectrum_side_px, study::spectrum_picture(power, spectrum_side_px), 1);
    }
    for (const PlaneOf& plane : job.planes()) {
        const Buffer buffer = job.buffer(plane);
        if (buffer.name == name) return from_plane(buffer, by);
    }
    return {};
}

}  // namespace umbra78::tools::web
