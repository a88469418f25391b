#include "shadow/rivals/light_order.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {

struct LightOrder::Pass {
    LightLines& lines;
    Casters& casters;
    OrderCounts& counts;
    bool has_meetings = true;
};

namespace {

struct OrderSpans {
    std::span<Fragment> fragments;
    std::span<LineId> lines, room;
    std::span<std::uint32_t> order, stack, heads, by_depth;
    std::span<std::int64_t> depths;
};

OrderSpans lay_out(Carver& carver, const FragmentSize& size, std::size_t facets) {
    return {carver.take<Fragment>(size.fragments),
            carver.take<LineId>(size.lines),
            carver.take<LineId>(size.room),
            carver.take<std::uint32_t>(size.fragments),
            carver.take<std::uint32_t>(size.fragments),
            carver.take<std::uint32_t>(facets),
            carver.take<std::uint32_t>(facets),
            carver.take<std::int64_t>(facets)};
}

}  // namespace

std::size_t LightOrder::bytes(const FragmentSize& size, std::size_t facets) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, size, facets);
    return carver.used();
}

LightOrder::LightOrder(std::span<std::byte> memory, const FragmentSize& size,
                       std::size_t facets) {
    Carver carver(memory);
    const OrderSpans s = lay_out(carver, size, facets);
    fits_ = carver.fits();
    needed_ = size;
    fragments_ = s.fragments, lines_ = s.lines, room_ = s.room;
    order_ = s.order, stack_ = s.stack, heads_ = s.heads, by_depth_ = s.by_depth;
    depths_ = s.depths;
}

// --- fragments ------------------------------------------------------------------------------

bool LightOrder::room_for(std::size_t fragments, std::size_t lines, std::size_t room) {
    needed_ = {std::max(needed_.fragments, fragments), std::max(needed_.lines, lines),
               std::max(needed_.room, room)};
    fits_ = fits_ && fragments <= fragments_.size() && lines <= lines_.size() &&
            room <= room_.size();
    return fits_;
}

// Goes on counting where there is no room, so that what the facets themselves take is known.
bool LightOrder::add(std::uint32_t facet, std::span<const LineId> outline) {
    const std::size_t index = used_++, first = used_lines_;
    used_lines_ += outline.size();
    if (!room_for(used_, used_lines_, 0)) return false;
    std::copy(outline.begin(), outline.end(),
              lines_.begin() + static_cast<std::ptrdiff_t>(first));
    fragments_[index] = {facet, static_cast<std::uint32_t>(first),
                         static_cast<std::uint32_t>(outline.size()), heads_[facet],
                         Placing::waiting, false};
    heads_[facet] = static_cast<std::uint32_t>(index);
    return true;
}

bool LightOrder::start(Pass& pass) {
    const Setting& setting = pass.lines.setting();
    used_ = used_lines_ = placed_ = depth_ = 0;
    std::fill(heads_.begin(), heads_.end(), none);
    for (std::uint32_t f = 0; f < setting.mesh.facets.size(); ++f)
        if (setting.light.sides[f] != 0) add(f, pass.lines.outline(f, pass.counts.cuts.signs));
    if (!fits_) return false;
    for (std::uint32_t f = 0; f < by_depth_.size(); ++f) {
        by_depth_[f] = f;
        depths_[f] = nearest_depth(setting, f);
    }
    std::sort(by_depth_.begin(), by_depth_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return depths_[a] != depths_[b] ? depths_[a] < depths_[b] : a < b;
    });
    return true;
}

// --- the order ------------------------------------------------------------------------------

bool LightOrder::hides(Pass& pass, const Fragment& a, const Fragment& b, Before before) {
    ++pass.counts.asked;
    std::span<const LineId> common;
    bool fits = true, result =
        common_part(pass.lines, lines(b), lines(a), room_, common, fits, pass.counts.cuts);
    // A footprint's line adds a line at most.
    if (!fits) room_for(0, 0, 2 * (a.count + b.count));
    if (result && before == Before::partly) {
        const std::size_t meetings = pass.lines.meetings();
        const LineId line = pass.lines.meeting(b.facet, a.facet,
                                               -pass.lines.setting().light.sides[a.facet]);
        pass.has_meetings = pass.lines.fits();
        LineList inside{}, outside{};
        result = pass.has_meetings && cut(pass.lines, common, line, inside, outside,
                                          pass.counts.cuts) != Part::outside;
        pass.lines.release(meetings);
    }
    pass.counts.hides += result ? 1 : 0;
    return result;
}

