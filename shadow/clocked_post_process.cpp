#include "shadow/clocked_definitions.hpp"

#include <algorithm>

namespace umbra78::shadow {

PostProcessPlan::PostProcessPlan(const Settings& s, const hw::MatrixWords& matrix)
    : transform(s.machine, s.timing, matrix), divide(s.machine, s.timing, matrix), lookup(s),
      divides(!matrix.affine), dithers(s.dither.shape != hw::DitherShape::none) {
    read_cycles = dithers ? hw::ClockedNoise::cycles_per_pixel(s.dither, s.timing) : 1;
    const int interpolate = lookup.blends ? lookup.interpolate_cycles() : 0;
    slot_cycles = std::max({transform.cycles(), divides ? divide.cycles() : 1,
                            lookup.fetch_cycles(), interpolate, 1});
    latency = transform.latency() + (divides ? divide.latency() : 0) + lookup.fetch_cycles() +
              interpolate + 3;  // place, compare, write
}

// A chunk that is all background, or all visible, is one step.
template <class Depth>
Schedule schedule(std::span<const Depth> depth, std::uint32_t background, int read_cycles,
                  int slot_cycles) {
    Schedule s;
    s.pixels = depth.size();
    const auto p = static_cast<std::uint64_t>(read_cycles);
    const std::uint64_t slot = std::max(static_cast<std::uint64_t>(slot_cycles), p);
    const auto none = static_cast<Depth>(background);
    std::uint64_t gap = 0;  // background pixels behind the one let go last
    const auto let_go = [&] {
        const std::uint64_t reading = p * (gap + 1);
        s.last_issue += s.visible == 0 ? reading - 1 : std::max(slot, reading);
        ++s.visible;
        gap = 0;
    };
    constexpr std::size_t chunk = 32;
    for (std::size_t k = 0; k < depth.size(); k += chunk) {
        const std::span piece = depth.subspan(k, std::min(chunk, depth.size() - k));
        std::uint32_t visible = 0;
        for (const Depth code : piece) visible += code != none;
        if (visible == 0) {
            gap += piece.size();
        } else if (visible == piece.size()) {
            let_go();
            s.last_issue += slot * (visible - 1);
            s.visible += visible - 1;
        } else {
            for (const Depth code : piece) code != none ? let_go() : void(++gap);
        }
    }
    s.trailing = p * gap;
    return s;
}

#define UMBRA78_CLOCKED(Depth)                                                                \
    template Schedule schedule(std::span<const Depth>, std::uint32_t, int, int);              \
    template class ClockedPostProcess<Depth>;
UMBRA78_CLOCKED(hw::Depth16)
UMBRA78_CLOCKED(hw::Depth32)
#undef UMBRA78_CLOCKED

}  // namespace umbra78::shadow
