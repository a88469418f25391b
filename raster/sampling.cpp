#include "raster/sampling.hpp"

#include "fixed/wide_int.hpp"

namespace umbra78::raster::detail {

// Edge functions fit 64 bits, since corners are 31-bit words; their products with depths do not.
bool wide_triangle_depth(const Corner& a, const Corner& b, const Corner& c, std::int32_t x,
                         std::int32_t y, std::int64_t& z) {
    using Wide = fixed::WideInt<4>;
    const auto edge = [](const Corner& p, const Corner& q, std::int64_t rx, std::int64_t ry) {
        return (std::int64_t{q.x} - p.x) * (ry - p.y) - (rx - p.x) * (std::int64_t{q.y} - p.y);
    };
    const auto grown = [](const Corner& p, const Corner& q) {
        const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y;
        return -slack * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
    };
    const std::int64_t turned = edge(a, b, c.x, c.y);
    if (turned == 0) return false;
    const std::int64_t sign = turned < 0 ? -1 : 1, area = sign * turned;
    const std::int64_t wc = sign * edge(a, b, x, y), wa = sign * edge(b, c, x, y);
    const std::int64_t wb = sign * edge(c, a, x, y);
    if (wc < grown(a, b) || wa < grown(b, c) || wb < grown(c, a)) return false;
    const Wide rise = Wide(wb) * Wide(std::int64_t{b.z} - a.z) +
                      Wide(wc) * Wide(std::int64_t{c.z} - a.z);
    // half_up(rise / area) = floor((2 rise + area) / (2 area)), looked for between the corners'
    // depths, which clamps it.
    const Wide top = (rise << 1) + Wide(area), bottom = Wide(area) << 1;
    std::int64_t low = std::min({a.z, b.z, c.z}), high = std::max({a.z, b.z, c.z});
    while (low < high) {
        const std::int64_t middle = high - (high - low) / 2;
        if (Wide(middle - a.z) * bottom <= top) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    z = low;
    return true;
}

}  // namespace umbra78::raster::detail
