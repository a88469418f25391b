#include "tools/study/motion/picture.hpp"

#include <algorithm>

namespace umbra78::tools::study {

std::vector<std::uint8_t> flicker_picture(const MotionSeen& seen) {
    const int steps = std::max(static_cast<int>(seen.compared.size()), 1);
    std::vector<std::uint8_t> gray(seen.flickers.size(), 255);
    for (std::size_t at = 0; at < gray.size(); ++at) {
        if (!seen.seen[at]) continue;
        const int n = seen.flickers[at];
        gray[at] = static_cast<std::uint8_t>(n == 0 ? 225 : 160 - 160 * n / steps);
    }
    return gray;
}

}  // namespace umbra78::tools::study
