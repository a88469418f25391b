// How far the machine's shadow is from truth. Whether its errors are moire or noise is measured by
// tools/truth/spectrum.hpp.
//
// Rates are fractions 0 .. 1. An image is size * size values, row 0 at the top, as in Truth; a
// span of another length stops the program, as every broken precondition does (fixed/trap.hpp). A
// band is an image of 0 and 1: its pixels are left out.
#pragma once

#include "tools/truth/truth.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace umbra78::tools {

// The machine's answer. Where `visible` is 0 the machine drew nothing; empty means all drawn.
struct MachineMask {
    std::span<const std::uint8_t> shadow;   // 0 light .. 255 shadow
    std::span<const std::uint8_t> visible;
    int threshold = 128;                    // shadow from here on

    bool in_shadow(std::size_t at) const { return shadow[at] >= threshold; }
    bool drawn(std::size_t at) const { return visible.empty() || visible[at] != 0; }
};

// Counts of pixels that both truth and the machine see.
struct ShadowError {
    int lit = 0, shadowed = 0;  // in truth
    int false_shadow = 0;       // lit in truth, shadowed in the mask: acne, moire
    int false_light = 0;        // shadowed in truth, lit in the mask: leak, detached shadow

    double false_shadow_rate() const { return lit ? double(false_shadow) / lit : 0; }
    double false_light_rate() const { return shadowed ? double(false_light) / shadowed : 0; }
};

// Over every pixel where `leave_out` (empty or a band) is 0.
ShadowError shadow_error(const Truth&, const MachineMask&,
                         std::span<const std::uint8_t> leave_out = {});

// How far a mask is from the fraction of the light that is seen, which is 0 or 1 for a light at
// infinity or at a point. Unlike the rates above it holds for masks with grey levels, too.
struct GradedError {
    int lit = 0, umbra = 0;            // in truth: all of the light is seen, or none
    int penumbra = 0;                  // and some of it, of a light with an area
    double absolute = 0;               // sum of |mask - truth|, in 255ths
    double squares = 0;                // of their squares, in 255ths squared
    int lit_below_98 = 0;              // lit pixels that get less than 98 % of the light
    int umbra_above_2 = 0;             // umbra pixels that get more than 2 %
    int between = 0;                   // pixels whose mask is neither 0 nor 255

    int pixels() const { return lit + umbra + penumbra; }
    bool graded() const { return between > 0; }
    // Of pixels() > 0, lit > 0 and umbra > 0; else 0.
    double mean_absolute() const;
    double rms() const;
    double lit_below_98_rate() const { return lit ? double(lit_below_98) / lit : 0; }
    // How large the machine's penumbra is, over the true one: pixels of neither end.
    double penumbra_ratio() const { return penumbra ? double(between) / penumbra : 0; }
    double umbra_above_2_rate() const { return umbra ? double(umbra_above_2) / umbra : 0; }
};

// Over every pixel that both see and where `leave_out` is 0.
GradedError graded_error(const Truth&, const MachineMask&,
                         std::span<const std::uint8_t> leave_out = {});

// Drawn pixels with drawn 4-neighbours none of which has the same answer.
int isolated_pixels(const MachineMask&, int size);

// 1 false shadow, -1 false light, 0 right, not seen by both, or left out.
std::vector<double> error_image(const Truth&, const MachineMask&,
                                std::span<const std::uint8_t> leave_out = {});

// 1 where truth is lit and the machine drew: the pixels where acne and moire may be.
std::vector<std::uint8_t> lit_pixels(const Truth&, const MachineMask&);

// False shadow on one sphere, from the observer's limb (first bin) to the shadow line (last).
// A lit pixel's place is the azimuth of its normal about the view's up axis; exact for a light
// in the view's horizontal plane. Pixels outside limb .. line count in the end bins.
std::vector<ShadowError> limb_to_line_profile(const Truth&, const MachineMask&,
                                              const TruthScene&, int sphere, const TruthView&,
                                              const TruthLight&, int bins);

}  // namespace umbra78::tools
