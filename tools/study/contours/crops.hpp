// A piece of the mask, magnified, once for each setting of the filters: what the numbers mean.
#pragma once

#include "tools/scene/scene_file.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

// Side by side; light is white. Empty for a scene without closed form.
struct Crops {
    int width = 0, height = 0;
    std::vector<std::uint8_t> grey;
};

// About the middle of the longest shadow line of a surface itself, 96 pixels a side three times as
// large, for each (dequantize, low_pass).
Crops crops(const LoadedScene&, std::span<const std::pair<int, int>> passes);

}  // namespace umbra78::tools::study
