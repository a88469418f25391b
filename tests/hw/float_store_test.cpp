// The depth store of floats: its codes are the host's floats, in their order.
#include "hw/machine_spec.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace umbra78::hw {
namespace {

MachineSpec spec_of(int z_bits, DepthStore store) {
    MachineSpec m;
    m.z_bits = z_bits;
    m.depth_store = store;
    return m;
}

std::uint32_t below(std::mt19937& random, std::uint32_t end) {
    return static_cast<std::uint32_t>(random() % end);
}

float depth_of(std::uint32_t code, const MachineSpec& m) {
    const std::uint32_t v = m.depth_store == DepthStore::of_reversed_floats
                                ? (std::uint32_t{1} << m.z_bits) - code
                                : code;
    return std::ldexp(static_cast<float>(v), -m.z_bits);
}

// Code by code, all over the range and next to every power of two.
TEST(FloatStore, KeepsTheNearestFloatAndNothingElse) {
    std::mt19937 random(78);
    for (const DepthStore store : {DepthStore::of_floats, DepthStore::of_reversed_floats}) {
        const MachineSpec m = spec_of(26, store);
        const std::uint32_t last = m.deepest_drawn(), whole = last + 2;
        const auto check = [&](std::uint32_t code) {
            if (code > last) return;
            // The conversion of an integer to a float rounds to nearest, ties to even.
            const float nearest = depth_of(code, m);
            const std::uint32_t kept = m.kept(code);
            const bool held = store == DepthStore::of_floats && nearest == 1.0f;
            ASSERT_EQ(depth_of(kept, m), held ? std::nextafter(1.0f, 0.0f) : nearest) << code;
            ASSERT_EQ(m.kept(kept), kept);
            ASSERT_LE(kept, last);
        };
        for (int bit = 0; bit < 26; ++bit)
            for (std::uint32_t off = 0; off < 40; ++off) {
                check((1u << bit) + off);
                check((1u << bit) - off);
                check(whole - (1u << bit) + off);
                check(whole - (1u << bit) - off);
            }
        for (int k = 0; k < 200000; ++k) check(below(random, whole));
    }
}

// A store that compares bits as integers orders samples as one that compares codes.
TEST(FloatStore, OrderIsThatOfTheBits) {
    std::mt19937 random(7);
    for (const DepthStore store : {DepthStore::of_floats, DepthStore::of_reversed_floats}) {
        const MachineSpec m = spec_of(26, store);
        for (int k = 0; k < 100000; ++k) {
            const std::uint32_t a = m.kept(below(random, m.background()));
            const std::uint32_t beside = std::min(a + static_cast<std::uint32_t>(k % 7),
                                                  m.deepest_drawn());
            const std::uint32_t b = m.kept(k % 2 ? below(random, m.background()) : beside);
            const auto bits_a = std::bit_cast<std::uint32_t>(depth_of(a, m));
            const auto bits_b = std::bit_cast<std::uint32_t>(depth_of(b, m));
            ASSERT_EQ(a < b, store == DepthStore::of_floats ? bits_a < bits_b : bits_a > bits_b);
        }
    }
}

TEST(FloatStore, OfTwentyFourBitsIsFixed) {
    for (const int z_bits : {4, 16, 24})
        for (const DepthStore store : {DepthStore::of_floats, DepthStore::of_reversed_floats}) {
            const MachineSpec m = spec_of(z_bits, store);
            for (std::uint32_t code = 0; code <= m.deepest_drawn(); code += 1 + code / 5000)
                ASSERT_EQ(m.kept(code), code);
        }
}

}  // namespace
}  // namespace umbra78::hw
