// Sampling: a block's 17 x 17 corners to samples of pixels (hw/MACHINE.md, section 7).
//
// In: corners in raster units, 31-bit words. Out: samples, Z in raster units, of which depth_code
// makes a Z code.
//
// leaf    The leaf's centre, the mean of its four corners, falls in one pixel. Catmull's own.
// centre  A leaf is the triangles (00, 10, 11) and (00, 11, 01). A pixel whose centre p lies in
//         one gets the Z of the triangle's plane there:
//
//           z = az + round((w_b (bz - az) + w_c (cz - az)) / |A|),  clamped to the corners' range
//
//         with the edge functions w and the doubled area A. "In" allows a slack of 1/64 pixel:
//         p is inside the triangle's box and on the inner side of each edge, both grown by the
//         slack (w >= -slack (|dx| + |dy|)). So neighbours that were split to different depths
//         leave no crack; pixels covered twice do no harm, since the nearest wins in any order.
#pragma once

#include "raster/block_rule.hpp"
#include "raster/leaf_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace umbra78::raster {

enum class Sampling : std::uint8_t { leaf, centre };

inline constexpr std::int32_t slack = 128;  // 1/64 pixel

// The farthest that two corners of a triangle may lie apart in X or in Y so that an edge function
// of a place within the triangle's box and the slack fits 32 bits. Almost four pixels.
inline constexpr std::int32_t max_triangle = (1 << 15) - 1 - slack;
static_assert(std::int64_t{2} * max_triangle * (max_triangle + slack) <= INT32_MAX);

// In an orthographic view no leaf is wider: the block rule's slopes and the corners' rounding make
// less than a pixel. In perspective the corners' rounding may be worth pixels where W is a word of
// a few units (a view of some object words' width); a wider triangle takes the wide form.
inline constexpr std::int64_t max_affine_leaf = max_slope / leaves + 2 * max_corner_error;
static_assert(max_affine_leaf <= pixel_units && pixel_units <= max_triangle);

struct Sample {
    int px, py;           // pixel, 0 is left and top
    std::int32_t x, y;    // where it was taken, raster units from the centre of the frame
    std::int64_t z;       // raster units
    int leaf_i, leaf_j;   // within the block
    bool second = false;  // of the leaf's triangles, in centre sampling
};

constexpr std::size_t leaf_number(const Sample& s) {
    return static_cast<std::size_t>(leaves * s.leaf_j + s.leaf_i);
}

using Corners = std::array<CornerGrid<std::int32_t>, 3>;

struct Corner {
    std::int32_t x, y, z;
};

inline Corner corner_at(const Corners& g, int i, int j) {
    const auto u = static_cast<std::size_t>(i), v = static_cast<std::size_t>(j);
    return {g[0][v][u], g[1][v][u], g[2][v][u]};
}

namespace detail {
// Twice the signed area of p, q and a place; positive where the turn is clockwise on the screen.
constexpr std::int64_t turn(const Corner& p, const Corner& q, std::int64_t x, std::int64_t y) {
    return (std::int64_t{q.x} - p.x) * (y - p.y) - (x - p.x) * (std::int64_t{q.y} - p.y);
}

// triangle_depth for triangles of any size and a place in their box.
bool wide_triangle_depth(const Corner& a, const Corner& b, const Corner& c, std::int32_t x,
                         std::int32_t y, std::int64_t& z);
}  // namespace detail

