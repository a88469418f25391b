// Drawing: patches to samples, by blocks of 16 x 16 leaves (Catmull's subdivision, 1974).
//
//   control points --transform unit--> components of a block --split by block_action-->
//   17 x 17 corners --sampling--> samples with their Z code, handed to a sink
//
// What the caller wants done with a sample is a Sink:
//   static constexpr bool shades;                        does it ask for levels?
//   bool hidden(x0, y0, x1, y1, code);                   everything there nearer than code?
//   void sample(const Sample&, code, const BlockShading*);
// A block whose nearest point is hidden in its whole window cannot change the frame and is left
// out. No allocation: the caller hands in one DrawMemory.
#pragma once

#include "hw/frame_store.hpp"
#include "raster/leaf_centres.hpp"
#include "raster/projection.hpp"
#include "raster/sampling.hpp"
#include "raster/shading.hpp"
#include "raster/view.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::raster {

// Object words: 16 bits, the largest fraction (at most 14, so that one_word is at least 1.0) that
// holds every control point of the scene.
inline constexpr int object_bits = 16;
inline constexpr int object_guard = 6;  // further fraction bits of the shading's place words
hw::WordFormat object_words(std::span<const Patch> patches);

// Rounds the view's exact matrix to the unit's words.
hw::LoadStatus load_view(const View& view, const MachineSpec& spec, WordFormat object,
                         MatrixWords& out);

// What shading needs of a view and a light.
Toward toward_viewer(const View& view, WordFormat object);
Toward toward_light(const View& light, WordFormat object);

struct DrawCounts {
    std::uint64_t patches = 0, blocks = 0;
    std::uint64_t samples = 0;        // handed to the sink: pixels drawn, with their overdraw
    std::uint64_t hidden_blocks = 0;  // left out behind what was drawn before
    std::uint64_t unresolved = 0;     // dropped at the last level or split
    std::uint64_t tested_blocks = 0;  // whose action was decided
    std::uint64_t splits = 0;
    std::uint64_t tested_centres = 0;  // pixel centres in a leaf's window
};

struct DrawSetup {
    MachineSpec spec;
    MatrixWords matrix;  // object words to screen
    WordFormat object;
    Sampling sampling = Sampling::centre;
    std::span<const Material> materials;
    ShadingSpec shading;
    hw::UnitWork work{};  // of what an affine matrix makes constant
};

inline constexpr int deepest_level = 24;  // halvings in each direction
// Splits a patch may take, so that every frame ends: figures need some hundreds. What would need
// more (a patch through a light's eye, magnified a thousandfold) is dropped and counted.
inline constexpr std::uint32_t max_splits = 1u << 20;

struct StackBlock {
    std::array<Component, 4> screen;  // x, y, z, or X, Y, Z, W
    std::array<Component, 3> world;   // only where the sink shades
    int level_u, level_v;
};

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

struct PixelWindow {
    int x0, y0, x1, y1;  // inclusive
};
PixelWindow pixel_window(const ScreenBounds& b, const MachineSpec& spec);

}  // namespace detail

template <class Sink>
DrawCounts draw(std::span<const Patch> patches, std::span<const std::uint32_t> order,
                const DrawSetup& setup, DrawMemory& memory, Sink& sink) {
    DrawCounts counts;
    detail::BlockWalk walk(setup, memory, Sink::shades, counts);
    const std::int64_t one_quantum = std::int64_t{1} << depth_guard(setup.spec);
    const auto emit = [&](const Sample& s, const BlockShading* shading) {
        std::uint32_t code = 0;
        if (!depth_code(s.z, setup.spec, code)) return;
        ++counts.samples;
        sink.sample(s, code, shading);
    };
    const auto sample = [&](const BlockShading* shading) {
        const auto each = [&](const Sample& s) { emit(s, shading); };
        if (setup.sampling == Sampling::centre) {
            counts.tested_centres += sample_lone_centres(memory.corners, setup.spec, each);
        } else {
            sample_leaves(memory.corners, setup.spec, each);
        }
    };
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[order.empty() ? k : order[k]];
        ++counts.patches;
        walk.push_patch(patch);
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            const detail::PixelWindow w = detail::pixel_window(bounds, setup.spec);
            std::uint32_t nearest = 0;
            // A quantum nearer than the bound, for what rounding may do to the corners.
            if (depth_code(bounds[2].min - one_quantum, setup.spec, nearest) &&
                sink.hidden(w.x0, w.y0, w.x1, w.y1, nearest)) {
                ++counts.hidden_blocks;
                continue;
            }
            if (!walk.make_corners()) {
                ++counts.unresolved;
                continue;
            }
            ++counts.blocks;
            if constexpr (Sink::shades) {
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

// Patches by the depth of their nearest control point: order changes time, never a bit.
void order_front_to_back(std::span<const Patch> patches, const View& view,
                         std::span<std::uint32_t> order, std::span<std::int64_t> scratch);

}  // namespace umbra78::raster
