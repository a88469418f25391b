#include "tools/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace umbra78::tools {
namespace {

constexpr double pi = std::numbers::pi;

void expect_image(std::size_t length, int size, const char* name) {
    if (length != static_cast<std::size_t>(size) * size)
        throw std::invalid_argument(std::string(name) + " is not size * size values long");
}

// Calls visit(at) for each pixel that both see and `leave_out` keeps.
template <class Visit>
void for_compared(const Truth& truth, const MachineMask& mask,
                  std::span<const std::uint8_t> leave_out, Visit visit) {
    expect_image(mask.shadow.size(), truth.size, "the mask");
    if (!mask.visible.empty()) expect_image(mask.visible.size(), truth.size, "mask.visible");
    if (!leave_out.empty()) expect_image(leave_out.size(), truth.size, "leave_out");
    for (std::size_t at = 0; at < truth.visible.size(); ++at)
        if (truth.visible[at] && mask.drawn(at) && (leave_out.empty() || !leave_out[at]))
            visit(at);
}

void count(ShadowError& error, bool lit, bool in_shadow) {
    error.lit += lit;
    error.shadowed += !lit;
    error.false_shadow += lit && in_shadow;
    error.false_light += !lit && !in_shadow;
}

// Calls visit(at) for the pixels of the image within `radius` of a pixel.
template <class Visit>
void for_disc(int size, std::size_t centre, double radius, Visit visit) {
    const int row = static_cast<int>(centre / size), column = static_cast<int>(centre % size);
    const int reach = static_cast<int>(radius);
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, size - 1); ++y)
        for (int x = std::max(column - reach, 0); x <= std::min(column + reach, size - 1); ++x)
            if ((x - column) * (x - column) + (y - row) * (y - row) <= radius * radius)
                visit(static_cast<std::size_t>(y) * size + x);
}

// Where the light's ray through a point beside P meets the sheet of the surface P is on.
struct Slid {
    double t = 0;
    bool over_the_edge = true;  // the sheet does not reach there
};

// The sheet toward the light is the later crossing of a ray that runs toward the light. A plane
// that faces the light has no sheet behind it that could end in light: it counts as unbounded.
Slid slide(const TruthScene& scene, int surface, bool faces_light, const Ray& to_light) {
    const int spheres = static_cast<int>(scene.spheres.size());
    if (surface < spheres) {
        const auto hit = crossings(scene.spheres[surface], to_light);
        return hit ? Slid{(*hit)[faces_light ? 1 : 0], false} : Slid{};
    }
    const auto hit = crossing(scene.planes[surface - spheres], to_light);
    return hit ? Slid{hit->t, !faces_light && !hit->inside} : Slid{};
}

}  // namespace

ShadowError shadow_error(const Truth& truth, const MachineMask& mask,
                         std::span<const std::uint8_t> leave_out) {
    ShadowError error;
    for_compared(truth, mask, leave_out,
                 [&](std::size_t at) { count(error, truth.lit[at], mask.in_shadow(at)); });
    return error;
}

// The nearest pixel of the other answer has a neighbour of this one's, so only such pixels need
// a disc; if an unseen pixel stands between, the two are not on one edge.
std::vector<std::uint8_t> edge_band(const Truth& truth, double radius_px) {
    const int size = truth.size;
    std::vector<std::uint8_t> band(truth.visible.size());
    for (std::size_t at = 0; at < band.size(); ++at) {
        const auto differs = [&](std::size_t other) {
            return truth.visible[at] && truth.visible[other] && truth.lit[at] != truth.lit[other];
        };
        bool edge = false;
        for_disc(size, at, 1, [&](std::size_t other) { edge |= differs(other); });
        if (!edge) continue;
        for_disc(size, at, radius_px, [&](std::size_t other) { band[other] |= differs(other); });
    }
    return band;
}

