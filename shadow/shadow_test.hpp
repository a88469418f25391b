// What the shadow test of a point reads: the machine's widths, where a pixel's coordinate lies,
// how the light map is looked up, the dither, and which of the pixel's depths is compared.
//
// Every stage of the post-process takes this value and not the settings of a whole frame
// (shadow/frame/settings.hpp), which add to it what the other stages read.
#pragma once

#include "hw/machine_spec.hpp"
#include "hw/noise_source.hpp"

#include <cstdint>

namespace umbra78::shadow {

// A pixel's coordinate in the post-process: its centre, or its index (half a pixel off).
enum class Registration : std::uint8_t { centre, index };
// What a point is compared with: the light map's Z of the texel it falls in; the exact mean of
// four; each of a window of texels by itself, so that the answer is a share of them (percentage
// closer filtering: Reeves, Salesin & Cook 1987); or, to show why that is done, a window's mean.
enum class Lookup : std::uint8_t { nearest, bilinear, percentage, filtered_depth };
// Where a window's taps lie: on the texels nearest to the point, or one in each of as many cells
// about the point, where the place's noise puts it.
enum class TapPlaces : std::uint8_t { grid, jittered };
// What bilinear lookup does where one of its four texels is background: it blends the background's
// code like any other, or falls back to the nearest texel alone.
enum class Background : std::uint8_t { blend, fall_back };

// What of a pixel is compared: its own depth; its plane's where the map is sampled
// (shadow/receiver.hpp); or its point, moved along its normal (shadow/normal_offset.hpp).
enum class Receiver : std::uint8_t { point, plane, normal };

// Where a receiver's plane or normal comes from: Z differences of the observer's store, or the
// normals that it keeps (shadow/kept_normal.hpp).
enum class SlopeSource : std::uint8_t { depths, normals };

struct ShadowTest {
    hw::MachineSpec machine{};
    Registration registration = Registration::centre;
    Lookup lookup = Lookup::nearest;
    Background background = Background::blend;
    std::int32_t taps = 3;  // of a window, a side; 2..5
    TapPlaces tap_places = TapPlaces::grid;
    hw::Dither dither{};
    Receiver receiver = Receiver::point;
    std::int32_t normal_offset_q8 = 1 << 8;  // texels, of receiver = normal
    SlopeSource slope_source = SlopeSource::depths;
};

// Whether the observer's store has to keep normals.
constexpr bool reads_normals(const ShadowTest& s) {
    return s.receiver != Receiver::point && s.slope_source == SlopeSource::normals;
}

// Whether a lookup reads a window of taps x taps texels.
constexpr bool has_window(Lookup lookup) {
    return lookup == Lookup::percentage || lookup == Lookup::filtered_depth;
}

}  // namespace umbra78::shadow
