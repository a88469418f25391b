// Where pixels flickered over a sequence, as a picture.
#pragma once

#include "tools/study/motion/motion.hpp"

#include <vector>

namespace umbra78::tools::study {

// The more often, the darker, black for every step; light grey where the pixel never flickered,
// white where it was never compared. As many pixels as the mask.
std::vector<std::uint8_t> flicker_picture(const MotionSeen&);

}  // namespace umbra78::tools::study
