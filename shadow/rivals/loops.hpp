// Polygons that may be concave and have holes, as loops of lines, and how a convex one is taken
// away from them (Weiler & Atherton 1977, "Hidden surface removal using polygon area sorting").
//
// A loop is a cyclic list of lines with the polygon on their insides; where two successive ones
// meet is a corner, at which the polygon is convex or reflex. So that of lines p and q is at p x q,
// or, where it is reflex, at q x p: it has no coordinates. Outer loops and holes differ in nothing.
#pragma once

#include "shadow/rivals/moved_lines.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct LoopSide {
    LineId line;
    bool is_reflex;  // the corner with the next side
};

struct Loop {
    std::uint32_t facet, first, count;  // sides [first, first + count)
};

struct LoopSize {
    std::size_t loops = 0, sides = 0;
};

// Loops while they are written. What does not fit is counted.
class LoopList {
public:
    static std::size_t bytes(const LoopSize& size);
    LoopList() = default;
    LoopList(std::span<std::byte> memory, const LoopSize& size);

    void clear() { count_ = {}, start_ = longest_ = 0; }
    void add(LineId line, bool is_reflex) {
        if (count_.sides < sides_.size()) sides_[count_.sides] = {line, is_reflex};
        ++count_.sides;
    }
    void end_loop(std::uint32_t facet);
    std::span<const LoopSide> begun() const { return sides().subspan(start_); }
    void drop() { count_.sides = start_; }  // what was begun
    void copy(const LoopList& from, const Loop& loop);

    bool fits() const {
        return has_memory_ && count_.loops <= loops_.size() && count_.sides <= sides_.size();
    }
    const LoopSize& count() const { return count_; }
    std::size_t longest() const { return longest_; }
    std::span<const Loop> loops() const { return loops_.first(count_.loops); }
    std::span<const LoopSide> sides() const { return sides_.first(count_.sides); }

private:
    std::span<Loop> loops_;
    std::span<LoopSide> sides_;
    LoopSize count_{};
    std::size_t start_ = 0, longest_ = 0;
    bool has_memory_ = false;
};

struct ClipSize {
    LoopSize loops;             // of one facet, while it is clipped
    std::size_t crossings = 0;  // of its sides and one template's
};

struct ClipCounts {
    std::uint64_t clips = 0;      // of what is lit of a facet by a template
    std::uint64_t corners = 0;    // that were asked for their side of a template's line
    std::uint64_t changed = 0;    // clips after which less was lit
    std::uint64_t crossings = 0;  // of the loops and the templates
    std::uint64_t compares = 0;   // of two crossings along a template's side
    std::uint64_t walks = 0;      // loops that were walked
    std::uint64_t flat = 0;       // of them, that have no area before the lines are moved
    std::uint64_t holes = 0;      // templates that were wholly within what was lit
    std::uint64_t inside = 0;     // loops that were wholly within a template
    MovedCounts moved;
};

inline constexpr std::size_t most_template_sides = 4;

// What is lit of one facet while templates are taken away from it.
class LoopClip {
public:
    static std::size_t bytes(const ClipSize& size);
    LoopClip() = default;
    LoopClip(std::span<std::byte> memory, const ClipSize& size);

    void begin(const LightLines& lines, std::uint32_t facet, const std::array<LineId, 3>& outline);
    // Takes away a convex polygon of another facet. False if that changed nothing, or there is no
    // room.
    bool take_away(std::span<const LineId> sides, ClipCounts& counts);
    const LoopList& lit() const { return loops_[turn_]; }
    bool is_dark() const { return lit().count().loops == 0; }

    // False once something did not fit. Then needed() is what would have let it go on.
    bool fits() const { return fits_; }
    const ClipSize& needed() const { return needed_; }

private:
    struct Crossing {
        std::uint32_t side;         // of the loop
        std::uint32_t next, place;  // the next crossing of the loop; the place on the template
        std::uint8_t edge;          // of the template
        bool enters, was_walked;
    };
    bool set_template(std::span<const LineId> sides);
    bool is_inside(LineId edge, const LoopSide& side, LineId next, ClipCounts& counts) const;
    int sign_at(LineId loop_line, LineId edge, bool enters, LineId of, ClipCounts& counts) const;
    bool find_signs(std::size_t edge, ClipCounts& counts);
    bool find_all_signs(ClipCounts& counts);
    void find_crossings(ClipCounts& counts);
    void cross_side(std::uint32_t side, std::uint32_t before, ClipCounts& counts);
    bool comes_before(const Crossing& a, const Crossing& b, ClipCounts& counts) const;
    void sort_along_template(ClipCounts& counts);
    bool is_template_inside(ClipCounts& counts) const;
    bool write_whole_loops(LoopList& out, ClipCounts& counts) const;
    std::uint32_t walk_template(LoopList& out, std::uint32_t from) const;
    std::uint32_t walk_loop(LoopList& out, std::uint32_t from) const;
    bool is_flat(std::span<const LoopSide> loop, ClipCounts& counts) const;
    void walk(LoopList& out, std::uint32_t first, ClipCounts& counts);
    bool note_need(const LoopList& list);

    const LightLines* lines_ = nullptr;
    std::uint32_t facet_ = 0;
    std::array<LineId, 3> outline_{};
    std::array<LoopList, 2> loops_;
    std::size_t turn_ = 0;
    std::span<std::uint8_t> signs_;     // of each side's corner: a bit for each line it is inside
    std::span<std::uint32_t> loop_of_;  // of each side: its loop
    std::span<Crossing> crossings_;
    std::span<std::uint32_t> along_;  // the crossings along the template
    std::size_t crossing_count_ = 0;
    std::span<const LineId> template_;
    std::uint32_t own_lines_ = 0, all_ = 0;  // bits of the template's lines
    ClipSize needed_{};
    bool fits_ = true;
};

}  // namespace umbra78::shadow::rivals
