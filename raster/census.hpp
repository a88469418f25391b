// The census of a view's blocks: what Catmull's subdivision makes of the patches, without drawing.
//
// It is what a drawing that is shared out by bands of lines needs to know beforehand: how many
// blocks there are about each line, so that the bands can be cut to equal work; and what such a
// drawing cannot count itself, because a patch that lies in two bands is walked in both.
#pragma once

#include "raster/draw.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::raster {

struct BlockCensus {
    static constexpr int strips = 64;  // of size_px / 64 lines each, or of one

    DrawCounts counts;        // patches, tested_blocks, splits, and unresolved but for quotients
    bool cut_short = false;   // a patch has used up its splits: what is drawn of it depends on it
    std::array<std::uint32_t, strips> blocks{};  // by the strip of their middle line

    BlockCensus& operator+=(const BlockCensus& more);
};

// Of these patches in any order, by Catmull's subdivision.
BlockCensus count_blocks(std::span<const Patch> patches, const DrawSetup& setup,
                         DrawMemory& memory);

// Cuts a frame into bands of as many blocks each as its strips allow; returns how many there are,
// at most as many as `out` has, and at least one.
std::size_t cut_bands(const BlockCensus& census, const MachineSpec& spec, std::span<hw::Band> out);

}  // namespace umbra78::raster
