// What a drawing is asked for (DrawSetup), and the memory that it works in.
#pragma once

#include "hw/band.hpp"
#include "raster/block_form.hpp"
#include "raster/casters.hpp"
#include "raster/dice.hpp"
#include "raster/facet_batch.hpp"
#include "raster/projection.hpp"
#include "raster/shading.hpp"
#include "raster/view.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace umbra78::raster {

// Rounds the view's exact matrix to the unit's words. An affine matrix is refused, too, where a
// raster word could be so large that its corrections and bounds would not fit 64 bits.
hw::LoadStatus load_view(const View& view, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out);
// The same of any matrix from world units to the screen.
hw::LoadStatus load_view(const RationalMatrix& exact, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out);

// How patches become samples: by Catmull's subdivision, or diced to facets (dice.hpp).
enum class PatchForm : std::uint8_t { catmull, diced };

// Which surfaces are drawn: all; those of which a sample may lie in the view; or the others, which
// changes no store. A patch is outside by its control points' bounds, a facet of the mesh by its
// corners.
enum class Drawn : std::uint8_t { all, inside, outside };

struct DrawSetup {
    MachineSpec spec;
    MatrixWords matrix;  // object words to screen
    WordFormat object;
    Sampling sampling = Sampling::centre;
    std::span<const Material> materials;  // at least as many as the patches name
    ShadingSpec shading;                  // read only by a sink that shades
    PatchForm form = PatchForm::catmull;
    int dice_levels = 3;              // at most so many
    std::int64_t dice_tolerance = 0;  // world words
    Facing facing = Facing::both;  // of facets
    // Whether blocks behind what was drawn before are left out. Without it the counts do not depend
    // on the order of the patches.
    bool leaves_out_hidden = true;
    hw::UnitWork work{};  // constants of an affine matrix that the unit computes for every point
    Drawn drawn = Drawn::all;
    Casters casters{};  // of a light's map
    const BlockForm* blocks = nullptr;  // another than the fastest
    bool batches_facets = true;         // where the forms cover them; else each by itself
    hw::Band band{};  // samples of other lines are left out, and blocks that have none in it

    bool by_centres() const {
        return !hw::built(hw::Feature::leaf_sampling) || sampling == Sampling::centre;
    }
    Facing facet_facing() const {
        return casters.facing == Facing::both ? facing : casters.facing;
    }
    // `outside` is asked only where it matters.
    template <class Outside>
    bool draws(Outside&& outside) const {
        return drawn == Drawn::all || outside() == (drawn == Drawn::outside);
    }
};

inline constexpr int deepest_level = 24;  // halvings in each direction
// Splits a patch may take, so that every frame ends: the figures need some hundreds. A patch that
// needs more (one through a light's eye, magnified a thousandfold) loses what is left of it.
inline constexpr std::uint32_t max_splits = 1u << 20;

struct StackBlock {
    std::array<Component, 4> screen;  // x, y, z, or X, Y, Z, W
    std::array<Component, 3> world;   // only where the sink shades
    int level_u, level_v;
    int line;  // of the frame: the worker whose band has it counts the block
};

// A split takes one block from the stack and puts two back, so the stack grows by one a level; the
// popped block and its second half need a place each.
struct DrawMemory {
    std::array<StackBlock, 2 * deepest_level + 2> stack;
    Corners corners;
    std::array<CornerGrid<std::int64_t>, 4> homogeneous;
    BlockSamples samples;
    std::array<std::uint32_t, BlockSamples::most> codes;  // of the samples
    LeafLevels levels;
    struct Nothing {};
    std::conditional_t<hw::built(hw::Feature::dicing), DiceMemory, Nothing> dice;
    std::conditional_t<hw::built(hw::Feature::triangles), FacetMemory, Nothing> facets;
};

}  // namespace umbra78::raster
