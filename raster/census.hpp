// The census of a view: about how much there is to draw on each line, without drawing it.
//
// A drawing that is shared out by bands of lines is cut by it to equal work. It walks Catmull's
// subdivision down to blocks of about 4 x 4 that will be drawn, an eighth of the whole tree.
#pragma once

#include "raster/draw.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::raster {

struct Census {
    static constexpr int strips = 64;  // of size_px / 64 lines each, or of one

    std::array<std::uint64_t, strips> pixels{};  // that the blocks' footprints have in a strip
    // No patch can use up its splits. Where one does, what is drawn of it depends on all of its
    // blocks that came before, and bands, which leave some of these out, would draw more.
    bool splits_suffice = true;

    Census& operator+=(const Census& more);
};

// Of these patches, in any order.
Census take_census(std::span<const Patch> patches, const DrawSetup& setup, DrawMemory& memory);

// Cuts a frame into bands with as much work each as its strips allow; returns how many there are,
// at most as many as `out` has, and at least one.
std::size_t cut_bands(const Census& census, const MachineSpec& spec, std::span<hw::Band> out);

}  // namespace umbra78::raster
