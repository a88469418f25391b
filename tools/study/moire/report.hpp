// The page of the moire study: verdicts, plots over the dither's size, pictures of the spectra, and
// which reading of the paper's sentence on the two bands fits.
#pragma once

#include "tools/study/measures.hpp"
#include "tools/study/moire/frame.hpp"

namespace umbra78::tools::study {

// The scene that a case draws: the request's, or the slanted plane.
LoadedScene moire_scene(const Request&, const Case&);

// A case's frame, drawn up to its mask.
struct MoireFrame {
    std::shared_ptr<const Traced> traced;
    std::vector<std::uint8_t> mask, visible;
    int window_px = 0;  // the side of the measured window; 0 for the scene's own surfaces
    double bias_quanta = 0;
    ShadowReport report;
    MachineMask shown() const { return {mask, visible}; }
};
MoireFrame draw_moire(const LoadedScene&, const Case&, const TruthCache&);

// The flatness up to which a window is a pattern, and from which on it is noise; between them
// nothing is said. White noise of errors has 0.56 to 0.59 (tools/truth/spectrum.hpp). Fewer windows
// than min_windows are no measure.
inline constexpr double max_periodic_flatness = 0.48, min_noise_flatness = 0.53;
inline constexpr int min_windows = 10;

// "pattern", "noise", "between" or "too few errors". For the plane by Fisher's p, 1 in 1000.
std::string verdict(const Row&);

void report_moire(const Request&, std::span<const Row>, Report&);

}  // namespace umbra78::tools::study
