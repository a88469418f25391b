// Operations of a drawing and of the filters, by the numbers of the table in hw/MACHINE.md, section
// 16, written out once more: an oracle for the ledger and the costs, for centre sampling.
#pragma once

#include "hw/operations.hpp"
#include "raster/draw.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::shadow::test {

// What the units are busy for, in the order adders, multipliers, divider, store.
struct Busy {
    std::uint64_t adds = 0, passes = 0, quotient_bits = 0, accesses = 0;

    // Cycles of four multipliers and as many adders.
    std::uint64_t one_after_the_other() const {
        return (adds + 3) / 4 + (passes + 3) / 4 + quotient_bits + accesses;
    }
    std::uint64_t side_by_side() const {
        return std::max({(adds + 3) / 4, (passes + 3) / 4, quotient_bits, accesses});
    }
};

// `point_passes`: of a control point through the transform unit, idle multipliers among them.
inline Busy drawing_by_hand(const raster::DrawCounts& c, bool affine, bool shades, unsigned n,
                            unsigned point_passes) {
    const std::uint64_t screen = affine ? 3 : 4, components = shades ? screen + 3 : screen;
    Busy b;
    b.adds = components * (60 * c.patches + 16 * c.splits) +
             screen * (43 * c.tested_blocks + 1260 * c.blocks) + 256 * 16 * c.blocks +
             60 * c.tested_centres + 6 * c.samples;
    b.passes = 16 * point_passes * c.patches + 16 * c.tested_centres + 4 * c.samples;
    b.quotient_bits = 22 * c.samples + (affine ? 0 : 26877 * c.blocks);
    b.accesses = 2 * c.samples;
    if (!shades) return b;
    b.adds += 4 * 48 * c.blocks + (40 + n) * c.samples;
    b.passes += 4 * 36 * c.blocks + (46 + n) * c.samples;
    b.quotient_bits += 4 * 75 * c.blocks + 60 * c.samples;
    b.accesses += 2 * c.samples;
    return b;
}

inline Busy dequantize_by_hand(std::uint64_t steps, std::uint64_t pixels, unsigned passes) {
    return {(54 + 6 * passes) * steps + 3 * pixels, 8 * steps + pixels, 128 * steps,
            36 * steps + 2 * pixels};
}
inline Busy low_pass_by_hand(std::uint64_t pixels, unsigned passes) {
    return {12 * passes * pixels, 0, 0, 10 * passes * pixels};
}
inline Busy composite_by_hand(std::uint64_t pixels) {
    return {2 * pixels, 2 * pixels, 10 * pixels, 4 * pixels};
}

inline bool same(const hw::Operations& o, const Busy& b) {
    return o.adds == b.adds && o.passes == b.passes && o.quotient_bits == b.quotient_bits &&
           o.accesses == b.accesses;
}

}  // namespace umbra78::shadow::test
