// How far the mask of captured buffers is from truth, what the error looks like, and how much bias
// takes it away.
//
// Truth is a mask that is given, or else an estimate: what is still in shadow when each pixel is
// compared at its own plane (receiver = plane, nearest lookup, 12 fraction bits, a bias of 2^-15 of
// the depth range). A pixel whose shadow its own plane explains is thus taken for lit: false
// shadow. It errs at edges of objects and where surfaces curve.
#pragma once

#include "tools/captured/capture.hpp"
#include "tools/study/moire/frame.hpp"
#include "tools/truth/metrics.hpp"

#include <optional>

namespace umbra78::tools::captured {

// In quanta: 2 of 16 bits.
inline int estimate_bias(const hw::MachineSpec& m) {
    return m.z_bits > 15 ? 2 << (m.z_bits - 16) : 1;
}
inline constexpr double tolerated_false_shadow = 0.001;
inline constexpr int edge_px = 2;

// The square of wholly lit pixels that has the most errors, and their spectrum there.
struct Window {
    int left = 0, top = 0, side = 0;
    std::vector<double> power;  // side x side bins
    Peak peak;
    FisherTest fisher;
    // What the two grids' beat would be if the window showed one plane; none where a corner has no
    // place in the light's view.
    std::optional<study::GridBeat> beat;
};

struct Judged {
    bool estimated = false;
    ShadowError error;
    int isolated_pixels = 0;
    std::vector<double> error_image;  // of the frame: 1 false shadow, -1 false light
    LocalFlatness flatness;           // of the false shadow of lit pixels
    std::optional<Window> window;     // none: no square of lit pixels has an error
};

// `truth` is the frame's darkness; empty: estimated.
Judged judge(const CapturedFrame&, std::span<const std::uint8_t> mask,
             std::span<const std::uint8_t> truth);

// The least whole number of quanta with less than the tolerated share of false shadow, leaving out
// what lies within edge_px of a shadow or of the background, and the error of the whole mask with
// it; nothing if an eighth of the depth range is not enough.
struct LeastBias {
    int quanta;
    ShadowError error;
};
std::optional<LeastBias> least_bias(const CapturedFrame&, std::span<const std::uint8_t> truth);

}  // namespace umbra78::tools::captured
