// The facets that may shadow a facet: first by their boxes in the light's picture, then by sides.
//
// A facet F that lies before a point of R, on the ray from the light, is there strictly on the
// light's side of R's plane. So if no corner of F is on that side F shadows nothing of R; if all
// are on it or on the plane, whatever of R is behind F's outline is in F's shadow. Likewise if all
// corners of R are on the side of F's plane that is away from the light, or on it; and if none is
// away, nothing is. Else both cross the other's plane, and the line where the planes meet parts
// what is before from what is behind (the tests of planes of Newell, Newell & Sancha 1972).
#pragma once

#include "shadow/rivals/light_grid.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// Whether a facet lies before another where their pictures overlap.
enum class Before : std::uint8_t {
    no,
    yes,
    partly,  // on one side of the line where the planes meet
};
Before before(const Setting& setting, std::uint32_t f, std::uint32_t on);

// How far a facet's nearest corner is from the light, as a number that grows with the distance.
std::int64_t nearest_depth(const Setting& setting, std::uint32_t facet);

struct CasterCounts {
    std::uint64_t boxes = 0;    // pairs of facets whose boxes were compared
    std::uint64_t planes = 0;   // of them, that overlap: asked for sides of planes
    std::uint64_t casters = 0;  // of them, that lie before
    std::uint64_t partly = 0;   // of these, on one side of a meeting line
};

class Casters {
public:
    // `marks` has a number for each facet.
    Casters(const Setting& setting, const LightGrid& grid, std::span<std::uint32_t> marks)
        : setting_(setting), grid_(grid), marks_(marks) {
        std::fill(marks_.begin(), marks_.end(), 0u);
    }

    // visit(f) of each facet that casts and whose box overlaps that of `on`, once, until it returns
    // false.
    template <class Visit>
    void for_near(std::uint32_t on, Visit&& visit) {
        ++mark_;
        bool going = true;
        for (int face = 0; face < grid_.picture().faces() && going; ++face) {
            LightBox box{}, other{};
            if (!grid_.picture().box(setting_.mesh.corners(on), face, box)) continue;
            grid_.for_cells(box, [&](std::size_t cell) {
                for (const std::uint32_t f : grid_.facets_in(cell)) {
                    if (!going) return;
                    if (f == on || marks_[f] == mark_) continue;
                    ++counts_.boxes;
                    if (!grid_.picture().box(setting_.mesh.corners(f), face, other) ||
                        !other.overlaps(box))
                        continue;
                    marks_[f] = mark_;
                    going = visit(f);
                }
            });
        }
    }
    // visit(f, Before) of those that lie before `on`.
    template <class Visit>
    void for_each(std::uint32_t on, Visit&& visit) {
        for_near(on, [&](std::uint32_t f) {
            const Before b = ask(f, on);
            return b == Before::no || visit(f, b);
        });
    }
    Before ask(std::uint32_t f, std::uint32_t on) {
        const Before b = before(setting_, f, on);
        ++counts_.planes;
        counts_.casters += b != Before::no ? 1 : 0;
        counts_.partly += b == Before::partly ? 1 : 0;
        return b;
    }
    const CasterCounts& counts() const { return counts_; }

private:
    const Setting& setting_;
    const LightGrid& grid_;
    std::span<std::uint32_t> marks_;
    std::uint32_t mark_ = 0;
    CasterCounts counts_{};
};

}  // namespace umbra78::shadow::rivals
