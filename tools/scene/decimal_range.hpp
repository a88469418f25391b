// A range of numbers written as "first:last:step", in exact decimals: "0:1:0.25" is 0, 0.25, 0.5,
// 0.75, 1, and "0:1:0.1" holds 0.3, not the double nearest to it.
//
// The three numbers are brought to integers of the same power of ten by fixed/decimal.hpp, so the
// numbers are written as in a scene file, but without an exponent. Throws nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools {

struct DecimalRange {
    std::vector<std::string> values;  // with the fewest decimals that say them exactly
    std::string error;                // what is wrong, in a sentence without a stop; or empty
};

// The values first + k step, k = 0, 1, ..., up to `last`, which is among them if a whole number
// of steps leads to it. An error: not three numbers, a step that does not lead from the first
// value to the last, more than 100 000 values, numbers beyond 2^62 units of the last decimal.
DecimalRange read_decimal_range(std::string_view text);

}  // namespace umbra78::tools