// A fragment that hides a part of b and is not placed.
std::uint32_t LightOrder::find_hiding(Pass& pass, std::uint32_t b) {
    ++pass.counts.scans;
    std::uint32_t found = none;
    const std::uint32_t on = fragments_[b].facet;
    const auto waits = [&](std::uint32_t a) { return fragments_[a].placing != Placing::placed; };
    pass.casters.for_near(on, [&](std::uint32_t f) {
        std::uint32_t a = heads_[f];
        while (a != none && !waits(a)) a = fragments_[a].next;
        if (a == none) return true;
        const Before before = pass.casters.ask(f, on);
        if (before == Before::no) return true;
        for (; a != none && found == none; a = fragments_[a].next)
            if (waits(a) && hides(pass, fragments_[a], fragments_[b], before)) found = a;
        return found == none && fits_ && pass.has_meetings;
    });
    return found;
}

// Cuts a fragment by the plane of `by`; its nearer part keeps its number. False if it has one part.
bool LightOrder::cut_fragment(Pass& pass, std::uint32_t t, std::uint32_t by) {
    const std::size_t meetings = pass.lines.meetings();
    const Fragment whole = fragments_[t];
    const LineId line = pass.lines.meeting(whole.facet, by, pass.lines.setting().light.sides[by]);
    pass.has_meetings = pass.lines.fits();
    if (!pass.has_meetings) return false;
    LineList near{room_.first(room_.size() / 2)}, far{room_.subspan(room_.size() / 2)};
    if (cut(pass.lines, lines(whole), line, near, far, pass.counts.cuts) != Part::both) {
        pass.lines.release(meetings);
        return false;
    }
    if (!room_for(used_ + 1, used_lines_ + near.count + far.count,
                  2 * std::max(near.count, far.count)))
        return false;
    add(whole.facet, far.lines());
    const std::size_t first = used_lines_;
    used_lines_ += near.count;
    std::copy_n(near.room.begin(), near.count,
                lines_.begin() + static_cast<std::ptrdiff_t>(first));
    Fragment& part = fragments_[t];
    part.first = static_cast<std::uint32_t>(first);
    part.count = static_cast<std::uint32_t>(near.count);
    return true;
}

// `a` is on the stack and hides what is on its top.
bool LightOrder::break_cycle(Pass& pass, std::uint32_t a) {
    ++pass.counts.cycles;
    for (std::size_t i = depth_; stack_[--i] != a;) {
        if (cut_fragment(pass, stack_[i], fragments_[a].facet)) {
            for (; depth_ > i; --depth_)
                fragments_[stack_[depth_ - 1]].placing = Placing::waiting;
            return true;
        }
        if (!fits_ || !pass.has_meetings) return false;
    }
    fixed::require(false, "light order: a cycle without a fragment that crosses the plane");
    return false;
}

bool LightOrder::place(Pass& pass, std::uint32_t fragment) {
    const auto push = [&](std::uint32_t f) {
        stack_[depth_++] = f;
        fragments_[f].placing = Placing::on_stack;
        pass.counts.deepest = std::max<std::uint64_t>(pass.counts.deepest, depth_);
    };
    push(fragment);
    while (depth_ > 0) {
        const std::uint32_t top = stack_[depth_ - 1];
        const std::uint32_t hiding = find_hiding(pass, top);
        if (!fits_ || !pass.has_meetings) return false;
        if (hiding == none) {
            fragments_[top].placing = Placing::placed;
            order_[placed_++] = top;
            --depth_;
        } else if (fragments_[hiding].placing == Placing::waiting) {
            push(hiding);
        } else if (!break_cycle(pass, hiding)) {
            return false;
        }
    }
    return true;
}

OrderStatus LightOrder::make(LightLines& lines, Casters& casters, OrderCounts& counts) {
    Pass pass{lines, casters, counts};
    if (!start(pass)) return OrderStatus::no_room;
    for (const std::uint32_t facet : by_depth_) {
        // A fragment's later parts come first in the list.
        for (std::uint32_t f = heads_[facet]; f != none;) {
            if (fragments_[f].placing == Placing::placed) {
                f = fragments_[f].next;
                continue;
            }
            if (!place(pass, f))
                return pass.has_meetings ? OrderStatus::no_room : OrderStatus::no_meetings;
            f = heads_[facet];
        }
    }
    return OrderStatus::ok;
}

void LightOrder::rank_facets(std::span<std::uint32_t> ranks) const {
    std::fill(ranks.begin(), ranks.end(), none);
    for (std::uint32_t place = 0; place < placed_; ++place) {
        std::uint32_t& rank = ranks[fragments_[order_[place]].facet];
        rank = std::min(rank, place);
    }
}

}  // namespace umbra78::shadow::rivals