std::vector<std::uint8_t> light_texel_band(const TruthScene& scene, const TruthLight& light,
                                           const TruthView& light_view, const Truth& truth,
                                           double filter_radius_px, double reach_texels) {
    const Real3 &right = light_view.rotation[0], &up = light_view.rotation[1];
    const auto texel = [&](std::size_t at) {
        const double depth = light_view.project(truth.position[at])[2];
        return light_view.pixel() * (light_view.perspective ? depth / light_view.distance : 1);
    };
    // Whether truth's answer at the pixel is another one, `x`, `y` away in the light's image.
    const auto changes = [&](std::size_t at, double x, double y) {
        const int surface = truth.surface[at];
        const bool faces_light = truth.n_dot_l[at] > 0;
        const Ray ray = light.ray(along(along(truth.position[at], x, right), y, up));
        const Slid slid = slide(scene, surface, faces_light, ray);
        if (blocked(scene, ray, slid.t, light.reach(), surface)) return truth.lit[at] != 0;
        return slid.over_the_edge || faces_light != (truth.lit[at] != 0);
    };

    std::array<std::array<double, 2>, 16> ways;
    for (int i = 0; i < 16; ++i) {
        const double reach = reach_texels * (i < 8 ? 1 : 0.5), angle = i * pi / 4;
        ways[i] = {reach * std::cos(angle), reach * std::sin(angle)};
    }
    std::vector<std::uint8_t> band(truth.visible.size());
    for (std::size_t at = 0; at < band.size(); ++at) {
        if (!truth.visible[at]) continue;
        const double unit = texel(at);
        const bool inside = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
            return changes(at, way[0] * unit, way[1] * unit);
        });
        band[at] = inside;
    }
    return widened(band, truth.size, filter_radius_px);
}

std::vector<std::uint8_t> widened(const std::vector<std::uint8_t>& band, int size,
                                  double radius_px) {
    expect_image(band.size(), size, "the band");
    std::vector<std::uint8_t> wider = band;
    for (std::size_t at = 0; at < band.size() && radius_px >= 1; ++at)
        if (band[at])
            for_disc(size, at, radius_px, [&](std::size_t near) { wider[near] = 1; });
    return wider;
}

int isolated_pixels(const MachineMask& mask, int size) {
    expect_image(mask.shadow.size(), size, "the mask");
    int isolated = 0;
    for (std::size_t at = 0; at < mask.shadow.size(); ++at) {
        if (!mask.drawn(at)) continue;
        int neighbours = -1, alike = -1;  // a disc of radius 1 holds the pixel itself
        for_disc(size, at, 1, [&](std::size_t other) {
            neighbours += mask.drawn(other);
            alike += mask.drawn(other) && mask.in_shadow(other) == mask.in_shadow(at);
        });
        isolated += neighbours > 0 && alike == 0;
    }
    return isolated;
}

std::vector<double> error_image(const Truth& truth, const MachineMask& mask,
                                std::span<const std::uint8_t> leave_out) {
    std::vector<double> error(truth.visible.size());
    for_compared(truth, mask, leave_out, [&](std::size_t at) {
        error[at] = int(mask.in_shadow(at)) - int(truth.lit[at] == 0);
    });
    return error;
}

std::vector<std::uint8_t> lit_pixels(const Truth& truth, const MachineMask& mask) {
    std::vector<std::uint8_t> lit(truth.visible.size());
    for_compared(truth, mask, {}, [&](std::size_t at) { lit[at] = truth.lit[at]; });
    return lit;
}

// With the light at azimuth +-A the sphere is lit and seen from azimuth +-90 (the limb) to
// +-(A - 90) degrees (the line).
std::vector<ShadowError> limb_to_line_profile(const Truth& truth, const MachineMask& mask,
                                              const TruthScene& scene, int sphere,
                                              const TruthView& view, const TruthLight& light,
                                              int bins) {
    std::vector<ShadowError> profile(bins);
    const Real3& centre = scene.spheres[sphere].centre;
    const auto azimuth = [&](const Real3& way) {
        return std::atan2(dot(way, view.rotation[0]), dot(way, view.rotation[2]));
    };
    const double light_azimuth = azimuth(light.ray(centre).direction);
    const double side = light_azimuth < 0 ? -1 : 1, limb = pi / 2;
    const double line = std::abs(light_azimuth) - pi / 2;
    for_compared(truth, mask, {}, [&](std::size_t at) {
        if (truth.surface[at] != sphere || !truth.lit[at]) return;
        const double here = side * azimuth(along(truth.position[at], -1, centre));
        const double place = std::clamp((limb - here) / (limb - line), 0.0, 1.0);
        const int bin = std::min(static_cast<int>(place * bins), bins - 1);
        count(profile[bin], true, mask.in_shadow(at));
    });
    return profile;
}

}  // namespace umbra78::tools
