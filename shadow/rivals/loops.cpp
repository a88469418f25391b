#include "shadow/rivals/loops.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {

// --- lists ----------------------------------------------------------------------------------

std::size_t LoopList::bytes(const LoopSize& size) {
    Carver carver(static_cast<std::byte*>(nullptr));
    carver.take<Loop>(size.loops);
    carver.take<LoopSide>(size.sides);
    return carver.used();
}

LoopList::LoopList(std::span<std::byte> memory, const LoopSize& size) {
    Carver carver(memory);
    loops_ = carver.take<Loop>(size.loops);
    sides_ = carver.take<LoopSide>(size.sides);
    has_memory_ = carver.fits();
}

void LoopList::end_loop(std::uint32_t facet) {
    const std::size_t sides = count_.sides - start_;
    if (count_.loops < loops_.size())
        loops_[count_.loops] = {facet, static_cast<std::uint32_t>(start_),
                                static_cast<std::uint32_t>(sides)};
    ++count_.loops;
    longest_ = std::max(longest_, sides);
    start_ = count_.sides;
}

void LoopList::copy(const LoopList& from, const Loop& loop) {
    for (const LoopSide& s : from.sides().subspan(loop.first, loop.count))
        add(s.line, s.is_reflex);
    end_loop(loop.facet);
}

// --- memory ---------------------------------------------------------------------------------

std::size_t LoopClip::bytes(const ClipSize& size) {
    Carver carver(static_cast<std::byte*>(nullptr));
    for (int k = 0; k < 2; ++k) carver.take<std::byte>(LoopList::bytes(size.loops));
    carver.take<std::uint8_t>(size.loops.sides);
    carver.take<std::uint32_t>(size.loops.sides);
    carver.take<Crossing>(size.crossings);
    carver.take<std::uint32_t>(size.crossings);
    return carver.used();
}

LoopClip::LoopClip(std::span<std::byte> memory, const ClipSize& size) {
    Carver carver(memory);
    const std::size_t list = LoopList::bytes(size.loops);
    for (LoopList& l : loops_) {
        const auto room = carver.take<std::byte>(list);
        l = LoopList(room, size.loops);
    }
    signs_ = carver.take<std::uint8_t>(size.loops.sides);
    loop_of_ = carver.take<std::uint32_t>(size.loops.sides);
    crossings_ = carver.take<Crossing>(size.crossings);
    along_ = carver.take<std::uint32_t>(size.crossings);
    fits_ = carver.fits();
    needed_ = size;
}

bool LoopClip::note_need(const LoopList& list) {
    const LoopSize& n = list.count();
    needed_.loops = {std::max(needed_.loops.loops, n.loops),
                     std::max(needed_.loops.sides, n.sides)};
    needed_.crossings = std::max(needed_.crossings, crossing_count_);
    fits_ = fits_ && list.fits() && crossing_count_ <= crossings_.size();
    return fits_;
}

void LoopClip::begin(const LightLines& lines, std::uint32_t facet,
                     const std::array<LineId, 3>& outline) {
    lines_ = &lines;
    facet_ = facet;
    outline_ = outline;
    crossing_count_ = 0;
    LoopList& whole = loops_[turn_];
    whole.clear();
    for (const LineId line : outline) whole.add(line, false);
    whole.end_loop(facet);
    note_need(whole);
}

// --- signs ----------------------------------------------------------------------------------

// False if the template lies beyond a line of the facet itself, which the two share: what is lit
// is wholly on one side of such a line.
bool LoopClip::set_template(std::span<const LineId> sides) {
    template_ = sides;
    all_ = (1u << sides.size()) - 1;
    own_lines_ = 0;
    for (std::size_t j = 0; j < sides.size(); ++j) {
        for (const LineId own : outline_) {
            if (own == sides[j].turned()) return false;
            if (own == sides[j]) own_lines_ |= 1u << j;
        }
    }
    return true;
}

// Whether a loop's corner is inside a line of the template. On this line itself it is: a template
// is greater than its outline by the least of all infinitesimals, so that neighbours leave nothing
// between them.
bool LoopClip::is_inside(LineId edge, const LoopSide& side, LineId next,
                         ClipCounts& counts) const {
    if (edge.is_along(side.line) || edge.is_along(next)) return true;
    return (moved_sign(*lines_, side.line, next, edge, counts.moved) > 0) != side.is_reflex;
}

// Of a line at the point where a loop's line crosses a line of the template.
int LoopClip::sign_at(LineId loop_line, LineId edge, bool enters, LineId of,
                      ClipCounts& counts) const {
    return (enters ? -1 : 1) * moved_sign(*lines_, loop_line, edge, of, counts.moved);
}

