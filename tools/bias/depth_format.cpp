#include "tools/bias/depth_format.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace umbra78::tools::bias {
namespace {

constexpr std::array<std::string_view, 3> format_names{"d16", "d24", "d32f"};

// depth (2^bits - 1) / 2^48, half up. The product has up to 72 bits, so the depth's two halves are
// multiplied apart: floor((2^24 a + b + half) / 2^48) = floor((a + floor((b + half)/2^24)) / 2^24).
std::uint32_t encode_unorm(int bits, std::int64_t depth) {
    const std::int64_t max = (std::int64_t{1} << bits) - 1, half = far_depth / 2;
    const std::int64_t low_mask = (1 << 24) - 1;
    const std::int64_t a = (depth >> 24) * max, b = (depth & low_mask) * max;
    return static_cast<std::uint32_t>((a + ((b + half) >> 24)) >> 24);
}

// The bits of the nearest float: exponent and 23 bits of mantissa, half to even. A carry out of the
// mantissa goes into the exponent by itself.
std::uint32_t encode_float(std::int64_t depth) {
    if (depth == 0) return 0;
    const int e = exponent_of(depth);
    const int shift = e + depth_fraction - 23;  // of the mantissa's last bit
    const auto word = static_cast<std::uint64_t>(depth);
    std::uint64_t mantissa;
    if (shift <= 0) {
        mantissa = word << -shift;
    } else {
        const std::uint64_t rest = word & ((std::uint64_t{1} << shift) - 1);
        const std::uint64_t half = std::uint64_t{1} << (shift - 1);
        mantissa = word >> shift;
        if (rest > half || (rest == half && (mantissa & 1) != 0)) ++mantissa;
    }
    const auto biased = static_cast<std::uint64_t>(e + 127);
    return static_cast<std::uint32_t>((biased << 23) + (mantissa - (std::uint64_t{1} << 23)));
}

}  // namespace

std::string_view name_of(DepthFormat format) {
    return format_names[static_cast<std::size_t>(format)];
}

std::optional<DepthFormat> depth_format(std::string_view name) {
    const auto found = std::find(format_names.begin(), format_names.end(), name);
    if (found == format_names.end()) return {};
    return static_cast<DepthFormat>(found - format_names.begin());
}

int unorm_bits(DepthFormat format) {
    if (format == DepthFormat::d32f) return 0;
    return format == DepthFormat::d16 ? 16 : 24;
}

int exponent_of(std::int64_t depth) {
    if (depth <= 0) return -depth_fraction;
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(depth))) - 1 -
           depth_fraction;
}

std::uint32_t encode(DepthFormat format, std::int64_t depth) {
    const std::int64_t held = std::clamp<std::int64_t>(depth, 0, far_depth);
    const int bits = unorm_bits(format);
    return bits > 0 ? encode_unorm(bits, held) : encode_float(held);
}

std::int64_t bias_unit(DepthFormat format, std::int64_t max_depth) {
    if (const int bits = unorm_bits(format); bits > 0) {
        const std::int64_t max = (std::int64_t{1} << bits) - 1;
        return (far_depth + max / 2) / max;
    }
    const int place = exponent_of(max_depth) - 23 + depth_fraction;
    return std::int64_t{1} << std::max(place, 0);
}

}  // namespace umbra78::tools::bias
