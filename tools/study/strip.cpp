#include "tools/study/strip.hpp"

#include <algorithm>

namespace umbra78::tools::study {

Strip side_by_side(std::span<const std::vector<std::uint8_t>> pictures, int size_px) {
    constexpr int gap = 8;
    Strip strip;
    strip.height = size_px;
    strip.width = static_cast<int>(pictures.size()) * (size_px + gap) - gap;
    strip.gray.assign(static_cast<std::size_t>(strip.width) * strip.height, 128);
    for (std::size_t k = 0; k < pictures.size(); ++k)
        for (int y = 0; y < size_px; ++y)
            std::copy_n(pictures[k].begin() + static_cast<std::ptrdiff_t>(y) * size_px, size_px,
                        strip.gray.begin() + static_cast<std::ptrdiff_t>(y) * strip.width +
                            static_cast<std::ptrdiff_t>(k) * (size_px + gap));
    return strip;
}

}  // namespace umbra78::tools::study