// Writes a bit of each corner. False if all are outside.
bool LoopClip::find_signs(std::size_t edge, ClipCounts& counts) {
    bool any = false;
    const auto sides = lit().sides();
    for (const Loop& loop : lit().loops()) {
        for (std::uint32_t i = 0; i < loop.count; ++i) {
            const LineId next = sides[loop.first + (i + 1 < loop.count ? i + 1 : 0)].line;
            const bool is_in = is_inside(template_[edge], sides[loop.first + i], next, counts);
            signs_[loop.first + i] |= static_cast<std::uint8_t>((is_in ? 1u : 0u) << edge);
            any = any || is_in;
        }
        counts.corners += loop.count;
    }
    return any;
}

// False if all is outside one of the template's lines.
bool LoopClip::find_all_signs(ClipCounts& counts) {
    std::uint32_t number = 0;
    for (const Loop& loop : lit().loops()) {
        for (std::uint32_t i = loop.first; i < loop.first + loop.count; ++i) {
            signs_[i] = static_cast<std::uint8_t>(own_lines_);
            loop_of_[i] = number;
        }
        ++number;
    }
    for (std::size_t j = 0; j < template_.size(); ++j)
        if ((own_lines_ >> j & 1) == 0 && !find_signs(j, counts)) return false;
    return true;
}

// --- crossings ------------------------------------------------------------------------------

// A side enters a convex template at one point at most, and leaves it after that.
void LoopClip::cross_side(std::uint32_t side, std::uint32_t before, ClipCounts& counts) {
    const std::uint32_t from = signs_[before], to = signs_[side], changed = from ^ to;
    if ((from | to) != all_) return;
    const LineId line = lit().sides()[side].line;
    for (const bool enters : {true, false}) {
        for (std::size_t j = 0; j < template_.size(); ++j) {
            if (((enters ? to : from) & changed & 1u << j) == 0) continue;
            bool is_on_template = true;
            for (std::size_t k = 0; k < template_.size(); ++k)
                if (k != j && (changed >> k & 1) != 0 && is_on_template)
                    is_on_template =
                        sign_at(line, template_[j], enters, template_[k], counts) > 0;
            if (!is_on_template) continue;
            if (crossing_count_ < crossings_.size())
                crossings_[crossing_count_] = {side, 0, 0, static_cast<std::uint8_t>(j), enters,
                                               false};
            ++crossing_count_;
        }
    }
}

void LoopClip::find_crossings(ClipCounts& counts) {
    crossing_count_ = 0;
    for (const Loop& loop : lit().loops()) {
        const std::size_t first = crossing_count_;
        for (std::uint32_t i = 0; i < loop.count; ++i)
            cross_side(loop.first + i, loop.first + (i == 0 ? loop.count : i) - 1, counts);
        if (crossing_count_ > crossings_.size()) continue;
        for (std::size_t c = first; c < crossing_count_; ++c)
            crossings_[c].next =
                static_cast<std::uint32_t>(c + 1 < crossing_count_ ? c + 1 : first);
    }
    counts.crossings += crossing_count_;
}

// Along the template's side, with its inside on the same hand as a loop's.
bool LoopClip::comes_before(const Crossing& a, const Crossing& b, ClipCounts& counts) const {
    if (a.edge != b.edge) return a.edge < b.edge;
    ++counts.compares;
    const auto sides = lit().sides();
    const int s = sign_at(sides[a.side].line, template_[a.edge], a.enters, sides[b.side].line,
                          counts);
    return (s > 0) == b.enters;  // where a side enters, the template leaves what is lit
}

void LoopClip::sort_along_template(ClipCounts& counts) {
    const auto along = along_.first(crossing_count_);
    for (std::size_t c = 0; c < along.size(); ++c) {
        std::size_t k = c;
        for (; k > 0 && comes_before(crossings_[c], crossings_[along[k - 1]], counts); --k)
            along[k] = along[k - 1];
        along[k] = static_cast<std::uint32_t>(c);
    }
    for (std::size_t k = 0; k < along.size(); ++k)
        crossings_[along[k]].place = static_cast<std::uint32_t>(k);
}

// Whether a template that crosses nothing is within what is lit: its first corner is within the
// facet, and a ray from there along its first line crosses the loops an odd number of times.
bool LoopClip::is_template_inside(ClipCounts& counts) const {
    if (own_lines_ != 0) return false;
    const LineId t0 = template_[0], t1 = template_[1];
    for (const LineId own : outline_)
        if (moved_sign(*lines_, t0, t1, own, counts.moved) < 0) return false;
    bool is_inside = false;
    for (const Loop& loop : lit().loops()) {
        std::uint32_t before = loop.first + loop.count - 1;
        for (std::uint32_t i = loop.first; i < loop.first + loop.count; before = i++) {
            const bool enters = (signs_[i] & 1) != 0;
            const LineId line = lit().sides()[i].line;
            if (((signs_[before] & 1) != 0) == enters || t1.is_along(line)) continue;
            if (sign_at(line, t0, enters, t1, counts) < 0) is_inside = !is_inside;
        }
    }
    return is_inside;
}

