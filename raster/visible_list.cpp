#include "raster/visible_list.hpp"

namespace umbra78::raster {
namespace {

const Material& material_of_patch(std::uint32_t patch, std::span<const Patch> patches,
                                  std::span<const Material> materials) {
    fixed::require(patch < patches.size() && patches[patch].material < materials.size(),
                   "list: a patch or its material is not there");
    return materials[patches[patch].material];
}

// What the block forms do not cover.
void shade_one_by_one(const VisibleBlock& block, const ShadingSpec& spec, const Material& material,
                      LeafLevels& levels) {
    for (std::size_t k = 0; k < block.count; ++k) {
        const WideVector normal{block.normals.n[0][k], block.normals.n[1][k],
                                block.normals.n[2][k]};
        levels.put(k, shade_normal(normal, spec, material), spec.channels, spec.source_count);
    }
}

}  // namespace

void VisibleList::add(std::uint32_t patch, bool in_lanes, std::size_t pixel,
                      const WideVector& normal) {
    const bool joins = used_ > 0 && room_[used_ - 1].patch == patch &&
                       room_[used_ - 1].in_lanes == in_lanes && room_[used_ - 1].count < leaves;
    if (!joins) {
        failed_ = failed_ || used_ == room_.size();
        if (failed_) return;
        room_[used_] = {};
        room_[used_].patch = patch;
        room_[used_].in_lanes = in_lanes;
        ++used_;
    }
    VisibleBlock& block = room_[used_ - 1];
    for (std::size_t k = 0; k < 3; ++k)
        block.normals.n[k][block.count] = static_cast<std::int32_t>(normal[k]);
    block.pixel[block.count] = static_cast<std::uint32_t>(pixel);
    ++block.count;
}

void VisibleList::measure(const ShadeJob& viewed, const BlockForm& form) {
    const UnitVector viewer{viewed.viewer[0], viewed.viewer[1], viewed.viewer[2]};
    if (measured_ && viewer == viewer_) return;
    for (VisibleBlock& block : room_.first(used_)) form.measure_normals(viewed, block.normals);
    measured_ = true;
    viewer_ = viewer;
}

bool lists_cover(const ShadingSpec& spec) {
    ShadeJob job;
    return !spec.keeps_normals && shade_job(spec, {}, job);
}

template <class Depth>
void shade_list(VisibleList& list, std::span<const Patch> patches,
                std::span<const Material> materials, const ShadingSpec& spec,
                hw::FrameStore<Depth>& store) {
    fixed::require(list.is_whole() && lists_cover(spec), "list: it does not cover this shading");
    const BlockForm& form = fastest_block_form();
    PictureSink<Depth> sink{store};
    const Material* material = nullptr;
    ShadeJob job;
    LeafLevels levels;
    shade_job(spec, {}, job);
    list.measure(job, form);
    for (const VisibleBlock& block : list.blocks()) {
        const Material& own = material_of_patch(block.patch, patches, materials);
        if (&own != material) {
            material = &own;
            shade_job(spec, own, job);
            job.two_sided = true;
        }
        if (block.in_lanes) {
            form.shade_normals(job, block.normals, block.count, levels);
        } else {
            shade_one_by_one(block, spec, own, levels);
        }
        for (std::size_t k = 0; k < block.count; ++k)
            sink.take(block.pixel[k], store.depth[block.pixel[k]], levels, k);
    }
}

template void shade_list(VisibleList&, std::span<const Patch>, std::span<const Material>,
                         const ShadingSpec&, hw::FrameStore<hw::Depth16>&);
template void shade_list(VisibleList&, std::span<const Patch>, std::span<const Material>,
                         const ShadingSpec&, hw::FrameStore<hw::Depth32>&);

}  // namespace umbra78::raster