// The triangle's depth at (x, y), rounded half up; false where it does not cover the place.
inline bool triangle_depth(const Corner& a, const Corner& b, const Corner& c, std::int32_t x,
                           std::int32_t y, std::int64_t& z) {
    const auto [min_x, max_x] = std::minmax({a.x, b.x, c.x});
    const auto [min_y, max_y] = std::minmax({a.y, b.y, c.y});
    if (x < min_x - slack || x > max_x + slack) return false;
    if (y < min_y - slack || y > max_y + slack) return false;
    if (max_x - min_x > max_triangle || max_y - min_y > max_triangle) [[unlikely]]
        return detail::wide_triangle_depth(a, b, c, x, y, z);
    const auto edge = [&](const Corner& p, const Corner& q, std::int32_t rx, std::int32_t ry) {
        return (q.x - p.x) * (ry - p.y) - (rx - p.x) * (q.y - p.y);
    };
    std::int32_t area = edge(a, b, c.x, c.y);
    if (area == 0) return false;  // edge-on: its neighbours cover what it would
    const std::int32_t sign = area < 0 ? -1 : 1;
    area *= sign;
    const std::int32_t wc = sign * edge(a, b, x, y), wa = sign * edge(b, c, x, y);
    const std::int32_t wb = sign * edge(c, a, x, y);
    const auto grown = [](const Corner& p, const Corner& q) {
        const std::int32_t dx = q.x - p.x, dy = q.y - p.y;
        return -slack * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
    };
    if (wc < grown(a, b) || wa < grown(b, c) || wb < grown(c, a)) return false;
    const std::int64_t rise = std::int64_t{wb} * (std::int64_t{b.z} - a.z) +
                              std::int64_t{wc} * (std::int64_t{c.z} - a.z);
    z = a.z + fixed::round_divide(rise, area, fixed::Rounding::half_up);
    z = std::clamp<std::int64_t>(z, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z}));
    return true;
}

// A pixel's centre in raster units from the centre of the frame; the first pixel whose centre is
// at a place or right of it, and the last whose centre is at it or left of it. |at| <= 2^30.
constexpr std::int32_t pixel_centre(int p, std::int32_t half_px) {
    return (2 * (p - half_px) + 1) * (1 << (raster_fraction - 1));
}
constexpr std::int32_t first_pixel(std::int32_t at, std::int32_t half_px) {
    const std::int32_t up = (1 << raster_fraction) - 1;
    return fixed::floor_shift(at - pixel_centre(0, half_px) + up, raster_fraction);
}
constexpr std::int32_t last_pixel(std::int32_t at, std::int32_t half_px) {
    return fixed::floor_shift(at - pixel_centre(0, half_px), raster_fraction);
}

// The pixels whose centres a leaf's box, grown by the slack, may hold: one row of leaves at once.
struct CentreWindow {
    std::array<std::int32_t, leaves> x0, x1, y0, y1;
};

inline void centre_windows(const Corners& g, int j, std::int32_t half_px, CentreWindow& w) {
    const std::int32_t last = 2 * half_px - 1;
    const auto v = static_cast<std::size_t>(j);
    const auto axis = [&](const CornerGrid<std::int32_t>& c, auto& first_px, auto& last_px) {
        for (std::size_t u = 0; u < leaves; ++u) {
            const std::int32_t min =
                std::min(std::min(c[v][u], c[v][u + 1]), std::min(c[v + 1][u], c[v + 1][u + 1]));
            const std::int32_t max =
                std::max(std::max(c[v][u], c[v][u + 1]), std::max(c[v + 1][u], c[v + 1][u + 1]));
            first_px[u] = std::max<std::int32_t>(first_pixel(min - slack, half_px), 0);
            last_px[u] = std::min(last_pixel(max + slack, half_px), last);
        }
    };
    axis(g[0], w.x0, w.x1);
    axis(g[1], w.y0, w.y1);
}

// Hands every sample of the block to `emit`, leaf by leaf. This is the definition; drawing uses the
// forms of block_form.hpp. Returns how many centres were tested.
template <class Emit>
std::uint64_t sample_centres(const Corners& g, const hw::MachineSpec& spec, Emit&& emit) {
    std::uint64_t tested = 0;
    const std::int32_t half = spec.half_px();
    CentreWindow w;
    for (int j = 0; j < leaves; ++j) {
        centre_windows(g, j, half, w);
        for (int i = 0; i < leaves; ++i) {
            const auto u = static_cast<std::size_t>(i);
            if (w.x0[u] > w.x1[u] || w.y0[u] > w.y1[u]) continue;
            const Corner c00 = corner_at(g, i, j), c10 = corner_at(g, i + 1, j);
            const Corner c01 = corner_at(g, i, j + 1), c11 = corner_at(g, i + 1, j + 1);
            tested += static_cast<std::uint64_t>((w.x1[u] - w.x0[u] + 1) * (w.y1[u] - w.y0[u] + 1));
            for (int py = w.y0[u]; py <= w.y1[u]; ++py) {
                for (int px = w.x0[u]; px <= w.x1[u]; ++px) {
                    const std::int32_t x = pixel_centre(px, half), y = pixel_centre(py, half);
                    std::int64_t z = 0;
                    if (triangle_depth(c00, c10, c11, x, y, z)) emit(Sample{px, py, x, y, z, i, j});
                    if (triangle_depth(c00, c11, c01, x, y, z))
                        emit(Sample{px, py, x, y, z, i, j, true});
                }
            }
        }
    }
    return tested;
}

