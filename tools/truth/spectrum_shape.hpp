// The shape of a spectrum: is its highest line more than chance, at which frequency is it, and is
// the power spread evenly over frequencies and directions?
//
// Frequencies are in cycles a pixel, u along x and v along y (down), -1/2 .. 1/2. Of each
// conjugate pair of bins one is counted: v > 0, or v = 0 and u > 0.
#pragma once

#include "tools/truth/spectrum.hpp"

#include <span>
#include <vector>

namespace umbra78::tools {

struct Frequency {
    double u = 0, v = 0;
    double period_px() const;  // infinite for none
};

// The frequency within -1/2 .. 1/2 that has the same samples; of the pair (f, -f) the one that is
// counted.
Frequency aliased(Frequency);
// The distance of two frequencies whose samples are compared: the least one between their aliases.
double distance(Frequency, Frequency);

// The highest measured bin of a periodogram (n * n bins). `over_mean` is 0 if all bins are 0.
struct Peak {
    Frequency at;
    double over_mean = 0;
};
Peak highest_peak(std::span<const double> power, int n);

// Fisher's test of the highest of m ordinates (R. A. Fisher 1929): g is its share of their sum,
// p the probability of as large a share among m independent exponentials,
//
//   p = sum over j = 1 .. 1/g of (-1)^(j-1) C(m, j) (1 - j g)^(m-1)
//
// The ordinates are those of the untapered periodogram, without the 3 x 3 bins round zero and
// those that are their own conjugates. p is exact for Gaussian noise, nearly so for binary noise.
struct FisherTest {
    double g = 0, p = 1;
    int ordinates = 0;
};
FisherTest fisher_test(std::span<const double> window, int n);
double fisher_p(double g, int ordinates);

// R. A. Ulichney, "Digital Halftoning" (1987), chapter 4: over rings a bin wide round zero
// frequency, the mean power and the variance of the power over its square. White noise has power
// 1 (here relative to the mean of all bins) and, averaged over K segments, -10 log10 K dB; a ring
// of N bins with one line has 10 log10 N dB. Tapered bins are not independent, which lowers small
// rings' anisotropy a little.
struct RadialPower {
    std::vector<double> frequency, power, anisotropy_db;  // by ring, out to 1/2
    double max_anisotropy_db = 0;                    // of the rings with `min_bins`
    static constexpr int min_bins = 8;
};
RadialPower radial_power(std::span<const double> power, int n);

// The mean periodogram of the segments of n x n pixels, side by side, that are wholly valid.
struct SegmentedSpectrum {
    std::vector<double> power;
    int n = 0, segments = 0;
};
SegmentedSpectrum segmented_spectrum(std::span<const double> error, int size,
                                     std::span<const std::uint8_t> valid, int n);

// The n x n window whose corner is at (left, top). A window that is not within the image stops the
// program.
std::vector<double> cut_window(std::span<const double> image, int size, int left, int top, int n);

}  // namespace umbra78::tools
