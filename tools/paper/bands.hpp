// The bands: which reading of the paper's sentence on figure 3 fits what the machine draws.
//
// Williams 1978, p. 273: the error is greatest "at the edge of the vertical shadow line (the
// right edge of the spheres in the light's view)" and in "a dark curved band to the left of it"
// ("the right edge of the spheres in the untransformed observer's view"). Figure 3 is drawn with
// the light on each possible side, with each sampling and each registration. The false-shadow rate
// is measured over the lit side of the spheres, from the limb (the visible edge) to the shadow line
// (where the surface turns away from the light), in four equal steps of the normal's azimuth: limb,
// middle, inner, line. tools/paper/BANDS.md is the table.
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

    // The parts of the sentence. A step is dark if its rate is at least min_dark; it is a band of
    // its own if its rate exceeds that of the next step toward the line by at least min_dark.
    static constexpr double min_dark = 0.05;
    bool line_is_lights_right_edge() const { return azimuth < 0; }
    bool max_at_line() const;
    bool band_left_of_line() const;
    bool observers_right_edge_dark() const {
        return right_edge_lit() && false_shadow[0] >= min_dark;
    }
};

// With figure 3's settings, except for the bias, in quanta.
std::vector<BandRow> measure_bands(int bias_quanta);

std::string to_markdown(const std::vector<BandRow>&, int bias_quanta);
nlohmann::ordered_json to_json(const std::vector<BandRow>&);

}  // namespace umbra78::tools
