// What the algorithms of class 1 need, made for tests with as much memory as they ask for; and the
// figures' scene, diced.
#pragma once

#include "shadow/frame/paper_scene_words.hpp"
#include "shadow/rivals/appel.hpp"
#include "shadow/rivals/dicing.hpp"
#include "shadow/rivals/irregular.hpp"
#include "tests/shadow/rivals/scenes.hpp"

#include <memory>
#include <vector>

namespace umbra78::shadow::rivals::test {

// Calls build(memory, needed) with the bytes that it asked for, three times at most.
template <class Build>
std::unique_ptr<Memory> with_room(Build&& build) {
    std::size_t needed = 0;
    for (int call = 0; call < 3; ++call) {
        auto memory = std::make_unique<Memory>(needed);
        if (build(memory->bytes().first(needed), needed)) return memory;
    }
    fixed::require(false, "a test's memory: what was asked for was not enough");
    return nullptr;
}

class Linked {
public:
    Linked(const Setting& setting, std::span<const std::uint32_t> shown, LinkOptions options = {})
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              counts = {};
              return links.build(setting, shown, options, memory, needed, counts) ==
                     LinkStatus::ok;
          })) {}
    Links links;
    LinkCounts counts;

private:
    std::unique_ptr<Memory> memory_;
};

class Bordered {
public:
    Bordered(const Setting& setting, const Links& links)
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              counts = {};
              return borders.build(setting, links, memory, needed, counts);
          })) {}
    Borders borders;
    BorderCounts counts;

private:
    std::unique_ptr<Memory> memory_;
};

class Gridded {
public:
    explicit Gridded(const Setting& setting)
        : memory_(with_room([&](std::span<std::byte> memory, std::size_t& needed) {
              return grid.build(setting, 0, memory, needed);
          })) {}
    LightGrid grid;

private:
    std::unique_ptr<Memory> memory_;
};

inline std::vector<std::uint8_t> mask_by_lists(const Setting& setting,
                                               std::span<const std::uint32_t> shown, int texels,
                                               IrregularCounts& counts) {
    std::vector<std::uint8_t> mask(shown.size());
    with_room([&](std::span<std::byte> memory, std::size_t& needed) {
        counts = {};
        const bool ok = irregular(setting, shown, {texels}, memory, mask, counts);
        needed = counts.bytes;
        return ok;
    });
    return mask;
}

// The figures' scene with its patches diced into 2^levels x 2^levels cells. If `distance` is not 0
// the observer is 8 world units away and the light, at a place, that many.
class FiguresScene {
public:
    FiguresScene(int levels, int xy_bits, int azimuth, int distance = 0) {
        constexpr int world_one = 65536;
        std::vector<raster::Patch> patches(4 * 32);
        for (std::size_t i = 0; i < 4; ++i)
            raster::sphere_patches(paper_scene::spheres[i],
                                   std::span<raster::Patch, 32>(patches.data() + 32 * i, 32));
        const raster::Surfaces surfaces(std::span<const raster::Patch>(patches), {});
        raster::View observer;
        observer.axes = raster::axes_from_angles(0, 0);
        observer.extent = paper_scene::extent_q16;
        raster::View light = observer;
        light.axes = raster::axes_from_angles(azimuth * world_one, 0);
        if (distance != 0) {
            observer.projection = light.projection = raster::Projection::perspective;
            observer.distance = 8 * world_one;
            light.distance = distance * world_one;
        }
        int fraction = 0;
        fixed::require(fit_fraction(observer, xy_bits, surfaces, std::span(&light, 1), fraction) ==
                           SpaceStatus::ok,
                       "the figures' scene fits");
        const ToWords to(observer, xy_bits, fraction);
        Space space;
        Centre centre{};
        fixed::require(to.space(space) && to.light(light, centre), "its eye and light fit");
        build(surfaces, levels, to, space, centre);
    }
    FiguresScene(const FiguresScene&) = delete;
    FiguresScene& operator=(const FiguresScene&) = delete;

    const Setting& setting() const { return setting_; }
    std::span<const std::uint32_t> shown() const { return shown_; }
    std::vector<std::uint8_t> brute_mask() const {
        const Gridded gridded(setting_);
        std::vector<std::uint8_t> mask(shown_.size());
        BruteCounts counts;
        brute(setting_, shown_, &gridded.grid, mask, counts);
        return mask;
    }

private:
    void build(const raster::Surfaces& surfaces, int levels, const ToWords& to, const Space& space,
               const Centre& light) {
        const MeshSize size = diced_size(surfaces, levels);
        mesh_memory_ = std::make_unique<Memory>(MeshBuilder::bytes(size));
        MeshBuilder builder(mesh_memory_->bytes(), size);
        const auto dice_memory = std::make_unique<raster::DiceMemory>();
        add_diced(surfaces, levels, to, *dice_memory, builder);
        Mesh mesh;
        fixed::require(builder.finish(mesh) == MeshStatus::ok, "its mesh");
        setting_memory_ = std::make_unique<Memory>(setting_bytes(mesh.facets.size(), mesh.edges.size()));
        fixed::require(make_setting(space, mesh, light, setting_memory_->bytes(), setting_),
                       "its setting");
        shown_.resize(space.pixels());
        VisibleCounts counts;
        find_visible(setting_, shown_, counts);
    }

    std::unique_ptr<Memory> mesh_memory_, setting_memory_;
    Setting setting_{};
    std::vector<std::uint32_t> shown_;
};

}  // namespace umbra78::shadow::rivals::test
