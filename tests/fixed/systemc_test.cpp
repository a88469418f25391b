// Rounding and overflow equal SystemC's: the hashes of tests/systemc/tables.txt, which SystemC
// wrote, computed again by this room. tests/systemc/run.sh asks SystemC itself.
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "fixed/fnv.hpp"
#include "fixed/overflow.hpp"
#include "fixed/rounding.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/paths.hpp"

namespace umbra78::fixed {
namespace {

struct TableOfSystemC {
    int length = 0, integer = 0;
    std::string rounding, overflow, hash;
};

const std::map<std::string, Rounding> roundings_of_systemc{
    {"floor", Rounding::floor},       {"ceiling", Rounding::ceiling},
    {"to_zero", Rounding::to_zero},   {"half_up", Rounding::half_up},
    {"half_to_zero", Rounding::half_to_zero}, {"half_away", Rounding::half_away},
    {"half_even", Rounding::half_even}};
const std::map<std::string, Overflow> overflows_of_systemc{
    {"wrap", Overflow::wrap},
    {"saturate", Overflow::saturate},
    {"saturate_symmetric", Overflow::saturate_symmetric}};

// A word of Q7.8 in the table's format. This room has no half_down (half toward minus infinity,
// SystemC's SC_RND_MIN_INF): it is the mirror image of half_up.
std::int64_t converted(std::int64_t word, const TableOfSystemC& table, Rounding rounding) {
    const int shift = 8 - (table.length - table.integer);
    const bool mirrored = table.rounding == "half_down";
    const std::int64_t rounded = mirrored ? -scale_shift(-word, shift, Rounding::half_up)
                                          : scale_shift(word, shift, rounding);
    return narrow(rounded, table.length, overflows_of_systemc.at(table.overflow));
}

std::string hash_of_table(const TableOfSystemC& table, Rounding rounding) {
    Fnv1a64 hash;
    for (std::int64_t word = INT16_MIN; word <= INT16_MAX; ++word) {
        hash.u32be(static_cast<std::uint32_t>(converted(word, table, rounding)));
    }
    std::string digits(16, '0');
    for (int k = 0; k < 16; ++k) {
        digits[static_cast<std::size_t>(k)] =
            "0123456789abcdef"[hash.value() >> (60 - 4 * k) & 15];
    }
    return digits;
}

Rounding rounding_of(const TableOfSystemC& table) {
    return table.rounding == "half_down" ? Rounding::half_up
                                         : roundings_of_systemc.at(table.rounding);
}

template <class Visit>
int for_each_table(Visit visit) {
    std::ifstream file(UMBRA78_SOURCE_DIR "/tests/systemc/tables.txt");
    TableOfSystemC table;
    int count = 0;
    while (file >> table.length >> table.integer >> table.rounding >> table.overflow >>
           table.hash) {
        if (!umbra78::test::sanitized || count % 5 == 0) visit(table);
        ++count;
    }
    return count;
}

// 13 formats, 8 roundings, 3 overflow modes: 20 447 232 words.
TEST(SystemC, RoundingsAndOverflowsAreTheSame) {
    const int count = for_each_table([](const TableOfSystemC& table) {
        EXPECT_EQ(hash_of_table(table, rounding_of(table)), table.hash)
            << table.length << ' ' << table.integer << ' ' << table.rounding << ' '
            << table.overflow;
    });
    EXPECT_EQ(count, 13 * 8 * 3);
}

// Wherever half_away has something to round, a wrong one is seen.
TEST(SystemC, WrongHalfAwayIsFound) {
    int found = 0;
    for_each_table([&found](const TableOfSystemC& table) {
        if (table.rounding == "half_away") {
            found += hash_of_table(table, Rounding::half_up) != table.hash ? 1 : 0;
        }
    });
    EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace umbra78::fixed
