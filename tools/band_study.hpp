// What of the paper's sentence on figure 3 fits which reading of it.
//
// Williams 1978, p. 273: the error is greatest "at the edge of the vertical shadow line (the
// right edge of the spheres in the light's view)" and in "a dark curved band to the left of it"
// ("the right edge of the spheres in the untransformed observer's view"). Figure 3 is drawn for
// each side the light may stand on, each sampling and each registration, and its false shadow
// followed over the lit side of the spheres from limb to shadow line, in four equal steps of the
// normal's azimuth: limb, middle, inner, line.
#pragma once

#include "shadow/settings.hpp"

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

    // The sentence's four parts. A band at the limb is there if at least a twentieth of its
    // pixels err, and more than in the middle.
    static constexpr double least_band = 0.05;
    bool line_is_lights_right_edge() const { return azimuth < 0; }
    bool greatest_at_line() const;
    bool band_at_limb() const;
    bool band_left_of_line() const { return band_at_limb() && !right_edge_lit(); }
    bool band_is_observers_right_edge() const { return band_at_limb() && right_edge_lit(); }
};

std::vector<BandRow> study_bands();

std::string to_markdown(const std::vector<BandRow>&);
nlohmann::ordered_json to_json(const std::vector<BandRow>&);

}  // namespace umbra78::tools
