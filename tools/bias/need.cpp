#include "tools/bias/need.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbra78::tools::bias {
namespace {

constexpr std::array<std::string_view, 4> filter_names{"nearest", "bilinear", "pcf3", "pcf5"};
constexpr std::array<int, 4> sides{1, 2, 3, 5};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

std::string_view name_of(Filter f) { return filter_names[static_cast<std::size_t>(f)]; }

std::optional<Filter> filter(std::string_view name) {
    const auto found = std::find(filter_names.begin(), filter_names.end(), name);
    if (found == filter_names.end()) return {};
    return static_cast<Filter>(found - filter_names.begin());
}

int taps_a_side(Filter f) { return sides[static_cast<std::size_t>(f)]; }

double reach(Filter f) { return taps_a_side(f) / 2.0; }

double MapSetup::tangent() const { return std::tan(radians(slope_deg)); }
double MapSetup::along_x() const { return tangent() * std::abs(std::cos(radians(azimuth_deg))); }
double MapSetup::along_y() const { return tangent() * std::abs(std::sin(radians(azimuth_deg))); }
double MapSetup::largest_slope() const { return std::max(along_x(), along_y()); }

int MapSetup::exponent() const {
    const double stored = reversed ? 1 - depth : depth;
    return exponent_of(static_cast<std::int64_t>(std::ldexp(stored, depth_fraction)));
}

double MapSetup::step() const {
    const int bits = unorm_bits(format);
    const double part = bits > 0 ? 1 / (std::ldexp(1, bits) - 1) : std::ldexp(1, exponent() - 23);
    return part * range;
}

Need need_of(const MapSetup& s) {
    const double sum = s.along_x() + s.along_y();
    Need need{};
    need.geometry = reach(s.filter) * s.texel() * sum;
    need.step = s.step();
    const double slope = s.tangent();
    need.slope_euclidean = slope > 0 ? reach(s.filter) * sum / slope : 0;
    need.slope_max = slope > 0 ? reach(s.filter) * sum / s.largest_slope() : 0;
    need.normal = need.geometry * std::cos(radians(s.slope_deg));
    return need;
}

}  // namespace umbra78::tools::bias