// Hands the sample of every leaf whose mean lies in the frame to `emit`.
template <class Emit>
void sample_leaves(const Corners& g, const hw::MachineSpec& spec, Emit&& emit) {
    const std::int64_t half = spec.half_px() * pixel_units;
    for (int j = 0; j < leaves; ++j) {
        for (int i = 0; i < leaves; ++i) {
            const Corner a = corner_at(g, i, j), b = corner_at(g, i + 1, j);
            const Corner c = corner_at(g, i, j + 1), d = corner_at(g, i + 1, j + 1);
            const auto mean = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
                return half_up<std::int64_t>(p + q + r + s, 2);
            };
            const std::int64_t x = mean(a.x, b.x, c.x, d.x), y = mean(a.y, b.y, c.y, d.y);
            const std::int64_t px = fixed::floor_shift(x + half, raster_fraction);
            const std::int64_t py = fixed::floor_shift(y + half, raster_fraction);
            if (px < 0 || py < 0 || px >= spec.size_px() || py >= spec.size_px()) continue;
            emit(Sample{static_cast<int>(px), static_cast<int>(py), static_cast<std::int32_t>(x),
                        static_cast<std::int32_t>(y), mean(a.z, b.z, c.z, d.z), i, j});
        }
    }
}

// A sample's Z code, rounded by spec.depth_rounding; false where the sample lies before the near
// plane or beyond the far one. What would get the background's code gets one code less; a store of
// floats keeps the nearest of theirs. Half up without floats, which the figures use, takes fewer
// steps than the others.
class DepthCoder {
public:
    explicit constexpr DepthCoder(const hw::MachineSpec& spec)
        : spec_(spec), guard_(depth_guard(spec)), offset_(spec.depth_offset()),
          background_(spec.background()),
          plain_(spec.depth_rounding == fixed::Rounding::half_up && guard_ > 0 &&
                 spec.depth_store == hw::DepthStore::fixed) {}

    [[gnu::always_inline]] constexpr bool operator()(std::int64_t z, std::uint32_t& code) const {
        if (!plain_) [[unlikely]] return general(z, code);
        return of_rounded(half_up(z, guard_), code);
    }
    // Of a sample that was moved away from the near plane; not beyond the far one.
    constexpr std::uint32_t moved(std::int64_t z) const {
        std::uint32_t code = 0;
        return general(z, code) ? code : spec_.kept(static_cast<std::uint32_t>(background_) - 1);
    }

private:
    constexpr bool general(std::int64_t z, std::uint32_t& code) const {
        if (!of_rounded(fixed::round_shift(z, guard_, spec_.depth_rounding), code)) return false;
        code = spec_.kept(code);
        return true;
    }
    constexpr bool of_rounded(std::int64_t rounded, std::uint32_t& code) const {
        const std::int64_t c = rounded + offset_;
        if (c < 0 || c > background_) return false;
        code = static_cast<std::uint32_t>(c) - (c == background_ ? 1 : 0);
        return true;
    }

    hw::MachineSpec spec_;
    int guard_;
    std::int64_t offset_, background_;
    bool plain_;
};

constexpr bool depth_code(std::int64_t z, const hw::MachineSpec& spec, std::uint32_t& code) {
    return DepthCoder(spec)(z, code);
}

}  // namespace umbra78::raster
