#include "shadow/frame/object_space_casts.hpp"

namespace umbra78::shadow {
namespace {

using namespace rivals;
using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const rivals::Setting&;

}  // namespace

Work by_splitting(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    Work result;
    in_workshop(s, carver, false, [&](Workshop& w) {
        SplitCounts counts;
        MaskCounts mask_counts;
        if (split(w.lines, w.casters, {}, w.lit_part, w.store, counts) != PieceStatus::ok ||
            !mask_of_pieces(w.lines, w.store, shown, w.shown, mask, mask_counts))
            return false;
        result = work_of(counts, mask_counts, w.store.pieces().size(), s.mesh, mask.size());
        return true;
    });
    return result;
}

Work by_perimeters(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    Work result;
    in_workshop(s, carver, true, [&](Workshop& w) {
        OrderCounts order_counts;
        PerimeterCounts counts;
        MaskCounts mask_counts;
        FootprintPairs pairs;
        if (w.order.make(w.lines, w.casters, order_counts) != OrderStatus::ok ||
            !pairs.make(w.lines, w.pairs, counts.cuts.signs) ||
            clip_by_perimeters(w.lines, w.casters, w.order, pairs, w.lit_part, w.store,
                               counts) !=
                PieceStatus::ok ||
            !mask_of_pieces(w.lines, w.store, shown, w.shown, mask, mask_counts))
            return false;
        result = work_of(order_counts, counts, mask_counts, w.store.pieces().size(), s.mesh,
                         mask.size());
        return true;
    });
    return result;
}

}  // namespace umbra78::shadow
