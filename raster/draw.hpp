// Drawing: patches to samples, by blocks of 16 x 16 leaves (Catmull's subdivision, 1974).
//
//   control points --transform unit--> components of a block --split by block_action-->
//   17 x 17 corners --sampling--> samples with their Z code, handed to a sink
//
// In: patches in world words, a view's loaded matrix, materials and light. Out: calls of the sink,
// and counts. A block that is too large after all its splits is dropped, counted as `unresolved`.
// A block whose nearest point is hidden in its whole footprint cannot change the frame and is left
// out. No allocation: the caller hands in one DrawMemory.
// Not emulated: the clock (drawing_cost.hpp makes operations of the counts).
#pragma once

#include "raster/footprint.hpp"
#include "raster/leaf_centres.hpp"
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
//   sample(...)   one sample, its Z code and its block's shading
template <class T>
concept Sink = requires(T& sink, const T& unchanged, const Footprint& footprint,
                        const Sample& sample, std::uint32_t code, const BlockShading* shading) {
    typename std::bool_constant<T::shades>;
    { unchanged.hidden(footprint) } -> std::same_as<bool>;
    { sink.sample(sample, code, shading) } -> std::same_as<void>;
};

// Rounds the view's exact matrix to the unit's words. An affine matrix is refused, too, where a
// raster word could be so large that its corrections and bounds would not fit 64 bits.
hw::LoadStatus load_view(const View& view, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out);

struct DrawCounts {
    std::uint64_t patches = 0, blocks = 0;
    std::uint64_t samples = 0;        // handed to the sink: pixels drawn, with their overdraw
    std::uint64_t hidden_blocks = 0;  // left out behind what was drawn before
    std::uint64_t unresolved = 0;     // dropped: no level or split left, or no quotient
    std::uint64_t tested_blocks = 0;  // whose action was decided
    std::uint64_t splits = 0;
    std::uint64_t tested_centres = 0;  // pixel centres in a leaf's window
};

struct DrawSetup {
    MachineSpec spec;
    MatrixWords matrix;  // object words to screen
    WordFormat object;
    Sampling sampling = Sampling::centre;
    std::span<const Material> materials;  // at least as many as the patches name
    ShadingSpec shading;                  // read only by a sink that shades
    hw::UnitWork work{};  // constants of an affine matrix that the unit computes for every point
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
    // Pops, splits and pushes until a block is ready to be drawn; false when none is left.
    bool next(ScreenBounds& bounds);
    // The popped block's corners; false if it had to be dropped.
    bool make_corners();
    const StackBlock& block() const { return memory_.stack[depth_]; }

private:
    bool affine() const { return setup_.matrix.affine; }
    BlockAction action(const StackBlock& b, ScreenBounds& bounds) const;
    void split(bool along_u);

    const DrawSetup& setup_;
    DrawMemory& memory_;
    bool shades_;
    DrawCounts& counts_;
    std::size_t depth_ = 0;  // blocks on the stack; the popped one lies just above
    std::uint32_t splits_ = 0;  // of the patch
};

}  // namespace detail

// Draws patches[order[0]], patches[order[1]], ..., or all in turn if `order` is empty. The sink
// sees every sample of every block that is not hidden. Traps where `order` is of another length, or
// where a patch names a material that is not there and the sink shades.
template <Sink SampleSink>
DrawCounts draw(std::span<const Patch> patches, std::span<const std::uint32_t> order,
                const DrawSetup& setup, DrawMemory& memory, SampleSink& sink) {
    fixed::require(order.empty() || order.size() == patches.size(),
                   "draw: the order is not one of these patches");
    DrawCounts counts;
    detail::BlockWalk walk(setup, memory, SampleSink::shades, counts);
    const auto emit = [&](const Sample& s, const BlockShading* shading) {
        std::uint32_t code = 0;
        if (!depth_code(s.z, setup.spec, code)) return;
        ++counts.samples;
        sink.sample(s, code, shading);
    };
    const auto sample = [&](const BlockShading* shading) {
        const auto each = [&](const Sample& s) { emit(s, shading); };
        if (setup.sampling == Sampling::centre) {
            counts.tested_centres += sample_leaf_centres(memory.corners, setup.spec, each);
        } else {
            sample_leaves(memory.corners, setup.spec, each);
        }
    };
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[order.empty() ? k : order[k]];
        fixed::require(!SampleSink::shades || patch.material < setup.materials.size(),
                       "draw: a patch names a material that is not there");
        ++counts.patches;
        walk.push_patch(patch);
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            if (sink.hidden(footprint(bounds, setup.spec))) {
                ++counts.hidden_blocks;
                continue;
            }
            if (!walk.make_corners()) {
                ++counts.unresolved;
                continue;
            }
            ++counts.blocks;
            if constexpr (SampleSink::shades) {
                const BlockShading shading(walk.block().world, setup.shading,
                                           setup.materials[patch.material]);
                sample(&shading);
            } else {
                sample(nullptr);
            }
        }
    }
    return counts;
}

// Patches by the depth of their nearest control point, nearest first; equal ones by their index.
// The order changes time, never a bit. `order` and `scratch` have a word for each patch.
void order_front_to_back(std::span<const Patch> patches, const View& view,
                         std::span<std::uint32_t> order, std::span<std::int64_t> scratch);

}  // namespace umbra78::raster
