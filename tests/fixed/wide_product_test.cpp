// Products and quotients of 128 bits, portable and native, against each other.
#include "fixed/wide_product.hpp"

#include <gtest/gtest.h>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

using umbra78::test::UInt128;

Word128 split(UInt128 v) {
    return {static_cast<std::uint64_t>(v >> 64), static_cast<std::uint64_t>(v)};
}
UInt128 joined(Word128 w) { return UInt128{w.high} << 64 | w.low; }

void expect_product(std::uint64_t a, std::uint64_t b) {
    const Word128 exact = split(UInt128{a} * b);
    ASSERT_EQ(multiply_wide(a, b), exact) << a << " * " << b;
    ASSERT_EQ(multiply_wide_portable(a, b), exact) << a << " * " << b;
}

void expect_quotient(Word128 numerator, std::uint64_t divisor) {
    const auto [q, r] = divide_wide(numerator, divisor);
    ASSERT_EQ(UInt128{q}, joined(numerator) / divisor)
        << numerator.high << ":" << numerator.low << " / " << divisor;
    ASSERT_EQ(UInt128{r}, joined(numerator) % divisor)
        << numerator.high << ":" << numerator.low << " / " << divisor;
}

TEST(MultiplyWide, BoundaryPairs) {
    for (const std::int64_t a : test::boundary_words) {
        for (const std::int64_t b : test::boundary_words) {
            expect_product(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b));
        }
    }
}

TEST(MultiplyWide, RandomPairs) {
    test::Random random;
    for (int i = 0; i < 300000; ++i) {
        expect_product(random.bits(), random.bits());
        expect_product(static_cast<std::uint64_t>(random.word()),
                       static_cast<std::uint64_t>(random.word()));
    }
}

TEST(DivideWide, BoundaryTriples) {
    for (const std::int64_t divisor : test::boundary_words) {
        const auto d = static_cast<std::uint64_t>(divisor);
        for (const std::int64_t high : test::boundary_words) {
            for (const std::int64_t low : test::boundary_words) {
                if (d != 0) {
                    expect_quotient({static_cast<std::uint64_t>(high) % d,
                                     static_cast<std::uint64_t>(low)}, d);
                }
            }
        }
    }
}

// Numerators one off a multiple make the digit estimate fail as often as it can.
TEST(DivideWide, RandomAndNearMultiples) {
    test::Random random;
    for (int i = 0; i < 300000; ++i) {
        const auto d = static_cast<std::uint64_t>(random.word()) | 1;
        expect_quotient({random.bits() % d, random.bits()}, d);
        const UInt128 multiple = UInt128{d} * static_cast<std::uint64_t>(random.word());
        expect_quotient(split(multiple), d);
        if (multiple != 0) {
            expect_quotient(split(multiple - 1), d);
        }
    }
}

TEST(DivideWide, ContractsTrap) {
    static_assert(!test::is_constant([] { return divide_wide({5, 0}, 5).quotient; }));
    static_assert(!test::is_constant([] { return divide_wide({0, 7}, 0).quotient; }));
    EXPECT_DEATH(divide_wide({5, 0}, 5), "quotient does not fit 64 bits");
}

}  // namespace
}  // namespace umbra78::fixed
