#include "shadow/filters/ramp.hpp"

#include "fixed/root.hpp"
#include "shadow/filters/filter_check.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace umbra78::shadow {
namespace {

constexpr std::uint8_t shadow_from = 128;

// Into `rows`: for each pixel how many lines away the nearest pixel in shadow of its column is, at
// most `far`.
void measure_columns(std::span<const std::uint8_t> mask, std::size_t size, std::uint8_t far,
                     std::span<std::uint8_t> rows) {
    const auto step = [&](std::size_t a, std::size_t before, bool has_before) {
        const int on = has_before ? rows[before] + 1 : far;
        const int here = mask[a] >= shadow_from ? 0 : std::min<int>(on, far);
        rows[a] = static_cast<std::uint8_t>(here);
    };
    for (std::size_t a = 0; a < mask.size(); ++a) step(a, a - size, a >= size);
    for (std::size_t a = mask.size() - size; a-- > 0;)
        rows[a] = static_cast<std::uint8_t>(std::min<int>(rows[a], rows[a + size] + 1));
}

// By squared distance, so that no root is taken in a frame.
using Table = std::array<std::uint8_t, max_ramp_px * max_ramp_px>;

}  // namespace

std::uint8_t ramp_darkness(int squares, int width) {
    if (squares >= width * width) return 0;
    const auto whole = static_cast<std::int64_t>(width) * 256;
    const auto distance = static_cast<std::int64_t>(
        fixed::isqrt(static_cast<std::uint64_t>(squares) << 16));
    return static_cast<std::uint8_t>((2 * 255 * (whole - distance) + whole) / (2 * whole));
}

template <class Depth>
void ramp(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
          Depth background, int width, std::span<std::uint8_t> rows, std::span<std::uint8_t> out) {
    check_filter(mask, observer, out, LineSet::of_frame(observer.xy_bits));
    fixed::require(width >= 1 && width <= max_ramp_px, "ramp: a width of 1 to 32 pixels");
    fixed::require(rows.size() == mask.size(), "ramp: its scratch has not one byte for each pixel");
    const int size = observer.size_px();
    measure_columns(mask, static_cast<std::size_t>(size), static_cast<std::uint8_t>(width), rows);
    Table dark;
    for (int k = 0; k < width * width; ++k)
        dark[static_cast<std::size_t>(k)] = ramp_darkness(k, width);
    for (int y = 0; y < size; ++y) {
        const std::size_t line = observer.address(0, y);
        for (int x = 0; x < size; ++x) {
            const std::size_t a = line + static_cast<std::size_t>(x);
            if (observer.depth[a] == background) {
                out[a] = 0;
                continue;
            }
            int least = width * width;
            for (int to = std::max(0, x - width + 1); to < std::min(size, x + width); ++to) {
                const int down = rows[line + static_cast<std::size_t>(to)];
                least = std::min(least, (to - x) * (to - x) + down * down);
            }
            const std::uint8_t ramped =
                least < width * width ? dark[static_cast<std::size_t>(least)] : std::uint8_t{0};
            out[a] = std::max(mask[a], ramped);
        }
    }
}

template void ramp(std::span<const std::uint8_t>, const hw::ReadOnlyStore<hw::Depth16>&,
                   hw::Depth16, int, std::span<std::uint8_t>, std::span<std::uint8_t>);
template void ramp(std::span<const std::uint8_t>, const hw::ReadOnlyStore<hw::Depth32>&,
                   hw::Depth32, int, std::span<std::uint8_t>, std::span<std::uint8_t>);

}  // namespace umbra78::shadow
