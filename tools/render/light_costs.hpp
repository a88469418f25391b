// What each light of a frame adds to it, in cycles of the machine and bytes of its memory.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/scene/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace umbra78::tools {

// Cycles with the units of each phase side by side.
struct LightCost {
    std::size_t light = 0;  // of the scene
    std::string name;
    std::size_t maps = 1;   // its depth maps
    std::uint64_t drawing = 0, transformation = 0, filters = 0;
    std::uint64_t bytes = 0;  // its maps, masks, filtered masks and shares, at the machine's widths

    std::uint64_t cycles() const { return drawing + transformation + filters; }
};

// A row a light of the scene.
std::vector<LightCost> light_costs(const LoadedScene&, std::span<const shadow::FrameLedger>);

std::string print(std::span<const LightCost>, int clock_ns);
nlohmann::ordered_json to_json(const LightCost&);

}  // namespace umbra78::tools
