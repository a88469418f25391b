// The forms of a mesh's work, for many facets at once; like block_form.hpp's, once for each
// instruction set.
//
//   see       16 vertices in an affine view                              facet.hpp
//   measure   a batch's triangles: side, area, which centres their boxes hold
//   few       samples of triangles whose box holds few centres           triangle.hpp
//   tile      samples of some columns of a larger triangle                triangle.hpp
//   put       a sample that was found elsewhere
//   shade     the levels of samples                                      facet.hpp
//
// The headers named on the right are the definitions; the text is facet_body.hpp. What a word of
// the lanes does not hold is left to the definition: measure() says so of a triangle.
#pragma once

#include "raster/scene.hpp"
#include "raster/shade_job.hpp"
#include "raster/triangle.hpp"

#include <array>
#include <cstdint>

namespace umbra78::raster {

// Vertices in an affine view: round((c . object word + constant) / 2^down), half up or floored.
struct VertexRow {
    std::int32_t coefficient[3];
    std::int64_t constant;  // with what is added to round
    int down;
    std::int64_t edge, band;  // of the cube, of the guard band
};
struct VertexJob {
    int object_down;  // from world words to object words
    VertexRow row[3];
};
// outside: a bit for each side of the cube that it lies beyond, and one for the guard band.
struct SeenVertex {
    static constexpr std::uint32_t beyond_band = 1 << 6;
    std::int32_t x, y, z;
    std::uint32_t outside;
};

enum class TriangleKind : std::uint8_t {
    turned,  // away
    empty,   // its box holds no centre, or it has no area
    few,     // its box holds few centres, and its edges' values fit 32 bits
    tiled,   // as TileWalk does it
    wide,    // left to the definition
};

inline constexpr std::int32_t max_few = (1 << 15) - 1;  // how far apart its corners may lie
inline constexpr std::int32_t most_few = 9;             // centres
static_assert(std::int64_t{2} * max_few * max_few <= INT32_MAX);

// The same for tiles: 2^10 pixels, and 2^22 in depth.
inline constexpr std::int32_t max_tiled = 1 << 23, max_tiled_depth = 1 << 22;

struct MeasureJob {
    std::int32_t half_px;
    bool clockwise, counter_clockwise, edge_on;  // which are drawn
};

// Triangles of one material. measure() puts their corners in clockwise order, so that the areas are
// positive, by exchanging b and c. Edge 0 lies opposite of a; `less` is 1 where a centre on the
// edge is another triangle's (the top-left rule).
struct TriangleBatch {
    static constexpr std::size_t most = 256;
    std::size_t count;
    std::uint32_t facet[most];
    SeenVertex seen[3][most];  // as the facet has them

    std::int32_t x[3][most], y[3][most], z[3][most];
    std::int64_t area[most];
    std::int32_t less[3][most];
    std::int32_t x0[most], x1[most], y0[most], y1[most];  // pixels whose centres the box holds
    std::uint8_t kind[most];       // TriangleKind
    std::uint8_t exchanged[most];  // b and c

    Corner corner(std::size_t c, std::size_t slot) const {
        return {x[c][slot], y[c][slot], z[c][slot]};
    }
};

// A pixel in one word.
constexpr std::uint32_t place_of(std::uint32_t px, std::uint32_t py) { return py << 16 | px; }

// Centres to be tested, each with the triangle it may lie in.
struct CentreList {
    static constexpr std::size_t most = 1024;
    std::size_t count;
    std::uint32_t place[most];
    std::uint16_t slot[most];
};

// A store of 16-bit codes, whose samples round half up. Where it keeps depth alone the lanes put
// samples there; else they leave out those that lie behind what is there. Without `codes` they do
// neither.
struct CodePlane {
    std::uint16_t* codes;
    int xy_bits, guard;
    std::int32_t offset, background;
    bool depth_alone;
};

inline constexpr int tile_lines = 64;
struct FacetSamples {
    static constexpr std::size_t most = 2048 + 16;  // 16 places may be written in vain
    std::size_t count;
    std::uint64_t coded;  // samples with a code, kept or not
    std::int32_t z[most];        // or their codes, where there are codes
    std::uint32_t place[most];   // place_of
    std::uint16_t slot[most];

    bool has_room(std::size_t more) const { return count + more + 16 < most; }
};

// Some columns of a triangle and some of its lines. The first centre is that of column 0. An edge's
// value is the exact one less raster_fraction low bits, floored, which keeps its sign: from centre
// to centre it changes by whole multiples. The depth is value + rest / area, floored.
struct TileColumns {
    static constexpr int most = 16;
    std::int32_t edge[3][most];      // beyond column 0's
    std::int32_t quotient[most];     // and so of the depth
    std::int64_t remainder[most];
    std::int32_t taken[most];        // all ones, or 0: not a column of the tile's
};
struct Tile {
    std::uint16_t slot, px, py;
    int columns, lines;  // 8 or 16 columns, all in the frame
    std::int32_t edge[3], down[3];
    std::int32_t value, down_quotient;
    std::int64_t rest, down_remainder, area;
};

// For shading: corner a's normal times 1024 and the others' less a's, turned to the side seen.
struct FacetNormals {
    std::int32_t base[3][TriangleBatch::most];
    std::int32_t to_b[3][TriangleBatch::most], to_c[3][TriangleBatch::most];
};

struct FacetForm {
    void (*see)(const VertexJob& job, const World* first, SeenVertex* out);
    void (*measure)(const MeasureJob& job, TriangleBatch& batch);
    // Appends. There is room.
    void (*few)(const TriangleBatch& batch, CentreList& list, std::int32_t half_px,
                const CodePlane& plane, FacetSamples& out);
    void (*tile)(const Tile& tile, const TileColumns& columns, const CodePlane& plane,
                 FacetSamples& out);
    // What is behind the last sample.
    void (*put)(const CodePlane& plane, FacetSamples& out);
    // Of `count` samples from `first` on, at most 256; their levels are numbered from 0.
    void (*shade)(const ShadeJob& job, const TriangleBatch& batch, const FacetNormals& normals,
                  std::int32_t half_px, const FacetSamples& list, std::size_t first,
                  std::size_t count, LeafLevels& out);
};

}  // namespace umbra78::raster
