// Footprints merged by two: facets with a common edge whose outlines are convex together, in the
// light's picture. Their edge inside is dropped, and one outline of four lines takes the place of
// two of three. It is a choice of those who clip (perimeters.hpp), and changes no mask.
//
// Both facets lie on one side each of the edge as the light sees it: with outlines (a, b, e) and
// (c, d, e turned around) the outline of both is (a, b, c, d). It is convex if the corner of c and
// d is strictly inside a and b. A facet is in one pair at most; pairs are made by the facets'
// numbers and then their sides.
#pragma once

#include "shadow/rivals/light_lines.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

class FootprintPairs {
public:
    static constexpr std::uint32_t none = UINT32_MAX;

    static std::size_t bytes(std::size_t facets);
    // No facet has a partner.
    FootprintPairs() = default;
    // False if the memory is too small.
    bool make(const LightLines& lines, std::span<std::byte> memory, SignCounts& counts);

    std::uint32_t partner(std::uint32_t facet) const {
        return partners_.empty() ? none : partners_[facet];
    }
    // Of both, for either of them.
    std::span<const LineId> outline(std::uint32_t facet) const {
        return outlines_[std::min(facet, partners_[facet])];
    }
    std::size_t pairs() const { return pairs_; }

    // Whether the facet was taken with its partner in this turn.
    bool is_taken(std::uint32_t facet, std::uint32_t turn) const { return taken_[facet] == turn; }
    void take(std::uint32_t facet, std::uint32_t turn) { taken_[facet] = turn; }

private:
    bool join(const LightLines& lines, std::uint32_t f, std::size_t side, std::uint32_t g,
              SignCounts& counts);

    std::span<std::uint32_t> partners_, taken_;
    std::span<std::array<LineId, 4>> outlines_;
    std::size_t pairs_ = 0;
};

}  // namespace umbra78::shadow::rivals
