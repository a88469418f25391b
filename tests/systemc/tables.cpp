// Tables of rounding and overflow by SystemC (IEEE 1666), whose fixed-point types others use:
// every word of 16 bits, taken as Q7.8, assigned to each of 13 formats in each rounding and
// overflow mode.
//
//   tables                prints a line for each: word length, integer bits, rounding, overflow and
//                         the hash of the 65536 words that result
//   tables --half-away=half_up   with a wrong half_away: tables.txt has to differ from it
//
// run.sh compares with tables.txt; tests/fixed/systemc_test.cpp computes the same by fixed/.
#include <systemc.h>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iomanip>
#include <iostream>

namespace {

struct Format {
    int length, integer;  // bits in all, and those before the point, the sign's among them
};
constexpr Format formats[] = {{16, 8}, {8, 8},  {8, 4},  {12, 8}, {12, 6},  {4, 4},  {4, 2},
                              {1, 1},  {2, 8},  {8, 12}, {16, 2}, {10, 10}, {24, 12}};

// SystemC has no rounding up, and fixed/ no half toward minus infinity: each is the mirror image of
// another, -round(-v).
struct Mode {
    const char* name;
    sc_q_mode mode;
    bool mirrored;
};
Mode modes[] = {{"floor", SC_TRN, false},          {"ceiling", SC_TRN, true},
                {"to_zero", SC_TRN_ZERO, false},   {"half_up", SC_RND, false},
                {"half_to_zero", SC_RND_ZERO, false}, {"half_away", SC_RND_INF, false},
                {"half_even", SC_RND_CONV, false}, {"half_down", SC_RND_MIN_INF, false}};

struct Limit {
    const char* name;
    sc_o_mode mode;
};
constexpr Limit limits[] = {
    {"wrap", SC_WRAP}, {"saturate", SC_SAT}, {"saturate_symmetric", SC_SAT_SYM}};

std::uint64_t hash_of(const Format& to, const Mode& rounding, const Limit& limit) {
    // Rounded in a word wide enough that nothing overflows, then assigned to the format: by itself
    // the mirror image of an overflow would be another one.
    const int fraction = to.length - to.integer;
    sc_fix wide(64, 64 - fraction, rounding.mode, SC_WRAP);
    sc_fix direct(to.length, to.integer, rounding.mode, limit.mode);
    sc_fix narrow(to.length, to.integer, SC_TRN, limit.mode);
    sc_fix given(40, 32), whole(40, 40);
    std::uint64_t hash = 0xcbf29ce484222325;
    for (int word = -32768; word <= 32767; ++word) {
        given = word;
        given >>= 8;
        if (rounding.mirrored) {
            wide = -given;
            narrow = -wide;
        } else {
            direct = given;
        }
        const sc_fix& result = rounding.mirrored ? narrow : direct;
        whole = fraction >= 0 ? result << fraction : result >> -fraction;
        const auto bits = static_cast<std::uint32_t>(whole.to_int64());
        for (int byte = 3; byte >= 0; --byte) {
            hash = (hash ^ (bits >> 8 * byte & 255)) * 0x100000001b3;
        }
    }
    return hash;
}

}  // namespace

int sc_main(int count, char** arguments) {
    if (count == 2 && std::strcmp(arguments[1], "--half-away=half_up") == 0) {
        modes[5].mode = SC_RND;
    } else if (count > 1) {
        std::cerr << "tables: unknown argument '" << arguments[1] << "'; see its first lines\n";
        return 2;
    }
    for (const Format& format : formats) {
        for (const Mode& mode : modes) {
            for (const Limit& limit : limits) {
                std::cout << format.length << ' ' << format.integer << ' ' << mode.name << ' '
                          << limit.name << ' ' << std::hex << std::setfill('0') << std::setw(16)
                          << hash_of(format, mode, limit) << std::dec << '\n';
            }
        }
    }
    return 0;
}
