// What is lit of one facet while shadows are taken away from it, and where its pieces are.
//
// Of a wide facet under thousands of small ones there are soon thousands of pieces, of which each
// footprint touches a few. The cuts themselves are the tree by which they are found: a piece that
// was cut stays as a node with its parts below it, and a footprint goes into a node if its box and
// the node's overlap (facet_picture.hpp). A box is made when it is first asked for, and the whole
// facet's never, so that a facet with one piece asks for none.
#pragma once

#include "shadow/rivals/facet_picture.hpp"
#include "shadow/rivals/pieces.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct WorkSize {
    std::size_t pieces = 0, lines = 0;  // of one facet, while it is cut; pieces that were cut, too
    std::size_t longest = 0;            // lines of one piece
};

// What is still lit of one facet: pieces that have no point in common.
class LitPart {
public:
    static std::size_t bytes(const WorkSize& size);
    LitPart() = default;
    LitPart(std::span<std::byte> memory, const WorkSize& size);

    // `outline` is within the facet. `lines` is kept by reference, until the next begin().
    void begin(const LightLines& lines, std::uint32_t facet, std::span<const LineId> outline);
    // Takes away what is inside all lines of a footprint, which is within the facets `by`, and adds
    // it to `out` as dark. A piece that has nothing inside stays whole. False if nothing
    // was inside, or there is no room.
    bool shade(std::span<const std::uint32_t> by, std::span<const LineId> footprint,
               PieceStore& out, CutCounts& counts);
    // Adds what is left to `out` as lit.
    void finish(PieceStore& out) const;
    bool is_dark() const { return live_ == 0; }

    // False once something did not fit. Then needed() is what was given, or more that would have
    // let it go on; how much the whole takes is known only with room for it.
    bool fits() const { return fits_; }
    const WorkSize& needed() const { return needed_; }

private:
    static constexpr std::uint32_t none = UINT32_MAX;
    // Nodes are in the order of a walk: to the first part, or, past this node and its parts, on to
    // `next`.
    struct Node {
        std::uint32_t first, count;  // lines; none if it is no piece any more
        std::uint32_t part, next;    // part: none if it was not cut
        PictureBox box;
        bool has_box;
    };
    bool touches(Node& node, const PictureBox& footprint, CutCounts& counts);
    bool take_away(std::uint32_t at, std::span<const LineId> footprint, PieceStore& out,
                   CutCounts& counts);
    bool within(std::span<const LineId> piece, std::span<const LineId> footprint,
                std::span<const LineId>& inside, CutCounts& counts);
    bool keep(const LineList& inside, const LineList& outside);
    void close_gaps();
    std::span<const LineId> lines_of(const Node& n) const {
        return lines_.subspan(n.first, n.count);
    }

    const LightLines* light_lines_ = nullptr;
    FacetPicture picture_{};
    std::uint32_t facet_ = 0;
    std::span<Node> nodes_;
    std::span<LineId> lines_;
    std::array<std::span<LineId>, 2> parts_;
    std::size_t used_nodes_ = 0, used_lines_ = 0, live_lines_ = 0, live_ = 0;
    WorkSize needed_{};
    bool fits_ = true;
};

}  // namespace umbra78::shadow::rivals
