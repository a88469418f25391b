// Drawing: surfaces to samples. Patches become blocks of 16 x 16 leaves (Catmull's subdivision,
// 1974), facets triangles (facet.hpp, triangle.hpp).
//
//   control points --transform unit--> components of a block --split by block_action-->
//   17 x 17 corners --sampling--> samples with their Z code, handed to a sink
//
// In: surfaces in world words, a view's loaded matrix, materials and light. Out: calls of the sink,
// and counts. A block that is too large after all its splits is dropped, counted as `unresolved`.
// A block whose nearest point is hidden in its whole footprint cannot change the frame and is left
// out. No allocation: the caller hands in one DrawMemory.
// Not emulated: the clock (drawing_cost.hpp makes operations of the counts).
#pragma once

#include "hw/features.hpp"
#include "raster/casters.hpp"
#include "raster/dice.hpp"
#include "raster/diced_view.hpp"
#include "raster/draw_counts.hpp"
#include "raster/facet.hpp"
#include "raster/footprint.hpp"
#include "raster/leaf_centres.hpp"
#include "raster/places.hpp"
#include "raster/projection.hpp"
#include "raster/sampling.hpp"
#include "raster/shading.hpp"
#include "raster/view.hpp"

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <type_traits>

namespace umbra78::raster {

// What is done with samples.
//   shades        a constant: whether sample() is given the block's shading, or nullptr
//   hidden(f)     whether every sample with this footprint would change nothing
//   sample(...)   one sample, its Z code and the shading of its block or facet
template <class T>
concept Sink = requires(T& sink, const T& unchanged, const Footprint& footprint,
                        const Sample& sample, std::uint32_t code, const BlockShading* shading,
                        const FacetShading* of_facet) {
    typename std::bool_constant<T::shades>;
    { unchanged.hidden(footprint) } -> std::same_as<bool>;
    { sink.sample(sample, code, shading) } -> std::same_as<void>;
    { sink.sample(sample, code, of_facet) } -> std::same_as<void>;
};

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
};

// A split takes one block from the stack and puts two back, so the stack grows by one a level; the
// popped block and its second half need a place each.
struct DrawMemory {
    std::array<StackBlock, 2 * deepest_level + 2> stack;
    Corners corners;
    std::array<CornerGrid<std::int64_t>, 4> homogeneous;
    struct Nothing {};
    std::conditional_t<hw::built(hw::Feature::dicing), DiceMemory, Nothing> dice;
};

namespace detail {

// Divides the corners of a perspective block; false if one has no quotient.
bool divide_corners(const std::array<CornerGrid<std::int64_t>, 4>& homogeneous,
                    const MachineSpec& spec, Corners& out);

// Everything but the sink: the current block's place on the stack and its corners.
class BlockWalk {
public:
    BlockWalk(const DrawSetup& setup, DrawMemory& memory, bool shades, DrawCounts& counts)
        : setup_(setup), memory_(memory), shades_(shades), counts_(counts) {}

    void push_patch(const Patch& patch);
    // Whether the patch pushed last is out of the view as a whole, and how it is taken off again.
    bool outside() const {
        ScreenBounds bounds;
        return action(memory_.stack[depth_ - 1], bounds) == BlockAction::outside;
    }
    void drop_patch() { --depth_; }
    // Pops, splits and pushes until a block is ready to be drawn; false when none is left.
    bool next(ScreenBounds& bounds);
    // The popped block's corners; false if it had to be dropped.
    bool make_corners();
    const StackBlock& block() const { return memory_.stack[depth_]; }

private:
    bool affine() const { return !setup_.matrix.divides(); }
    BlockAction action(const StackBlock& b, ScreenBounds& bounds) const;
    void split(bool along_u);

    const DrawSetup& setup_;
    DrawMemory& memory_;
    bool shades_;
    DrawCounts& counts_;
    std::size_t depth_ = 0;  // blocks on the stack; the popped one lies just above
    std::uint32_t splits_ = 0;  // of the patch
};

// Hands what a drawing samples to its sink, with its Z code, and counts it.
template <class SampleSink>
struct Emitter {
    const DrawSetup& setup;
    SampleSink& sink;
    DrawCounts& counts;