// --- what is left ---------------------------------------------------------------------------

// Loops that cross nothing stay if they are outside the template. True if one was inside.
bool LoopClip::write_whole_loops(LoopList& out, ClipCounts& counts) const {
    bool any_inside = false;
    std::size_t c = 0;
    for (const Loop& loop : lit().loops()) {
        const std::size_t first = c;
        while (c < crossing_count_ && crossings_[c].side < loop.first + loop.count) ++c;
        if (c > first) continue;
        const bool is_inside = signs_[loop.first] == all_;
        any_inside = any_inside || is_inside;
        counts.inside += is_inside ? 1 : 0;
        if (!is_inside) out.copy(lit(), loop);
    }
    return any_inside;
}

// From where a loop enters the template, backward along it, to where it leaves it.
std::uint32_t LoopClip::walk_template(LoopList& out, std::uint32_t from) const {
    const Crossing& start = crossings_[from];
    const std::uint32_t to = along_[(start.place == 0 ? crossing_count_ : start.place) - 1];
    const Crossing& end = crossings_[to];
    fixed::require(!end.enters, "crossings along a template do not alternate");
    const std::size_t sides = template_.size();
    std::size_t steps = (start.edge + sides - end.edge) % sides, edge = start.edge;
    if (steps == 0 && end.place > start.place) steps = sides;
    for (; steps > 0; --steps) {
        out.add(template_[edge].turned(), true);
        edge = (edge == 0 ? sides : edge) - 1;
    }
    out.add(template_[edge].turned(), false);
    return to;
}

// From where a loop leaves the template to where it enters it again.
std::uint32_t LoopClip::walk_loop(LoopList& out, std::uint32_t from) const {
    const Crossing& start = crossings_[from];
    const Crossing& end = crossings_[start.next];
    fixed::require(end.enters, "crossings along a loop do not alternate");
    const Loop& loop = lit().loops()[loop_of_[start.side]];
    std::uint32_t i = start.side;
    do {
        const LoopSide& side = lit().sides()[i];
        out.add(side.line, side.is_reflex);
        i = i + 1 < loop.first + loop.count ? i + 1 : loop.first;
    } while (i != end.side);
    out.add(lit().sides()[i].line, false);
    return start.next;
}

// Whether all corners are on one of a loop's own lines, which are not moved: then it has no area.
bool LoopClip::is_flat(std::span<const LoopSide> loop, ClipCounts& counts) const {
    for (const LoopSide& on : loop) {
        bool all_on = true;
        for (std::size_t i = 0; i < loop.size() && all_on; ++i) {
            const LineId a = loop[i].line, b = loop[i + 1 < loop.size() ? i + 1 : 0].line;
            all_on = on.line.is_along(a) || on.line.is_along(b) ||
                     lines_->sign(a, b, on.line, counts.moved.signs) == 0;
        }
        if (all_on) return true;
    }
    return false;
}

void LoopClip::walk(LoopList& out, std::uint32_t first, ClipCounts& counts) {
    ++counts.walks;
    std::uint32_t at = first;
    do {
        crossings_[at].was_walked = true;
        at = walk_loop(out, walk_template(out, at));
    } while (at != first);
    if (out.fits() && is_flat(out.begun(), counts)) {
        ++counts.flat;
        out.drop();
    } else {
        out.end_loop(facet_);
    }
}

bool LoopClip::take_away(std::span<const LineId> sides, ClipCounts& counts) {
    ++counts.clips;
    if (!set_template(sides) || !find_all_signs(counts)) return false;
    find_crossings(counts);
    LoopList& out = loops_[1 - turn_];
    out.clear();
    if (!note_need(lit())) return false;
    sort_along_template(counts);
    const bool is_less = write_whole_loops(out, counts);
    for (std::uint32_t c = 0; c < crossing_count_; ++c) {
        if (crossings_[c].enters && !crossings_[c].was_walked) walk(out, c, counts);
    }
    const bool is_hole = crossing_count_ == 0 && is_template_inside(counts);
    if (is_hole) {
        ++counts.holes;
        for (std::size_t j = sides.size(); j > 0; --j) out.add(sides[j - 1].turned(), true);
        out.end_loop(facet_);
    }
    if (!note_need(out) || (!is_less && !is_hole && crossing_count_ == 0)) return false;
    ++counts.changed;
    turn_ = 1 - turn_;
    return true;
}

}  // namespace umbra78::shadow::rivals
