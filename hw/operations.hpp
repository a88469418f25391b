// The cost of a stage that has no clocked form: its counted operations, on the machine's units.
//
//   adders       additions and compares, on as many adders as there are multipliers
//   multipliers  passes of 16 x 16 bits
//   divider      quotients and roots, one divider, a bit a cycle
//   store        accesses of the frame store, one a cycle
//
// Drawing and filters are costed in this way (hw/MACHINE.md, section 16). Where the units work side
// by side the busiest one determines the time; one after the other, the sum.
#pragma once

#include "hw/machine_spec.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::hw {

struct Operations {
    std::uint64_t adds = 0;
    std::uint64_t products = 0, passes = 0;         // a wide product is 2 or 4 passes
    std::uint64_t quotients = 0, quotient_bits = 0;  // roots, too
    std::uint64_t accesses = 0;

    constexpr Operations& operator+=(const Operations& o) {
        adds += o.adds;
        products += o.products;
        passes += o.passes;
        quotients += o.quotients;
        quotient_bits += o.quotient_bits;
        accesses += o.accesses;
        return *this;
    }
    friend constexpr Operations operator*(std::uint64_t n, const Operations& o) {
        return {n * o.adds,      n * o.products,      n * o.passes,
                n * o.quotients, n * o.quotient_bits, n * o.accesses};
    }
    friend constexpr Operations operator+(Operations a, const Operations& b) { return a += b; }
};

struct UnitCycles {
    std::uint64_t adders = 0, multipliers = 0, divider = 0, store = 0;

    std::uint64_t one_after_the_other() const { return adders + multipliers + divider + store; }
    std::uint64_t side_by_side() const { return std::max({adders, multipliers, divider, store}); }
    const char* busiest() const {
        const std::uint64_t max = side_by_side();
        return max == divider       ? "divider"
               : max == multipliers ? "multipliers"
               : max == adders      ? "adders"
                                     : "frame store";
    }
};

constexpr UnitCycles unit_cycles(const Operations& o, const MachineSpec& spec) {
    const auto n = static_cast<std::uint64_t>(spec.multipliers);
    return {(o.adds + n - 1) / n, (o.passes + n - 1) / n, o.quotient_bits, o.accesses};
}

// FPS AP-120B: an addition and a multiplication a cycle whatever their width, a scalar divide in 23
// cycles (3.8 us; FPS Math Library, 1977; a root is assumed to take as long), and a data memory
// access in 2 ("standard") or 1 ("fast").
constexpr UnitCycles ap120b_cycles(const Operations& o, int memory_cycles) {
    return {o.adds, o.products, 23 * o.quotients,
            o.accesses * static_cast<std::uint64_t>(memory_cycles)};
}

}  // namespace umbra78::hw
