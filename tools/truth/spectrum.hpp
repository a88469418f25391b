// Whether an error is periodic (moire) or noise: spectra of windows of an error image.
//
// An image is size * size values, row 0 at the top; a span of another length stops the program.
// White noise has a flatness of exp(-0.5772) = 0.5615.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra78::tools {

// What the window is weighted with. Hann keeps a strong line from leaking into other bins. Without
// a taper the bins of white noise are independent, which Fisher's test needs.
enum class Taper : std::uint8_t { hann, none };

// The periodogram of an n x n window: mean subtracted, tapered, |DFT|^2, n * n bins in the DFT's
// order. The transform is KISS FFT's; fast for n with small factors. The measures below leave
// out the 3 x 3 bins round zero frequency, into which the taper leaks the mean, and count both
// bins of every conjugate pair.
std::vector<double> periodogram(std::span<const double> window, int n, Taper = Taper::hann);

// Whether the bin is outside the 3 x 3 round zero frequency.
inline bool measured_bin(int u, int v, int n) {
    return std::min(u, n - u) > 1 || std::min(v, n - v) > 1;
}

// Geometric over arithmetic mean of the bins: exp(-0.5772) = 0.5615 for white noise, near 0 for
// a pattern that repeats. 0 for a constant window.
double spectral_flatness(std::span<const double> window, int n);

// Largest bin over the mean of the bins: about ln(n * n) for white noise. For windows that show one
// slanted plane, whose moire is one line. 0 for a constant window.
double peak_over_mean(std::span<const double> window, int n);

struct LocalFlatness {
    double median = 0;
    int windows = 0;  // with 0 windows the median says nothing
};
struct FlatnessSettings {
    int window = 32, stride = 16;  // pixels
    double min_valid = 1;          // fraction of valid pixels a window needs; others count as mean
    int min_errors = 16;           // pixels that differ from the window's commonest value
};

// The moire of a sphere is a chirp, which the spectrum of the whole picture takes for noise; the
// median over small windows does not. Windows with too few valid pixels or fewer than `min_errors`
// errors are left out.
// Calibrated on white errors: 0.562 where half of the pixels err, 0.568 where a tenth do, 0.573
// at 5 %, 0.592 at 2 %; a grating 0.02, a chirp 0.05. Compare errors of like density.
LocalFlatness median_local_flatness(std::span<const double> error, int size,
                                    std::span<const std::uint8_t> valid,
                                    const FlatnessSettings& = {});

}  // namespace umbra78::tools
