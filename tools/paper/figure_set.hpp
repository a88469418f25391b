// Figures 1 to 6, drawn by the machine; stages that they share are run once.
#pragma once

#include "shadow/frame/paper_figures.hpp"
#include "tools/render/report.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace umbra78::tools {

// The scene of tools/scenes/figures.toml, from the words of shadow/frame/paper_figures.hpp.
LoadedScene figures_scene();

struct Figure {
    int number;
    std::string shows;
    std::vector<std::uint8_t> picture;  // gray, size_px * size_px
    std::string golden;                 // the name of the buffer that the picture is made from
    std::string hash;                   // of that buffer
    std::uint64_t machine_cycles;       // from the scene to the figure, as is host_ms
    double host_ms;
    BiasReport bias;
    std::optional<ShadowReport> error;  // figures 3 to 6
    shadow::Settings settings;
};

class FigureSet {
public:
    FigureSet();

    const std::array<Figure, shadow::figure_count>& figures() const { return figures_; }
    // Every stage's buffer: observer_z, light_z, intensity, mask3, mask4, edges5, filtered5,
    // picture6; and figures 3 and 4 on the AP-120B, mask3_ap120b, mask4_ap120b.
    std::vector<Buffer> buffers() const;
    // Figure 3's mask in index registration, for the studies.
    const std::vector<std::uint8_t>& index_mask() const { return index_mask_; }

    // Figure 3 or 4 as the AP-120B computes it.
    const std::vector<std::uint8_t>& ap120b_mask(int figure) const {
        return ap120b_masks_[static_cast<std::size_t>(figure - 3)];
    }

    const LoadedScene& scene() const { return scene_; }
    const SceneTruth& truth() const { return truth_; }
    const std::vector<std::uint8_t>& visible() const { return visible_; }
    int size_px() const { return scene_.settings.machine.size_px(); }
    int clock_ns() const { return scene_.settings.timing.clock_ns; }

private:
    void add(int number, std::string shows, std::vector<std::uint8_t> picture,
             const Buffer& golden, std::uint64_t cycles, double host_ms,
             std::span<const std::uint8_t> mask = {});
    std::vector<std::uint8_t> copy(Plane) const;
    std::vector<std::uint8_t> mask_with(const shadow::Settings&);
    Buffer mask_buffer(const char* name, const std::vector<std::uint8_t>& mask) const {
        return {name, size_px(), 255, std::span(mask)};
    }

    LoadedScene scene_ = figures_scene();
    SceneTruth truth_;
    Band band_;
    RenderJob job_;
    std::vector<std::uint8_t> visible_, mask3_, index_mask_;
    std::array<std::vector<std::uint8_t>, 2> ap120b_masks_;
    std::array<Figure, shadow::figure_count> figures_{};
};

}  // namespace umbra78::tools
