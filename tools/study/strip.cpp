#include "tools/study/strip.hpp"

#include <algorithm>

namespace umbra78::tools::study {

Strip side_by_side(std::span<const std::vector<std::uint8_t>> pictures, int size_px) {
    return in_rows(pictures, size_px, static_cast<int>(pictures.size()));
}

Strip in_rows(std::span<const std::vector<std::uint8_t>> pictures, int size_px, int columns) {
    constexpr int gap = 8;
    const int count = static_cast<int>(pictures.size());
    const int rows = (count + columns - 1) / columns, pitch = size_px + gap;
    Strip strip;
    strip.width = std::min(count, columns) * pitch - gap;
    strip.height = rows * pitch - gap;
    strip.gray.assign(static_cast<std::size_t>(strip.width) * strip.height, 128);
    for (int k = 0; k < count; ++k)
        for (int y = 0; y < size_px; ++y) {
            const std::ptrdiff_t top = (k / columns) * pitch + y, left = (k % columns) * pitch;
            const auto from = pictures[static_cast<std::size_t>(k)].begin() +
                              static_cast<std::ptrdiff_t>(y) * size_px;
            std::copy_n(from, size_px, strip.gray.begin() + top * strip.width + left);
        }
    return strip;
}

}  // namespace umbra78::tools::study
