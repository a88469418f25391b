// Fnv1a64: the 64-bit Fowler-Noll-Vo hash, 1a form, over bytes in a stated order.
//
//   h = 0xcbf29ce484222325;  for each byte b:  h = (h xor b) * 0x100000001b3  mod 2^64
//
// Source: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, "The FNV Non-Cryptographic Hash
// Algorithm" (IETF draft). Words are taken high byte first whatever the host's byte order, so a
// hash depends on values only. It detects accidents, not an adversary.
#pragma once

#include <cstdint>

namespace umbra78::fixed {

class Fnv1a64 {
public:
    constexpr void byte(std::uint8_t b) { hash_ = (hash_ ^ b) * prime; }

    constexpr void u16be(std::uint16_t word) {
        byte(static_cast<std::uint8_t>(word >> 8));
        byte(static_cast<std::uint8_t>(word));
    }

    constexpr void u32be(std::uint32_t word) {
        u16be(static_cast<std::uint16_t>(word >> 16));
        u16be(static_cast<std::uint16_t>(word));
    }

    constexpr std::uint64_t value() const { return hash_; }

private:
    static constexpr std::uint64_t offset_basis = 0xcbf29ce484222325;
    static constexpr std::uint64_t prime = 0x100000001b3;
    std::uint64_t hash_ = offset_basis;
};

}  // namespace umbra78::fixed
