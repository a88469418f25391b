// What a store shows, as a list: its visible samples with their normals. Where the lights or the
// materials alone have changed, the samples are shaded from it, sixteen at a time, and no patch is
// drawn.
//
//   VisibleSink   gathers the samples that lie at the stored depth, from a drawing of patches
//   shade_list    puts their levels into the store
//
// All samples at the stored depth of a pixel are listed: which of them the store shows depends on
// their levels (sinks.hpp). In: lights and a viewer at infinity; normals that are not kept by the
// store. The list has the caller's memory. What does not fit it, and triangles, are not listed: the
// list is then not whole, and the view is to be drawn.
#pragma once

#include "raster/facet.hpp"
#include "raster/sinks.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::raster {

// Up to sixteen samples of one patch.
struct VisibleBlock {
    SampleNormals normals;
    std::uint32_t pixel[leaves];  // their addresses in the store
    std::uint32_t patch;
    std::uint8_t count;
    bool in_lanes;  // whether the block forms shade them
};

class VisibleList {
public:
    VisibleList() = default;
    explicit VisibleList(std::span<VisibleBlock> room) : room_(room) {}

    // Enough for a store where blocks are half full; each patch may leave one that is not.
    static constexpr std::size_t blocks_for(std::size_t pixels) { return pixels / 8; }

    bool is_whole() const { return whole_; }
    bool does_not_fit() const { return failed_; }
    std::span<const VisibleBlock> blocks() const { return room_.first(used_); }
    // Finds what of the samples' shading depends on the viewer alone, unless it is known.
    void measure(const ShadeJob& viewed, const BlockForm& form);

    void forget() { *this = VisibleList(room_); }
    void fail() { failed_ = true; }
    void add(std::uint32_t patch, bool in_lanes, std::size_t pixel, const WideVector& normal);
    void end() { whole_ = !failed_; }

private:
    std::span<VisibleBlock> room_;
    std::size_t used_ = 0;
    bool whole_ = false, failed_ = false, measured_ = false;
    UnitVector viewer_{};  // measured for
};

template <class Depth>
class VisibleSink {
public:
    static constexpr bool shades = true, makes_levels = false;

    VisibleSink(const hw::FrameStore<Depth>& store, VisibleList& list)
        : store_(store), list_(list) {}

    bool hidden(const Footprint& f) const { return all_nearer(store_, f); }
    void begin_patch(std::uint32_t patch) { patch_ = patch; }
    bool keeps(int px, int py, std::uint32_t code) const {
        return code == store_.depth[store_.address(px, py)];
    }
    void sample(const Sample& s, std::uint32_t code, const BlockShading* shading) {
        if (!keeps(s.px, s.py, code)) return;
        list_.add(patch_, shading->turns_little(), store_.address(s.px, s.py),
                  shading->mean_normal(s.leaf_i, s.leaf_j));
    }
    void sample(const Sample&, std::uint32_t, const FacetShading*) { list_.fail(); }

private:
    const hw::FrameStore<Depth>& store_;
    VisibleList& list_;
    std::uint32_t patch_ = 0;
};

// Whether samples can be shaded without their places.
bool lists_cover(const ShadingSpec& spec);

// In: a whole list of these patches, and a store with the Z that it was made of and whose levels
// are the largest. A material that is not there traps.
template <class Depth>
void shade_list(VisibleList& list, std::span<const Patch> patches,
                std::span<const Material> materials, const ShadingSpec& spec,
                hw::FrameStore<Depth>& store);

}  // namespace umbra78::raster
