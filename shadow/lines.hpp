// A set of scan lines, a bit each: the lines on which a pass over a frame has work to do.
//
// The machine notes such bits as it writes a plane: which lines of the observer's store hold a
// visible pixel, and which lines of the mask a shadow. A pass then leaves the other lines out.
#pragma once

#include "hw/band.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

class LineSet {
public:
    static constexpr int max_lines = 4096;

    // Of a frame of `size` lines, none of them in the set.
    explicit LineSet(int size = 0) : size_(std::clamp(size, 0, max_lines)) {}
    static LineSet all(int size) {
        LineSet set(size);
        for (int y = 0; y < set.size(); ++y) set.add(y);
        return set;
    }

    // All lines of a frame of 2^xy_bits; of none for bits that no machine has, which the pass over
    // such a frame refuses.
    static LineSet of_frame(int xy_bits) {
        return all(xy_bits < 0 || (1 << std::min(xy_bits, 30)) > max_lines ? 0 : 1 << xy_bits);
    }

    int size() const { return size_; }
    bool has(int y) const { return (word(y) >> (y % 64) & 1u) != 0; }
    void add(int y) { word(y) |= std::uint64_t{1} << (y % 64); }
    std::uint64_t count() const {
        int n = 0;
        for (const std::uint64_t w : words_) n += std::popcount(w);
        return static_cast<std::uint64_t>(n);
    }
    // Those of a band alone.
    LineSet within(const hw::Band& band) const {
        LineSet part(size_);
        for (int y = std::max(band.first, 0); y < std::min(band.end, size_); ++y)
            if (has(y)) part.add(y);
        return part;
    }
    // These lines and those next to them.
    LineSet with_neighbours() const {
        LineSet grown(size_);
        for (int y = 0; y < size_; ++y)
            if (has(y) || (y > 0 && has(y - 1)) || (y + 1 < size_ && has(y + 1))) grown.add(y);
        return grown;
    }

private:
    const std::uint64_t& word(int y) const { return words_[static_cast<std::size_t>(y) / 64]; }
    std::uint64_t& word(int y) { return words_[static_cast<std::size_t>(y) / 64]; }

    int size_;
    std::array<std::uint64_t, max_lines / 64> words_{};
};

// The lines of a mask that are not lit from end to end. A frame has at least 16 pixels a side, so
// the compiler may look at as many at once.
inline LineSet lines_with_shadow(std::span<const std::uint8_t> mask, int size) {
    LineSet lines(size);
    const auto n = static_cast<std::size_t>(size);
    for (int y = 0; y < size; ++y) {
        const std::uint8_t* line = mask.data() + static_cast<std::size_t>(y) * n;
        std::array<std::uint8_t, 16> any{};
        for (std::size_t x = 0; x + 16 <= n; x += 16)
            for (std::size_t k = 0; k < 16; ++k) any[k] |= line[x + k];
        if (any != std::array<std::uint8_t, 16>{}) lines.add(y);
    }
    return lines;
}

// Whether something is visible on a line of Z codes.
template <class Depth>
bool has_visible(std::span<const Depth> line, std::uint32_t background) {
    return std::ranges::any_of(line, [&](Depth code) { return code != background; });
}

// Of at most 64 codes: bit k says whether code k is visible.
template <class Depth>
std::uint64_t drawn_of_64(std::span<const Depth> codes, Depth background) {
    std::uint64_t drawn = 0;
    for (std::size_t k = 0; k < codes.size(); ++k)
        drawn |= std::uint64_t{codes[k] != background} << k;
    return drawn;
}

// The lines of a plane of Z codes with something visible.
template <class Depth>
LineSet lines_with_visible(std::span<const Depth> depth, int size, std::uint32_t background) {
    LineSet lines(size);
    const auto n = static_cast<std::size_t>(size);
    for (int y = 0; y < size; ++y) {
        if (has_visible<Depth>(depth.subspan(static_cast<std::size_t>(y) * n, n), background))
            lines.add(y);
    }
    return lines;
}

}  // namespace umbra78::shadow
