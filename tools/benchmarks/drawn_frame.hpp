// The figures' scene and float frames' meshes with their frames, for what is measured.
#pragma once

#include "shadow/frame/frame.hpp"
#include "shadow/frame/paper_figures.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace umbra78::tools {

// A scene with its frame, drawn once.
struct DrawnFrame {
    shadow::Settings settings;
    shadow::Scene scene;
    std::vector<std::byte> memory;
    shadow::FrameBuffers<hw::Depth16> frame;
    shadow::FrameMatrices matrices;
    shadow::FrameCounts counts;
    shadow::FramePlan plan;

    // `workers`: the most that may be set in its frame's executor.
    DrawnFrame(const shadow::Settings& s, std::span<const raster::Patch> patches,
               const raster::Mesh& mesh, std::size_t workers = 1)
        : settings(s), scene{patches,
                             {&shadow::figure_material, 1},
                             shadow::figure_view(0),
                             {{shadow::figure_view(shadow::figure_azimuth_q16)}}},
          matrices{} {
        scene.mesh = mesh;
        shadow::FrameShape shape(scene, s);
        shape.workers = workers;
        memory.resize(shadow::frame_bytes<hw::Depth16>(s.machine, patches.size(), shape) + 64);
        void* at = memory.data();
        std::size_t space = memory.size();
        auto* aligned = static_cast<std::byte*>(std::align(64, space - 64, at, space));
        frame = shadow::carve<hw::Depth16>({aligned, space}, s.machine, patches.size(), shape);
        draw();
        plan = shadow::make_plan(inputs());
    }
    shadow::FrameInputs inputs() const { return {scene, settings, matrices}; }
    void draw() { shadow::render(scene, settings, frame, matrices, counts); }
};

// Figure 6 by both samplings and meshes of its spheres, by name.
std::vector<std::pair<std::string, std::unique_ptr<DrawnFrame>>> benchmark_frames(
    std::size_t workers);

}  // namespace umbra78::tools
