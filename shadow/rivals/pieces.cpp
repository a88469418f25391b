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

void fill_piece(const LightLines& lines, const Piece& piece, std::span<const ShownLine> borders,
                std::span<const std::uint32_t> shown, std::span<std::uint8_t> mask,
                MaskCounts& counts) {
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
            mask[at] = piece.is_lit ? lit : dark;
        }
    }
}

}  // namespace

bool mask_of_pieces(const LightLines& lines, const PieceStore& pieces,
                    std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                    std::span<std::uint8_t> mask, MaskCounts& counts) {
    if (room.size() < pieces.longest()) return false;
    const Setting& setting = lines.setting();
    for (std::size_t at = 0; at < mask.size(); ++at)
        mask[at] = shown[at] == nothing_seen ? lit : dark;
    for (const Piece& piece : pieces.pieces()) {
        if (setting.eye.sides[piece.facet] == 0 || setting.attached(piece.facet)) continue;
        const auto ids = pieces.lines(piece);
        for (std::size_t k = 0; k < ids.size(); ++k) room[k] = lines.shown(piece.facet, ids[k]);
        fill_piece(lines, piece, room.first(ids.size()), shown, mask, counts);
    }
    return true;
}

// --- what is being cut ----------------------------------------------------------------------

std::size_t LitPart::bytes(const WorkSize& size) {
    Carver carver(static_cast<std::byte*>(nullptr));
    carver.take<Range>(size.pieces);
    carver.take<LineId>(size.lines);
    carver.take<LineId>(size.longest);
    carver.take<LineId>(size.longest);
    return carver.used();
}

LitPart::LitPart(std::span<std::byte> memory, const WorkSize& size) {
    Carver carver(memory);
    pieces_ = carver.take<Range>(size.pieces);
    lines_ = carver.take<LineId>(size.lines);
    for (auto& part : parts_) part = carver.take<LineId>(size.longest);
    fits_ = carver.fits();
    needed_ = size;
}

void LitPart::begin(std::span<const LineId> outline) {
    used_pieces_ = used_lines_ = live_ = 0;
    const LineList whole{lines_, outline.size()};
    if (!keep({}, whole)) return;
    std::copy(outline.begin(), outline.end(), lines_.begin());
}

// Makes the lines that are at the end of lines_ a piece.
bool LitPart::keep(const LineList& inside, const LineList& outside) {
    needed_ = {std::max(needed_.pieces, used_pieces_ + 1),
               std::max(needed_.lines, used_lines_ + outside.count),
               std::max(needed_.longest, inside.count)};
    fits_ = fits_ && inside.fits() && outside.fits() && used_pieces_ < pieces_.size();
    if (!fits_) return false;
    pieces_[used_pieces_++] = {static_cast<std::uint32_t>(used_lines_),
                               static_cast<std::uint32_t>(outside.count)};
    used_lines_ += outside.count;
    ++live_;
    return true;
}

// Finds what of a piece is inside a footprint, and adds what is not. False if nothing is inside.
bool LitPart::within(const LightLines& lines, std::span<const LineId> piece,
                     std::span<const LineId> footprint, std::span<const LineId>& inside,
                     CutCounts& counts) {
    inside = piece;
    std::size_t turn = 0;
    for (const LineId line : footprint) {
        LineList in{parts_[turn]}, out{lines_.subspan(used_lines_)};
        const Part part = cut(lines, inside, line, in, out, counts);
        if (part == Part::outside) return false;
        if (part == Part::inside) continue;
        if (!keep(in, out)) return false;
        inside = in.lines();
        turn = 1 - turn;
    }
    return true;
}

bool LitPart::shade(const LightLines& lines, std::uint32_t facet,
                    std::span<const LineId> footprint, PieceStore& out, CutCounts& counts) {
    close_gaps();
    const std::size_t pieces = used_pieces_;
    bool any = false;
    for (std::size_t i = 0; i < pieces && fits_; ++i) {
        const Range piece = pieces_[i];
        if (piece.count == 0) continue;
        const std::size_t before_pieces = used_pieces_, before_lines = used_lines_;
        std::span<const LineId> inside;
        if (within(lines, lines_.subspan(piece.first, piece.count), footprint, inside, counts)) {
            out.add(facet, false, inside);
            pieces_[i].count = 0;
            --live_;
            any = true;
        } else {
            counts.undone += used_pieces_ - before_pieces;
            live_ -= used_pieces_ - before_pieces;
            used_pieces_ = before_pieces, used_lines_ = before_lines;
        }
    }
    return any;
}

// Moves the pieces together if half of them are none any more.
void LitPart::close_gaps() {
    if (used_pieces_ < 2 * live_ + 2) return;
    std::size_t pieces = 0, lines = 0;
    for (std::size_t i = 0; i < used_pieces_; ++i) {
        const Range p = pieces_[i];
        if (p.count == 0) continue;
        std::copy_n(lines_.begin() + p.first, p.count,
                    lines_.begin() + static_cast<std::ptrdiff_t>(lines));
        pieces_[pieces++] = {static_cast<std::uint32_t>(lines), p.count};
        lines += p.count;
    }
    used_pieces_ = pieces, used_lines_ = lines;
}

void LitPart::finish(std::uint32_t facet, PieceStore& out) const {
    for (const Range& p : pieces_.first(used_pieces_))
        if (p.count != 0) out.add(facet, true, lines_.subspan(p.first, p.count));
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

}  // namespace umbra78::shadow::rivals
