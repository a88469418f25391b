// What the fuzz targets of the core share: input words from bytes, and the machine's second
// definition, the C of tests/independent/c, with which the core has to agree.
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "hw/machine_spec.hpp"

// The header is C, and stands in a namespace of its own here.
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#define _Noreturn [[noreturn]]
namespace umbra78::oracle {
extern "C" {
#include "tests/independent/c/machine.h"
}
}  // namespace umbra78::oracle
#undef _Noreturn

namespace umbra78::fuzz {

// A difference, or a rule that does not hold, ends the run.
inline void demand(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "ERROR: %s\n", what);
    std::abort();
}

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : provider_(data, size) {}

    std::int64_t in(std::int64_t least, std::int64_t most) {
        return provider_.ConsumeIntegralInRange(least, most);
    }
    int number(int least, int most) { return provider_.ConsumeIntegralInRange(least, most); }
    // A word of `bits` bits: the ends and small ones are as likely as all others.
    std::int32_t word(int bits) {
        const std::int64_t half = std::int64_t{1} << (bits - 1);
        switch (number(0, 3)) {
            case 0: return static_cast<std::int32_t>(in(-2, 2));
            case 1: return static_cast<std::int32_t>(number(0, 1) != 0 ? half - 1 : -half);
            default: return static_cast<std::int32_t>(in(-half, half - 1));
        }
    }

private:
    FuzzedDataProvider provider_;
};

// Widths beyond their ranges, too.
inline hw::MachineSpec any_spec(Bytes& bytes) {
    hw::MachineSpec m;
    const auto rounding = [&bytes] { return static_cast<hw::Rounding>(bytes.number(0, 6)); };
    m.xy_bits = bytes.number(3, 13);
    m.z_bits = bytes.number(3, 27);
    m.coefficient_bits = bytes.number(7, 33);
    m.fraction_bits = bytes.number(-1, 13);
    m.multipliers = std::array{1, 4, 16, 3}[static_cast<std::size_t>(bytes.number(0, 3))];
    m.max_accumulator_bits = bytes.number(15, 65);
    m.product_rounding = rounding();
    m.transform_rounding = rounding();
    m.coefficient_rounding = rounding();
    m.depth_rounding = rounding();
    m.depth_store = static_cast<hw::DepthStore>(bytes.number(0, 2));
    m.divide_order = static_cast<hw::DivideOrder>(bytes.number(0, 1));
    return m;
}

inline oracle::Settings settings_of(const hw::MachineSpec& m) {
    oracle::Settings s{};
    s.xy_bits = m.xy_bits;
    s.z_bits = m.z_bits;
    s.coefficient_bits = m.coefficient_bits;
    s.fraction_bits = m.fraction_bits;
    s.accumulator_bits = m.max_accumulator_bits;
    s.product_rounding = static_cast<int>(m.product_rounding);
    s.transform_rounding = static_cast<int>(m.transform_rounding);
    s.coefficient_rounding = static_cast<int>(m.coefficient_rounding);
    s.depth_rounding = static_cast<int>(m.depth_rounding);
    s.depth_store = static_cast<int>(m.depth_store);
    s.divide_order = static_cast<int>(m.divide_order);
    s.sampling = oracle::CENTRE;
    oracle::widths(&s);
    return s;
}

}  // namespace umbra78::fuzz
