// Worst error of a determinant of lines by their leading bits, by the production code.
#include "shadow/rivals/light_lines.hpp"
#include "tests/proofs/search.hpp"

namespace umbra78::proofs {
namespace {

using shadow::rivals::leading_bits;
using shadow::rivals::LightLine;

template <class Number>
Wide determinant(const std::array<std::array<Number, 3>, 3>& m) {
    const auto at = [&](std::size_t i, std::size_t j) { return Wide{m[i][j]}; };
    Wide sum = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
        sum += at(2, j) * (at(0, k) * at(1, l) - at(0, l) * at(1, k));
    }
    return sum;
}

}  // namespace

// Numbers of 2^20 and small ones whose other bits are all ones or all zeros.
void line_errors() {
    Words words;
    Worst worst("leading");
    constexpr int other = 8;
    constexpr std::int64_t most = std::int64_t{1} << (leading_bits + other);
    for (int k = 0; k < 200'000; ++k) {
        std::array<std::array<std::int64_t, 3>, 3> m{}, lead{};
        Given given;
        for (std::size_t i = 0; i < 3; ++i) {
            std::array<shadow::rivals::Sum, 3> v;
            for (std::size_t j = 0; j < 3; ++j) {
                const bool ones = words.bits() % 2 == 0;
                // The longest number has leading_bits and `other` bits, whatever its sign.
                m[i][j] = words.bits() % 2 == 0 ? (ones ? most - 1 : most - (1 << other))
                                                : (ones ? -most + (1 << other) - 1 : -most + 1);
                v[j] = m[i][j];
                given.push_back(m[i][j]);
            }
            const LightLine line(v);
            for (std::size_t j = 0; j < 3; ++j) lead[i][j] = line.leading[j];
        }
        const Wide unit = Wide{1} << (3 * other);
        worst.add(ratio(determinant(m) - determinant(lead) * unit, unit), given);
    }
}

}  // namespace umbra78::proofs
