// Which facets may lie between a light and a point: a grid over the light's picture of the scene.
//
// The picture of a direction L is a shear: the axis of its largest component is dropped (ties x,
// y, z), say x, and u = y Lx - x Ly, v = z Lx - x Lz, exact. A light at a place has the six faces
// of a cube around it, and on a face u and v are quotients by the depth, rounded down to 20 bits.
// A facet is in every cell that its box touches, edges included, so a point's cell has every facet
// that can be before it; some that are not, too. What the grid leaves out changes no answer.
#pragma once

#include "shadow/rivals/pencil.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// A point, as the light has it.
struct LightPlace {
    int face;
    std::int64_t u, v;
};

struct LightBox {
    int face;
    std::int64_t u0, u1, v0, v1;  // both ends are in it
    bool overlaps(const LightBox& o) const {
        return face == o.face && u0 <= o.u1 && o.u0 <= u1 && v0 <= o.v1 && o.v0 <= v1;
    }
};

class LightPicture {
public:
    explicit LightPicture(const Centre& light);

    int faces() const { return light_.w == 0 ? 1 : 6; }
    // Of a direction: the axis that is dropped, then those of u and v.
    const std::array<std::size_t, 3>& axes() const { return axis_; }
    // The facet's box on a face; false if it has none there.
    bool box(const std::array<Point, 3>& corners, int face, LightBox& out) const;
    // Of the point of a facet's plane that a pixel shows. u and v are rounded down.
    LightPlace place(const SeenPlane& on, const Centre& eye, std::int32_t px,
                     std::int32_t py) const;
    // How far from the light along a face's axis, or along a direction: of two points at one place
    // the nearer has the less.
    std::int64_t depth(const Point& p, int face) const;

private:
    Centre light_;
    std::array<std::size_t, 3> axis_;  // dropped, of u, of v
};

class LightGrid {
public:
    // False if the memory is too small; `needed` is how many bytes it takes. `cells` is the side
    // of a face's grid, a power of two; 0 chooses one by the number of facets.
    bool build(const Setting& setting, int cells, std::span<std::byte> memory,
               std::size_t& needed);

    std::span<const std::uint32_t> facets_at(const LightPlace& p) const {
        return facets_in(cell_at(p));
    }
    const LightPicture& picture() const { return picture_; }
    std::size_t entries() const { return items_.size(); }

    // The cells of all faces, in order of face, row and column.
    std::size_t cells() const { return starts_.size() - 1; }
    std::size_t cell_at(const LightPlace& p) const {
        return (static_cast<std::size_t>(p.face) * side() + row(p.v)) * side() + column(p.u);
    }
    std::span<const std::uint32_t> facets_in(std::size_t cell) const {
        return items_.subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
    }
    // visit(cell) of each that a box touches.
    template <class Visit>
    void for_cells(const LightBox& box, Visit&& visit) const {
        for (std::size_t r = row(box.v0); r <= row(box.v1); ++r)
            for (std::size_t c = column(box.u0); c <= column(box.u1); ++c)
                visit((static_cast<std::size_t>(box.face) * side() + r) * side() + c);
    }

private:
    std::size_t side() const { return static_cast<std::size_t>(cells_); }
    std::size_t column(std::int64_t u) const;
    std::size_t row(std::int64_t v) const;

    LightPicture picture_{Centre{}};
    std::int64_t u0_ = 0, v0_ = 0;
    int shift_u_ = 0, shift_v_ = 0, cells_ = 1;
    std::span<std::uint32_t> starts_, items_;
};

}  // namespace umbra78::shadow::rivals
