// The smile of figure 7, as a table of parts.
//
// The smile of the paper was sculpted by Alvy Ray Smith and is lost. This one is our own: lips and
// upper teeth, 5 wide, that stand alone as a cat's once did. It looks along z; the lips meet at
// the corners, and light passes between the teeth and the lower lip. To change it, change the
// tables and print the files in tools/scenes/models again.
#include "tools/sculpt/model.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace umbra78::tools {
namespace {

// The mouth lies on an upright cylinder of elliptic section, somewhat wider than the lips.
constexpr double arch_half_width = 3.0, arch_depth = 1.9;

struct OnArch {
    Point place, front;
    double degrees;
};
OnArch on_arch(double x, double y) {
    const double s = x / arch_half_width, c = std::sqrt(1 - s * s);
    const Point front = unit({s * arch_depth, 0, c * arch_half_width});
    return {{x, y, arch_depth * (c - 1)}, front,
            std::atan2(front.x, front.z) * 180 / std::numbers::pi};
}

// A section of a lip: where its middle is, how far it is from there to each of its sides.
struct LipSection {
    double x, y, up, down, front, back;
};

// From the middle to the left corner, which is at +x; the other half is its mirror.
const std::vector<LipSection> upper_lip{
    {0.00, 0.62, 0.21, 0.22, 0.38, 0.22}, {0.40, 0.66, 0.28, 0.22, 0.40, 0.22},
    {0.95, 0.72, 0.26, 0.20, 0.38, 0.21}, {1.50, 0.86, 0.22, 0.19, 0.34, 0.20},
    {2.00, 1.08, 0.18, 0.17, 0.28, 0.18}, {2.34, 1.30, 0.16, 0.14, 0.22, 0.16},
    {2.55, 1.48, 0.14, 0.12, 0.17, 0.14}, {2.66, 1.60, 0.09, 0.07, 0.10, 0.09},
    {2.70, 1.65, 0.00, 0.00, 0.00, 0.00},
};
const std::vector<LipSection> lower_lip{
    {0.00, -0.86, 0.29, 0.36, 0.50, 0.24}, {0.55, -0.81, 0.29, 0.36, 0.49, 0.24},
    {1.10, -0.57, 0.27, 0.33, 0.44, 0.22}, {1.60, -0.13, 0.23, 0.28, 0.37, 0.20},
    {2.05, 0.45, 0.18, 0.23, 0.30, 0.18},  {2.38, 1.04, 0.13, 0.17, 0.22, 0.15},
    {2.56, 1.42, 0.09, 0.11, 0.14, 0.11},  {2.62, 1.54, 0.00, 0.00, 0.00, 0.00},
};

Chain section_chain(const LipSection& s, double side) {
    const auto [place, front, degrees] = on_arch(side * s.x, s.y);
    const Point up{0, s.up, 0}, down{0, -s.down, 0};
    const std::array<Point, 4> out{up, s.front * front, down, -s.back * front};
    Chain chain{place + out[0]};
    for (std::size_t k = 0; k < 4; ++k) {
        const Point from = out[k], to = out[(k + 1) % 4];
        chain.insert(chain.end(), {place + from + round_handle * to,
                                   place + round_handle * from + to, place + to});
    }
    return chain;
}

Surface lip(const std::vector<LipSection>& half) {
    std::vector<Chain> sections;
    for (std::size_t k = half.size() - 1; k > 0; --k)
        sections.push_back(section_chain(half[k], -1));
    for (const LipSection& s : half) sections.push_back(section_chain(s, 1));
    return loft(sections);
}

// A pair of upper teeth: the middle of the left one, its ends above and below, half its width.
struct Tooth {
    const char* name;
    double x, top, edge, half_width;
};
const std::vector<Tooth> teeth{
    {"middle incisors", 0.275, 0.60, -0.27, 0.280}, {"side incisors", 0.770, 0.62, -0.20, 0.220},
    {"canines", 1.190, 0.68, -0.11, 0.215},         {"first premolars", 1.570, 0.74, 0.13, 0.190},
    {"second premolars", 1.890, 0.86, 0.43, 0.175}, {"molars", 2.130, 1.06, 0.66, 0.155},
};

Surface tooth(const Tooth& t) {
    const OnArch spot = on_arch(t.x, (t.top + t.edge) / 2);
    const Chain half = Pen(0, -1).bend(1, -1, 1, 0, 0.86).bend(1, 1, 0, 1, 0.7);
    return placed(lathe(half, rounded_square(0.8)),
                  {spot.place - 0.1 * spot.front, {0, spot.degrees, 0},
                   {t.half_width, (t.top - t.edge) / 2, 0.2}});
}

}  // namespace

std::vector<Part> smile_parts() {
    std::vector<Part> parts{{"lips", "upper lip", lip(upper_lip)},
                            {"lips", "lower lip", lip(lower_lip)}};
    for (const Tooth& t : teeth)
        parts.push_back({"teeth", t.name, joined({tooth(t), mirrored(tooth(t))})});
    return parts;
}

}  // namespace umbra78::tools
