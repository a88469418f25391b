// Convex pieces of facets, as lists of lines in the light's picture, and how a line cuts them.
//
// A piece is the points of a facet that are strictly inside each of its lines. The lines follow
// each other around it; a corner is where two successive ones meet. Every line has a side of the
// piece, so two that follow each other are never one. Cut by a line, what is strictly inside and
// what is strictly outside are pieces, too. There is a part on a side exactly if a corner is
// strictly on that side; a corner on the line makes neither part. So a piece without area is never
// made, and what lies on the line itself belongs to no piece: no pixel does, since its centre is
// moved off every line (planes.hpp).
#pragma once

#include "shadow/rivals/light_lines.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct CutCounts {
    std::uint64_t tests = 0;   // of a piece against a line
    std::uint64_t cuts = 0;    // of them, that left two parts
    std::uint64_t undone = 0;  // cuts of pieces of which, after all, nothing was in the shadow
    SignCounts signs;
};

// A list of lines while it is written. What does not fit is counted.
struct LineList {
    std::span<LineId> room{};
    std::size_t count = 0;

    void add(LineId id) {
        if (count < room.size()) room[count] = id;
        ++count;
    }
    bool fits() const { return count <= room.size(); }
    std::span<const LineId> lines() const { return room.first(count); }
};

enum class Part : std::uint8_t { inside, outside, both };

// Which parts a piece has on a line's sides. `inside` and `outside` are empty lists before; they
// hold the parts only if there are both.
Part cut(const LightLines& lines, std::span<const LineId> piece, LineId line, LineList& inside,
         LineList& outside, CutCounts& counts);

// --- what is made ---------------------------------------------------------------------------

struct Piece {
    std::uint32_t facet, first, count;  // lines [first, first + count)
    bool is_lit;
};

struct PieceSize {
    std::size_t pieces = 0, lines = 0;
};

// All pieces of a scene. More than fit are counted.
class PieceStore {
public:
    static std::size_t bytes(const PieceSize& size, std::size_t facets);
    PieceStore() = default;
    PieceStore(std::span<std::byte> memory, const PieceSize& size, std::size_t facets);

    void add(std::uint32_t facet, bool is_lit, std::span<const LineId> lines);
    // Puts the pieces in the order of their facets. False if some did not fit.
    bool finish();

    std::span<const Piece> pieces() const { return pieces_.first(needed_.pieces); }
    std::span<const Piece> of(std::uint32_t facet) const {
        return pieces_.subspan(starts_[facet], starts_[facet + 1] - starts_[facet]);
    }
    std::span<const LineId> lines(const Piece& p) const { return lines_.subspan(p.first, p.count); }
    bool fits() const { return has_memory_ && needed_.pieces <= pieces_.size() &&
                               needed_.lines <= lines_.size(); }
    const PieceSize& needed() const { return needed_; }
    std::size_t longest() const { return longest_; }  // lines of a piece

private:
    std::span<Piece> pieces_;
    std::span<LineId> lines_;
    std::span<std::uint32_t> starts_;
    PieceSize needed_{};
    std::size_t longest_ = 0;
    bool has_memory_ = false;
};

struct MaskCounts {
    std::uint64_t pieces = 0;  // of facets that are seen and not attached
    std::uint64_t rows = 0;    // of pieces
    std::uint64_t pixels = 0;  // that found their piece: each once, as pieces are a partition
};

// The mask: a pixel is lit if the piece in which it is, of the facet that it shows, is lit.
// `room` has at least pieces.longest() lines; false if it has less.
bool mask_of_pieces(const LightLines& lines, const PieceStore& pieces,
                    std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                    std::span<std::uint8_t> mask, MaskCounts& counts);

// --- what is being cut ----------------------------------------------------------------------

struct WorkSize {
    std::size_t pieces = 0, lines = 0;  // of one facet, while it is cut
    std::size_t longest = 0;            // lines of one piece
};

// What is still lit of one facet: pieces that have no point in common.
class LitPart {
public:
    static std::size_t bytes(const WorkSize& size);
    LitPart() = default;
    LitPart(std::span<std::byte> memory, const WorkSize& size);

    void begin(std::span<const LineId> outline);
    // Takes away what is inside all lines of a footprint, and adds it to `out` as dark. A piece
    // that has nothing inside stays whole. False if nothing was inside, or there is no room.
    bool shade(const LightLines& lines, std::uint32_t facet, std::span<const LineId> footprint,
               PieceStore& out, CutCounts& counts);
    // Adds what is left to `out` as lit.
    void finish(std::uint32_t facet, PieceStore& out) const;
    bool is_dark() const { return live_ == 0; }

    // False once something did not fit. Then needed() is what was given, or more that would have
    // let it go on; how much the whole takes is known only with room for it.
    bool fits() const { return fits_; }
    const WorkSize& needed() const { return needed_; }

private:
    struct Range {
        std::uint32_t first, count;  // no lines: no piece any more
    };
    bool within(const LightLines& lines, std::span<const LineId> piece,
                std::span<const LineId> footprint, std::span<const LineId>& inside,
                CutCounts& counts);
    bool keep(const LineList& inside, const LineList& outside);
    void close_gaps();

    std::span<Range> pieces_;
    std::span<LineId> lines_;
    std::array<std::span<LineId>, 2> parts_;
    std::size_t used_pieces_ = 0, used_lines_ = 0, live_ = 0;
    WorkSize needed_{};
    bool fits_ = true;
};

// What of a piece is inside all lines of a footprint; false if nothing is. `inside` is the piece
// itself, or is written to one half of `room`, while the other is used, too; `fits` becomes false
// if a half is too short.
bool common_part(const LightLines& lines, std::span<const LineId> piece,
                 std::span<const LineId> footprint, std::span<LineId> room,
                 std::span<const LineId>& inside, bool& fits, CutCounts& counts);

}  // namespace umbra78::shadow::rivals
