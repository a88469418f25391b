// The divider, clocked: restoring division of a point's X, Y and Z by W, a quotient bit a step.
//
//   remainder <- 2 remainder + next bit of |acc_r| 2^(shift + 1)
//   if remainder >= acc_w:  remainder <- remainder - acc_w, quotient bit 1, else 0
//
// A result of b bits takes a cycle to load, b + 1 steps (the last bit has the weight 1/2) and a
// cycle to correct: round, restore the sign, and test the width. The serial divider does X, then Y,
// then Z (the clipping divider of Sproull and Sutherland, 1968, made a bit a cycle, too). Three
// pipelined dividers work side by side and take a point a cycle; a stage makes as many bits as the
// clock has room for subtractions.
//
// In: four accumulators of up to 64 bits. Out: fixed::Quotient for each of X, Y and Z. W <= 0 and
// a result that is too wide are statuses. Bits and statuses are those of fixed::divide; tests hold
// them equal.
#pragma once

#include "fixed/divide.hpp"
#include "hw/clocked/handshake.hpp"
#include "hw/clocked/timing.hpp"
#include "hw/transform_unit.hpp"

#include <array>
#include <cstdint>

namespace umbra78::hw {

class DividePipeline {
public:
    DividePipeline(const MachineSpec& spec, const Timing& timing, const MatrixWords& matrix)
        : rounding_(spec.transform_rounding), serial_(timing.divider == Divider::serial),
          bits_a_stage_(timing.divide_bits_a_stage()) {
        const std::array<int, 3> fraction{spec.fraction_bits, spec.fraction_bits,
                                          spec.depth_fraction()};
        bits_ = {spec.xy_bits + spec.fraction_bits + 1, spec.xy_bits + spec.fraction_bits + 1,
                 spec.z_bits + 1};
        for (std::size_t r = 0; r < 3; ++r) {
            shift_[r] = divide_shift(matrix, static_cast<Row>(r), fraction[r]);
            fixed::require(shift_[r] >= -62 && shift_[r] <= 62,
                           "clocked divider: shift outside -62..62");
        }
        longest_ = bits_[0] > bits_[2] ? bits_[0] : bits_[2];
        serial_cycles_ = serial_divide_cycles(spec);
    }

    // Cycles a point: of the one stage, or of each of the pipeline's.
    int cycles() const { return serial_ ? serial_cycles_ : 1; }
    int stages() const {
        return serial_ ? 1 : 2 + (longest_ + 1 + bits_a_stage_ - 1) / bits_a_stage_;
    }
    int latency() const { return cycles() * stages(); }
    // Of row r's quotient: its bits, how far its dividend shifts left, its first and last step.
    int bits(int r) const { return bits_[std::size_t(r)]; }
    int shift(int r) const { return shift_[std::size_t(r)]; }
    int first_step(int r) const { return serial_ && r > 0 ? last_step(r - 1) + 1 : 0; }
    int last_step(int r) const {
        return serial_ ? first_step(r) + bits(r) + 2 : stages() - 1;
    }

    // To a Chain or a StageList.
    template <class Stages>
    void add_stages(Stages& chain) const {
        for (int k = 0; k < stages(); ++k) chain.add("divide", cycles());
    }

private:
    friend struct DividerRegisters;
    Rounding rounding_;
    bool serial_;
    int bits_a_stage_, longest_, serial_cycles_;
    std::array<int, 3> bits_{}, shift_{};
};

struct DividerRegisters {
    struct Register {
        std::uint64_t magnitude, divisor, remainder, quotient;
        int bits_left;  // of the quotient
        bool negative, sticky;
        fixed::Quotient result;
    };
    std::array<Register, 3> row{};
    Accumulators dividend{};

    void load(const Accumulators& words) { dividend = words; }

