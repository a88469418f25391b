// Class 2 of the rivals, handed its memory from what is left of the frame's (as rival_casts.hpp).
#pragma once

#include "shadow/frame/rival_casts.hpp"

namespace umbra78::shadow::rivals {

Work by_splitting(const Setting& s, std::span<const std::uint32_t> shown,
                          Carver& carver, std::span<std::uint8_t> mask);

Work by_perimeters(const Setting& s, std::span<const std::uint32_t> shown,
                           Carver& carver, std::span<std::uint8_t> mask);

Work by_outlines(const Setting& s, std::span<const std::uint32_t> shown,
                         Carver& carver, std::span<std::uint8_t> mask);

// --- what class 2 works in, for its casts and for pictures of it ----------------------------

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

inline PieceParts parts_of(Carver& carver, const Mesh& mesh, const PieceRoom& room) {
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

// cast(lay_out(carver, turn), turn) in as much room as the memory has, in doublings; if it says
// that this was too little, twice as much is asked.
template <class LayOut, class Cast>
void in_doublings(Carver& carver, LayOut&& lay_out, Cast&& cast) {
    const auto needs = [&](std::size_t turn) {
        Carver trial(static_cast<std::byte*>(nullptr));
        lay_out(trial, turn);
        return trial.used();
    };
    std::size_t turn = 1;
    while (needs(2 * turn) <= carver.rest().size()) turn *= 2;
    const Carver before = carver;
    const auto parts = lay_out(carver, turn);
    if (!carver.fits() || cast(parts, turn)) return;
    carver = before;
    carver.take<std::byte>(needs(2 * turn));
}

// cast(workshop), which says whether it had enough room.
template <class Cast>
void in_workshop(const Setting& s, Carver& carver, bool has_order, Cast&& cast) {
    const std::size_t facets = s.mesh.facets.size();
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return;
    const auto lay_out = [&](Carver& in, std::size_t turn) {
        return parts_of(in, s.mesh, PieceRoom(facets, turn, has_order));
    };
    in_doublings(carver, lay_out, [&](const PieceParts& parts, std::size_t turn) {
        const PieceRoom room(facets, turn, has_order);
        Workshop work{{}, LitPart(parts.work, room.work),
                      PieceStore(parts.store, room.pieces, facets),
                      LightOrder(parts.order, room.fragments, facets),
                      Casters(s, grid, parts.marks), parts.shown, parts.pairs};
        return work.lines.make(s, room.meetings, parts.lines) && cast(work);
    });
}

}  // namespace umbra78::shadow::rivals
