// Where pixels flickered over a sequence, as a picture.
#pragma once

#include "tools/study/motion/motion.hpp"

#include <span>
#include <vector>

namespace umbra78::tools::study {

// The more often, the darker, black for every step; light grey where the pixel never flickered,
// white where it was never compared. As many pixels as the mask.
std::vector<std::uint8_t> flicker_picture(const MotionSeen&);

// Pictures of the same size in a row, with a gap of grey between.
struct Strip {
    int width = 0, height = 0;
    std::vector<std::uint8_t> gray;
};
Strip side_by_side(std::span<const std::vector<std::uint8_t>> pictures, int size_px);

}  // namespace umbra78::tools::study
