#include "raster/tile_walk.hpp"

namespace umbra78::raster {
namespace {

using detail::turn;

// Within so far from a corner an edge's value times a depth fits 63 bits for any centre of the box.
constexpr std::int32_t near_extent = 1 << 18;
static_assert(2 * max_tiled_depth <= INT64_MAX / (std::int64_t{4} * near_extent * near_extent));
static_assert(2 * max_tiled_depth <= INT64_MAX / (std::int64_t{4} * max_tiled * pixel_units));

// An edge's value changes by at most so much within a tile.
constexpr std::int64_t tile_reach = std::int64_t{max_tiled} * (TileColumns::most + tile_lines);
static_assert(2 * tile_reach <= INT32_MAX);

// What stands for an edge's value where no centre of a tile is outside: it stays positive for any
// column.
constexpr std::int32_t max_inner = TileColumns::most * max_tiled;
static_assert(std::int64_t{2} * max_inner <= INT32_MAX);

// a + n b modulo 2^64: of a sliver's slope, which no two of its centres are apart for.
std::int64_t wrapped_sum(std::int64_t a, std::int64_t n, std::int64_t b) {
    const auto word = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
    return static_cast<std::int64_t>(word(a) + word(n) * word(b));
}

}  // namespace

TileWalk::TileWalk(const TriangleBatch& batch, std::size_t slot, std::int32_t half_px)
    : slot_(static_cast<std::uint16_t>(slot)), half_px_(half_px), x0_(batch.x0[slot]),
      x1_(batch.x1[slot]), y0_(batch.y0[slot]), y1_(batch.y1[slot]), area_(batch.area[slot]) {
    const std::array<Corner, 3> at{batch.corner(0, slot), batch.corner(1, slot),
                                   batch.corner(2, slot)};
    const auto& [a, b, c] = at;
    const std::int32_t x = pixel_centre(x0_, half_px), y = pixel_centre(y0_, half_px);
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner &p = at[(k + 1) % 3], &q = at[(k + 2) % 3];
        edge_[k] = fixed::floor_shift(turn(p, q, x, y) - batch.less[k][slot], raster_fraction);
        right_[k] = p.y - q.y;
        down_[k] = q.x - p.x;
    }
    const std::int64_t bz = std::int64_t{b.z} - a.z, cz = std::int64_t{c.z} - a.z;
    column_ = over_area((bz * right_[1] + cz * right_[2]) * pixel_units);
    line_ = over_area((bz * down_[1] + cz * down_[2]) * pixel_units);
    const auto [low_x, high_x] = std::minmax({a.x, b.x, c.x});
    const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
    const bool small = std::max(high_x - low_x, high_y - low_y) <= near_extent;
    near_x_ = small ? x0_ : last_pixel(a.x, half_px);
    near_y_ = small ? y0_ : last_pixel(a.y, half_px);
    const std::int32_t nx = pixel_centre(near_x_, half_px), ny = pixel_centre(near_y_, half_px);
    const std::int64_t n = turn(c, a, nx, ny) * bz + turn(a, b, nx, ny) * cz;
    near_ = over_area(n + fixed::floor_shift(area_, 1));
    near_.quotient += a.z;
    columns_ = x1_ - x0_ < TileColumns::most / 2 ? TileColumns::most / 2 : TileColumns::most;
    Fraction at_column{0, 0};
    for (int k = 0; k < columns_; ++k) {
        at_.quotient[k] = static_cast<std::int32_t>(at_column.quotient);
        at_.remainder[k] = at_column.remainder;
        for (std::size_t e = 0; e < 3; ++e) at_.edge[e][k] = k * right_[e];
        at_column.quotient = wrapped_sum(at_column.quotient, 1, column_.quotient);
        at_column.remainder += column_.remainder;
        const bool carries = at_column.remainder >= area_;
        at_column.remainder -= carries ? area_ : 0;
        at_column.quotient = wrapped_sum(at_column.quotient, 1, carries ? 1 : 0);
    }
}

// The frame's last columns belong to a tile that begins further left.
void TileWalk::take_columns(int px) {
    first_ = std::min<std::int32_t>(px, 2 * half_px_ - columns_);
    for (int k = 0; k < columns_; ++k)
        at_.taken[k] = first_ + k >= px && first_ + k <= x1_ ? -1 : 0;
}

bool TileWalk::make(int py, Tile& out) const {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t e = edge_[k] + std::int64_t{first_ - x0_} * right_[k] +
                               std::int64_t{py - y0_} * down_[k];
        if (e < -tile_reach) return false;
        const bool inner = e > tile_reach;
        out.edge[k] = inner ? max_inner : static_cast<std::int32_t>(e);
        out.down[k] = inner ? 0 : down_[k];
    }
    Fraction depth = near_;
    const std::int64_t columns = first_ - near_x_, lines = py - near_y_;
    if (columns != 0 || lines != 0) {
        const Fraction carried =
            over_area(near_.remainder + columns * column_.remainder + lines * line_.remainder);
        depth.quotient = wrapped_sum(depth.quotient, columns, column_.quotient);
        depth.quotient = wrapped_sum(depth.quotient, lines, line_.quotient);
        depth.quotient = wrapped_sum(depth.quotient, 1, carried.quotient);
        depth.remainder = carried.remainder;
    }
    out.slot = slot_;
    out.px = static_cast<std::uint16_t>(first_);
    out.py = static_cast<std::uint16_t>(py);
    out.columns = columns_;
    out.lines = std::min<std::int32_t>(y1_ - py + 1, tile_lines);
    out.value = static_cast<std::int32_t>(depth.quotient);  // modulo 2^32: of no centre outside
    out.rest = depth.remainder;
    out.down_quotient = static_cast<std::int32_t>(line_.quotient);
    out.down_remainder = line_.remainder;
    out.area = area_;
    return true;
}

}  // namespace umbra78::raster
