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
    std::uint64_t boxes = 0;   // of pieces, compared with a footprint's
    std::uint64_t boxed = 0;   // pieces whose box was made
    std::uint64_t corners = 0;         // of them
    std::uint64_t footprints = 0;      // whose box was made
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

// What of a piece is inside all lines of a footprint; false if nothing is. `inside` is the piece
// itself, or is written to one half of `room`, while the other is used, too; `fits` becomes false
// if a half is too short.
bool common_part(const LightLines& lines, std::span<const LineId> piece,
                 std::span<const LineId> footprint, std::span<LineId> room,
                 std::span<const LineId>& inside, bool& fits, CutCounts& counts);

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
    std::uint64_t pieces = 0;  // that were drawn, of facets that are seen and not attached
    std::uint64_t rows = 0;    // of their facets
    std::uint64_t pixels = 0;  // that are in one: each once, as pieces are a partition
};

// The mask: a pixel is lit if it is in a lit piece of the facet that it shows. Dark pieces are not
// drawn: what no lit piece has is dark.
// `room` has at least pieces.longest() lines; false if it has less.
bool mask_of_pieces(const LightLines& lines, const PieceStore& pieces,
                    std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                    std::span<std::uint8_t> mask, MaskCounts& counts);

// For a picture of the pieces: of each pixel the number of its piece in pieces(), lit or dark, or
// no_piece where it shows nothing, or a facet that is turned from the light or was not cut.
inline constexpr std::uint32_t no_piece = UINT32_MAX;
bool pieces_of_pixels(const LightLines& lines, const PieceStore& pieces,
                      std::span<const std::uint32_t> shown, std::span<ShownLine> room,
                      std::span<std::uint32_t> out, MaskCounts& counts);

}  // namespace umbra78::shadow::rivals
