#include "raster/census.hpp"

#include <algorithm>

namespace umbra78::raster {
namespace {

constexpr int block_scale = 4;
// A block of 4 x 4 is halved twice each way; once more each way is for what rounding adds.
constexpr std::uint64_t splits_of_such = 63;

void add_footprint(const Footprint& f, int size, Census& census) {
    for (int strip = f.y0 * Census::strips / size; strip < Census::strips; ++strip) {
        const int first = strip * size / Census::strips;
        const int end = (strip + 1) * size / Census::strips;
        if (first > f.y1) return;
        const int lines = std::min(f.y1 + 1, end) - std::max(f.y0, first);
        if (lines > 0)
            census.pixels[static_cast<std::size_t>(strip)] +=
                static_cast<std::uint64_t>(lines) * static_cast<std::uint64_t>(f.x1 - f.x0 + 1);
    }
}

}  // namespace

Census& Census::operator+=(const Census& more) {
    splits_suffice = splits_suffice && more.splits_suffice;
    for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k] += more.pixels[k];
    return *this;
}

Census take_census(std::span<const Patch> patches, const DrawSetup& setup, DrawMemory& memory) {
    Census census;
    DrawCounts counts;
    detail::BlockWalk walk(setup, memory, false, counts);
    for (const Patch& patch : patches) {
        walk.push_patch(patch);
        std::uint64_t splits = counts.splits, blocks = 0;
        ScreenBounds bounds;
        while (walk.next(bounds, block_scale)) {
            add_footprint(footprint(bounds, setup.spec), setup.spec.size_px(), census);
            ++blocks;
        }
        splits = counts.splits - splits + splits_of_such * blocks;
        census.splits_suffice = census.splits_suffice && splits < max_splits;
    }
    return census;
}

std::size_t cut_bands(const Census& census, const MachineSpec& spec, std::span<hw::Band> out) {
    std::uint64_t all = 0, seen = 0;
    for (const std::uint64_t n : census.pixels) all += n;
    const int size = spec.size_px();
    std::size_t bands = 0;
    int first = 0;
    for (int strip = 1; strip <= Census::strips; ++strip) {
        seen += census.pixels[static_cast<std::size_t>(strip - 1)];
        const int end = strip * size / Census::strips;
        if (end == first) continue;
        // Whether the strips so far have the share of the bands that would be closed.
        const bool full = all > 0 && seen * out.size() >= all * (bands + 1);
        if (strip < Census::strips && (!full || bands + 1 == out.size())) continue;
        out[bands++] = {first, end};
        first = end;
    }
    return bands;
}

}  // namespace umbra78::raster
