// What the moire study draws and measures: a slanted plane beside the scene's own surfaces, the
// beat of the two grids, the shadow with a generator that is no good, and an error's spectrum.
#pragma once

#include "tools/study/measures.hpp"
#include "tools/truth/spectrum_shape.hpp"

#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// A plane that fills the observer's picture, lit everywhere, under a light from the left.
extern const std::string_view slanted_plane;

// The two grids on a plane that both views see orthographically. The light's place (X, Y), in
// texels, of observer pixel (x, y) is affine in x and y, so whatever depends on X and Y modulo a
// texel, as a nearest lookup's error does, is made of the frequencies
//
//   k (dX/dx, dX/dy) + l (dY/dx, dY/dy)   cycles a pixel, k and l whole
//
// which sampling at whole pixels folds into -1/2 .. 1/2: the beat. The error is
// zu (X - its texel's centre) + zv (Y - its texel's centre), two saw teeth, whose fundamental is
// the stronger where the slope is the greater; the compare with the bias adds sums of them.
struct GridBeat {
    Frequency x, y;       // of X and of Y, before folding
    double zu = 0, zv = 0;  // depth a texel along X and Y
    Frequency harmonic(int k, int l) const;  // folded
    Frequency predicted() const;             // the fundamental of the steeper axis
};
// Through the pixel in the middle of the picture and its neighbours, which must see one plane.
GridBeat grid_beat(const SceneTruth&);

// The harmonic of the lowest order |k| + |l| that stands within `reach` of the frequency; order 0
// where none up to `most_order` does.
struct Harmonic {
    int k = 0, l = 0;
};
Harmonic harmonic_at(const GridBeat&, Frequency, double reach, int max_order = 5);

// The mask with a generator that is started anew in every row: row 0's words in all of them.
// For Z of up to 16 bits, behind draw_mask.
std::vector<std::uint8_t> mask_with_restarted_rows(const RenderJob&);

// The false shadow of a lit surface, as a spectrum. `window_px` is the side of the square in the
// middle of the picture; 0 for spheres, whose moire is a chirp: then only `flatness` is measured.
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

// A window of the error's spectrum as a picture, zero frequency in the middle, black to white over
// `decades` below the highest bin.
std::vector<std::uint8_t> spectrum_picture(std::span<const double> power, int n,
                                           double decades = 4);

// The window_px^2 window of the image with the most errors, for spheres' pictures.
std::vector<double> busiest_window(const SceneTruth&, const MachineMask&, int window_px);

}  // namespace umbra78::tools::study
