// Brute force: the definition of what is dark, which every exact rival must equal.
//
// A pixel that shows a facet is dark if the facet turns its seen side from the light (attached
// shadow), or if another facet lies between the light and the point that is seen (cast shadow).
// Each facet is asked, by itself. A grid in the light's picture leaves out those that cannot be in
// between; the bits are the same.
#pragma once

#include "shadow/rivals/light_grid.hpp"
#include "shadow/rivals/visible.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

inline constexpr std::uint8_t lit = 0, dark = 255;

struct BruteCounts {
    std::uint64_t points = 0;  // pixels that show a facet whose seen side is lit
    std::uint64_t facets = 0;  // asked of them
};

// `mask` is 0 or 255; 0 where nothing is seen. `grid` may be null.
void brute(const Setting& setting, std::span<const std::uint32_t> shown, const LightGrid* grid,
           std::span<std::uint8_t> mask, BruteCounts& counts);

// How many facets lie between the light and the point that a pixel shows, of all facets.
std::uint32_t surfaces_before(const Setting& setting, std::uint32_t shown, int column, int row);

}  // namespace umbra78::shadow::rivals
