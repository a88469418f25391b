// The figures' scene as the rivals have it.
#pragma once

#include "shadow/frame/paper_scene_words.hpp"
#include "shadow/rivals/dicing.hpp"
#include "tests/shadow/rivals/scenes.hpp"

#include <memory>
#include <vector>

namespace umbra78::shadow::rivals::test {

// The figures' scene with its patches diced into 2^levels x 2^levels cells. If `distance` is not 0
// the observer is 8 world units away and the light, at a place, that many. Angles in degrees.
class FiguresScene {
public:
    explicit FiguresScene(int levels, int xy_bits = 9, int azimuth = -100, int distance = 0,
                          int elevation = 0) {
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
        light.axes = raster::axes_from_angles(azimuth * world_one, elevation * world_one);
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
        LightGrid grid;
        std::size_t needed = 0;
        grid.build(setting_, 0, {}, needed);
        Memory memory(needed);
        fixed::require(grid.build(setting_, 0, memory.bytes(), needed), "its grid");
        std::vector<std::uint8_t> mask(shown_.size());
        BruteCounts counts;
        brute(setting_, shown_, &grid, mask, counts);
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
        setting_memory_ = std::make_unique<Memory>(
            setting_bytes(mesh.facets.size(), mesh.edges.size()));
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
