#include "tools/render/error_map.hpp"

#include "tools/truth/image_walk.hpp"

#include <array>

namespace umbra78::tools {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour false_shadow_colour{235, 50, 40}, false_light_colour{70, 120, 255},
    other_surface{255, 220, 0}, exact_edge{70, 210, 90};

bool on_edge(const Truth& truth, std::size_t at) {
    if (!truth.visible[at] || truth.lit[at]) return false;
    bool edge = false;
    for_disc(truth.size, at, 1, [&](std::size_t other) {
        edge |= truth.visible[other] && truth.lit[other];
    });
    return edge;
}

}  // namespace

std::vector<std::uint8_t> error_map(const SceneTruth& truth, const RenderJob& job) {
    const std::vector<std::uint8_t> visible = job.visible();
    const MachineMask mask{job.bytes(Plane::filtered), visible};
    // A truth that does not know how deep its surfaces lie cannot say which they are.
    const std::vector<Covered> covered =
        truth.truth.depth.empty()
            ? std::vector<Covered>(visible.size(), Covered::right)
            : coverage_image(truth.truth, job.buffer(Plane::observer_z), truth.observer);
    const std::vector<double> error = error_image(truth.truth, mask, truth.unlit_side);
    const std::span<const std::uint8_t> picture = job.bytes(Plane::picture);
    std::vector<std::uint8_t> map;
    map.reserve(3 * picture.size());
    for (std::size_t at = 0; at < picture.size(); ++at) {
        const auto gray = static_cast<std::uint8_t>(picture[at] * 5 / 8);
        const Colour colour = covered[at] != Covered::right ? other_surface
                              : error[at] > 0               ? false_shadow_colour
                              : error[at] < 0               ? false_light_colour
                              : on_edge(truth.truth, at)    ? exact_edge
                                                            : Colour{gray, gray, gray};
        map.insert(map.end(), colour.begin(), colour.end());
    }
    return map;
}

}  // namespace umbra78::tools