    // Steps 0 .. latency() - 1.
    void step(const DividePipeline& plan, int cycle) {
        if (plan.serial_) {
            std::size_t r = 0;
            while (cycle >= plan.bits_[r] + 3) cycle -= plan.bits_[r++] + 3;
            advance(plan, r, cycle == 0, cycle == plan.bits_[r] + 2, 1);
        } else {
            for (std::size_t r = 0; r < 3; ++r)
                advance(plan, r, cycle == 0, cycle == plan.stages() - 1, plan.bits_a_stage_);
        }
    }

private:
    void advance(const DividePipeline& plan, std::size_t r, bool first, bool last, int bits) {
        if (first) return start(plan, r);
        if (last) return correct(plan, r);
        for (int k = 0; k < bits && row[r].bits_left > 0; ++k) make_bit(plan, r);
    }

    // Bit i of |dividend| 2^(shift + 1); below bit 0 of the word there are zeros.
    static std::uint64_t dividend_bit(const Register& d, int i, int shift) {
        const int at = i - shift - 1;
        return at < 0 || at > 63 ? 0 : d.magnitude >> at & 1;
    }

    // The remainder starts with the bits above the quotient's. If it is not less than the divisor,
    // the quotient does not fit.
    void start(const DividePipeline& plan, std::size_t r) {
        Register& d = row[r];
        d = {};
        d.negative = dividend[r] < 0;
        d.magnitude = fixed::magnitude(dividend[r]);
        d.result = {0, dividend[3] <= 0 ? DivideStatus::divisor_not_positive : DivideStatus::ok};
        if (dividend[3] <= 0) return;
        d.divisor = static_cast<std::uint64_t>(dividend[3]);
        const int up = plan.shift_[r] - plan.bits_[r];  // N / 2^(bits + 1) = |acc| 2^up
        const bool lost = up > 0 && d.magnitude >> (64 - up) != 0;
        const std::uint64_t top = up < -63 ? 0 : up < 0 ? d.magnitude >> -up : d.magnitude << up;
        if (lost || top >= d.divisor) {
            d.result = {d.negative ? fixed::min_signed(plan.bits_[r])
                                   : fixed::max_signed(plan.bits_[r]),
                        DivideStatus::overflow};
            return;
        }
        d.remainder = top;
        d.bits_left = plan.bits_[r] + 1;
        // Of what a right shift drops below the last bit, only whether it is zero matters.
        const int dropped = -plan.shift_[r] - 1;
        d.sticky = dropped > 0 && d.magnitude << (64 - dropped) != 0;
    }

    void make_bit(const DividePipeline& plan, std::size_t r) {
        Register& d = row[r];
        --d.bits_left;
        d.remainder = d.remainder << 1 | dividend_bit(d, d.bits_left, plan.shift_[r]);
        const bool one = d.remainder >= d.divisor;
        if (one) d.remainder -= d.divisor;
        d.quotient = d.quotient << 1 | (one ? 1 : 0);
    }

    // quotient = floor(2 |q|), so its last bit and the remainder decide how |q| rounds.
    void correct(const DividePipeline& plan, std::size_t r) {
        Register& d = row[r];
        if (d.result.status != DivideStatus::ok) return;
        const bool rest = d.remainder != 0 || d.sticky;
        const std::uint64_t quarters = (d.quotient & 1) << 1 | (rest ? 1 : 0);  // of 4
        const auto whole = static_cast<std::int64_t>(d.quotient >> 1);
        // The floor of a negative value is one less where there is a fraction, and the fraction
        // above the floor is then 1 minus that of |q|.
        const bool below = d.negative && quarters != 0;
        const std::int64_t floor = d.negative ? -whole - (below ? 1 : 0) : whole;
        const std::uint64_t above = below ? 4 - quarters : quarters;
        const bool odd = (floor & 1) != 0;
        const std::int64_t value =
            floor + (fixed::rounds_up(d.negative, odd, 2 * above, 4, plan.rounding_) ? 1 : 0);
        d.result = {fixed::saturate(value, plan.bits_[r]),
                    fixed::fits(value, plan.bits_[r]) ? DivideStatus::ok : DivideStatus::overflow};
    }
};

}  // namespace umbra78::hw
