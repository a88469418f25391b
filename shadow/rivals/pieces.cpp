#include "shadow/rivals/pieces.hpp"

#include "shadow/rivals/brute.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {

// Corner i is where lines i and i + 1 meet, and line i goes from corner i - 1 to corner i.
Part cut(const LightLines& lines, std::span<const LineId> piece, LineId line, LineList& inside,
         LineList& outside, CutCounts& counts) {
    ++counts.tests;
    bool some_inside = false, some_outside = false;
    const int last = lines.sign(piece.back(), piece.front(), line, counts.signs);
    int before = last;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const int after =
            i + 1 < piece.size() ? lines.sign(piece[i], piece[i + 1], line, counts.signs) : last;
        some_inside = some_inside || after > 0;
        some_outside = some_outside || after < 0;
        if (before > 0 || after > 0) inside.add(piece[i]);
        if (before < 0 || after < 0) outside.add(piece[i]);
        if (before > 0 && after <= 0) inside.add(line);
        if (before < 0 && after >= 0) outside.add(line.turned());
        before = after;
    }
    if (some_inside && some_outside) {
        ++counts.cuts;
        return Part::both;
    }
    return some_inside ? Part::inside : Part::outside;
}

bool common_part(const LightLines& lines, std::span<const LineId> piece,
                 std::span<const LineId> footprint, std::span<LineId> room,
                 std::span<const LineId>& inside, bool& fits, CutCounts& counts) {
    const std::size_t half = room.size() / 2;
    std::size_t turn = 0;
    inside = piece;
    for (const LineId line : footprint) {
        LineList in{room.subspan(turn * half, half)}, out{};
        const Part part = cut(lines, inside, line, in, out, counts);
        if (part == Part::outside) return false;
        if (part == Part::inside) continue;
        fits = fits && in.fits();
        if (!fits) return false;
        inside = in.lines();
        turn = 1 - turn;
    }
    return true;
}

// --- what is made ---------------------------------------------------------------------------

namespace {

struct StoreSpans {
    std::span<Piece> pieces;
    std::span<LineId> lines;
    std::span<std::uint32_t> starts;
};

StoreSpans lay_out(Carver& carver, const PieceSize& size, std::size_t facets) {
    return {carver.take<Piece>(size.pieces), carver.take<LineId>(size.lines),
            carver.take<std::uint32_t>(facets + 1)};
}

}  // namespace

std::size_t PieceStore::bytes(const PieceSize& size, std::size_t facets) {
    Carver carver(static_cast<std::byte*>(nullptr));
    lay_out(carver, size, facets);
    return carver.used();
}

PieceStore::PieceStore(std::span<std::byte> memory, const PieceSize& size, std::size_t facets) {
    Carver carver(memory);
    const StoreSpans s = lay_out(carver, size, facets);
    has_memory_ = carver.fits();
    pieces_ = s.pieces, lines_ = s.lines, starts_ = s.starts;
}

void PieceStore::add(std::uint32_t facet, bool is_lit, std::span<const LineId> lines) {
    const PieceSize at = needed_;
    ++needed_.pieces;
    needed_.lines += lines.size();
    longest_ = std::max(longest_, lines.size());
    if (!fits()) return;
    pieces_[at.pieces] = {facet, static_cast<std::uint32_t>(at.lines),
                          static_cast<std::uint32_t>(lines.size()), is_lit};
    std::copy(lines.begin(), lines.end(),
              lines_.begin() + static_cast<std::ptrdiff_t>(at.lines));
}

bool PieceStore::finish() {
    if (!fits()) return false;
    const auto pieces = pieces_.first(needed_.pieces);
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.facet != b.facet ? a.facet < b.facet : a.first < b.first;
    });
    std::fill(starts_.begin(), starts_.end(), 0);
    for (const Piece& p : pieces) ++starts_[p.facet + 1];
    for (std::size_t f = 1; f < starts_.size(); ++f) starts_[f] += starts_[f - 1];
    return true;
}

namespace {

// visit(pixel) of each that shows the piece's facet and is in the piece.
template <class Visit>
void for_pixels_of(const LightLines& lines, const Piece& piece,
                   std::span<const ShownLine> borders, std::span<const std::uint32_t> shown,
                   MaskCounts& counts, Visit&& visit) {
    const Setting& setting = lines.setting();
    const Space& space = setting.space;
    const Run rows = rows_of(setting, piece.facet);
    ++counts.pieces;
    for (int row = rows.from; row < rows.to; ++row) {
        ++counts.rows;
        Run run = setting.covered_run(piece.facet, row);
        for (const ShownLine& border : borders) run = border.inside(space, run, row);
        const std::size_t start =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(space.size_px());
        for (int column = run.from; column < run.to; ++column) {
            const std::size_t at = start + static_cast<std::size_t>(column);
            if (shown[at] != piece.facet) continue;
            ++counts.pixels;
            visit(at);
        }
    }
}

// visit(piece's number, pixel) for the pieces that `wanted` takes, of facets that may be lit.
template <class Wanted, class Visit>
bool for_pixels(const LightLines& lines, const PieceStore& pieces,
                std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                MaskCounts& counts, Wanted&& wanted, Visit&& visit) {
    if (room.size() < pieces.longest()) return false;
    const Setting& setting = lines.setting();
    const auto all = pieces.pieces();
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Piece& piece = all[n];
        if (!wanted(piece) || setting.eye.sides[piece.facet] == 0 ||
            setting.attached(piece.facet))
            continue;
        const auto ids = pieces.lines(piece);
        for (std::size_t k = 0; k < ids.size(); ++k) room[k] = lines.shown(piece.facet, ids[k]);
        for_pixels_of(lines, piece, room.first(ids.size()), shown, counts,
                      [&](std::size_t at) { visit(n, at); });
    }
    return true;
}

}  // namespace

bool mask_of_pieces(const LightLines& lines, const PieceStore& pieces,
                    std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                    std::span<std::uint8_t> mask, MaskCounts& counts) {
    for (std::size_t at = 0; at < mask.size(); ++at)
        mask[at] = shown[at] == nothing_seen ? lit : dark;
    return for_pixels(lines, pieces, shown, room, counts,
                      [](const Piece& p) { return p.is_lit; },
                      [&](std::size_t, std::size_t at) { mask[at] = lit; });
}

bool pieces_of_pixels(const LightLines& lines, const PieceStore& pieces,
                      std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                      std::span<std::uint32_t> out, MaskCounts& counts) {
    std::fill(out.begin(), out.end(), no_piece);
    return for_pixels(lines, pieces, shown, room, counts, [](const Piece&) { return true; },
                      [&](std::size_t n, std::size_t at) {
                          out[at] = static_cast<std::uint32_t>(n);
                      });
}

}  // namespace umbra78::shadow::rivals
