// Algebraic laws of this room under RapidCheck, with words weighted towards the boundaries: its
// own integers grow with the case number and seldom come near the edge of a word. A failure is
// shrunk and printed with the RC_PARAMS that repeat it. Without RapidCheck this file is empty.
#if __has_include(<rapidcheck/gtest.h>)

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "fixed/decimal.hpp"
#include "fixed/divide.hpp"
#include "fixed/noise.hpp"
#include "fixed/overflow.hpp"
#include "fixed/rational.hpp"
#include "fixed/root.hpp"
#include "fixed/rounding.hpp"
#include "fixed/sine.hpp"
#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

// Half of the words are a boundary or next to one, a quarter a power of two or next to one.
rc::Gen<std::int64_t> word() {
    const auto near = [](std::int64_t base, int step) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(base) +
                                         static_cast<std::uint64_t>(step));
    };
    const std::vector<std::int64_t> boundary(test::boundary_words.begin(),
                                             test::boundary_words.end());
    return rc::gen::weightedOneOf<std::int64_t>(
        {{2, rc::gen::apply(near, rc::gen::elementOf(boundary), rc::gen::inRange(-2, 3))},
         {1, rc::gen::apply(near,
                            rc::gen::map(rc::gen::inRange(0, 64),
                                         [](int n) { return min_signed(n + 1); }),
                            rc::gen::inRange(-1, 2))},
         {1, rc::gen::arbitrary<std::int64_t>()}});
}
rc::Gen<Rounding> rounding() { return rc::gen::elementOf(test::all_roundings); }
int up_to(int high) { return *rc::gen::inRange(0, high + 1); }

RC_GTEST_PROP(RoundingLaws, EveryModeLiesBetweenFloorAndCeiling, ()) {
    const std::int64_t v = *word();
    const int n = up_to(62);
    const std::int64_t low = round_shift(v, n, Rounding::floor);
    const std::int64_t high = round_shift(v, n, Rounding::ceiling);
    const std::int64_t got = round_shift(v, n, *rounding());
    RC_ASSERT(got == low || got == high);
    RC_ASSERT(high - low == (scale_shift(low, -n, Rounding::floor) == v ? 0 : 1));
}

RC_GTEST_PROP(RoundingLaws, SymmetricModesCommuteWithNegation, ()) {
    const std::int64_t v = *word();
    RC_PRE(v != INT64_MIN);
    const int n = up_to(62);
    for (const Rounding r : {Rounding::to_zero, Rounding::half_to_zero, Rounding::half_away,
                             Rounding::half_even}) {
        RC_ASSERT(round_shift(-v, n, r) == -round_shift(v, n, r));
    }
    RC_ASSERT(round_shift(-v, n, Rounding::floor) == -round_shift(v, n, Rounding::ceiling));
}

RC_GTEST_PROP(RoundingLaws, EveryModeIsMonotonic, ()) {
    const std::int64_t a = *word(), b = *word();
    const int n = up_to(80);
    const Rounding r = *rounding();
    RC_ASSERT((a <= b) <= (scale_shift(a, n, r) <= scale_shift(b, n, r)));
}

RC_GTEST_PROP(RoundingLaws, ShiftIsDivisionByAPowerOfTwo, ()) {
    const std::int64_t v = *word();
    const int n = up_to(62);
    const Rounding r = *rounding();
    RC_ASSERT(round_shift(v, n, r) == round_divide(v, std::int64_t{1} << n, r));
}

RC_GTEST_PROP(OverflowLaws, WrapIsAHomomorphism, ()) {
    const std::int64_t a = *word(), b = *word();
    const int bits = 1 + up_to(63);
    const auto plus = [](std::int64_t x, std::int64_t y) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) +
                                         static_cast<std::uint64_t>(y));
    };
    RC_ASSERT(wrap(plus(wrap(a, bits), wrap(b, bits)), bits) == wrap(plus(a, b), bits));
}

RC_GTEST_PROP(OverflowLaws, NarrowingIsIdempotentAndKeepsWhatFits, ()) {
    const std::int64_t v = *word();
    const int bits = 2 + up_to(61);
    for (const Overflow o : {Overflow::wrap, Overflow::saturate, Overflow::saturate_symmetric}) {
        const std::int64_t once = narrow(v, bits, o);
        RC_ASSERT(fits(once, bits));
        RC_ASSERT(narrow(once, bits, o) == once);
        RC_ASSERT(once == v || !fits(v, bits) || v == min_signed(bits));
    }
}