    // `offset` moves the sample away, and not beyond the far plane; it is not negative.
    template <class Shading>
    void operator()(const Sample& s, const Shading* shading, std::int64_t offset = 0) const {
        std::uint32_t code = 0;
        if (!depth_code(s.z, setup.spec, code)) return;
        if (offset > 0 && !depth_code(s.z + offset, setup.spec, code))
            code = setup.spec.deepest_drawn();
        ++counts.samples;
        sink.sample(s, code, shading);
    }
};

template <class SampleSink>
const Material* material_of(std::uint16_t material, const DrawSetup& setup) {
    if (!SampleSink::shades) return nullptr;
    fixed::require(material < setup.materials.size(),
                   "draw: a surface names a material that is not there");
    return &setup.materials[material];
}

template <class SampleSink>
void sample_block(const DrawSetup& setup, const DrawMemory& memory, const BlockShading* shading,
                  const Emitter<SampleSink>& emit) {
    const auto take = [&](auto&& each) {
        if constexpr (HasPlaces<SampleSink>) {
            emit.counts.tested_centres +=
                sample_block_places(memory.corners, emit.sink.places, each);
        } else if (!hw::built(hw::Feature::leaf_sampling) || setup.sampling == Sampling::centre) {
            emit.counts.tested_centres += sample_leaf_centres(memory.corners, setup.spec, each);
        } else {
            sample_leaves(memory.corners, setup.spec, each);
        }
    };
    if (setup.casters.all_alike()) return take([&](const Sample& s) { emit(s, shading); });
    if constexpr (hw::built(hw::Feature::surface_bias)) {
        take([&](const Sample& s) {
            std::int64_t offset = 0;
            if (cast_by_leaf(setup.casters, memory.corners, s, setup.sampling, offset))
                emit(s, shading, offset);
        });
    }
}

template <class SampleSink>
void draw_patches(std::span<const Patch> patches, std::span<const std::uint32_t> order,
                  const DrawSetup& setup, DrawMemory& memory, const Emitter<SampleSink>& emit) {
    DrawCounts& counts = emit.counts;
    BlockWalk walk(setup, memory, SampleSink::shades, counts);
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[order.empty() ? k : order[k]];
        const Material* material = material_of<SampleSink>(patch.material, setup);
        walk.push_patch(patch);
        if (!setup.draws([&] { return walk.outside(); })) {
            walk.drop_patch();
            continue;
        }
        ++counts.patches;
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            if (setup.leaves_out_hidden && emit.sink.hidden(footprint(bounds, setup.spec))) {
                ++counts.hidden_blocks;
                continue;
            }
            if (!walk.make_corners()) {
                ++counts.unresolved;
                continue;
            }
            ++counts.blocks;
            if constexpr (SampleSink::shades) {
                const BlockShading shading(walk.block().world, setup.shading, *material);
                sample_block(setup, memory, &shading, emit);
            } else {
                sample_block(setup, memory, nullptr, emit);
            }
        }
    }
}

