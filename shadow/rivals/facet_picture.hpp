// Boxes in the light's picture of one facet and of what may shadow it.
//
// A piece of a facet has no coordinates (pieces.hpp), and a box of it is never asked for an answer:
// only whether another's box is apart from it, so that nothing has to be asked. So a box may be too
// large and must not be too small, and its sides are rounded outward. Unlike the grid's picture
// (light_grid.hpp), which has six faces for a light at a place, that of a facet is on one plane:
// across the axis on which all of the facet is before the light, and is farthest from it. A facet
// that is before the light on no axis has no boxes.
#pragma once

#include "shadow/rivals/light_lines.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// Both ends are in it.
struct PictureBox {
    std::int32_t u0, u1, v0, v1;
    bool overlaps(const PictureBox& o) const {
        return u0 <= o.u1 && o.u0 <= u1 && v0 <= o.v1 && o.v0 <= v1;
    }
};

class FacetPicture {
public:
    FacetPicture() = default;
    FacetPicture(const Setting& setting, std::uint32_t facet);

    bool has_boxes() const { return has_boxes_; }
    // Of whole facets: everything, if some of it is not before the light.
    PictureBox of_facets(const Setting& setting, std::span<const std::uint32_t> facets) const;
    // Of a piece of the picture's own facet.
    PictureBox of_piece(const LightLines& lines, std::span<const LineId> piece) const;

private:
    bool add_facet(const Setting& setting, std::uint32_t facet, PictureBox& box) const;

    bool is_direction_ = true, has_boxes_ = false;
    std::size_t d_ = 0, a_ = 1, b_ = 2;  // the axis across which the picture is, and its own
    std::int64_t sense_ = 1;             // the facet is before the light along axis d, or against
};

}  // namespace umbra78::shadow::rivals
