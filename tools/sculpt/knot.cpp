// A trefoil knot: one tube, which passes three times over and three times under itself.
//
//   x = sin t + 2 sin 2t    y = 2 cos 2t - cos t    z = sin 3t    0 <= t <= 2 pi
//
// The curve is drawn through equal steps of t by cubics that have its places and directions there.
// It stands on two of its three loops at y = 0 and looks along z. To change it, change the numbers
// and print the file in tools/scenes/models again.
#include "tools/sculpt/model.hpp"

#include <cmath>
#include <numbers>

namespace umbra78::tools {
namespace {

constexpr int steps = 24;
constexpr double thickness = 0.62;  // the tube's radius; two strands are 2 apart where they cross
constexpr double foot = 2.06;       // from the middle of the knot down to the middle of its loops

Point place(double t) {
    return {std::sin(t) + 2 * std::sin(2 * t), 2 * std::cos(2 * t) - std::cos(t) + foot + thickness,
            std::sin(3 * t)};
}
Point speed(double t) {
    return {std::cos(t) + 4 * std::cos(2 * t), std::sin(t) - 4 * std::sin(2 * t),
            3 * std::cos(3 * t)};
}

Chain trefoil() {
    const double step = 2 * std::numbers::pi / steps;
    Chain chain{place(0)};
    for (int k = 0; k < steps; ++k) {
        const double a = k * step, b = (k + 1) % steps * step;  // it ends exactly where it began
        chain.insert(chain.end(), {place(a) + step / 3 * speed(a), place(b) - step / 3 * speed(b),
                                   place(b)});
    }
    return chain;
}

}  // namespace

std::vector<Part> knot_parts() {
    return {{"tube", "tube", tube(trefoil(), std::vector<double>(steps + 1, thickness))}};
}

}  // namespace umbra78::tools
