#include "shadow/low_pass.hpp"

#include <cstddef>

namespace umbra78::shadow {

template <class Depth>
void low_pass(std::span<const std::uint8_t> mask, const hw::FrameStore<Depth>& observer,
              Depth background, std::span<std::uint8_t> out) {
    const int size = observer.size_px();
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const std::size_t here = observer.address(x, y);
            out[here] = 0;
            if (observer.depth[here] == background) continue;
            const int self = mask[here];
            int sum = 8;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const int px = x + dx, py = y + dy;
                    const bool beyond = px < 0 || py < 0 || px >= size || py >= size;
                    const std::size_t a = beyond ? here : observer.address(px, py);
                    const bool none = observer.depth[a] == background;
                    sum += (2 - dx * dx) * (2 - dy * dy) * (none ? self : mask[a]);
                }
            }
            out[here] = static_cast<std::uint8_t>(sum >> 4);
        }
    }
}

template void low_pass(std::span<const std::uint8_t>, const hw::FrameStore<hw::Depth16>&,
                       hw::Depth16, std::span<std::uint8_t>);
template void low_pass(std::span<const std::uint8_t>, const hw::FrameStore<hw::Depth32>&,
                       hw::Depth32, std::span<std::uint8_t>);

}  // namespace umbra78::shadow
