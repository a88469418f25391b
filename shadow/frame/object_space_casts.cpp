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

    PieceRoom(std::size_t facets, std::size_t turn)
        : meetings(turn * (facets / 2 + 256)),
          work{turn * (facets / 4 + 256), turn * (2 * facets + 2048), turn * 32},
          pieces{turn * (12 * facets + 256), turn * (40 * facets + 1024)} {}
};

struct PieceParts {
    std::span<std::byte> lines, work, store;
    std::span<std::uint32_t> marks;
    std::span<ShownLine> shown;
};

PieceParts parts_of(Carver& carver, const Mesh& mesh, const PieceRoom& room) {
    const std::size_t facets = mesh.facets.size();
    return {carver.take<std::byte>(LightLines::bytes(mesh, room.meetings)),
            carver.take<std::byte>(LitPart::bytes(room.work)),
            carver.take<std::byte>(PieceStore::bytes(room.pieces, facets)),
            carver.take<std::uint32_t>(facets), carver.take<ShownLine>(room.work.longest)};
}

// What class 2 works in.
struct Workshop {
    LightLines lines;
    LitPart lit_part;
    PieceStore store;
    Casters casters;
    std::span<ShownLine> shown;
};

// cast(workshop) in as much room as the memory has, in doublings; if it says that this was too
// little, twice as much is asked.
template <class Cast>
void in_workshop(SettingOf s, Carver& carver, Cast&& cast) {
    const std::size_t facets = s.mesh.facets.size();
    LightGrid grid;
    if (!built_grid(s, carver, grid)) return;
    const auto needs = [&](std::size_t turn) {
        Carver trial(static_cast<std::byte*>(nullptr));
        parts_of(trial, s.mesh, PieceRoom(facets, turn));
        return trial.used();
    };
    std::size_t turn = 1;
    while (needs(2 * turn) <= carver.rest().size()) turn *= 2;
    Carver before = carver;
    const PieceRoom room(facets, turn);
    const PieceParts parts = parts_of(carver, s.mesh, room);
    if (!carver.fits()) return;
    Workshop work{{}, LitPart(parts.work, room.work), PieceStore(parts.store, room.pieces, facets),
                  Casters(s, grid, parts.marks), parts.shown};
    if (work.lines.make(s, room.meetings, parts.lines) && cast(work)) return;
    carver = before;
    carver.take<std::byte>(needs(2 * turn));
}

}  // namespace

Work by_splitting(SettingOf s, Shown shown, Carver& carver, Mask mask) {
    Work result;
    in_workshop(s, carver, [&](Workshop& w) {
        SplitCounts counts;
        MaskCounts mask_counts;
        if (split(w.lines, w.casters, {}, w.lit_part, w.store, counts) != PieceStatus::ok ||
            !mask_of_pieces(w.lines, w.store, shown, w.shown, mask, mask_counts))
            return false;
        result = work_of(counts, mask_counts, s.mesh, mask.size());
        return true;
    });
    return result;
}

}  // namespace umbra78::shadow
