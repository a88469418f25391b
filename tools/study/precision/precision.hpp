// The study of precision: each fixed-point unit against exact arithmetic, with its worst input.
//
// A unit is a function of a few words whose error, in LSB of its result, can be computed exactly.
// If the words are few, all are tried. Otherwise random inputs are drawn and improved: one word is
// changed by a bit or by one, and the change is kept if the error grows. No error may exceed the
// bound, which follows from the unit's one rounding.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

using Input = std::array<std::int64_t, 4>;

struct PrecisionUnit {
    std::string_view name;
    std::string_view bound_source;           // why the bound is what it is
    double bound;                            // in LSB
    int words;                               // how many of the input's words are used
    std::array<int, 4> bits;                 // their widths, signed
    bool exhaustive;                         // all words are tried; in quick runs every 61st
    // The error in LSB; negative if the input is not in the unit's domain.
    double (*error)(const Input&);
};
std::vector<PrecisionUnit> precision_units();

inline constexpr int error_bins = 16;  // from 0 to the bound, equally wide

struct PrecisionResult {
    std::uint64_t cases = 0;
    double worst = 0, mean = 0;
    Input at{};
    std::array<std::uint64_t, error_bins + 1> histogram{};  // the last: above the bound
};
PrecisionResult measure(const PrecisionUnit&, bool quick);

}  // namespace umbra78::tools::study
