#include "tools/render/light_costs.hpp"

#include "tools/scene/view_keys.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbra78::tools {

using shadow::FrameLedger;

std::vector<LightCost> light_costs(const LoadedScene& scene,
                                   std::span<const FrameLedger> ledgers) {
    const hw::MachineSpec& machine = scene.settings.machine;
    const std::uint64_t pixels = std::uint64_t{1} << (2 * machine.xy_bits);
    const bool has_map = shadow::map_layers(scene.settings) > 0;
    const std::uint64_t z_bytes = !has_map ? 0 : machine.z_bits > 16 ? 4 : 2;
    const std::uint64_t channels = scene.is_coloured() ? 3 : 1;
    std::vector<LightCost> costs;
    std::size_t next = 0;  // of the depth maps
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
        LightCost cost{.light = l, .name = name_of_light(l, scene.lights.size())};
        const std::size_t points = scene.lights[l].views().size();
        cost.maps = has_map ? points : 0;
        for (const FrameLedger& map : ledgers.subspan(next, points)) {
            cost.drawing += FrameLedger::cycles(map.light, true);
            cost.transformation += map.transformation(true);
            cost.filters += map.filters(true);
        }
        next += points;
        // Maps; a mask each, or one of all sectors; an area's joined mask; two filtered; the shares.
        const std::uint64_t masks = scene.lights[l].sectored    ? 1
                                    : points > 1                 ? points + 1
                                    : scene.lights[l].ramp_px > 0 ? 2
                                                                  : 1;
        cost.bytes = pixels * (cost.maps * z_bytes + masks + 2 + channels);
        costs.push_back(cost);
    }
    return costs;
}

std::string print(std::span<const LightCost> costs, int clock_ns) {
    std::string text =
        fmt::format("{:<11} {:>4}{:>14}{:>16}{:>12}{:>12}{:>10}\n", "of a light", "maps",
                    "drawing ms", "transform ms", "filters ms", "in all ms", "MB");
    const auto ms = [&](std::uint64_t cycles) { return simulated_ms(cycles, clock_ns); };
    for (const LightCost& c : costs)
        text += fmt::format("{:<11} {:>4}{:>14.1f}{:>16.1f}{:>12.1f}{:>12.1f}{:>10.2f}\n", c.name,
                            c.maps, ms(c.drawing), ms(c.transformation), ms(c.filters),
                            ms(c.cycles()), static_cast<double>(c.bytes) / 1e6);
    return text;
}

nlohmann::ordered_json to_json(const LightCost& c) {
    return {{"light", c.name},
            {"depth_maps", c.maps},
            {"drawing_cycles", c.drawing},
            {"transformation_cycles", c.transformation},
            {"filter_cycles", c.filters},
            {"cycles", c.cycles()},
            {"bytes", c.bytes}};
}

}  // namespace umbra78::tools
