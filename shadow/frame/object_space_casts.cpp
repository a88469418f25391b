#include "shadow/frame/object_space_casts.hpp"

namespace umbra78::shadow {
namespace {

using namespace rivals;
using Shown = std::span<const std::uint32_t>;
using Mask = std::span<std::uint8_t>;
using SettingOf = const rivals::Setting&;

// How much room pieces get: `turn` times as much for each step in which it was too little. Most
// scenes fit in the first.
struct PieceRoom {
    std::size_t meetings;
    WorkSize work;
    PieceSize pieces;
    FragmentSize fragments;  // for the order from the light, if there is one

    PieceRoom(std::size_t facets, std::size_t turn, bool has_order)
        : meetings(turn * (facets / 2 + 256)),
          work{turn * (facets / 4 + 256), turn * (2 * facets + 2048), turn * 32},
          pieces{turn * (12 * facets + 256), turn * (40 * facets + 1024)} {
        if (has_order)
            fragments = {turn * (2 * facets + 64), turn * (8 * facets + 256), turn * 64};
    }
    bool has_order() const { return fragments.fragments != 0; }
};

struct PieceParts {
    std::span<std::byte> lines, work, store, order, pairs;
    std::span<std::uint32_t> marks;
    std::span<ShownLine> shown;
};

PieceParts parts_of(Carver& carver, const Mesh& mesh, const PieceRoom& room) {
    const std::size_t facets = mesh.facets.size();
    return {carver.take<std::byte>(LightLines::bytes(mesh, room.meetings)),
            carver.take<std::byte>(LitPart::bytes(room.work)),
            carver.take<std::byte>(PieceStore::bytes(room.pieces, facets)),
            carver.take<std::byte>(LightOrder::bytes(room.fragments, facets)),
            carver.take<std::byte>(room.has_order() ? FootprintPairs::bytes(facets) : 0),
            carver.take<std::uint32_t>(facets), carver.take<ShownLine>(room.work.longest)};
}

// What class 2 works in.
struct Workshop {
    LightLines lines;
    LitPart lit_part;
    PieceStore store;
    LightOrder order;
    Casters casters;
    std::span<ShownLine> shown;
    std::span<std::byte> pairs;
};

// cast(workshop) in as much room as the memory has, in doublings; if it says that this was too
// little, twice as much is asked.
template <class Cast>
void in_workshop(SettingOf s, Carver& carver, bool has_order, Cast&& cast) {
    const std::size_t facets = s.mesh.facets.size();
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return;
    const auto needs = [&](std::size_t turn) {
        Carver trial(static_cast<std::byte*>(nullptr));
        parts_of(trial, s.mesh, PieceRoom(facets, turn, has_order));
        return trial.used();
    };
    std::size_t turn = 1;
    while (needs(2 * turn) <= carver.rest().size()) turn *= 2;
    Carver before = carver;
    const PieceRoom room(facets, turn, has_order);
    const PieceParts parts = parts_of(carver, s.mesh, room);
    if (!carver.fits()) return;
    Workshop work{{}, LitPart(parts.work, room.work), PieceStore(parts.store, room.pieces, facets),
                  LightOrder(parts.order, room.fragments, facets),
                  Casters(s, grid, parts.marks), parts.shown, parts.pairs};
    if (work.lines.make(s, room.meetings, parts.lines) && cast(work)) return;
    carver = before;
    carver.take<std::byte>(needs(2 * turn));
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

}  // namespace umbra78::shadow
