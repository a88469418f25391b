// The sectors of a light that shines in all directions: six views from its place, the faces of a
// cube about it (Williams 1978, p. 272: the sphere of illumination, sectored; hw/MACHINE.md,
// section 25).
//
//   D_a     the place of a point less the light's, along the world's axis a, times the point's
//           homogeneous W > 0
//   sector  2 a + (D_a < 0), with |D_a| the largest; of equal ones the first of x, y, z
//   X, Y    half_px times two of the D over W = |D_a|, in the sector's own axes
//   Z       the sector's row Z over the same W
//
// Membership is decided from the exact sums and never from rounded results, so that each point has
// one sector. All six faces read the same three rows, so that a point's X and Y lie on its face.
// A unit that is loaded for a sector holds D_x, D_y, D_z in its rows X, Y, W, and the sector's own
// row in Z: what a face has as X, Y and W are these sums exchanged and negated, not other words.
//
// In: screen words of the observer. Out: as hw/transform_unit.hpp.
#pragma once

#include "hw/transform_unit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::hw {

inline constexpr int sector_count = 6;
inline constexpr int no_sector = -1;

// D_x, D_y, D_z: the sums of the unit's rows X, Y, W.
using Direction = std::array<std::int64_t, 3>;

constexpr std::size_t axis_of(int sector) { return static_cast<std::size_t>(sector / 2); }
constexpr bool looks_back(int sector) { return sector % 2 == 1; }
constexpr std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

// The sector that a direction is sorted into. A point in the light's own place has none.
constexpr int sector_of(const Direction& d) {
    std::size_t axis = 0;
    for (std::size_t b = 1; b < 3; ++b)
        if (magnitude(d[b]) > magnitude(d[axis])) axis = b;
    if (d[axis] == 0) return no_sector;
    return static_cast<int>(2 * axis) + (d[axis] < 0 ? 1 : 0);
}

// The same, asked by one sector alone: whether a direction lies in its cone.
constexpr bool in_cone(int sector, const Direction& d) {
    const std::size_t axis = axis_of(sector);
    const std::int64_t w = looks_back(sector) ? -d[axis] : d[axis];
    if (w <= 0) return false;
    for (std::size_t b = 0; b < 3; ++b)
        if (b < axis ? magnitude(d[b]) >= w : magnitude(d[b]) > w) return false;
    return true;
}

// A sector's X, Y and W, each one of the sums with a sign.
struct FaceAxis {
    std::size_t of;
    bool negated;
    constexpr std::int64_t operator()(const Direction& d) const { return negated ? -d[of] : d[of]; }
};
struct Face {
    FaceAxis x, y, w;
};
// From the axes of section 4's view along +x, -x, +y, -y, +z, -z: right, down and forward.
inline constexpr std::array<Face, sector_count> faces{{
    {{2, false}, {1, true}, {0, false}},
    {{2, true}, {1, true}, {0, true}},
    {{0, false}, {2, true}, {1, false}},
    {{0, false}, {2, false}, {1, true}},
    {{0, true}, {1, true}, {2, false}},
    {{0, false}, {1, true}, {2, true}},
}};

using ExactRow = std::array<Rational, 4>;

// Rounds D_x, D_y, D_z with one exponent for the three, the smallest that holds all their words,
// and a sector's row Z with its own. Refused as load_matrix() refuses.
LoadStatus load_sector(const std::array<ExactRow, 3>& directions, const ExactRow& z,
                       const MachineSpec& spec, WordFormat input, MatrixWords& out);

// The rows of a sector as those of a view of its own: what SectorUnit computes, as long as the
// accumulators drop no bits.
constexpr MatrixWords face_matrix(const MatrixWords& loaded, int sector) {
    constexpr std::array<std::size_t, 3> holds{0, 1, 3};
    const Face& face = faces[static_cast<std::size_t>(sector)];
    MatrixWords made = loaded;
    const auto row = [&](std::size_t to, const FaceAxis& axis) {
        for (std::size_t c = 0; c < 4; ++c) {
            const std::int32_t word = loaded.word[holds[axis.of]][c];
            made.word[to][c] = axis.negated ? -word : word;
        }
    };
    row(0, face.x);
    row(1, face.y);
    row(3, face.w);
    return made;
}

// The unit of one sector.
class SectorUnit {
public:
    SectorUnit(const MachineSpec& spec, const MatrixWords& matrix, int sector)
        : unit_(spec, matrix), sector_(sector) {}

    Direction direction(const Words& v) const {
        return {unit_.sum(Row::x, v), unit_.sum(Row::y, v), unit_.sum(Row::w, v)};
    }
    // Of a point whose direction is known.
    Point operator()(const Words& v, const Direction& d) const {
        const Face& face = faces[static_cast<std::size_t>(sector_)];
        return unit_.quotients({face.x(d), face.y(d), unit_.sum(Row::z, v), face.w(d)});
    }
    Point operator()(const Words& v) const { return (*this)(v, direction(v)); }
    bool holds(const Direction& d) const { return in_cone(sector_, d); }

private:
    TransformUnit unit_;
    int sector_;
};

}  // namespace umbra78::hw
