// The depth formats of today's maps, in integers: what a window depth is stored as.
//
// A window depth, 0 at the near plane and 1 at the far one, is a whole number of 2^-48. D16 and D24
// store depth (2^n - 1), rounded to the nearest code; D32F stores the nearest 32-bit float, as its
// bits, which grow with it. Reversed Z stores 1 - depth. The host's floating point has no part in
// it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace umbra78::tools::bias {

enum class DepthFormat : std::uint8_t { d16, d24, d32f };
std::string_view name_of(DepthFormat);
std::optional<DepthFormat> depth_format(std::string_view name);
// Of the two that hold a normalized integer; 0 for the float.
int unorm_bits(DepthFormat);

inline constexpr int depth_fraction = 48;
inline constexpr std::int64_t far_depth = std::int64_t{1} << depth_fraction;

// The stored code of a depth, which is held to 0 .. 1 first. Halves are rounded up in UNORM, to
// even in float.
std::uint32_t encode(DepthFormat, std::int64_t depth);

// r, what a constant bias of 1 adds to a primitive whose max depth is given, in 2^-48: 1/(2^n - 1),
// rounded, or 2^(e - 23) with the exponent e of that depth.
std::int64_t bias_unit(DepthFormat, std::int64_t max_depth);
// e: 2^e <= depth < 2^(e + 1); of no depth that of 2^-48.
int exponent_of(std::int64_t depth);

}  // namespace umbra78::tools::bias
