// The low-pass: the definition at the frame's border, and the same in lanes inside it.
#include "shadow/filters/low_pass.hpp"

#include "shadow/filters/filter_check.hpp"

#include <cstddef>

namespace umbra78::shadow {
namespace {

// The definition, for the frame's border: a neighbour that is not there counts as the pixel.
template <class Depth>
std::uint8_t pixel(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
                   Depth background, int x, int y) {
    const int size = observer.size_px();
    const std::size_t here = observer.address(x, y);
    if (observer.depth[here] == background) return 0;
    const int self = mask[here];
    int sum = 8;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int px = x + dx, py = y + dy;
            const bool beyond = px < 0 || py < 0 || px >= size || py >= size;
            const std::size_t a = beyond ? here : observer.address(px, py);
            const bool none = observer.depth[a] == background;
            sum += low_pass_weight(dx, dy) * (none ? self : mask[a]);
        }
    }
    return static_cast<std::uint8_t>(sum / 16);
}

// The same inside the border, a scan line at once, with selections for branches. `mask` and
// `depth` point to the line's first pixel, `stride` away from those above and below.
template <class Depth>
void inner_row(const std::uint8_t* mask, const Depth* depth, int stride, Depth background,
               std::uint8_t* out) {
    for (int x = 1; x < stride - 1; ++x) {
        const std::uint16_t self = mask[x];
        const auto at = [&](int a) -> std::uint16_t {
            return depth[a] == background ? self : std::uint16_t{mask[a]};
        };
        const int above = x - stride, below = x + stride;
        const auto sum = static_cast<std::uint16_t>(
            8 + at(above - 1) + 2 * at(above) + at(above + 1) + 2 * at(x - 1) + 4 * self +
            2 * at(x + 1) + at(below - 1) + 2 * at(below) + at(below + 1));
        out[x] = static_cast<std::uint8_t>(depth[x] == background ? 0 : sum >> 4);
    }
}

}  // namespace

template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out, const LineSet& lines) {
    check_filter(mask, observer, out, lines);
    const auto from = reinterpret_cast<std::uintptr_t>(mask.data());
    const auto to = reinterpret_cast<std::uintptr_t>(out.data());
    fixed::require(from + mask.size() <= to || to + out.size() <= from,
                   "low-pass: the mask and the result overlap");
    const int size = observer.size_px(), last = size - 1;
    for (int y = 0; y < size; ++y) {
        if (!lines.has(y)) continue;
        const std::size_t row = observer.address(0, y);
        const bool border = y == 0 || y == last;
        if (!border)
            inner_row(mask.data() + row, observer.depth.data() + row, size, background,
                      out.data() + row);
        for (int x = 0; x < size; x += border ? 1 : last)
            out[observer.address(x, y)] = pixel(mask, observer, background, x, y);
    }
}

template void low_pass(std::span<const std::uint8_t>, const hw::ReadOnlyStore<hw::Depth16>&,
                       hw::Depth16, std::span<std::uint8_t>, const LineSet&);
template void low_pass(std::span<const std::uint8_t>, const hw::ReadOnlyStore<hw::Depth32>&,
                       hw::Depth32, std::span<std::uint8_t>, const LineSet&);

}  // namespace umbra78::shadow
