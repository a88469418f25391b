// Rows of an exact matrix, rounded to coefficient words with an exponent (hw/MACHINE.md, section
// 5).
#pragma once

#include "fixed/rational.hpp"
#include "hw/machine_spec.hpp"
#include "hw/transform_unit.hpp"

#include <array>
#include <cstdint>

namespace umbra78::hw {

using RowWords = std::array<std::int32_t, 4>;

// The fourth column multiplies one_word and not 1.0: scaled so that the sum comes out right.
std::array<Rational, 4> for_words(std::array<Rational, 4> row, WordFormat input);

// Rounds a row at one exponent; false where a word does not fit.
bool round_row(const std::array<Rational, 4>& row, int exponent, const MachineSpec& spec,
               RowWords& words);

// The same at the smallest exponent in range at which every word fits; a row of zeros has 0.
bool quantize_row(const std::array<Rational, 4>& row, const MachineSpec& spec, RowWords& words,
                  int& exponent);

}  // namespace umbra78::hw
