// The forms of a block's work: one meaning, once for each instruction set.
//
//   expand    the corners of its 16 x 16 leaves                         leaf_grid.hpp
//   centres   its samples at the pixels' centres                        sampling.hpp
//   leaves    its samples at the leaves' centres                        sampling.hpp
//   shade     the levels of its leaves                                  shading.hpp
//   measure_normals, shade_normals
//             the same of samples with these normals, of which the first does what does not
//             depend on a light
//
// The headers named on the right are the definitions. The forms are one text, block_body.hpp, of
// loops over 16 leaves that the compiler makes vectors of, once for each of fixed/lane_sets.hpp.
// The program asks the processor once a drawing and takes the last form that it has. Tests run
// every form that the machine has and compare it bit for bit with the definitions.
//
// centres and leaves step back where a word may not fit their lanes: they return false, and the
// definition does the block. shade() is asked only for what BlockShading::job covers.
#pragma once

#include "raster/facet_form.hpp"
#include "raster/sampling.hpp"
#include "raster/shade_job.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::raster {

// A sample as a block's list has it. The leaf's number is 16 j + i.
struct BlockSample {
    std::int32_t x, y, z;
    std::uint8_t leaf;
    bool second;
};

struct BlockSamples {
    static constexpr std::size_t most = 2 * leaves * leaves + 1;  // one place is written in vain
    std::size_t count;
    std::uint64_t tested;  // centres
    std::array<BlockSample, most> sample;
};

struct BlockForm {
    std::string_view name;
    bool (*supported)();  // by this processor
    void (*expand)(const std::array<Component, 3>& block, Corners& grid);
    bool (*centres)(const Corners& grid, std::int32_t half_px, BlockSamples& out);
    bool (*leaves)(const Corners& grid, std::int32_t half_px, BlockSamples& out);
    // Of `count` leaves, by their numbers; there is room for 15 more numbers behind them.
    void (*shade)(const ShadeJob& job, std::uint8_t* numbers, std::size_t count, LeafLevels& out);
    // Of the job only the viewer is read.
    void (*measure_normals)(const ShadeJob& job, SampleNormals& normals);
    // Of the first `count` of these normals, by their order. They were measured for this viewer.
    void (*shade_normals)(const ShadeJob& job, const SampleNormals& normals, std::size_t count,
                          LeafLevels& out);
    FacetForm facets;
};

// All that are compiled in, `plain` first, the fastest last.
std::span<const BlockForm> block_forms();
// The last one that is supported.
const BlockForm& fastest_block_form();

}  // namespace umbra78::raster
