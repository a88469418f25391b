// What the moire study draws and measures: a slanted plane as well as the scene's own surfaces, the
// beat of the two grids, the shadow with a bad noise generator, and the spectrum of the error.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/truth/scene_truth.hpp"
#include "tools/truth/spectrum_shape.hpp"

#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// A plane that fills the observer's picture, lit everywhere, under a light from the left.
extern const std::string_view slanted_plane;

// The two grids on a plane that both views see orthographically. The light's place (X, Y), in
// texels, of observer pixel (x, y) is affine in x and y. Whatever depends on X and Y modulo a
// texel, such as the error of a nearest lookup, therefore consists of the frequencies
//
//   k (dX/dx, dX/dy) + l (dY/dx, dY/dy)   cycles a pixel, k and l whole
//
// which sampling at whole pixels folds into -1/2 .. 1/2: the beat. The error is
// zu (X - its texel's centre) + zv (Y - its texel's centre), two saw teeth. The stronger
// fundamental is that of the greater slope; the comparison with the bias adds sums of both.
struct GridBeat {
    Frequency x, y;       // of X and of Y, before folding
    double zu = 0, zv = 0;  // depth a texel along X and Y
    Frequency harmonic(int k, int l) const;  // folded
    Frequency predicted() const;             // the fundamental of the steeper axis
};
// From the pixel in the middle of the picture and two neighbours. Throws SceneError if they do not
// see one plane.
GridBeat grid_beat(const SceneTruth&);

// The harmonic of the lowest order |k| + |l| that is within `reach` of the frequency; (0, 0) if
// none up to `max_order` is.
struct Harmonic {
    int k = 0, l = 0;
};
Harmonic harmonic_at(const GridBeat&, Frequency, double reach, int max_order = 5);

// The mask with a generator that restarts in every row, so that all rows have row 0's words. The
// job's mask must be drawn. Throws SceneError for Z of more than 16 bits.
std::vector<std::uint8_t> mask_with_restarted_rows(const RenderJob&);

// The spectrum of the false shadow of lit surfaces. `window_px` is the side of the square in the
// middle of the picture; 0 for spheres, whose moire is a chirp: only `flatness` is then measured.
struct ErrorSpectrum {
    LocalFlatness flatness;
    std::vector<double> power;  // of the window: window_px^2 bins
    Peak peak;
    FisherTest fisher;
    RadialPower radial;         // of segments of segment_px^2 in the window
    int segments = 0;
    static constexpr int segment_px = 64;
};
ErrorSpectrum error_spectrum(const SceneTruth&, const MachineMask&, int window_px);

// A spectrum of n x n bins as a picture: zero frequency in the middle, the highest bin white, black
// from `decades` below it.
std::vector<std::uint8_t> spectrum_picture(std::span<const double> power, int n,
                                           double decades = 4);

// The wholly lit window of window_px^2 pixels with the most errors; zeros if there is none.
std::vector<double> busiest_window(const SceneTruth&, const MachineMask&, int window_px);

}  // namespace umbra78::tools::study
