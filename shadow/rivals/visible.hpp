// The facet that each pixel shows: of those that cover its centre, the nearest to the eye,
// exactly. Of facets at one place, in one plane, the one of the least number.
#pragma once

#include "shadow/rivals/pencil.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

inline constexpr std::uint32_t nothing_seen = UINT32_MAX;

struct VisibleCounts {
    std::uint64_t rows = 0;      // of facets: three crossings each
    std::uint64_t covered = 0;   // pixels of facets
    std::uint64_t compares = 0;  // of two facets at a pixel
};

// The rows whose centres a facet may cover.
Run rows_of(const Setting& setting, std::size_t facet);

// `shown` has setting.space.pixels() numbers, row by row from the top.
void find_visible(const Setting& setting, std::span<std::uint32_t> shown, VisibleCounts& counts);

}  // namespace umbra78::shadow::rivals
