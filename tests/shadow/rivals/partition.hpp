// What the pieces of class 2 are asked by tests: whether they are a partition.
#pragma once

#include "tests/shadow/rivals/object_space.hpp"

#include <gtest/gtest.h>

namespace umbra78::shadow::rivals::test {

// How often a pixel was found in a piece; each pixel's own is lit as the mask has it.
inline std::uint64_t pixels_in_pieces(ObjectSpace& o, std::span<const std::uint32_t> shown) {
    const Setting& setting = o.lines().setting();
    const PieceStore& store = o.store();
    const auto mask = o.mask();
    std::vector<std::uint32_t> numbers(shown.size());
    std::vector<ShownLine> room(store.longest());
    MaskCounts counts;
    fixed::require(pieces_of_pixels(o.lines(), store, shown, room, numbers, counts),
                   "a test's room for a piece's lines");
    for (std::size_t at = 0; at < mask.size(); ++at) {
        const bool has_piece = numbers[at] != no_piece;
        EXPECT_EQ(has_piece, shown[at] != nothing_seen && !setting.attached(shown[at]));
        if (!has_piece) continue;
        EXPECT_EQ(store.pieces()[numbers[at]].is_lit, mask[at] == lit) << "pixel " << at;
        EXPECT_EQ(store.pieces()[numbers[at]].facet, shown[at]) << "pixel " << at;
    }
    return counts.pixels;
}

// How many pieces hold a pixel's point. In a partition it is one.
inline std::size_t pieces_at(const LightLines& lines, const PieceStore& store, std::uint32_t on,
                             std::size_t at) {
    const Space& space = lines.setting().space;
    const auto size = static_cast<std::size_t>(space.size_px());
    const std::int32_t px = space.centre(static_cast<int>(at % size));
    const std::int32_t py = space.centre(static_cast<int>(at / size));
    std::size_t count = 0;
    for (const Piece& piece : store.of(on)) {
        bool inside = true;
        for (const LineId id : store.lines(piece))
            inside = inside && lines.shown(on, id).sign_at(px, py) > 0;
        count += inside ? 1 : 0;
    }
    return count;
}

// Each of the pixels, of which every `step`-th is asked, is in one piece of the facet it shows.
inline void expect_partition(ObjectSpace& o, std::span<const std::uint32_t> shown,
                             std::size_t step) {
    for (std::size_t at = 0; at < shown.size(); at += step) {
        const std::uint32_t on = shown[at];
        if (on == nothing_seen || o.lines().setting().attached(on)) continue;
        ASSERT_EQ(pieces_at(o.lines(), o.store(), on, at), 1u) << "pixel " << at;
    }
}

}  // namespace umbra78::shadow::rivals::test