// `all`: whatever setup.drawn says, for a mesh that was chosen as a whole.
template <class SampleSink>
void draw_facets(const Mesh& mesh, const DrawSetup& setup, FacetWalk& walk,
                 const Emitter<SampleSink>& emit, bool all = false) {
    DrawCounts& counts = emit.counts;
    walk.begin(mesh);
    for (const Facet& facet : mesh.facets) {
        const Material* material = material_of<SampleSink>(facet.material, setup);
        const FacetWalk::Outcome outcome = walk.project(facet);
        if (!all && !setup.draws([&] { return walk.unseen(outcome); })) continue;
        ++counts.facets;
        if (outcome == FacetWalk::Outcome::unresolved) ++counts.unresolved_facets;
        if (outcome == FacetWalk::Outcome::cut) ++counts.cut_facets;
        if (outcome > FacetWalk::Outcome::cut) continue;
        for (std::size_t k = 0; k < walk.triangles(); ++k) {
            const FacetTriangle triangle = walk.triangle(k);
            const auto& [a, b, c] = triangle.screen;
            if (setup.facet_facing() != Facing::both &&
                !is_drawn(setup.facet_facing(), turn(a, b, c.x, c.y))) {
                ++counts.turned_triangles;
                continue;
            }
            std::int64_t offset = 0;
            if (!setup.casters.all_alike() && setup.casters.slope_q8 > 0)
                offset = setup.casters.offset(depth_slope(a, b, c));
            std::uint64_t lines = 0;
            if constexpr (HasPlaces<SampleSink>) {
                const FacetShading* const none = nullptr;
                lines = sample_triangle_places(a, b, c, emit.sink.places,
                                               [&](const Sample& s) { emit(s, none, offset); });
            } else if constexpr (SampleSink::shades) {
                const FacetShading shading(triangle, walk.facet(), facet.normal[0] == Facet::flat,
                                           setup.shading, *material);
                lines = sample_triangle(a, b, c, setup.spec,
                                        [&](const Sample& s) { emit(s, &shading, offset); });
            } else {
                const FacetShading* const none = nullptr;
                lines = sample_triangle(a, b, c, setup.spec,
                                        [&](const Sample& s) { emit(s, none, offset); });
            }
            counts.triangles += lines > 0 ? 1 : 0;
            counts.triangle_lines += lines;
        }
    }
}

template <class SampleSink>
void draw_diced(std::span<const Patch> patches, std::span<const std::uint32_t> order,
                const DrawSetup& setup, DrawMemory& memory, FacetWalk& walk,
                const Emitter<SampleSink>& emit) {
    const DicedView view(setup.spec, setup.matrix, setup.object);
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[order.empty() ? k : order[k]];
        if (!setup.draws([&] { return view.outside(patch); })) continue;
        const DiceLevels levels = dice_levels(patch, setup.dice_levels, setup.dice_tolerance);
        const Mesh mesh = dice(patch, levels, SampleSink::shades, memory.dice);
        ++emit.counts.patches;
        ++emit.counts.diced_patches;
        emit.counts.diced_vertices += mesh.vertices.size();
        draw_facets(mesh, setup, walk, emit, true);
    }
}

}  // namespace detail

// Draws the patches, patches[order[0]], patches[order[1]], ..., or all in turn if `order` is empty,
// and then the mesh. The sink sees every sample of every block that is not hidden and of every
// facet. Traps where `order` is of another length, or where a surface names a material that is not
// there and the sink shades, or a vertex or normal that is not there.
template <Sink SampleSink>
DrawCounts draw(const Surfaces& surfaces, std::span<const std::uint32_t> order,
                const DrawSetup& setup, DrawMemory& memory, SampleSink& sink) {
    fixed::require(order.empty() || order.size() == surfaces.patches.size(),
                   "draw: the order is not one of these patches");
    const bool diced = setup.form == PatchForm::diced;
    fixed::require(hw::built(hw::Feature::dicing) || !diced, "draw: dicing is not built");
    fixed::require(hw::built(hw::Feature::triangles) || surfaces.mesh.facets.empty(),
                   "draw: triangles are not built");
    DrawCounts counts;
    const detail::Emitter<SampleSink> emit{setup, sink, counts};
    if (!diced) detail::draw_patches(surfaces.patches, order, setup, memory, emit);
    const std::uint64_t of_patches = counts.samples;
    if constexpr (hw::built(hw::Feature::triangles)) {
        if (diced || !surfaces.mesh.facets.empty()) {
            FacetWalk walk(setup.spec, setup.matrix, setup.object, setup.work, SampleSink::shades);
            if constexpr (hw::built(hw::Feature::dicing)) {
                if (diced) detail::draw_diced(surfaces.patches, order, setup, memory, walk, emit);
            }
            detail::draw_facets(surfaces.mesh, setup, walk, emit);
        }
    }
    counts.facet_samples = counts.samples - of_patches;
    return counts;
}

// Patches by the depth of their nearest control point, nearest first; equal ones by their index.
// The order changes time, never a bit. `order` and `scratch` have a word for each patch.
void order_front_to_back(std::span<const Patch> patches, const View& view,
                         std::span<std::uint32_t> order, std::span<std::int64_t> scratch);

}  // namespace umbra78::raster
