#include "shadow/frame/object_space_casts.hpp"

namespace umbra78::shadow::rivals {
namespace {

using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const Setting&;

// As PieceRoom, for loops.
struct LoopRoom {
    std::size_t meetings;
    ClipSize work;
    LoopSize loops;

    LoopRoom(std::size_t facets, std::size_t turn)
        : meetings(turn * (facets / 2 + 256)),
          work{{turn * (facets / 16 + 256), turn * (facets + 2048)}, turn * (facets / 16 + 256)},
          loops{turn * (facets + 256), turn * (6 * facets + 1024)} {}
};

struct LoopParts {
    std::span<std::byte> lines, work, store;
    std::span<std::uint32_t> marks;
    std::span<ListedCaster> listed;
    std::span<ShownLine> shown;
    std::span<std::uint8_t> flips;
};

LoopParts loop_parts(Carver& carver, SettingOf s, const LoopRoom& room) {
    const std::size_t facets = s.mesh.facets.size();
    return {carver.take<std::byte>(LightLines::bytes(s.mesh, room.meetings)),
            carver.take<std::byte>(LoopClip::bytes(room.work)),
            carver.take<std::byte>(LoopList::bytes(room.loops)),
            carver.take<std::uint32_t>(facets), carver.take<ListedCaster>(facets),
            carver.take<ShownLine>(room.work.loops.sides),
            carver.take<std::uint8_t>(static_cast<std::size_t>(s.space.size_px()) + 1)};
}

// False if there is too little room.
bool clip_in(const LoopParts& parts, const LoopRoom& room, SettingOf s, const LightGrid& grid,
             Shown shown, Mask mask, Work& result) {
    LightLines lines;
    Casters casters(s, grid, parts.marks);
    LoopClip work(parts.work, room.work);
    LoopList store(parts.store, room.loops);
    AthertonCounts counts;
    LoopMaskCounts mask_counts;
    if (!lines.make(s, room.meetings, parts.lines) ||
        clip_by_outlines(lines, casters, {}, parts.listed, work, store, counts) !=
            PieceStatus::ok ||
        !mask_of_loops(lines, store, shown, parts.shown, parts.flips, mask, mask_counts))
        return false;
    result = work_of(counts, mask_counts, s.mesh, mask.size());
    return true;
}

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

Work by_outlines(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    Work result;
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return result;
    const auto lay_out = [&](Carver& in, std::size_t turn) {
        return loop_parts(in, s, LoopRoom(s.mesh.facets.size(), turn));
    };
    in_doublings(carver, lay_out, [&](const LoopParts& parts, std::size_t turn) {
        return clip_in(parts, LoopRoom(s.mesh.facets.size(), turn), s, grid, shown, mask, result);
    });
    return result;
}

}  // namespace umbra78::shadow::rivals
