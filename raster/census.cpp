#include "raster/census.hpp"

#include <algorithm>

namespace umbra78::raster {

BlockCensus& BlockCensus::operator+=(const BlockCensus& more) {
    counts += more.counts;
    cut_short = cut_short || more.cut_short;
    for (std::size_t k = 0; k < blocks.size(); ++k) blocks[k] += more.blocks[k];
    return *this;
}

BlockCensus count_blocks(std::span<const Patch> patches, const DrawSetup& setup,
                         DrawMemory& memory) {
    BlockCensus census;
    const int size = setup.spec.size_px();
    detail::BlockWalk walk(setup, memory, false, census.counts);
    for (const Patch& patch : patches) {
        walk.push_patch(patch);
        if (!setup.draws([&] { return walk.outside(); })) {
            walk.drop_patch();
            continue;
        }
        ++census.counts.patches;
        const std::uint64_t before = census.counts.splits;
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            const Footprint f = footprint(bounds, setup.spec);
            ++census.blocks[static_cast<std::size_t>((f.y0 + f.y1) / 2 * BlockCensus::strips /
                                                     size)];
        }
        census.cut_short = census.cut_short || census.counts.splits - before == max_splits;
    }
    return census;
}

std::size_t cut_bands(const BlockCensus& census, const MachineSpec& spec,
                      std::span<hw::Band> out) {
    std::uint64_t all = 0, seen = 0;
    for (const std::uint32_t n : census.blocks) all += n;
    const int size = spec.size_px();
    std::size_t bands = 0;
    int first = 0;
    for (int strip = 1; strip <= BlockCensus::strips; ++strip) {
        seen += census.blocks[static_cast<std::size_t>(strip - 1)];
        const int end = strip * size / BlockCensus::strips;
        if (end == first) continue;
        // Whether the strips so far have the share of the bands that would be closed.
        const bool full = all > 0 && seen * out.size() >= all * (bands + 1);
        if (strip < BlockCensus::strips && (!full || bands + 1 == out.size())) continue;
        out[bands++] = {first, end};
        first = end;
    }
    return bands;
}

}  // namespace umbra78::raster
