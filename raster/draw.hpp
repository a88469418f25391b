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
#include "raster/diced_view.hpp"
#include "raster/draw_facets.hpp"
#include "raster/footprint.hpp"
#include "raster/places.hpp"
#include "raster/sampling.hpp"

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <type_traits>

namespace umbra78::raster {

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
    bool outside() {
        ScreenBounds bounds;
        return decide(memory_.stack[depth_ - 1], bounds).action == BlockAction::outside;
    }
    void drop_patch() { --depth_; }
    // Pops, splits and pushes until a block is ready to be drawn, or no larger than `scale` such
    // blocks each way; false when none is left.
    bool next(ScreenBounds& bounds, int scale = 1);
    // Whether the popped block is for this band to count. It is for one, though several draw it.
    bool counted() const { return setup_.band.has(block().line); }
    // The popped block's corners; false if it had to be dropped.
    bool make_corners(const BlockForm& form);
    const StackBlock& block() const { return memory_.stack[depth_]; }

private:
    bool affine() const { return !setup_.matrix.divides(); }
    struct Decision {
        BlockAction action;
        bool bounded;  // whether its bounds are known
    };
    Decision decide(StackBlock& b, ScreenBounds& bounds) const;
    Decision in_band(StackBlock& b, BlockAction action, const ScreenBounds& bounds) const;
    void split(bool along_u);

    const DrawSetup& setup_;
    DrawMemory& memory_;
    bool shades_;
    DrawCounts& counts_;
    std::size_t depth_ = 0;  // blocks on the stack; the popped one lies just above
    std::uint32_t splits_ = 0;  // of the patch
};

// A block's samples; false if they are left to the definition, by which a leaf may have any number.
bool find_samples(const Corners& corners, const DrawSetup& setup, const BlockForm& form,
                  BlockSamples& out);

// The levels of the samples' leaves.
void shade_leaves(const BlockSamples& samples, const BlockForm& form, LeafLevels& levels,
                  BlockShading& shading);

inline Sample sample_of(const BlockSample& s, std::int32_t half_px) {
    const auto pixel = [&](std::int32_t at) {
        return fixed::floor_shift(at, raster_fraction) + half_px;
    };
    return {pixel(s.x), pixel(s.y), s.x, s.y, s.z, s.leaf % leaves, s.leaf / leaves, s.second};
}

// Whether a sample is drawn, and by how much it is moved away.
inline bool is_cast(const DrawSetup& setup, const Corners& corners, const Sample& s,
                    std::int64_t& offset) {
    offset = 0;
    if constexpr (!hw::built(hw::Feature::surface_bias)) return true;
    return setup.casters.all_alike() ||
           cast_by_leaf(setup.casters, corners, s, setup.sampling, offset);
}

// Leaves in the list the samples that the sink may take, with their codes.
template <class SampleSink>
void keep_samples(const DrawSetup& setup, DrawMemory& memory, const Emitter<SampleSink>& emit) {
    BlockSamples& list = memory.samples;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < list.count; ++k) {
        const BlockSample s = list.sample[k];
        const Sample whole = sample_of(s, setup.spec.half_px());
        std::int64_t offset = 0;
        std::uint32_t code = 0;
        if (!setup.band.has(whole.py)) continue;
        if (!is_cast(setup, memory.corners, whole, offset)) continue;
        if (!emit.code_of(s.z, offset, code)) continue;
        list.sample[kept] = s;
        memory.codes[kept] = code;
        if constexpr (requires { emit.sink.keeps(0, 0, code); }) {
            kept += emit.sink.keeps(whole.px, whole.py, code) ? 1 : 0;
        } else {
            ++kept;
        }
    }
    list.count = kept;
}

// `material` is nullptr where the sink does not shade.
template <class SampleSink>
void sample_block(const DrawSetup& setup, DrawMemory& memory, const BlockForm& form,
                  const StackBlock& block, const Material* material,
                  const Emitter<SampleSink>& emit) {
    const auto shaded = [&](auto&& run) {
        if constexpr (SampleSink::shades) {
            BlockShading shading(block.world, setup.shading, *material);
            run(&shading);
        } else {
            run(static_cast<BlockShading*>(nullptr));
        }
    };
    const auto one_by_one = [&](auto&& sample) {
        shaded([&](const BlockShading* shading) {
            sample([&](const Sample& s) {
                std::int64_t offset = 0;
                if (is_cast(setup, memory.corners, s, offset)) emit(s, shading, offset);
            });
        });
    };
    std::uint64_t& tested = emit.counts.tested_centres;
    if constexpr (HasPlaces<SampleSink>) {
        one_by_one([&](auto&& each) {
            tested += sample_block_places(memory.corners, emit.sink.places, each);
        });
    } else if (!find_samples(memory.corners, setup, form, memory.samples)) {
        one_by_one([&](auto&& each) {
            if (!setup.by_centres()) return sample_leaves(memory.corners, setup.spec, each);
            tested += sample_centres(memory.corners, setup.spec, each);
        });
    } else {
        const BlockSamples& samples = memory.samples;
        tested += samples.tested;
        keep_samples(setup, memory, emit);
        if (samples.count == 0) return;
        shaded([&](BlockShading* shading) {
            if constexpr (!requires { SampleSink::makes_levels; })
                if (shading != nullptr) shade_leaves(samples, form, memory.levels, *shading);
            for (std::size_t k = 0; k < samples.count; ++k)
                emit.sink.sample(sample_of(samples.sample[k], setup.spec.half_px()),
                                 memory.codes[k], static_cast<const BlockShading*>(shading));
        });
    }
}

template <class SampleSink>
void draw_patches(std::span<const Patch> patches, std::span<const std::uint32_t> order,
                  const DrawSetup& setup, DrawMemory& memory, const Emitter<SampleSink>& emit) {
    DrawCounts& counts = emit.counts;
    const BlockForm& form = setup.blocks != nullptr ? *setup.blocks : fastest_block_form();
    BlockWalk walk(setup, memory, SampleSink::shades, counts);
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const std::size_t number = order.empty() ? k : order[k];
        const Patch& patch = patches[number];
        const Material* material = material_of<SampleSink>(patch.material, setup);
        if constexpr (requires { emit.sink.begin_patch(0u); })
            emit.sink.begin_patch(static_cast<std::uint32_t>(number));
        walk.push_patch(patch);
        if (!setup.draws([&] { return walk.outside(); })) {
            walk.drop_patch();
            continue;
        }
        ScreenBounds bounds;
        while (walk.next(bounds)) {
            const Footprint reached = clipped(footprint(bounds, setup.spec), setup.band);
            if (setup.leaves_out_hidden && emit.sink.hidden(reached)) {
                ++counts.hidden_blocks;
                continue;
            }
            if constexpr (requires { emit.sink.expect(reached); }) emit.sink.expect(reached);
            if (!walk.make_corners(form)) {
                counts.unresolved += walk.counted() ? 1 : 0;
                continue;
            }
            ++counts.blocks;
            sample_block(setup, memory, form, walk.block(), material, emit);
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
        FacetDrawing(setup, memory.facets, walk, emit).draw(mesh, true);
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
            const FacetForm* form = setup.blocks != nullptr ? &setup.blocks->facets : nullptr;
            FacetWalk walk(setup.spec, setup.matrix, setup.object, setup.work, SampleSink::shades,
                           form);
            if constexpr (hw::built(hw::Feature::dicing)) {
                if (diced) detail::draw_diced(surfaces.patches, order, setup, memory, walk, emit);
            }
            detail::FacetDrawing(setup, memory.facets, walk, emit).draw(surfaces.mesh, false);
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
