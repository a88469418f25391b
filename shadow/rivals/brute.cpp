#include "shadow/rivals/brute.hpp"

#include <array>

namespace umbra78::shadow::rivals {

void brute(const Setting& setting, std::span<const std::uint32_t> shown, const LightGrid* grid,
           std::span<std::uint8_t> mask, BruteCounts& counts) {
    const Space& space = setting.space;
    const auto facets = static_cast<std::uint32_t>(setting.mesh.facets.size());
    std::array<HidingLines, 32> lines;  // of facets asked not long ago
    std::size_t at = 0;
    for (int row = 0; row < space.size_px(); ++row) {
        for (int column = 0; column < space.size_px(); ++column, ++at) {
            const std::uint32_t on = shown[at];
            mask[at] = on != nothing_seen && setting.attached(on) ? dark : lit;
            if (on == nothing_seen || mask[at] == dark) continue;
            const std::int32_t px = space.centre(column), py = space.centre(row);
            const auto hidden_by = [&](std::uint32_t f) {
                ++counts.facets;
                return lines[f % lines.size()].hide(setting, f, on, px, py);
            };
            ++counts.points;
            bool hidden = false;
            if (grid != nullptr) {
                const LightPlace place =
                    grid->picture().place(setting.planes[on], space.eye(), px, py);
                for (const std::uint32_t f : grid->facets_at(place))
                    if (hidden = hidden_by(f); hidden) break;
            } else {
                for (std::uint32_t f = 0; f < facets && !hidden; ++f) hidden = hidden_by(f);
            }
            mask[at] = hidden ? dark : lit;
        }
    }
}

std::uint32_t surfaces_before(const Setting& setting, std::uint32_t shown, int column, int row) {
    std::uint32_t count = 0;
    for (std::size_t f = 0; f < setting.mesh.facets.size(); ++f)
        count += setting.hides(setting.light, f, shown, setting.space.centre(column),
                               setting.space.centre(row)) ? 1 : 0;
    return count;
}

}  // namespace umbra78::shadow::rivals
