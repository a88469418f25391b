// The figures of merit of a frame as text and JSON: bias, errors, times.
#pragma once

#include "tools/io/text_formats.hpp"
#include "tools/render/render_job.hpp"
#include "tools/truth/scene_truth.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace umbra78::tools {

// The bias in light-map Z quanta, light-map texels and world units, at the light's target; of a
// light with an area, of the first of its depth maps.
struct BiasReport {
    double quanta, texels, world;
};
BiasReport bias_report(const RenderJob&, std::size_t light = 0);

std::string print(const BiasReport&);      // "64 quanta = 0.5 texels = 0.00390625 world units"
std::string percent(std::optional<double> rate);  // "23.87" or "n/a"
// The lines error, compared, edge and truth. A rate of no pixels is n/a. Of a mask with grey levels
// the error is in the light that is seen; its rates at the threshold are in the JSON alone.
// Of the pixels that show a scene's ground.
std::string print_on_ground(const ShadowReport& report);
std::string print(const ShadowReport&);

nlohmann::ordered_json to_json(const BiasReport&);
nlohmann::ordered_json to_json(const StageTimes&);
nlohmann::ordered_json to_json(const std::optional<ShadowReport>&);  // null for none

}  // namespace umbra78::tools
