// What decided a pixel of a rival: the facet that it shows, and, where the light is on the side
// that is seen, the facets before it and the sides of shadow volumes between it and the eye.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/watch/pixel_trace.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace umbra78::tools {

struct RivalTrace {
    Pixel pixel{};
    std::string state;          // "nothing seen", "lit", "attached shadow", "cast shadow"
    std::size_t facets = 0;     // of the scene
    std::uint32_t facet = 0;    // shown
    std::vector<std::uint32_t> casters{};  // facets between the point and the light
    struct Side {
        std::uint32_t low, high;  // vertices of its edge
        std::int32_t change;      // of the count, where it is crossed
    };
    std::size_t contour = 0;      // edges on which sides stand
    std::vector<Side> sides{};    // crossed between the eye and the point
    std::int32_t at_eye = 0;      // volumes in which the eye is
};

// Throws SceneError for a pixel outside the picture.
RivalTrace trace_rival(const RenderJob&, Pixel);
std::string print(const RivalTrace&);
nlohmann::ordered_json to_json(const RivalTrace&);

}  // namespace umbra78::tools
