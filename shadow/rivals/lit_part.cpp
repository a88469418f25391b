#include "shadow/rivals/lit_part.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {

std::size_t LitPart::bytes(const WorkSize& size) {
    Carver carver(static_cast<std::byte*>(nullptr));
    carver.take<Node>(size.pieces);
    carver.take<LineId>(size.lines);
    carver.take<LineId>(size.longest);
    carver.take<LineId>(size.longest);
    return carver.used();
}

LitPart::LitPart(std::span<std::byte> memory, const WorkSize& size) {
    Carver carver(memory);
    nodes_ = carver.take<Node>(size.pieces);
    lines_ = carver.take<LineId>(size.lines);
    for (auto& part : parts_) part = carver.take<LineId>(size.longest);
    fits_ = carver.fits();
    needed_ = size;
}

void LitPart::begin(const LightLines& lines, std::uint32_t facet,
                    std::span<const LineId> outline) {
    light_lines_ = &lines;
    facet_ = facet;
    picture_ = FacetPicture(lines.setting(), facet);
    used_nodes_ = used_lines_ = live_lines_ = live_ = 0;
    const LineList whole{lines_, outline.size()};
    if (!keep({}, whole)) return;
    std::copy(outline.begin(), outline.end(), lines_.begin());
    live_ = 1, live_lines_ = outline.size();
}

// Makes the lines that are at the end of lines_ a piece.
bool LitPart::keep(const LineList& inside, const LineList& outside) {
    needed_ = {std::max(needed_.pieces, used_nodes_ + 1),
               std::max(needed_.lines, used_lines_ + outside.count),
               std::max(needed_.longest, inside.count)};
    fits_ = fits_ && inside.fits() && outside.fits() && used_nodes_ < nodes_.size();
    if (!fits_) return false;
    nodes_[used_nodes_++] = {static_cast<std::uint32_t>(used_lines_),
                             static_cast<std::uint32_t>(outside.count), none, none, {}, false};
    used_lines_ += outside.count;
    return true;
}

// Finds what of a piece is inside a footprint, and adds what is not. False if nothing is inside.
bool LitPart::within(std::span<const LineId> piece, std::span<const LineId> footprint,
                     std::span<const LineId>& inside, CutCounts& counts) {
    inside = piece;
    std::size_t turn = 0;
    for (const LineId line : footprint) {
        LineList in{parts_[turn]}, out{lines_.subspan(used_lines_)};
        const Part part = cut(*light_lines_, inside, line, in, out, counts);
        if (part == Part::outside) return false;
        if (part == Part::inside) continue;
        if (!keep(in, out)) return false;
        inside = in.lines();
        turn = 1 - turn;
    }
    return true;
}

// A piece loses what is inside a footprint; what is left of it are its parts. False if nothing is
// inside.
bool LitPart::take_away(std::uint32_t at, std::span<const LineId> footprint, PieceStore& out,
                        CutCounts& counts) {
    Node& node = nodes_[at];
    const std::size_t first = used_nodes_, first_line = used_lines_;
    std::span<const LineId> inside;
    if (!within(lines_of(node), footprint, inside, counts)) {
        counts.undone += used_nodes_ - first;
        used_nodes_ = first, used_lines_ = first_line;
        return false;
    }
    out.add(facet_, false, inside);
    for (std::size_t part = first; part < used_nodes_; ++part)
        nodes_[part].next = part + 1 < used_nodes_ ? static_cast<std::uint32_t>(part + 1)
                                                   : node.next;
    live_ += used_nodes_ - first - 1;
    live_lines_ += used_lines_ - first_line - node.count;
    if (used_nodes_ > first) node.part = static_cast<std::uint32_t>(first);
    node.count = 0;
    return true;
}

// The whole facet, from which the parts were cut, is not asked: its casters overlap it.
bool LitPart::touches(Node& node, const PictureBox& footprint, CutCounts& counts) {
    if (&node == nodes_.data() || !picture_.has_boxes()) return true;
    if (!node.has_box) {
        node.box = picture_.of_piece(*light_lines_, lines_of(node));
        node.has_box = true;
        ++counts.boxed;
        counts.corners += node.count;
    }
    ++counts.boxes;
    return node.box.overlaps(footprint);
}

bool LitPart::shade(std::span<const std::uint32_t> by, std::span<const LineId> footprint,
                    PieceStore& out, CutCounts& counts) {
    close_gaps();
    const std::size_t nodes = used_nodes_;
    PictureBox box{};
    if (nodes > 1 && picture_.has_boxes()) {
        box = picture_.of_facets(light_lines_->setting(), by);
        counts.footprints += by.size();
    }
    bool any = false;
    for (std::uint32_t at = 0; at != none && fits_;) {
        Node& node = nodes_[at];
        const bool is_dark = node.count == 0 && node.part == none;
        if (is_dark || !touches(node, box, counts)) {
            at = node.next;
        } else if (node.part != none) {
            at = node.part;
        } else {
            any = take_away(at, footprint, out, counts) || any;
            at = node.next;  // its parts are outside
        }
    }
    return any;
}

// Moves the lines together if half of them are of no piece any more.
void LitPart::close_gaps() {
    if (used_lines_ < 2 * live_lines_ + 64) return;
    std::size_t lines = 0;
    for (Node& n : nodes_.first(used_nodes_)) {
        if (n.count == 0) continue;
        std::copy_n(lines_.begin() + n.first, n.count,
                    lines_.begin() + static_cast<std::ptrdiff_t>(lines));
        n.first = static_cast<std::uint32_t>(lines);
        lines += n.count;
    }
    used_lines_ = lines;
}

void LitPart::finish(PieceStore& out) const {
    for (const Node& n : nodes_.first(used_nodes_))
        if (n.count != 0) out.add(facet_, true, lines_of(n));
}

}  // namespace umbra78::shadow::rivals
