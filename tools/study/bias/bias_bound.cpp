#include "tools/study/bias/bias_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace umbra78::tools::study {

namespace {

// Twice how far a texel that is compared with a point may lie from it, without dither.
int reach(const shadow::Settings& s) {
    const int jittered = s.tap_places == shadow::TapPlaces::jittered ? 1 : 0;
    switch (s.lookup) {
        case shadow::Lookup::nearest: return 1;
        case shadow::Lookup::bilinear: return 0;
        case shadow::Lookup::percentage: return s.taps + jittered;
        case shadow::Lookup::filtered_depth: return 1 + jittered;
    }
    return 0;
}

}  // namespace

double bias_bound(double slope, const shadow::Settings& s) {
    const double jitter = hw::silent(s.dither, s.machine) ? 0 : s.dither.size_q8 / 256.0;
    const double texels = jitter + reach(s);
    const double quanta_a_texel = std::ldexp(slope, s.machine.z_bits);
    return (texels > 0 ? texels * quanta_a_texel / 2 : 0) + 1;
}

double bias_bound_for(double share, std::span<const double> slope,
                      std::span<const std::uint8_t> lit, std::span<const std::uint8_t> leave_out,
                      const shadow::Settings& s) {
    std::vector<double> kept;
    for (std::size_t at = 0; at < slope.size(); ++at)
        if (lit[at] && (leave_out.empty() || !leave_out[at])) kept.push_back(slope[at]);
    if (kept.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto over = static_cast<std::ptrdiff_t>(share * static_cast<double>(kept.size()));
    const auto place = kept.end() - 1 - std::min<std::ptrdiff_t>(over, std::ssize(kept) - 1);
    std::nth_element(kept.begin(), place, kept.end());
    return bias_bound(*place, s);  // grows with the slope
}

}  // namespace umbra78::tools::study
