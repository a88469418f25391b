// Square pictures in a row or in several, for a study's page.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace umbra78::tools::study {

// Of the same size, with a gap of grey between.
struct Strip {
    int width = 0, height = 0;
    std::vector<std::uint8_t> gray;
};
Strip side_by_side(std::span<const std::vector<std::uint8_t>> pictures, int size_px);
// In rows of `columns`; the last may have fewer.
Strip in_rows(std::span<const std::vector<std::uint8_t>> pictures, int size_px, int columns);

}  // namespace umbra78::tools::study
