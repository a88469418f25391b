// Visits pixels of images of size * size values, row 0 at the top, for the measures of this room.
#pragma once

#include "fixed/trap.hpp"
#include "tools/truth/metrics.hpp"

#include <algorithm>
#include <cstddef>

namespace umbra78::tools {

// Stops the program if an image is not size * size values long.
inline void expect_image(std::size_t length, int size) {
    fixed::require(length == static_cast<std::size_t>(size) * size,
                   "truth: an image is not size * size values long");
}

// Calls visit(at) for each pixel that both see and `leave_out` keeps.
template <class Visit>
void for_compared(const Truth& truth, const MachineMask& mask,
                  std::span<const std::uint8_t> leave_out, Visit visit) {
    expect_image(mask.shadow.size(), truth.size);
    if (!mask.visible.empty()) expect_image(mask.visible.size(), truth.size);
    if (!leave_out.empty()) expect_image(leave_out.size(), truth.size);
    for (std::size_t at = 0; at < truth.visible.size(); ++at)
        if (truth.visible[at] && mask.drawn(at) && (leave_out.empty() || !leave_out[at]))
            visit(at);
}

// Calls visit(at) for the pixels of the image within `radius` of a pixel.
template <class Visit>
void for_disc(int size, std::size_t centre, double radius, Visit visit) {
    const int row = static_cast<int>(centre / size), column = static_cast<int>(centre % size);
    const int reach = static_cast<int>(radius);
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, size - 1); ++y)
        for (int x = std::max(column - reach, 0); x <= std::min(column + reach, size - 1); ++x)
            if ((x - column) * (x - column) + (y - row) * (y - row) <= radius * radius)
                visit(static_cast<std::size_t>(y) * size + x);
}

}  // namespace umbra78::tools
