#include "shadow/rivals/perimeters.hpp"

namespace umbra78::shadow::rivals {
namespace {

// Clips what is lit by the footprints of a facet. False if there is no room.
bool shade_by_facet(LightOrder& order, std::uint32_t facet, LitPart& lit_part, PieceStore& out,
                    PerimeterCounts& counts) {
    for (std::uint32_t a = order.first_of(facet); a != LightOrder::none; a = order.at(a).next) {
        if (!order.at(a).joined) continue;
        ++counts.compared;
        lit_part.shade(facet, order.lines(order.at(a)), out, counts.cuts);
    }
    return lit_part.fits();
}

}  // namespace

PieceStatus clip_by_perimeters(LightLines& lines, Casters& casters, LightOrder& order,
                               LitPart& lit_part, PieceStore& out, PerimeterCounts& counts) {
    for (const std::uint32_t index : order.order()) {
        Fragment& fragment = order.at(index);
        ++counts.fragments;
        lit_part.begin(lines, fragment.facet, order.lines(fragment));
        casters.for_each(fragment.facet, [&](std::uint32_t f, Before) {
            return !lit_part.is_dark() &&
                   shade_by_facet(order, f, lit_part, out, counts);
        });
        if (!lit_part.fits()) return PieceStatus::no_work_room;
        fragment.joined = !lit_part.is_dark();
        counts.joined += fragment.joined ? 1 : 0;
        counts.edges += fragment.joined ? fragment.count : 0;
        lit_part.finish(out);
    }
    counts.casters = casters.counts();
    return out.finish() ? PieceStatus::ok : PieceStatus::no_room;
}

}  // namespace umbra78::shadow::rivals
