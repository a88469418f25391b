// Wrapping and saturation of every 16-bit word and of the boundary words, by 128-bit models.
#include "fixed/overflow.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using test::Int128;

// The definitions, in 128 bits: the interval, and the residue that lies in it.
Int128 model_min(int bits) { return -(Int128{1} << (bits - 1)); }
Int128 model_max(int bits) { return (Int128{1} << (bits - 1)) - 1; }
Int128 model_wrap(Int128 v, Int128 low, int bits) {
    const Int128 modulus = Int128{1} << bits;
    return low + ((v - low) % modulus + modulus) % modulus;
}
Int128 model_clamp(Int128 v, Int128 low, Int128 high) {
    return v < low ? low : v > high ? high : v;
}

void expect_signed(std::int64_t v, int bits) {
    const Int128 low = model_min(bits), high = model_max(bits);
    ASSERT_EQ(Int128{wrap(v, bits)}, model_wrap(v, low, bits)) << v << " in " << bits;
    ASSERT_EQ(Int128{saturate(v, bits)}, model_clamp(v, low, high)) << v << " in " << bits;
    ASSERT_EQ(Int128{saturate_symmetric(v, bits)}, model_clamp(v, -high, high))
        << v << " in " << bits;
    ASSERT_EQ(fits(v, bits), v >= low && v <= high) << v << " in " << bits;
    if (fits(v, bits)) {
        ASSERT_EQ(trap_overflow(v, bits), v);
    }
}

void expect_unsigned(std::int64_t v, int bits) {
    const Int128 high = (Int128{1} << bits) - 1;
    ASSERT_EQ(Int128{wrap_unsigned(v, bits)}, model_wrap(v, 0, bits)) << v << " in " << bits;
    ASSERT_EQ(Int128{saturate_unsigned(v, bits)}, model_clamp(v, 0, high)) << v << " in " << bits;
    ASSERT_EQ(fits_unsigned(v, bits), v >= 0 && v <= high) << v << " in " << bits;
    if (fits_unsigned(v, bits)) {
        ASSERT_EQ(trap_overflow_unsigned(v, bits), v);
    }
}

TEST(Overflow, BoundaryWordsInEveryWidth) {
    for (const std::int64_t v : test::boundary_words) {
        for (int bits = 1; bits <= 64; ++bits) {
            expect_signed(v, bits);
        }
        for (int bits = 1; bits <= 63; ++bits) {
            expect_unsigned(v, bits);
        }
    }
}

// The edges of every width, one to either side.
TEST(Overflow, EdgesOfEveryWidth) {
    for (int bits = 1; bits <= 63; ++bits) {
        const auto edge = static_cast<std::int64_t>(std::uint64_t{1} << (bits - 1));
        for (std::int64_t step = -2; step <= 1; ++step) {
            expect_signed(edge + step + 1, bits);
            expect_signed(-edge + step, bits);
            expect_unsigned(edge + step + 1, bits);
            expect_unsigned(step, bits);
        }
    }
    EXPECT_EQ(min_signed(1), -1);
    EXPECT_EQ(max_signed(1), 0);
    EXPECT_EQ(min_signed(64), INT64_MIN);
    EXPECT_EQ(max_signed(64), INT64_MAX);
    EXPECT_EQ(max_unsigned(63), INT64_MAX);
}

TEST(Overflow, Every16BitWordInTo1To17Bits) {
    for (std::int64_t v = INT16_MIN; v <= UINT16_MAX; ++v) {
        for (int bits = 1; bits <= 17; ++bits) {
            expect_signed(v, bits);
            expect_unsigned(v, bits);
        }
    }
}

TEST(Overflow, RandomWords) {
    test::Random random;
    for (int i = 0; i < 200000; ++i) {
        const std::int64_t v = random.word();
        expect_signed(v, static_cast<int>(random.between(1, 64)));
        expect_unsigned(v, static_cast<int>(random.between(1, 63)));
    }
}

TEST(Narrow, IsTheNamedOperation) {
    for (const std::int64_t v : test::boundary_words) {
        EXPECT_EQ(narrow(v, 16, Overflow::wrap), wrap(v, 16));
        EXPECT_EQ(narrow(v, 16, Overflow::saturate), saturate(v, 16));
        EXPECT_EQ(narrow(v, 16, Overflow::saturate_symmetric), saturate_symmetric(v, 16));
        EXPECT_EQ(narrow_unsigned(v, 16, Overflow::wrap), wrap_unsigned(v, 16));
        EXPECT_EQ(narrow_unsigned(v, 16, Overflow::saturate), saturate_unsigned(v, 16));
        EXPECT_EQ(narrow_unsigned(v, 16, Overflow::saturate_symmetric), saturate_unsigned(v, 16));
    }
    EXPECT_EQ(narrow(-32768, 16, Overflow::trap), -32768);
    EXPECT_EQ(narrow_unsigned(65535, 16, Overflow::trap), 65535);
    EXPECT_DEATH(narrow(32768, 16, Overflow::trap), "does not fit the signed");
    EXPECT_DEATH(narrow(-32769, 16, Overflow::trap), "does not fit the signed");
    EXPECT_DEATH(narrow_unsigned(65536, 16, Overflow::trap), "does not fit the unsigned");
    EXPECT_DEATH(narrow_unsigned(-1, 16, Overflow::trap), "does not fit the unsigned");
}

TEST(Overflow, ContractsAreCompileErrorsAndTraps) {
    static_assert(test::is_constant([] { return wrap(5, 1) + wrap(5, 64); }));
    static_assert(!test::is_constant([] { return wrap(5, 0); }));
    static_assert(!test::is_constant([] { return wrap(5, 65); }));
    static_assert(!test::is_constant([] { return saturate(5, 0); }));
    static_assert(!test::is_constant([] { return wrap_unsigned(5, 64); }));
    static_assert(!test::is_constant([] { return trap_overflow(8, 4); }));
    static_assert(test::is_constant([] { return trap_overflow(7, 4); }));
    EXPECT_DEATH(wrap(5, 0), "signed width outside");
    EXPECT_DEATH(saturate_unsigned(5, 0), "unsigned width outside");
    EXPECT_DEATH(fits(5, 65), "signed width outside");
}

}  // namespace
}  // namespace umbra78::fixed
