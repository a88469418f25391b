// Each rival of shadow/rivals, handed its memory from what is left of the frame's.
#pragma once

#include "shadow/carver.hpp"
#include "shadow/frame/settings.hpp"
#include "shadow/rivals/costs.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// Writes the mask and returns what it took. If the carver does not hold it afterwards, the mask is
// not complete, and used() is what would have let it go on. `scale` is of the observer's store.
Work cast_by(Form form, const Setting& setting,
                     std::span<const std::uint32_t> shown, const DepthScale& scale,
                     Carver& carver, std::span<std::uint8_t> mask);

// What takes its memory from the rest and says how much it needs: build(memory, needed).
template <class Build>
bool built_from(Carver& carver, Build&& build) {
    if (!carver.fits()) return false;
    std::size_t needed = 0;
    const bool done = build(carver.rest(), needed);
    carver.take<std::byte>(needed);
    return done && carver.fits();
}

inline bool built_grid(const Setting& s, Carver& carver, LightGrid& grid) {
    return built_from(carver, [&](std::span<std::byte> memory, std::size_t& needed) {
        return grid.build(s, 0, memory, needed);
    });
}

}  // namespace umbra78::shadow::rivals
