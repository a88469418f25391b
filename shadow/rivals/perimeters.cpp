#include "shadow/rivals/perimeters.hpp"

namespace umbra78::shadow::rivals {
namespace {

struct FootprintClipping {
    LightLines& lines;
    Casters& casters;
    LightOrder& order;
    FootprintPairs& pairs;
    LitPart& lit_part;
    PieceStore& out;
    PerimeterCounts& counts;

    PieceStatus clip(std::uint32_t index);

private:
    bool is_whole_footprint(std::uint32_t facet) const;
    bool shade_by_pair(std::uint32_t on, std::uint32_t turn, std::uint32_t facet);
    bool shade_by_facet(std::uint32_t facet);
};

// Whether a facet is one footprint and not pieces.
bool FootprintClipping::is_whole_footprint(std::uint32_t facet) const {
    const Fragment& f = order.at(order.first_of(facet));
    return f.next == LightOrder::none && f.joined;
}

// Clips by a facet and its partner. False if they are not merged here.
bool FootprintClipping::shade_by_pair(std::uint32_t on, std::uint32_t turn, std::uint32_t facet) {
    const std::uint32_t other = pairs.partner(facet);
    if (other == FootprintPairs::none || other == on || !is_whole_footprint(facet) ||
        !is_whole_footprint(other) || casters.ask(other, on) == Before::no)
        return false;
    ++counts.compared, ++counts.pairs;
    pairs.take(other, turn);
    const std::array<std::uint32_t, 2> both{facet, other};
    lit_part.shade(both, pairs.outline(facet), out, counts.cuts);
    return true;
}

// Clips what is lit by the footprints of a facet. False if there is no room.
bool FootprintClipping::shade_by_facet(std::uint32_t facet) {
    for (std::uint32_t a = order.first_of(facet); a != LightOrder::none; a = order.at(a).next) {
        if (!order.at(a).joined) continue;
        ++counts.compared;
        lit_part.shade(std::span(&facet, 1), order.lines(order.at(a)), out, counts.cuts);
    }
    return lit_part.fits();
}

PieceStatus FootprintClipping::clip(std::uint32_t index) {
    Fragment& fragment = order.at(index);
    ++counts.fragments;
    lit_part.begin(lines, fragment.facet, order.lines(fragment));
    casters.for_near(fragment.facet, [&](std::uint32_t f) {
        if (lit_part.is_dark()) return false;
        if (pairs.partner(f) != FootprintPairs::none && pairs.is_taken(f, index)) return true;
        if (casters.ask(f, fragment.facet) == Before::no) return true;
        return shade_by_pair(fragment.facet, index, f) ? lit_part.fits() : shade_by_facet(f);
    });
    if (!lit_part.fits()) return PieceStatus::no_work_room;
    fragment.joined = !lit_part.is_dark();
    counts.joined += fragment.joined ? 1 : 0;
    counts.edges += fragment.joined ? fragment.count : 0;
    lit_part.finish(out);
    return PieceStatus::ok;
}

}  // namespace

PieceStatus clip_by_perimeters(LightLines& lines, Casters& casters, LightOrder& order,
                               FootprintPairs& pairs, LitPart& lit_part, PieceStore& out,
                               PerimeterCounts& counts) {
    FootprintClipping clipping{lines, casters, order, pairs, lit_part, out, counts};
    for (const std::uint32_t index : order.order())
        if (const PieceStatus status = clipping.clip(index); status != PieceStatus::ok)
            return status;
    counts.casters = casters.counts();
    return out.finish() ? PieceStatus::ok : PieceStatus::no_room;
}

}  // namespace umbra78::shadow::rivals
