// A machine word as text: decimal, the value it stands for with its Q format, and hexadecimal.
//
// A format is Qi.f, i bits before the point and f behind it, the sign not counted; UQi.f has no
// sign. Hexadecimal is two's complement in the word's own width. Everything is exact.
#pragma once

#include "fixed/wide_int.hpp"

#include <cstdint>
#include <string>

namespace umbra78::tools {

struct Word {
    std::int64_t value = 0;
    int bits = 0;
    int fraction = 0;
    bool has_sign = true;
};

// Of `bits`, or as many more as the value needs: some of the machine's registers are wider than
// what they hold.
Word signed_word(std::int64_t value, int bits, int fraction = 0);
Word unsigned_word(std::int64_t value, int bits, int fraction = 0);

std::string real_text(const Word&);    // "-175.5"
std::string format_text(const Word&);  // "Q8.7", "UQ16.0"
std::string hex_text(const Word&);     // "a840", as many digits as the width needs

using WideWord = fixed::WideInt<4>;
std::string decimal_text(WideWord);

}  // namespace umbra78::tools
