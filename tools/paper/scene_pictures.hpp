// Figures 7 and 8 and the gallery: scene files drawn as they are, with error and cost.
//
// The paper's figures 7 and 8 show a smile and a robot whose models are lost; these are this
// project's own. The gallery shows the other surfaces that scenes may have.
#pragma once

#include "tools/render/report.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct ScenePicture {
    std::string_view name;   // of its file and its golden
    std::string_view shows;  // a caption
    std::string_view scene;  // a file of tools/scenes
    std::string_view set{};  // overrides, with a blank between two
    bool figure = false;     // one of the paper's; else of the gallery
    std::string_view needs{};  // a file, without which it is left out
    std::string_view package{};  // that brings the file
};

std::span<const ScenePicture> scene_pictures();

// What one light's shadow costs: the frame without it is the observer's view alone.
struct ShadowCost {
    std::uint64_t cycles = 0, cycles_without = 0;
    double host_ms = 0, host_ms_without = 0;

    double times_cycles() const {
        return static_cast<double>(cycles) / static_cast<double>(cycles_without);
    }
    double times_host() const { return host_ms / host_ms_without; }
};

struct DrawnScene {
    const ScenePicture* of = nullptr;
    std::string left_out;  // why, in a line; then there is nothing else
    std::size_t patches = 0, triangles = 0;
    int size_px = 0, clock_ns = 0;
    std::vector<std::vector<std::uint8_t>> channels;  // of the picture: one, or red, green, blue
    std::vector<std::uint8_t> rgb;  // of a coloured one
    std::size_t lights = 1, maps = 1;
    ShadowCost cost;
    std::optional<ShadowReport> error;  // of a scene with one light
    std::optional<ShadowReport> on_ground{};  // of the pixels that show its ground
    std::vector<std::string> warnings;

    bool coloured() const { return channels.size() > 1; }
    // What a sheet of grays shows: of a coloured one the mean, with green twice.
    std::vector<std::uint8_t> gray() const;
    // The golden's buffers: NAME, or NAME_red, NAME_green, NAME_blue.
    std::vector<Buffer> buffers() const;
};

// Draws them all from the scene files in `folder`, several at a time, in the table's order.
std::vector<DrawnScene> draw_scene_pictures(const std::string& folder);

// Cost of the shadow, scene by scene: a Markdown table.
std::string cost_table(std::span<const DrawnScene>);

nlohmann::ordered_json to_json(const DrawnScene&);

}  // namespace umbra78::tools
