// Extreme words in every register of the units, against 128-bit arithmetic that shares no code.
//
// A 3 x 4 transform has twelve coefficients; with five words for each there are 5^12 = 244 140 625
// matrices. A row's accumulator depends only on its own four coefficients and the point, so the
// 3 x 5^4 rows, each at all 5^3 points, cover all matrices.
#include "tools/study/stability/stability.hpp"

#include "fixed/overflow.hpp"
#include "fixed/root.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

namespace umbra78::tools::study {
namespace {

__extension__ using Wide = __int128;

// The extremes of a word of `bits` bits, and 0.
std::array<std::int64_t, 5> corners(int bits) {
    const std::int64_t max = (std::int64_t{1} << (bits - 1)) - 1;
    return {-max - 1, -max, 0, max - 1, max};
}

constexpr hw::MachineSpec machines[] = {
    {},                                                                     // 1978
    {.coefficient_bits = 24},                                               // perspective24
    {.xy_bits = 12, .z_bits = 24, .coefficient_bits = 32, .fraction_bits = 12},  // the widest
    {.xy_bits = 4, .z_bits = 4, .coefficient_bits = 8, .fraction_bits = 0},      // the narrowest
};

Finding verdict(std::uint64_t cases, std::uint64_t wrong, const std::string& first) {
    Finding f;
    f.status = "ok";
    f.holds = wrong == 0 && cases > 0;
    f.error = static_cast<double>(wrong);
    f.bound = 0;
    f.unit = "wrong words";
    f.observed = wrong == 0 ? fmt::format("{} cases, none wrong", cases)
                            : fmt::format("{} of {} wrong, first {}", wrong, cases, first);
    return f;
}

// Every row of extreme coefficients at every extreme point.
Finding accumulators(const UnitsUnderTest& units, const Effort&) {
    std::uint64_t cases = 0, wrong = 0;
    std::string first;
    for (const hw::MachineSpec& spec : machines) {
        const auto c = corners(spec.coefficient_bits), v = corners(spec.word_bits());
        const Wide max = (Wide{1} << (spec.accumulator_bits() - 1)) - 1;
        for (int row = 0; row < 3 * 625; ++row) {
            const auto r = static_cast<std::size_t>(row % 3);
            hw::MatrixWords m;
            for (int j = 0, rest = row / 3; j < 4; ++j, rest /= 5)
                m.word[r][static_cast<std::size_t>(j)] = static_cast<std::int32_t>(c[rest % 5]);
            for (std::size_t p = 0; p < 125; ++p) {
                const hw::Words w{static_cast<std::int32_t>(v[p % 5]),
                                  static_cast<std::int32_t>(v[p / 5 % 5]),
                                  static_cast<std::int32_t>(v[p / 25])};
                const auto& k = m.word[r];
                const Wide must = Wide{k[0]} * w.x + Wide{k[1]} * w.y + Wide{k[2]} * w.z +
                                  Wide{k[3]} * spec.one_word();
                const auto is = units.accumulate(m, static_cast<hw::Row>(r), w, spec.one_word());
                ++cases;
                if (is == must && must <= max && must >= -max - 1) continue;
                if (wrong++ == 0)
                    first = fmt::format("({}, {}, {}, {}) at ({}, {}, {}): {}", k[0], k[1], k[2],
                                        k[3], w.x, w.y, w.z, is);
            }
        }
    }
    Finding f = verdict(cases, wrong, first);
    f.observed += "; 5^12 matrices of each of 4 machines by their rows";
    return f;
}

// round half up of num 2^shift / den, by 128-bit division; shift >= 0.
Wide rounded_quotient(Wide num, Wide den, int shift) {
    const Wide twice = 2 * (num * (Wide{1} << shift)) + den;
    const Wide q = twice / (2 * den);
    return twice % (2 * den) < 0 ? q - 1 : q;
}

// The divider on all pairs of accumulators that extreme words make: value, status, saturation.
Finding quotients(const UnitsUnderTest& units, const Effort& effort) {
    const hw::MachineSpec spec;
    std::set<std::int64_t> sums{1, 2, 3, -1, INT64_C(1) << 34, -(INT64_C(1) << 34)};
    const auto c = corners(spec.coefficient_bits);
    for (const std::int64_t a : c)
        for (const std::int64_t b : c)
            for (const std::int64_t v : corners(spec.word_bits()))
                for (const std::int64_t w : corners(spec.word_bits()))
                    sums.insert(a * v + b * w);
    std::uint64_t cases = 0, wrong = 0;
    std::string first;
    for (const int shift : effort.quick ? std::vector{0, 7} : std::vector{0, 1, 7, 12, 42})
        for (const std::int64_t num : sums)
            for (const std::int64_t den : sums) {
                constexpr int bits = 17;
                const fixed::Quotient is = units.divide(num, den, shift, bits,
                                                        fixed::Rounding::half_up);
                fixed::Quotient must{0, fixed::DivideStatus::divisor_not_positive};
                if (den > 0) {
                    const Wide q = rounded_quotient(num, den, shift);
                    const Wide max = (1 << (bits - 1)) - 1;
                    const Wide word = q > max ? max : q < -max - 1 ? -max - 1 : q;
                    must = {static_cast<std::int64_t>(word),
                            word == q ? fixed::DivideStatus::ok : fixed::DivideStatus::overflow};
                }
                ++cases;
                if (is == must || wrong++ > 0) continue;
                first = fmt::format("{} 2^{} / {}: {}, must be {}", num, shift, den, is.value,
                                    must.value);
            }
    return verdict(cases, wrong, first);
}

// w = 0, -1, minimum: a status and 0, whatever the numerator.
Finding no_divisor(const UnitsUnderTest& units, const Effort&) {
    std::uint64_t cases = 0, wrong = 0;
    std::string first;
    for (const std::int64_t den : {std::int64_t{0}, std::int64_t{-1}, INT64_MIN})
        for (const std::int64_t num : {INT64_MIN, std::int64_t{-1}, std::int64_t{0}, INT64_MAX})
            for (int shift = -62; shift <= 62; ++shift) {
                const auto q = units.divide(num, den, shift, 17, fixed::Rounding::half_up);
                ++cases;
                if (q.status == fixed::DivideStatus::divisor_not_positive && q.value == 0)
                    continue;
                if (wrong++ == 0) first = fmt::format("{} / {}", num, den);
            }
    return verdict(cases, wrong, first);
}

// Saturation gives the nearest word at every width, for the extreme words of every other width.
Finding saturation(const UnitsUnderTest& units, const Effort&) {
    std::uint64_t cases = 0, wrong = 0;
    std::string first;
    for (int bits = 1; bits <= 63; ++bits) {
        const Wide max = (Wide{1} << (bits - 1)) - 1;
        for (int of = 2; of <= 64; ++of)
            for (const std::int64_t v : {fixed::min_signed(of), fixed::max_signed(of),
                                         fixed::min_signed(of) + 1, fixed::max_signed(of) - 1}) {
                const Wide must = v > max ? max : v < -max - 1 ? -max - 1 : Wide{v};
                ++cases;
                const std::int64_t is = units.saturate(v, bits);
                if (is == must) continue;
                if (wrong++ == 0) first = fmt::format("{} in {} bits: {}", v, bits, is);
            }
    }
    return verdict(cases, wrong, first);
}

// Extreme and nearly singular words in the whole perspective unit: the status is defined, and the
// quotient has its certificate.
Finding whole_unit(const UnitsUnderTest&, const Effort& effort) {
    std::uint64_t cases = 0, wrong = 0;
    std::string first;
    for (hw::MachineSpec spec : machines) {
        spec.divide_order = hw::DivideOrder::exact;
        const auto c = corners(spec.coefficient_bits), v = corners(spec.word_bits());
        for (int k = 0; k < 625 * 25; k += effort.quick ? 7 : 1) {
            hw::MatrixWords m;
            m.affine = false;
            m.exponent = {31, -11, 0, k % 2 == 0 ? -11 : 31};  // as far apart as is loaded
            auto rest = static_cast<std::size_t>(k);
            for (std::size_t j = 0; j < 4; ++j, rest /= 5)
                for (std::size_t r = 0; r < 4; ++r)
                    m.word[r][j] = static_cast<std::int32_t>(c[(rest + r * (r + 1)) % 5]);
            const hw::TransformUnit unit(spec, m);
            for (std::size_t p = 0; p < 125; ++p) {
                const hw::Words w{static_cast<std::int32_t>(v[p % 5]),
                                  static_cast<std::int32_t>(v[p / 5 % 5]),
                                  static_cast<std::int32_t>(v[p / 25])};
                const hw::Point out = unit(w);
                const std::int64_t acc_w = hw::accumulate(m, hw::Row::w, w, spec.one_word());
                const bool behind = out.status == hw::DivideStatus::divisor_not_positive;
                const std::int64_t x = hw::accumulate(m, hw::Row::x, w, spec.one_word());
                const bool certified =
                    out.status != hw::DivideStatus::ok ||
                    fixed::certificate_holds(x, acc_w,
                                             hw::divide_shift(m, hw::Row::x, spec.fraction_bits),
                                             out.x);
                ++cases;
                if (behind == (acc_w <= 0) && certified) continue;
                if (wrong++ == 0) first = fmt::format("matrix {} point {}", k, p);
            }
        }
    }
    return verdict(cases, wrong, first);
}

}  // namespace

std::vector<UnitCase> unit_cases() {
    return {
        {"unit: all corner products of 3 x 4", "every accumulator exact, and in its bits",
         accumulators},
        {"unit: quotients of extreme sums", "the rounded quotient, or the saturated word with "
                                            "the status overflow", quotients},
        {"unit: w zero, negative, least", "the status divisor_not_positive, and 0", no_divisor},
        {"unit: saturation at every width", "the nearest word, never a wrapped one", saturation},
        {"unit: extreme perspective matrices", "a status exactly where W <= 0, else certified",
         whole_unit},
    };
}

}  // namespace umbra78::tools::study
