// A machine word as text: decimal, its value with its Q format, and hexadecimal.
//
// The format Qi.f has i bits before the point and f after it, and a sign that is not counted; UQi.f
// has no sign. Hexadecimal is two's complement in the word's own width. Everything is exact.
#pragma once

#include "fixed/wide_int.hpp"

#include <cstdint>
#include <string>

namespace umbra78::tools {

struct MachineWord {
    std::int64_t value = 0;
    int bits = 0;
    int fraction = 0;
    bool has_sign = true;
};

// A word of `bits`, or of as many more as the value needs: some of the machine's registers are
// wider than the format of what they hold.
MachineWord signed_word(std::int64_t value, int bits, int fraction = 0);
MachineWord unsigned_word(std::int64_t value, int bits, int fraction = 0);

std::string real_text(const MachineWord&);    // "-175.5"
std::string format_text(const MachineWord&);  // "Q8.7", "UQ16.0"
std::string hex_text(const MachineWord&);     // "a840", as many digits as the width needs

using WideWord = fixed::WideInt<4>;
std::string decimal_text(WideWord);

}  // namespace umbra78::tools
