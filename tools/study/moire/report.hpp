// What the moire study's rows say: verdicts, plots over the dither's size, pictures of the spectra,
// and which reading of the paper's sentence on the two bands fits.
#pragma once

#include "tools/study/moire/frame.hpp"

namespace umbra78::tools::study {

// A case's frame, as far as its mask.
struct MoireFrame {
    LoadedScene scene;
    std::shared_ptr<const Traced> traced;
    std::vector<std::uint8_t> mask, visible;
    int window_px = 0;  // 0 for the scene's own surfaces
    double bias_quanta = 0;
    MachineMask shown() const { return {mask, visible}; }
};
MoireFrame draw_moire(const Request&, const Case&, const TruthCache&);
ShadowReport report_of(const MoireFrame&);

// Between them nothing is said: white noise of errors has 0.56 to 0.59 (tools/truth/spectrum.hpp),
// and so few windows are no measure.
inline constexpr double max_periodic_flatness = 0.48, min_noise_flatness = 0.53;
inline constexpr int min_windows = 10;

// "pattern", "noise", "between" or "no errors". Of a plane by Fisher's p, 1 in 1000.
std::string verdict(const Row&);

void report_moire(const Request&, std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
