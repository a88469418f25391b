// The order of the facets from the light: none hides a part of one before it (after Newell, Newell
// & Sancha 1972, "A Solution to the Hidden Surface Problem").
//
// A fragment is a facet or a piece of one. A hides B if they have a point of the picture in common
// where A is nearer; asked in the order of cost: are they in the order already, do the boxes
// overlap, do the facets' corners lie on sides of planes that decide it, have the outlines anything
// in common, and, if both cross the other's plane, is any of it beyond A's plane. All are exact,
// so there is no order but where there must be.
//
// The facets are taken by their nearest corner. Before one is placed, those that hide a part of it
// are, which a stack remembers. If such a one, A, is on the stack already there is a cycle: A
// hides B, which hides ..., which hides A. Then one of the others crosses A's plane: a fragment
// that does not, and is hidden by one that lies beyond the plane or on it, lies beyond it, so if
// none crossed it all would, but the last hides A and has points before it. The first such
// fragment, from the top of the stack, is cut in two by A's plane, and the stack goes back to
// before it. Each cut is by the plane of a facet, of which there are finitely many, so this ends.
#pragma once

#include "shadow/rivals/casters.hpp"
#include "shadow/rivals/pieces.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

enum class Placing : std::uint8_t { waiting, on_stack, placed };

struct Fragment {
    std::uint32_t facet, first, count;  // lines [first, first + count)
    std::uint32_t next;                 // of its facet; none: UINT32_MAX
    Placing placing;
    bool joined;  // for perimeters: it is a footprint
};

struct FragmentSize {
    std::size_t fragments = 0, lines = 0;
    std::size_t room = 0;  // lines, for two pieces while they are compared
};

struct OrderCounts {
    std::uint64_t scans = 0;     // of fragments: for one that hides it and is not placed
    std::uint64_t asked = 0;     // pairs of fragments, past boxes and sides of planes
    std::uint64_t hides = 0;     // of them, where one hides the other
    std::uint64_t cycles = 0;    // each cut one fragment in two
    std::uint64_t deepest = 0;   // of the stack
    CutCounts cuts;
};

enum class OrderStatus : std::uint8_t {
    ok,
    no_room,      // for fragments or their lines: needed() would have let it go on
    no_meetings,  // for meeting lines: LightLines' meetings_needed() would have let it go on
};

class LightOrder {
public:
    static std::size_t bytes(const FragmentSize& size, std::size_t facets);
    LightOrder() = default;
    LightOrder(std::span<std::byte> memory, const FragmentSize& size, std::size_t facets);

    OrderStatus make(LightLines& lines, Casters& casters, OrderCounts& counts);

    // Fragments, the nearest first.
    std::span<const std::uint32_t> order() const { return order_.first(placed_); }
    // Of each facet the place of its nearest fragment in the order; none if it was not placed.
    void rank_facets(std::span<std::uint32_t> ranks) const;
    Fragment& at(std::uint32_t fragment) { return fragments_[fragment]; }
    std::uint32_t first_of(std::uint32_t facet) const { return heads_[facet]; }
    std::span<const LineId> lines(const Fragment& f) const {
        return lines_.subspan(f.first, f.count);
    }
    // What was given, or more that would have let it go on.
    const FragmentSize& needed() const { return needed_; }

    static constexpr std::uint32_t none = UINT32_MAX;

private:
    struct Pass;  // the lines, casters and counts of one make()

    bool start(Pass& pass);
    bool add(std::uint32_t facet, std::span<const LineId> outline);
    bool room_for(std::size_t fragments, std::size_t lines, std::size_t room);
    bool place(Pass& pass, std::uint32_t fragment);
    std::uint32_t find_hiding(Pass& pass, std::uint32_t b);
    bool hides(Pass& pass, const Fragment& a, const Fragment& b, Before before);
    bool break_cycle(Pass& pass, std::uint32_t a);
    bool cut_fragment(Pass& pass, std::uint32_t t, std::uint32_t by);

    std::span<Fragment> fragments_;
    std::span<LineId> lines_, room_;
    std::span<std::uint32_t> order_, stack_, heads_, by_depth_;
    std::span<std::int64_t> depths_;
    std::size_t used_ = 0, used_lines_ = 0, placed_ = 0, depth_ = 0;
    FragmentSize needed_{};
    bool fits_ = true;
};

}  // namespace umbra78::shadow::rivals
