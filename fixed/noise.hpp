// The noise register: a 31-stage linear feedback shift register, one bit a clock.
//
//   b[n] = b[n-31] xor b[n-28]         feedback polynomial x^31 + x^28 + 1 (PRBS31, ITU-T O.150)
//
// The polynomial is primitive, so every nonzero state is met once in 2^31 - 1 clocks. The state is
// the window b[n] .. b[n+30], bit 0 the next bit out:
//
//        out <- [ 0 | 1 | 2 | 3 | ... | 30 ] <-+
//                 |           |                |
//                 +--> xor <--+----------------+       (stage 0 and stage 3: 31 and 28 clocks ago)
//
// jump(k) goes k clocks ahead in O(log k): over GF(2) the shift is multiplication by x modulo the
// recurrence's characteristic polynomial x^31 + x^3 + 1, so b[n+k] is the sum of those b[n+i] for
// which x^k has the term x^i. So the state of a scan line does not need the lines before it.
//
// NoiseStream64 gives the same bits 64 at a time. Over GF(2) the fourth power of the polynomial
// is x^124 + x^112 + 1, so b[n] = b[n-124] xor b[n-112]. Both terms are at least 64 bits back, so
// a whole word is two funnel shifts and an exclusive or.
#pragma once

#include <bit>
#include <cstdint>

#include "fixed/dither.hpp"  // IWYU pragma: export -- what the bits are drawn for
#include "fixed/trap.hpp"

namespace umbra78::fixed {

class NoiseRegister {
public:
    static constexpr int stages = 31;
    static constexpr std::uint64_t period = (std::uint64_t{1} << stages) - 1;

    // Bit i of the seed is b[i]. From the state 0 only zeros follow, so it is not a seed.
    constexpr explicit NoiseRegister(std::uint32_t seed) : state_(seed) {
        require(seed != 0 && seed <= period, "noise seed must be a nonzero 31-bit word");
    }

    constexpr std::uint32_t state() const { return state_; }

    // The next count <= 64 bits, the first one out in bit 0.
    constexpr std::uint64_t take(int count) {
        require(count >= 0 && count <= 64, "noise: 0..64 bits a call");
        const Window w = window(state_);
        const std::uint64_t bits = count == 64 ? w.low : w.low & ((std::uint64_t{1} << count) - 1);
        const std::uint64_t next = count == 64  ? w.high
                                   : count == 0 ? w.low
                                                : w.low >> count | w.high << (64 - count);
        state_ = static_cast<std::uint32_t>(next & period);
        return bits;
    }

    // Forward by any number of bits.
    constexpr void jump(std::uint64_t bits) { jump_by(power_of_x(bits)); }
    // By the bits of which `power` is the power_of_x: many jumps of one length.
    constexpr void jump_by(std::uint32_t power) {
        const std::uint64_t known = window(state_).low;
        std::uint64_t sum = 0;
        for (int i = 0; i < stages; ++i) {
            sum ^= (power >> i & 1) != 0 ? known >> i : 0;
        }
        state_ = static_cast<std::uint32_t>(sum & period);
    }

    // x^exponent modulo x^31 + x^3 + 1, by squaring from the top bit down.
    static constexpr std::uint32_t power_of_x(std::uint64_t exponent) {
        std::uint64_t p = 1;
        for (int bit = 64 - std::countl_zero(exponent); bit-- > 0;) {
            p = reduce(spread(p));
            p = (exponent >> bit & 1) != 0 ? reduce(p << 1) : p;
        }
        return static_cast<std::uint32_t>(p);
    }

    friend constexpr bool operator==(const NoiseRegister&, const NoiseRegister&) = default;

private:
    // b[n] .. b[n+63] and b[n+64] .. b[n+94].
    struct Window {
        std::uint64_t low, high;
    };
    static constexpr Window window(std::uint64_t state) {
        constexpr std::uint64_t mask28 = (std::uint64_t{1} << 28) - 1;
        // 31 known bits give the next 28, those the next 5, and 64 the next 28 and 3.
        std::uint64_t low = state | ((state ^ state >> 3) & mask28) << 31;
        low |= (low >> 28 ^ low >> 31) << 59;
        std::uint64_t high = (low >> 33 ^ low >> 36) & mask28;
        high |= ((low >> 61 ^ high) & 7) << 28;
        return {low, high};
    }

    // The square of a polynomial over GF(2): its terms' exponents doubled.
    static constexpr std::uint64_t spread(std::uint64_t p) {
        p = (p | p << 16) & 0x0000ffff0000ffff;
        p = (p | p << 8) & 0x00ff00ff00ff00ff;
        p = (p | p << 4) & 0x0f0f0f0f0f0f0f0f;
        p = (p | p << 2) & 0x3333333333333333;
        return (p | p << 1) & 0x5555555555555555;
    }
    // Degree at most 60 to at most 30: x^31 = x^3 + 1, twice.
    static constexpr std::uint64_t reduce(std::uint64_t p) {
        for (int pass = 0; pass < 2; ++pass) {
            const std::uint64_t over = p >> 31;
            p = (p & period) ^ over ^ over << 3;
        }
        return p;
    }

    std::uint32_t state_;
};

class NoiseStream64 {
public:
    // Starts at the register's next bit.
    constexpr explicit NoiseStream64(NoiseRegister start)
        : low_(start.take(64)), high_(start.take(64)) {}

    // The next 64 bits, the first one in bit 0; equal to NoiseRegister::take(64).
    constexpr std::uint64_t next64() {
        const std::uint64_t out = low_;
        const std::uint64_t following = funnel(4) ^ funnel(16);  // 128 - 124, 128 - 112
        low_ = high_;
        high_ = following;
        return out;
    }

private:
    // 64 bits of the history from bit `count` on.
    constexpr std::uint64_t funnel(int count) const {
        return low_ >> count | high_ << (64 - count);
    }
    std::uint64_t low_, high_;  // the next 128 bits, not yet given out
};

}  // namespace umbra78::fixed
