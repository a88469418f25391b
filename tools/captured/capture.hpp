// The shadow test on depth buffers that another program has drawn.
//
// The buffers become the machine's words (codes.hpp), the matrix becomes coefficient words with the
// bias in row Z (conventions.hpp), and the post-process runs as on a frame of its own. What it
// needs more than depths and a matrix, it does not do: no units of bias but quanta, no receiver
// that follows a light's measures, no filters.
#pragma once

#include "shadow/frame/settings.hpp"
#include "shadow/post_process.hpp"
#include "tools/captured/codes.hpp"
#include "tools/io/buffers.hpp"

#include <optional>
#include <string>
#include <vector>

namespace umbra78::tools::captured {

struct Capture {
    NumberImage observer, light;
    Matrix16 matrix{};
    std::string matrix_name = "--matrix";
    Convention convention;
    DepthFormat format;
    std::vector<std::string> set;  // "key=value", of the settings that the shadow test reads
};

// What became of the observer's pixels.
struct Outcomes {
    std::size_t background = 0;   // nothing was drawn there
    std::size_t no_quotient = 0;  // w is not positive, or a quotient does not fit
    std::size_t outside = 0;      // of the light's buffer
    std::size_t compared = 0;
    std::size_t shadowed = 0;
};

class CapturedFrame {
public:
    // Throws SceneError.
    explicit CapturedFrame(const Capture&);

    // The mask with this bias, or with that of the settings.
    std::vector<std::uint8_t> mask(std::int64_t bias_q16) const;
    std::vector<std::uint8_t> mask() const { return mask(settings_.bias_q16); }
    // With a receiver of its own, whose depth is that of its plane where the map is sampled.
    std::vector<std::uint8_t> mask_of_planes(std::int64_t bias_q16) const;
    Outcomes outcomes(std::span<const std::uint8_t> mask) const;

    const shadow::Settings& settings() const { return settings_; }
    const hw::MachineSpec& spec() const { return settings_.machine; }
    Sides observer_sides() const { return observer_sides_; }
    Sides light_sides() const { return light_sides_; }
    const Codes& observer() const { return observer_; }
    const Codes& light() const { return light_; }
    std::vector<std::uint8_t> visible() const;  // 1 where something was drawn
    hw::MatrixWords words(std::int64_t bias_q16) const;
    // A pixel's results, without noise.
    hw::Point point(int x, int y) const;
    // A plane of the frame, for its hash and its files.
    Buffer buffer(const std::string& name, const Codes&) const;
    Buffer buffer(const std::string& name, std::span<const std::uint8_t> bytes) const;

private:
    std::vector<std::uint8_t> mask(const shadow::Settings&, std::int64_t bias_q16) const;

    const Capture& capture_;
    shadow::Settings settings_;
    Sides observer_sides_, light_sides_;
    Codes observer_, light_;
};

// Of the pixels that lie in the buffer, row by row.
template <class Value>
std::vector<Value> cut(std::span<const Value> frame, Sides sides, int frame_px) {
    std::vector<Value> out;
    out.reserve(static_cast<std::size_t>(sides.width) * static_cast<std::size_t>(sides.height));
    for (int y = 0; y < sides.height; ++y) {
        const auto row = frame.subspan(static_cast<std::size_t>(y) *
                                           static_cast<std::size_t>(frame_px),
                                       static_cast<std::size_t>(sides.width));
        out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

}  // namespace umbra78::tools::captured
