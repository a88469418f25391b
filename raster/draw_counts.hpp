// What a drawing of a view counts (draw.hpp), from which drawing_cost.hpp makes operations.
#pragma once

#include <cstdint>

namespace umbra78::raster {

struct DrawCounts {
    std::uint64_t subdivided() const { return patches - diced_patches; }
    std::uint64_t patches = 0, blocks = 0;
    std::uint64_t samples = 0;        // handed to the sink: pixels drawn, with their overdraw
    std::uint64_t facet_samples = 0;  // those of facets among them
    std::uint64_t hidden_blocks = 0;  // left out behind what was drawn before
    std::uint64_t unresolved = 0;     // dropped: no level or split left, or no quotient
    std::uint64_t tested_blocks = 0;  // whose action was decided
    std::uint64_t splits = 0;
    std::uint64_t tested_centres = 0;  // pixel centres in a leaf's window
    std::uint64_t facets = 0, cut_facets = 0;  // of the mesh; those cut to the guard band
    std::uint64_t diced_patches = 0, diced_vertices = 0;
    std::uint64_t turned_triangles = 0;          // left out by their facing
    std::uint64_t triangles = 0;               // that may cover a centre
    std::uint64_t triangle_lines = 0;          // scan lines in their boxes
    std::uint64_t unresolved_facets = 0;       // dropped: a corner has no quotient

    DrawCounts& operator+=(const DrawCounts&);
};

}  // namespace umbra78::raster
