// The machine's widths and roundings: one value that every unit is given. Nothing is global.
//
// The default is the machine of 1978: a 512 x 512 frame store, 16-bit Z, a multiplier-accumulator
// of 16 x 16 bits into 35 (the class of TRW's TDC1010J). Every width can be set. The member
// functions are the formats that follow from the widths, and `check` says which width, if any, is
// out of the range in which no sum and no shift overflows.
//
// Screen space is a cube: X, Y and Z are counted in pixels from its centre, so an orthographic
// view's Z quantum is 2^-depth_fraction() pixel (1/128 by default). See hw/MACHINE.md, section 2.
#pragma once

#include "fixed/rounding.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace umbra78::hw {

using fixed::Rounding;

// Where a perspective quotient is rounded: once, after the division of the exact accumulators; or
// x and w also before it, to show what that costs.
enum class DivideOrder : std::uint8_t { exact, round_first };

// Which codes a depth store keeps: all of z_bits; or those that a 32-bit float holds of the depth,
// or of one minus it (hw/MACHINE.md, section 28).
enum class DepthStore : std::uint8_t { fixed, of_floats, of_reversed_floats };
inline constexpr int float_significand = 24;

struct MachineSpec {
    int xy_bits = 9;            // pixels a side = 2^xy_bits; 4..12
    int z_bits = 16;            // 4..26; the all-ones code is the background
    int coefficient_bits = 16;  // signed Q1.(bits - 2), one exponent a row; 8..32
    int fraction_bits = 7;      // of X and Y after the transform; 0..12
    int multipliers = 4;        // 1, 4 or 16 multipliers of 16 x 16 bits
    int max_accumulator_bits = 64;  // bits a row's accumulator may have; 16..64, see built_bits()
    Rounding product_rounding = Rounding::floor;  // of products, if the accumulator is short
    Rounding transform_rounding = Rounding::half_up;
    Rounding coefficient_rounding = Rounding::half_even;
    Rounding depth_rounding = Rounding::half_up;
    DepthStore depth_store = DepthStore::fixed;
    DivideOrder divide_order = DivideOrder::exact;

    constexpr int size_px() const { return 1 << xy_bits; }
    constexpr int half_px() const { return 1 << (xy_bits - 1); }

    // Z quanta a pixel, as a power of two; negative where a quantum is larger than a pixel.
    constexpr int depth_fraction() const { return z_bits - xy_bits; }

    // Fraction bits of the words that enter the transform unit: enough for Z, and for a pixel's
    // centre.
    constexpr int input_fraction() const { return depth_fraction() > 1 ? depth_fraction() : 1; }
    constexpr int word_bits() const { return xy_bits + input_fraction(); }
    constexpr std::int32_t one_word() const { return std::int32_t{1} << (word_bits() - 2); }

    // The sum of four exact products, at most 4 2^(word_bits - 1) 2^(coefficient_bits - 1), needs
    // the bits of both factors and two more. The machine has three more, 35 by default, as the
    // single-chip multiplier-accumulators of the time had (TRW TDC1010J: 16 x 16 bits into 35).
    constexpr int accumulator_bits() const { return word_bits() + coefficient_bits + 3; }
    // A shorter accumulator lacks low bits, and each product is rounded to its bits when added.
    constexpr int dropped_bits() const {
        const int excess = accumulator_bits() - max_accumulator_bits;
        return excess > 0 ? excess : 0;
    }
    constexpr int built_bits() const { return accumulator_bits() - dropped_bits(); }

    constexpr std::uint32_t background() const { return (std::uint32_t{1} << z_bits) - 1; }
    constexpr std::uint32_t deepest_drawn() const { return background() - 1; }
    constexpr std::int64_t depth_offset() const { return std::int64_t{1} << (z_bits - 1); }

    // The code that the store keeps of a drawn one, 0 .. deepest_drawn().
    constexpr std::uint32_t kept(std::uint32_t code) const {
        return depth_store == DepthStore::fixed ? code : kept_float(code);
    }

private:
    constexpr std::uint32_t kept_float(std::uint32_t code) const {
        const std::uint32_t whole = std::uint32_t{1} << z_bits;
        const bool reversed = depth_store == DepthStore::of_reversed_floats;
        const std::uint32_t v = reversed ? whole - code : code;
        const int drop = std::max(0, static_cast<int>(std::bit_width(v)) - float_significand);
        const auto rounded = static_cast<std::uint32_t>(
            fixed::round_shift(std::int64_t{v}, drop, Rounding::half_even) << drop);
        if (reversed) return whole - rounded;
        const std::uint32_t step = std::uint32_t{1} << std::max(1, z_bits - float_significand);
        return std::min(rounded, whole - step);
    }
};

// Which width, if any, is out of its range.
enum class SpecStatus : std::uint8_t {
    ok, xy_bits, z_bits, coefficient_bits, fraction_bits, multipliers, max_accumulator_bits
};

constexpr SpecStatus check(const MachineSpec& m) {
    if (m.xy_bits < 4 || m.xy_bits > 12) return SpecStatus::xy_bits;
    // The divider shifts a Z of 20 fraction bits 62 places.
    if (m.z_bits < 4 || m.z_bits > 26 || m.depth_fraction() > 20) return SpecStatus::z_bits;
    if (m.coefficient_bits < 8 || m.coefficient_bits > 32) return SpecStatus::coefficient_bits;
    if (m.fraction_bits < 0 || m.fraction_bits > 12) return SpecStatus::fraction_bits;
    if (m.multipliers != 1 && m.multipliers != 4 && m.multipliers != 16)
        return SpecStatus::multipliers;
    if (m.max_accumulator_bits < 16 || m.max_accumulator_bits > 64)
        return SpecStatus::max_accumulator_bits;
    return SpecStatus::ok;
}

static_assert(MachineSpec{}.word_bits() == 16 && MachineSpec{}.accumulator_bits() == 35,
              "1978's formats: 16-bit words, 35-bit accumulator");

}  // namespace umbra78::hw
