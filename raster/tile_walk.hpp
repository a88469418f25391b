// A triangle in tiles of 8 or 16 columns and at most 64 lines, for the lanes (facet_form.hpp).
//
// The depth at a centre is floor((n + floor(area / 2)) / area) over corner a's, with
//
//   n = e_b (b.z - a.z) + e_c (c.z - a.z)        e: an edge's value there, triangle.hpp
//
// which is half_up(n / area). n changes by one amount from column to column and by another from
// line to line, so its quotient and remainder are found once, at a centre near which the products
// fit 64 bits, and stepped from there.
#pragma once

#include "raster/facet_form.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::raster {

class TileWalk {
public:
    // Of a triangle that measure() found to be `tiled`.
    TileWalk(const TriangleBatch& batch, std::size_t slot, std::int32_t half_px);

    // Hands every tile that may hold a sample to `visit`, with its columns.
    template <class Visit>
    void tiles(Visit&& visit) {
        for (int px = x0_; px <= x1_; px += columns_) {
            take_columns(px);
            for (int py = y0_; py <= y1_; py += tile_lines) {
                Tile tile;
                if (make(py, tile)) visit(tile, at_);
            }
        }
    }

private:
    struct Fraction {  // quotient + remainder / area
        std::int64_t quotient, remainder;
    };
    Fraction over_area(std::int64_t n) const {
        const std::int64_t truncated = n / area_, left = n - truncated * area_;
        return left < 0 ? Fraction{truncated - 1, left + area_} : Fraction{truncated, left};
    }
    // The columns from px on.
    void take_columns(int px);
    // False if no centre of the tile is on the inner side of all edges.
    bool make(int py, Tile& out) const;

    std::uint16_t slot_;
    std::int32_t half_px_;
    std::int32_t x0_, x1_, y0_, y1_;
    std::int64_t area_;
    std::array<std::int64_t, 3> edge_;  // at (x0, y0), less raster_fraction bits
    std::array<std::int32_t, 3> right_, down_;
    int near_x_, near_y_;  // the pixel where the depth is found
    Fraction near_{}, column_{}, line_{};
    std::int32_t columns_, first_;  // of a tile; the first of the tiles now being made
    TileColumns at_;
};

}  // namespace umbra78::raster
