#include "tools/stream/hills.hpp"

#include "fixed/rounding.hpp"
#include "fixed/sine.hpp"
#include "tools/stream/packed.hpp"

#include <algorithm>

namespace umbra78::tools {
namespace {

// Degrees across the square: two and a half waves, and nine small ones.
constexpr std::int64_t slow_degrees = 900, fast_degrees = 3240;
constexpr std::int32_t slow_amplitude = 5 << 15, fast_amplitude = 3 << 14;  // 5/2 and 3/4 units

std::int32_t times(std::int32_t amplitude, std::int32_t a, std::int32_t b) {
    const std::int64_t product = fixed::floor_shift(std::int64_t{a} * b, 30);
    return static_cast<std::int32_t>(fixed::floor_shift(product * amplitude, 30));
}

// The Bezier coefficients of a segment of a uniform cubic B-spline, times 6.
std::array<std::int64_t, 4> bezier(std::int64_t a, std::int64_t b, std::int64_t c,
                                   std::int64_t d) {
    return {a + 4 * b + c, 4 * b + 2 * c, 2 * b + 4 * c, b + 4 * c + d};
}

std::int32_t divided(std::int64_t v, std::int64_t by) {
    return static_cast<std::int32_t>(fixed::round_divide(v, by, fixed::Rounding::half_even));
}

}  // namespace

Hills::Hills(const HillsShape& shape)
    : shape_(shape),
      per_layer_((shape.patches + shape.layers - 1) / std::max<std::uint64_t>(shape.layers, 1)),
      per_side_(1) {
    while (per_side_ * per_side_ < per_layer_) ++per_side_;
    const auto k = static_cast<std::int64_t>(per_side_);
    for (std::int64_t i = -1; i <= k + 1; ++i) {
        const auto sine = [&](std::int64_t degrees) {
            const std::int64_t q16 =
                fixed::round_divide(i * degrees * 65536, k, fixed::Rounding::floor);
            return fixed::sine_cosine(static_cast<std::int32_t>(q16 % (360 * 65536))).sine;
        };
        sines_.push_back({sine(slow_degrees), sine(fast_degrees)});
    }
    patches_.reserve(max_packed_records);
}

bool Hills::rewind() {
    at_ = 0;
    return true;
}

Hills::Next Hills::next(raster::Surfaces& batch) {
    if (at_ == shape_.patches) return Next::end;
    patches_.clear();
    const std::uint64_t end = std::min(shape_.patches, at_ + max_packed_records);
    for (; at_ < end; ++at_) patches_.push_back(patch(at_));
    batch = std::span<const raster::Patch>(patches_);
    return Next::batch;
}

// Of the net's point (i, j), counted from -1.
std::int32_t Hills::height(std::int64_t i, std::int64_t j) const {
    const auto& x = sines_[static_cast<std::size_t>(i + 1)];
    const auto& z = sines_[static_cast<std::size_t>(j + 1)];
    return times(slow_amplitude, x[0], z[0]) + times(fast_amplitude, x[1], z[1]);
}

raster::Patch Hills::patch(std::uint64_t number) const {
    const std::uint64_t layer = number / per_layer_, place = number % per_layer_;
    const auto column = static_cast<std::int64_t>(place % per_side_);
    const auto row = static_cast<std::int64_t>(place / per_side_);
    std::array<std::array<std::int64_t, 4>, 4> rows{};  // by z, of Bezier coefficients along x
    for (std::int64_t j = 0; j < 4; ++j)
        rows[static_cast<std::size_t>(j)] =
            bezier(height(column - 1, row + j - 1), height(column, row + j - 1),
                   height(column + 1, row + j - 1), height(column + 2, row + j - 1));
    const auto at = [&](std::int64_t third) {
        const auto thirds = 3 * static_cast<std::int64_t>(per_side_);
        return divided(2 * third * shape_.side - thirds * shape_.side, 2 * thirds);
    };
    const auto drop = static_cast<std::int64_t>(layer) * shape_.gap;
    raster::Patch out;
    out.material = first_material_;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto y = bezier(rows[0][i], rows[1][i], rows[2][i], rows[3][i]);
        for (std::size_t j = 0; j < 4; ++j)
            out.control[4 * j + i] = {
                at(3 * column + static_cast<std::int64_t>(i)) - origin_.x,
                static_cast<std::int32_t>(divided(y[j], 36) - drop - origin_.y),
                at(3 * row + static_cast<std::int64_t>(j)) - origin_.z};
    }
    return out;
}

}  // namespace umbra78::tools