RC_GTEST_PROP(DivideLaws, NearestQuotientsCarryTheirCertificate, ()) {
    const std::int64_t num = *word(), den = *word();
    const int shift = up_to(124) - 62;
    const Rounding r = *rc::gen::element(Rounding::half_up, Rounding::half_to_zero,
                                         Rounding::half_away, Rounding::half_even);
    const Quotient q = divide(num, den, shift, 63, r);
    RC_CLASSIFY(q.status == DivideStatus::ok, "quotient fits");
    RC_ASSERT((q.status == DivideStatus::divisor_not_positive) == (den <= 0));
    RC_ASSERT(q.status != DivideStatus::ok || certificate_holds(num, den, shift, q.value));
}

RC_GTEST_PROP(DivideLaws, EqualsTheRationalRoundedOnce, ()) {
    const std::int64_t num = *word(), den = *word();
    RC_PRE(den > 0);
    const int shift = up_to(124) - 62;
    const Rounding r = *rounding();
    std::int64_t exact = 0;
    const bool fit = Rational(num, den).round_scaled(shift, r, exact) && fits(exact, 63);
    const Quotient q = divide(num, den, shift, 63, r);
    RC_ASSERT(fit == (q.status == DivideStatus::ok));
    RC_ASSERT(!fit || q.value == exact);
}

RC_GTEST_PROP(RootLaws, RootOfASquareAndOfItsNeighbours, ()) {
    const auto r = static_cast<std::uint64_t>(*word()) & UINT32_MAX;
    RC_PRE(r > 0);
    RC_ASSERT(isqrt(r * r) == r);
    RC_ASSERT(isqrt(r * r - 1) == r - 1);
    RC_ASSERT(isqrt(r * r + 2 * r) == r);
}

RC_GTEST_PROP(SineLaws, OnTheCircleAndOddAndEven, ()) {
    const auto angle = static_cast<std::int32_t>(wrap(*word(), 32));
    RC_PRE(angle != INT32_MIN);
    const SineCosine w = sine_cosine(angle), mirrored = sine_cosine(-angle);
    RC_ASSERT(mirrored == (SineCosine{-w.sine, w.cosine}));
    // Each word is off by half a unit at most, so the square of the radius by at most 2^30 sqrt 2.
    const std::int64_t radius2 = std::int64_t{w.sine} * w.sine + std::int64_t{w.cosine} * w.cosine;
    RC_ASSERT(magnitude(radius2 - (std::int64_t{1} << 60)) <= 1518500251u);
}

RC_GTEST_PROP(NoiseLaws, JumpEqualsTaking, ()) {
    const auto seed = static_cast<std::uint32_t>(*rc::gen::inRange<std::int64_t>(1, 1ll << 31));
    NoiseRegister walked(seed), jumped(seed);
    std::uint64_t distance = 0;
    for (int i = up_to(20); i > 0; --i) {
        const int count = up_to(64);
        walked.take(count);
        distance += static_cast<std::uint64_t>(count);
    }
    jumped.jump(distance);
    RC_ASSERT(walked == jumped);
}

RC_GTEST_PROP(NoiseLaws, StreamsOfASumAreTheSumOfStreams, ()) {
    const auto a = static_cast<std::uint32_t>(*rc::gen::inRange<std::int64_t>(1, 1ll << 31));
    const auto b = static_cast<std::uint32_t>(*rc::gen::inRange<std::int64_t>(1, 1ll << 31));
    RC_PRE(a != b);
    NoiseRegister x(a), y(b), sum(a ^ b);
    const auto distance = static_cast<std::uint64_t>(*word());
    x.jump(distance);
    y.jump(distance);
    sum.jump(distance);
    RC_ASSERT(sum.take(64) == (x.take(64) ^ y.take(64)));
}

RC_GTEST_PROP(DecimalLaws, PrintedWordsComeBack, ()) {
    const std::int64_t v = *word();
    const int f = up_to(48);
    std::array<char, longest_decimal> buffer{};
    const auto length = static_cast<std::size_t>(print_decimal(v, f, buffer));
    const std::string_view text(buffer.data(), length);
    RC_ASSERT(parse_decimal(text, f, 64) == (DecimalResult{v, DecimalStatus::ok}));
}

RC_GTEST_PROP(DecimalLaws, OneDigitTooManyIsRoundedHalfToEven, ()) {
    const std::int64_t v = *word();
    const int f = up_to(48);
    std::array<char, longest_decimal> buffer{};
    const auto length = static_cast<std::size_t>(print_decimal(v, f + 1, buffer));
    const std::int64_t even = round_shift(v, 1, Rounding::half_even);
    RC_ASSERT(parse_decimal({buffer.data(), length}, f, 64).value == even);
}

RC_GTEST_PROP(DecimalLaws, AnyTextIsANumberOrIsRefused, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(
        std::string("0123456789+-._eE x")));
    const DecimalResult result = parse_decimal(text, up_to(48), 1 + up_to(63));
    RC_ASSERT(result.status == DecimalStatus::ok || result.value == 0);
    RC_ASSERT((result.status == DecimalStatus::empty) == text.empty());
}

}  // namespace
}  // namespace umbra78::fixed

#endif
