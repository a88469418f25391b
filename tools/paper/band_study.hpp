// What of the paper's sentence on figure 3 fits which reading of it.
//
// Williams 1978, p. 273: the error is greatest "at the edge of the vertical shadow line (the
// right edge of the spheres in the light's view)" and in "a dark curved band to the left of it"
// ("the right edge of the spheres in the untransformed observer's view"). Figure 3 is drawn for
// each side the light may stand on, each sampling and each registration, and its false shadow
// followed over the lit side of the spheres from limb to shadow line, in four equal steps of the
// normal's azimuth: limb, middle, inner, line.
#pragma once

#include "shadow/frame/settings.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

namespace umbra78::tools {

struct BandRow {
    int azimuth;  // of the light, degrees; positive is to the observer's right
    raster::Sampling sampling;
    shadow::Registration registration;
    std::array<double, 4> false_shadow;  // rates: limb, middle, inner, line; of all four spheres

    // Geometry: the lit limb is on the light's side; the line is where the surface turns away
    // from the light, left of the disc's centre at -100 and +80 degrees.
    bool right_edge_lit() const { return azimuth > 0; }
    bool line_left_of_centre() const { return (azimuth < 0) == (azimuth < -90 || azimuth > 90); }

    // The sentence's parts, with these thresholds: a step is dark from `least_dark` on, and a
    // band of its own if it is darker by as much than the step next to it toward the line.
    static constexpr double min_dark = 0.05;
    bool line_is_lights_right_edge() const { return azimuth < 0; }
    bool max_at_line() const;
    bool band_left_of_line() const;
    bool observers_right_edge_dark() const {
        return right_edge_lit() && false_shadow[0] >= min_dark;
    }
};

// With figure 3's settings, but this bias in quanta.
std::vector<BandRow> study_bands(int bias_quanta);

std::string to_markdown(const std::vector<BandRow>&, int bias_quanta);
nlohmann::ordered_json to_json(const std::vector<BandRow>&);

}  // namespace umbra78::tools
