#include "tools/truth/metrics.hpp"

#include "tools/truth/image_walk.hpp"
#include "tools/truth/real3.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

void count(ShadowError& error, bool lit, bool in_shadow) {
    error.lit += lit;
    error.shadowed += !lit;
    error.false_shadow += lit && in_shadow;
    error.false_light += !lit && !in_shadow;
}

}  // namespace

ShadowError shadow_error(const Truth& truth, const MachineMask& mask,
                         std::span<const std::uint8_t> leave_out) {
    ShadowError error;
    for_compared(truth, mask, leave_out,
                 [&](std::size_t at) { count(error, truth.lit[at], mask.in_shadow(at)); });
    return error;
}

double GradedError::mean_absolute() const {
    return pixels() ? absolute / 255 / pixels() : 0;
}
double GradedError::rms() const {
    return pixels() ? std::sqrt(squares / pixels()) / 255 : 0;
}

GradedError graded_error(const Truth& truth, const MachineMask& mask,
                         std::span<const std::uint8_t> leave_out) {
    GradedError error;
    for_compared(truth, mask, leave_out, [&](std::size_t at) {
        const int dark = mask.shadow[at];
        const double share = truth.light_share(at);
        const double off = std::abs(dark - 255 * (1 - share));
        error.absolute += off;
        error.squares += off * off;
        const bool beyond = off * 100 > 255 * 2;  // off by more than 2 % of the light
        error.lit += share == 1;
        error.umbra += share == 0;
        error.penumbra += share > 0 && share < 1;
        error.lit_below_98 += share == 1 && beyond;
        error.umbra_above_2 += share == 0 && beyond;
        error.between += dark != 0 && dark != 255;
    });
    return error;
}

// Beyond the border nothing is drawn: a frame of such pixels goes round the image, so that the loop
// has no branches and its bytes fit lanes.
int isolated_pixels(const MachineMask& mask, int size) {
    expect_image(mask.shadow.size(), size);
    enum : std::uint8_t { none, lit, shadow };
    const auto n = static_cast<std::size_t>(size), stride = n + 2;
    std::vector<std::uint8_t> framed(stride * stride, none);
    for (std::size_t y = 0; y < n; ++y) {
        std::uint8_t* row = framed.data() + (y + 1) * stride + 1;
        for (std::size_t x = 0; x < n; ++x) {
            const std::size_t at = y * n + x;
            row[x] = !mask.drawn(at) ? none : mask.in_shadow(at) ? shadow : lit;
        }
    }
    int isolated = 0;
    for (std::size_t y = 0; y < n; ++y) {
        const std::uint8_t* row = framed.data() + (y + 1) * stride;  // from the frame's column
        const std::uint8_t *above = row - stride + 1, *below = row + stride + 1;
        for (std::size_t x = 0; x < n; ++x) {
            const int left = row[x], k = row[x + 1], right = row[x + 2];
            const int up = above[x], down = below[x];
            const bool alike = (left == k) | (right == k) | (up == k) | (down == k);
            isolated += ((k != none) & ((left | right | up | down) != none) & !alike) ? 1 : 0;
        }
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
