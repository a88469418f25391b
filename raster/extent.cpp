#include "raster/extent.hpp"

#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"

#include <algorithm>

namespace umbra78::raster {

void Box::add(const World& p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
}

std::uint32_t Box::largest() const {
    if (empty()) return 0;
    std::uint64_t largest = 0;
    for (const std::int32_t v : {min.x, min.y, min.z, max.x, max.y, max.z})
        largest = std::max(largest, fixed::magnitude(v));
    return static_cast<std::uint32_t>(largest);
}

World Box::centre() const {
    if (empty()) return {};
    const auto middle = [](std::int64_t a, std::int64_t b) {
        return static_cast<std::int32_t>(fixed::round_shift(a + b, 1, fixed::Rounding::floor));
    };
    return {middle(min.x, max.x), middle(min.y, max.y), middle(min.z, max.z)};
}

void ViewRanges::add(const World& p) {
    right.add(along(axes.right, p));
    up.add(along(axes.up, p));
    back.add(along(axes.back, p));
}

}  // namespace umbra78::raster
