// The figures' scene as the rivals have it: its patches diced, the observer and the light.
#pragma once

#include "shadow/frame/paper_scene_words.hpp"
#include "shadow/rivals/dicing.hpp"
#include "tests/shadow/rivals/scenes.hpp"

namespace umbra78::shadow::rivals::test {

inline raster::View figures_observer() {
    raster::View view{};
    view.axes = raster::axes_from_angles(0, 0);
    view.extent = paper_scene::extent_q16;
    return view;
}

inline raster::View figures_light() {
    raster::View view = figures_observer();
    view.axes = raster::axes_from_angles(paper_scene::light_azimuth_q16, 0);
    return view;
}

// Diced into 2^levels x 2^levels cells a patch, with `bits` bits of X and Y.
class FiguresScene {
public:
    explicit FiguresScene(int levels, int bits = 9) {
        const raster::View observer = figures_observer(), light = figures_light();
        for (std::size_t k = 0; k < paper_scene::spheres.size(); ++k)
            raster::sphere_patches(paper_scene::spheres[k],
                                   std::span(patches_).subspan(32 * k).first<32>());
        const raster::Surfaces surfaces(std::span<const raster::Patch>(patches_), {});
        int fraction = 0;
        fixed::require(fit_fraction(observer, bits, surfaces, std::span(&light, 1), fraction) ==
                           SpaceStatus::ok, "the figures fit");
        const ToWords to(observer, bits, fraction);
        Space space;
        Centre centre{};
        fixed::require(to.space(space) && to.light(light, centre), "the figures' light fits");
        const MeshSize size = diced_size(surfaces, levels);
        mesh_memory_ = std::make_unique<Memory>(MeshBuilder::bytes(size));
        MeshBuilder builder(mesh_memory_->bytes(), size);
        const auto dice_memory = std::make_unique<raster::DiceMemory>();
        add_diced(surfaces, levels, to, *dice_memory, builder);
        Mesh mesh;
        fixed::require(builder.finish(mesh) == MeshStatus::ok, "the figures' mesh");
        setting_memory_ = std::make_unique<Memory>(setting_bytes(mesh.facets.size(), mesh.edges.size()));
        fixed::require(make_setting(space, mesh, centre, setting_memory_->bytes(), setting_),
                       "the figures' setting");
        shown_.resize(space.pixels());
        VisibleCounts counts;
        find_visible(setting_, shown_, counts);
    }
    FiguresScene(const FiguresScene&) = delete;
    FiguresScene& operator=(const FiguresScene&) = delete;

    const Setting& setting() const { return setting_; }
    std::span<const std::uint32_t> shown() const { return shown_; }

private:
    std::array<raster::Patch, 32 * paper_scene::spheres.size()> patches_{};
    std::unique_ptr<Memory> mesh_memory_, setting_memory_;
    Setting setting_{};
    std::vector<std::uint32_t> shown_;
};

}  // namespace umbra78::shadow::rivals::test
