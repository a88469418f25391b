// Decimals against literals; the short way against the long one; words that come back as printed.
#include "fixed/decimal.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/fixed/boundary.hpp"

namespace umbra78::fixed {
namespace {

std::string printed(std::int64_t value, int fraction_bits) {
    std::array<char, longest_decimal> buffer{};
    const int length = print_decimal(value, fraction_bits, buffer);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

constexpr DecimalResult good(std::int64_t value) { return {value, DecimalStatus::ok}; }
constexpr DecimalResult bad(DecimalStatus status) { return {0, status}; }

TEST(ParseDecimal, Examples) {
    static_assert(parse_decimal("1.5", 16, 32) == good(3 << 15));
    static_assert(parse_decimal("-2.5", 0, 16) == good(-2));  // a tie: to even
    static_assert(parse_decimal("3.5", 0, 16) == good(4));
    EXPECT_EQ(parse_decimal("0", 7, 16), good(0));
    EXPECT_EQ(parse_decimal("-0.0", 7, 16), good(0));
    EXPECT_EQ(parse_decimal("+1_000.5e-3", 16, 32), good(65569));  // 65568.768
    EXPECT_EQ(parse_decimal("1e3", 0, 16), good(1000));
    EXPECT_EQ(parse_decimal("1E+3", 0, 16), good(1000));
    EXPECT_EQ(parse_decimal("0.0001e4", 7, 16), good(128));
    EXPECT_EQ(parse_decimal("12345678901234567e-16", 48, 64), good(347499968120224));
    EXPECT_EQ(parse_decimal("0.1", 48, 64), good(28147497671066));  // 28147497671065.6
    EXPECT_EQ(parse_decimal("000000000000000000000000000001", 0, 2), good(1));
    EXPECT_EQ(parse_decimal("0e999999999999999999999999", 0, 2), good(0));
    EXPECT_EQ(parse_decimal("5e-999999999999999999999999", 48, 2), good(0));
    EXPECT_EQ(parse_decimal("-9223372036854775808", 0, 64), good(INT64_MIN));
    EXPECT_EQ(parse_decimal("9223372036854775807", 0, 64), good(INT64_MAX));
}

TEST(ParseDecimal, RangeIsThatOfTheWordAfterRounding) {
    constexpr auto out = bad(DecimalStatus::out_of_range);
    EXPECT_EQ(parse_decimal("127.99609375", 7, 15), out);  // a tie that rounds up to 2^14
    EXPECT_EQ(parse_decimal("127.99609374", 7, 15), good(16383));
    EXPECT_EQ(parse_decimal("-128.00390625", 7, 15), good(-16384));
    EXPECT_EQ(parse_decimal("-128.00390626", 7, 15), out);
    EXPECT_EQ(parse_decimal("9223372036854775808", 0, 64), out);
    EXPECT_EQ(parse_decimal("-9223372036854775809", 0, 64), out);
    EXPECT_EQ(parse_decimal("18446744073709551616", 0, 64), out);
    EXPECT_EQ(parse_decimal("9999999999999999999", 48, 64), out);
    EXPECT_EQ(parse_decimal("10000000000000000000", 0, 64), out);
    EXPECT_EQ(parse_decimal("1e999999999999999999999", 0, 64), out);
    EXPECT_EQ(parse_decimal("1" + std::string(400, '0'), 0, 64), out);
    EXPECT_EQ(parse_decimal("1" + std::string(400, '0') + "e-400", 0, 64), good(1));
}

TEST(ParseDecimal, TextThatIsNoNumber) {
    EXPECT_EQ(parse_decimal("", 7, 16), bad(DecimalStatus::empty));
    for (const std::string_view text :
         {"+", "-", ".", "e", ".5", "5.", "5.e1", "1e", "1e+", "1e1.5", "--1", "+-1", "1 ", " 1",
          "1,5", "0x10", "inf", "nan", "_1", "1_", "1__0", "1_.5", "1._5", "1.5_", "1e_5", "1e5_",
          "1e5 ", "1.2.3", "1f", "\xd9\xa1"}) {
        EXPECT_EQ(parse_decimal(text, 7, 16), bad(DecimalStatus::bad_character)) << text;
    }
    EXPECT_EQ(parse_decimal(std::string_view("1\0", 2), 7, 16), bad(DecimalStatus::bad_character));
}

// The short way against the long one: every status, every word.
void expect_same_both_ways(const std::string& text, int fraction_bits, int bits) {
    ASSERT_EQ(parse_decimal(text, fraction_bits, bits),
              detail::parse_decimal<false>(text, fraction_bits, bits))
        << text << " with " << fraction_bits << " fraction bits in " << bits;
}

// Every number of up to four digits, with the point and the exponent anywhere.
TEST(ParseDecimal, EveryFewDigitsAreTheSameTheShortWay) {
    for (int digits = 1; digits <= 4; ++digits) {
        const int end = std::array{0, 10, 100, 1000, 10000}[static_cast<std::size_t>(digits)];
        for (int value = 0; value < end; ++value) {
            std::string text = std::to_string(end + value).substr(1);  // with its leading zeros
            const int point = value % digits;
            if (point > 0) {
                text.insert(static_cast<std::size_t>(point), ".");
            }
            for (const int exponent : {0, -1, 3, -5, 15, -14, 16, -16, 18, -18, 20, -20}) {
                const std::string number = text + "e" + std::to_string(exponent);
                expect_same_both_ways(exponent == 0 ? text : number, 16, 32);
                expect_same_both_ways("-" + number, value % 49, 64);
            }
        }
    }
}

// Numbers of 14 to 22 digits, so that both ways and the change between them are met: random ones,
// ties (which have at most 18 digits for up to 16 fraction bits) and their neighbours.
TEST(ParseDecimal, ManyDigitsAreTheSameTheShortWay) {
    test::Random random;
    int at_the_limit = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string digits(static_cast<std::size_t>(random.between(14, 22)), '0');
        for (char& digit : digits) {
            digit = static_cast<char>('0' + random.between(0, 9));
        }
        if (random.between(0, 3) == 0) {
            digits.replace(1, 8, random.between(0, 1) == 0 ? "00000000" : "99999999");
        }
        at_the_limit += digits.size() == 18 || digits.size() == 19 ? 1 : 0;
        const auto point = static_cast<std::size_t>(random.between(1, 13));
        const std::string number = digits.substr(0, point) + "." + digits.substr(point);
        const auto fraction_bits = static_cast<int>(random.between(0, 48));
        const auto bits = static_cast<int>(random.between(1, 64));
        expect_same_both_ways(number, fraction_bits, bits);
        expect_same_both_ways(number, fraction_bits, 64);
        expect_same_both_ways(digits + "e-" + std::to_string(random.between(0, 24)), 0, 64);
        const auto f = static_cast<int>(random.between(0, 15));
        std::string tie = printed(2 * random.between(-(1 << 20), 1 << 20) + 1, f + 1);
        expect_same_both_ways(tie, f, 64);
        tie.back() = random.between(0, 1) == 0 ? '4' : '6';
        expect_same_both_ways(tie, f, 64);
    }
    EXPECT_GT(at_the_limit, 3000);
}

// Where the short way ends: 18 digits, 18 decimals, words of 62 bits.
TEST(ParseDecimal, BothSidesOfTheShortWaysLimits) {
    for (const char* text :
         {"999999999999999999", "1000000000000000000", "0.999999999999999999",
          "0.9999999999999999999", "99999999999999999e1", "99999999999999999e2", "1e17", "1e18",
          "1e-18", "1e-19", "4611686018427387903", "4611686018427387904", "70368744177663.5",
          "70368744177664", "70368744177664.5", "0e99", "0e-99", "-0e18", "000000000000000000001"})
        for (const int fraction_bits : {0, 1, 15, 16, 47, 48})
            for (const int bits : {1, 16, 61, 62, 63, 64})
                expect_same_both_ways(text, fraction_bits, bits);
}

TEST(PrintDecimal, Examples) {
    EXPECT_EQ(printed(1, 16), "0.0000152587890625");
    EXPECT_EQ(printed(0, 16), "0");
    EXPECT_EQ(printed(-5, 1), "-2.5");
    EXPECT_EQ(printed(3 << 16, 16), "3");
    EXPECT_EQ(printed(-1, 7), "-0.0078125");
    EXPECT_EQ(printed(INT64_MAX, 0), "9223372036854775807");
    EXPECT_EQ(printed(INT64_MIN, 0), "-9223372036854775808");
    EXPECT_EQ(printed(INT64_MIN, 60), "-8");
    const std::string longest = printed(INT64_MIN + 1, 60);
    EXPECT_EQ(longest.substr(0, 24), "-7.999999999999999999132");
    EXPECT_EQ(longest.size(), 63u);
}

TEST(PrintDecimal, BufferTooShortTraps) {
    std::array<char, 4> buffer{};
    EXPECT_EQ(print_decimal(-5, 1, buffer), 4);
    EXPECT_DEATH(print_decimal(-5, 2, buffer), "buffer too short");
    EXPECT_DEATH(print_decimal(0, 61, buffer), "0..60 fraction bits");
    EXPECT_DEATH(parse_decimal("0", 49, 64), "0..48 fraction bits");
    EXPECT_DEATH(parse_decimal("0", 0, 65), "signed width outside");
}

TEST(Decimal, Every16BitWordComesBack) {
    for (std::int64_t v = INT16_MIN; v <= INT16_MAX; ++v) {
        for (const int f : {0, 7, 16}) {
            ASSERT_EQ(parse_decimal(printed(v, f), f, 16), good(v)) << printed(v, f);
        }
    }
}

// A word and a half more is a tie: even wins. The shortest push either way decides it, however
// far behind the point it comes, and wherever the exponent puts the point.
TEST(ParseDecimal, TiesAndTheirNeighbours) {
    test::Random random;
    for (int i = 0; i < 4000; ++i) {
        const auto f = static_cast<int>(random.between(0, 48));
        const std::int64_t v = random.word() >> 3;
        const std::string tie = printed(2 * v + 1, f + 1);
        const std::int64_t even = v % 2 == 0 ? v : v + 1;
        ASSERT_EQ(parse_decimal(tie, f, 63), good(even)) << tie << " f " << f;
        const std::string zeros(random.bits() % 100, '0');
        ASSERT_EQ(parse_decimal(tie + zeros, f, 63), good(even)) << tie << " f " << f;
        const std::int64_t away = tie[0] == '-' ? v : v + 1;  // larger in magnitude
        ASSERT_EQ(parse_decimal(tie + zeros + "1", f, 63), good(away)) << tie << " f " << f;
        // The last digit of a tie is a 5; 4999... is just below.
        const std::string below = tie.substr(0, tie.size() - 1) + "4" + std::string(80, '9');
        ASSERT_EQ(parse_decimal(below, f, 63), good(v + v + 1 - away)) << below << " f " << f;
    }
}

// Moving the point and undoing it by the exponent changes nothing.
TEST(ParseDecimal, ExponentMovesThePoint) {
    test::Random random;
    for (int i = 0; i < 4000; ++i) {
        const auto f = static_cast<int>(random.between(1, 48));
        const std::int64_t v = random.word() | 1;
        const std::string text = printed(v, f);
        const std::size_t point = text.find('.');
        const std::string digits = text.substr(0, point) + text.substr(point + 1);
        const auto decimals = text.size() - point - 1;
        ASSERT_EQ(parse_decimal(digits + "e-" + std::to_string(decimals), f, 64), good(v)) << text;
        const bool negative = v < 0;
        const std::string fraction = std::string(negative ? "-0." : "0.") +
                                     digits.substr(negative ? 1 : 0) + "e" +
                                     std::to_string(point - (negative ? 1 : 0));
        ASSERT_EQ(parse_decimal(fraction, f, 64), good(v)) << fraction;
    }
}

}  // namespace
}  // namespace umbra78::fixed
