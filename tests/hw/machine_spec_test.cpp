// The specification: 1978's formats, the ranges of the widths, and that no width overflows.
#include "hw/transform_unit.hpp"
#include "hw/machine_spec.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace umbra78::hw {
namespace {

TEST(MachineSpec, TheDefaultIs1978s) {
    constexpr MachineSpec m;
    static_assert(check(m) == SpecStatus::ok);
    EXPECT_EQ(m.size_px(), 512);
    EXPECT_EQ(m.half_px(), 256);
    EXPECT_EQ(m.word_bits(), 16);
    EXPECT_EQ(m.accumulator_bits(), 35);
    EXPECT_EQ(m.depth_fraction(), 7) << "a quantum is 1/128 pixel";
    EXPECT_EQ(m.one_word(), 1 << 14);
    EXPECT_EQ(m.background(), 0xffffu);
    EXPECT_EQ(m.deepest_drawn(), 0xfffeu);
    EXPECT_EQ(m.depth_offset(), 0x8000);
}

TEST(MachineSpec, EveryKnobIsRefusedOneStepOutsideItsRange) {
    struct Case {
        int MachineSpec::*width;
        int min, max;
        SpecStatus status;
    };
    constexpr std::array<Case, 5> cases{{
        {&MachineSpec::xy_bits, 4, 12, SpecStatus::xy_bits},
        {&MachineSpec::z_bits, 4, 26, SpecStatus::z_bits},
        {&MachineSpec::coefficient_bits, 8, 32, SpecStatus::coefficient_bits},
        {&MachineSpec::fraction_bits, 0, 12, SpecStatus::fraction_bits},
        {&MachineSpec::max_accumulator_bits, 16, 64, SpecStatus::max_accumulator_bits},
    }};
    for (const Case& c : cases) {
        for (int value = c.min - 2; value <= c.max + 2; ++value) {
            MachineSpec m;
            m.*c.width = value;
            const bool inside = value >= c.min && value <= c.max;
            EXPECT_EQ(check(m), inside ? SpecStatus::ok : c.status) << value;
        }
    }
    for (int n = 0; n <= 20; ++n) {
        MachineSpec m;
        m.multipliers = n;
        EXPECT_EQ(check(m) == SpecStatus::ok, n == 1 || n == 4 || n == 16) << n;
    }
}

// Words of any width in range fit what carries them: 32-bit words, 64-bit accumulators, a pixel's
// centre and every Z code exact in an input word.
TEST(MachineSpec, EveryWidthInRangeCloses) {
    for (int xy = 4; xy <= 12; ++xy) {
        for (int z = 4; z <= 26; ++z) {
            MachineSpec m;
            m.xy_bits = xy;
            m.z_bits = z;
            m.coefficient_bits = 32;
            if (z > xy + 20) {
                EXPECT_EQ(check(m), SpecStatus::z_bits);
                continue;
            }
            ASSERT_EQ(check(m), SpecStatus::ok);
            EXPECT_LE(m.word_bits(), 31);
            EXPECT_LE(m.accumulator_bits(), 62);
            EXPECT_GE(m.input_fraction(), 1) << "a pixel's centre is a word";
            EXPECT_GE(m.input_fraction(), m.depth_fraction()) << "a Z code is a word";
            // 0 .. 2^z - 1, centred, in words: -2^(bits-1) .. below 2^(bits-1).
            const std::int64_t scale = std::int64_t{1} << (m.input_fraction() - m.depth_fraction());
            EXPECT_EQ(m.depth_offset() * scale, std::int64_t{1} << (m.word_bits() - 1));
        }
    }
}

TEST(Divider, ASerialQuotientTakesACycleABitAndTwo) {
    // X and Y: 9 integer and 7 fraction bits, sign, rounding; Z: 16 bits, sign, rounding.
    EXPECT_EQ(serial_divide_cycles({}), 2 * (9 + 7 + 2 + 2) + (16 + 2 + 2));
    MachineSpec m;
    for (const auto& [width, cycles] :
         {std::pair{&MachineSpec::xy_bits, 2}, std::pair{&MachineSpec::fraction_bits, 2},
          std::pair{&MachineSpec::z_bits, 1}, std::pair{&MachineSpec::coefficient_bits, 0}}) {
        MachineSpec wider = m;
        wider.*width += 1;
        EXPECT_EQ(serial_divide_cycles(wider) - serial_divide_cycles(m), cycles);
    }
}

}  // namespace
}  // namespace umbra78::hw
