// The units of the study of precision, their errors in exact arithmetic, and their bounds.
#include "fixed/divide.hpp"
#include "fixed/float38.hpp"
#include "fixed/root.hpp"
#include "fixed/sine.hpp"
#include "hw/transform_unit.hpp"
#include "tools/study/precision/precision.hpp"

#include <cmath>
#include <numbers>

namespace umbra78::tools::study {
namespace {

__extension__ using Wide = __int128;

double magnitude(Wide v) { return static_cast<double>(v < 0 ? -v : v); }

// Rounding shift by 7, half even: v / 2^7.
double rounding_shift(const Input& in) {
    const std::int64_t q = fixed::round_shift(in[0], 7, fixed::Rounding::half_even);
    return magnitude(Wide{q} * 128 - in[0]) / 128;
}

// Four products of 16 x 16 bits, rounded once after the sum; the words repeat, as a matrix's do.
double multiply_accumulate(const Input& in) {
    const Wide sum = Wide{in[0]} * in[1] + Wide{in[2]} * in[3] + Wide{in[0]} * in[3] +
                     Wide{in[2]} * in[1];
    const std::int64_t acc = in[0] * in[1] + in[2] * in[3] + in[0] * in[3] + in[2] * in[1];
    const std::int64_t q = fixed::round_shift(acc, 14, fixed::Rounding::half_up);
    return magnitude(Wide{q} * (1 << 14) - sum) / (1 << 14);
}

// num 2^7 / den, as the perspective divide forms a coordinate from two accumulators.
double quotient(const Input& in) {
    if (in[1] <= 0) return -1;
    const fixed::Quotient q = fixed::divide(in[0], in[1], 7, 63);
    if (q.status != fixed::DivideStatus::ok) return -1;
    return magnitude(Wide{q.value} * in[1] - Wide{in[0]} * 128) / static_cast<double>(in[1]);
}

// sqrt v - floor(sqrt v); the difference of the squares is exact.
double root(const Input& in) {
    const auto v = static_cast<std::uint64_t>(in[0]);
    const std::uint64_t r = fixed::isqrt(v);
    const double rest = static_cast<double>(v - r * r);
    if (v - r * r > 2 * r) return 2;  // not the floor
    return rest / (static_cast<double>(r) + std::sqrt(static_cast<double>(v)) + (v == 0 ? 1 : 0));
}

double sine(const Input& in) {
    // 64 fraction bits of long double are 2^33 of an LSB; the angle is reduced before.
    const long double turn = static_cast<long double>(in[0] % (360 << 16)) / (180 << 16);
    const long double exact = std::sin(turn * std::numbers::pi_v<long double>);
    const auto is = fixed::sine_cosine(static_cast<std::int32_t>(in[0])).sine;
    return static_cast<double>(std::abs(is - std::ldexp(exact, 30)));
}

// 1978's unit with in[0] and in[1] for the X row's coefficients and in[2], in[3] for x and y.
hw::MatrixWords matrix(const Input& in, bool affine) {
    hw::MatrixWords m;
    const auto a = static_cast<std::int32_t>(in[0]), b = static_cast<std::int32_t>(in[1]);
    m.word = {{{a, b, b, a}, {b, a, a, b}, {a, a, b, b}, {0, 0, 0, 1 << 14}}};
    if (!affine) m.word[3] = {b, 0, a, 1 << 14};
    m.affine = affine;
    return m;
}

Wide row(const hw::MatrixWords& m, std::size_t r, const hw::Words& v) {
    const auto& c = m.word[r];
    return Wide{c[0]} * v.x + Wide{c[1]} * v.y + Wide{c[2]} * v.z + Wide{c[3]} * (1 << 14);
}

hw::Words point(const Input& in) {
    const auto x = static_cast<std::int32_t>(in[2]), y = static_cast<std::int32_t>(in[3]);
    return {x, y, static_cast<std::int32_t>((in[2] + in[3]) / 2)};
}

double affine_transform_by(const hw::MachineSpec& spec, const Input& in) {
    const hw::MatrixWords m = matrix(in, true);
    const hw::Words v = point(in);
    const hw::Point p = hw::TransformUnit(spec, m)(v);
    const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
    double worst = 0;
    for (std::size_t r = 0; r < 3; ++r)  // 14 bits of coefficient; 7 of fraction in and out
        worst = std::max(worst, magnitude(Wide{out[r]} * (1 << 14) - row(m, r, v)) / (1 << 14));
    return worst;
}

double affine_transform(const Input& in) { return affine_transform_by({}, in); }

double short_transform(const Input& in) {
    hw::MachineSpec spec;
    spec.max_accumulator_bits = 22;
    return affine_transform_by(spec, in);
}

double perspective_transform(const Input& in) {
    const hw::MatrixWords m = matrix(in, false);
    const hw::Words v = point(in);
    const hw::Point p = hw::TransformUnit({}, m)(v);
    const Wide w = row(m, 3, v);
    if (p.status != hw::DivideStatus::ok) return -1;
    if (w <= 0) return 9;  // a value where there is none
    const std::array<std::int64_t, 3> out{p.x, p.y, p.z};
    double worst = 0;
    for (std::size_t r = 0; r < 3; ++r)
        worst = std::max(worst, magnitude(Wide{out[r]} * w - row(m, r, v) * 128) /
                                    static_cast<double>(w));
    return worst;
}

// Normalised words within 2^+-20 of one another, so that the sum's exact value fits 128 bits.
fixed::Float38 float38(std::int64_t mantissa, std::int64_t exponent) {
    return fixed::Float38::from_parts(static_cast<std::int32_t>(mantissa),
                                      static_cast<int>(512 + exponent))
        .normalised();
}

// |result - exact| in LSB of the result; exact is word 2^scale, scale relative to 2^-27.
double error38(const fixed::Float38& f, Wide exact, int scale) {
    if (exact == 0) return f.is_zero() ? 0 : 9;
    const int lsb = f.biased_exponent() - 512;  // the result's last bit, relative to 2^-27
    if (lsb >= scale)
        return magnitude((Wide{f.mantissa()} << (lsb - scale)) - exact) /
               std::ldexp(1.0, lsb - scale);
    return magnitude(Wide{f.mantissa()} - (exact << (scale - lsb)));
}

double float_sum(const Input& in) {
    const fixed::Float38 a = float38(in[0], in[1]), b = float38(in[2], in[3]);
    if (a.is_zero() || b.is_zero()) return -1;
    const int ea = a.biased_exponent() - 512, eb = b.biased_exponent() - 512;
    const int low = std::min(ea, eb);
    const Wide exact = (Wide{a.mantissa()} << (ea - low)) + (Wide{b.mantissa()} << (eb - low));
    return error38(a + b, exact, low);
}

double float_product(const Input& in) {
    const fixed::Float38 a = float38(in[0], in[1]), b = float38(in[2], in[3]);
    const int scale = a.biased_exponent() + b.biased_exponent() - 1024 - 27;
    return error38(a * b, Wide{a.mantissa()} * b.mantissa(), scale);
}

}  // namespace

std::vector<PrecisionUnit> precision_units() {
    constexpr std::string_view once = "one rounding to nearest";
    constexpr std::string_view once_after = "exact sum, one rounding to nearest";
    // The sine's evaluation is off by 3 units of 2^-63 at most (fixed/sine.hpp).
    const double sine_bound = 0.5 + 3 * std::ldexp(1.0, -33) + std::ldexp(1.0, -30);
    return {
        {"rounding shift", once, 0.5, 1, {24, 0, 0, 0}, true, rounding_shift},
        {"multiply-accumulate", once_after, 0.5, 4, {16, 16, 16, 16}, false,
         multiply_accumulate},
        {"divide", "the certificate: 2 |q den - num 2^n| <= den", 0.5, 2, {36, 36, 0, 0}, false,
         quotient},
        {"root, all of 24 bits", "the floor: below 1", 1, 1, {25, 0, 0, 0}, true,
         [](const Input& in) { return in[0] < 0 ? -1.0 : root(in); }},
        {"root, 64 bits", "the floor: below 1", 1, 1, {64, 0, 0, 0}, false, root},
        {"sine", "correctly rounded; 3 units of 2^-63 in its evaluation", sine_bound, 1,
         {26, 0, 0, 0}, true, sine},
        {"transform", once_after, 0.5, 4, {16, 16, 16, 16}, false, affine_transform},
        // Three products lose up to 2^13 - 1 each, of an LSB of 2^14; the fourth ends in 14 zeros.
        // What is left is at most half an LSB, which is rounded up.
        {"transform, 22-bit accumulators", "three products cut down by 13 bits, rounded half up",
         3 * 8191.0 / 16384, 4, {16, 16, 16, 16}, false, short_transform},
        {"transform with perspective divide", "exact sums, the quotient's certificate", 0.5, 4,
         {16, 16, 16, 16}, false, perspective_transform},
        {"Float38 add", "rounded once to 27 bits", 0.5, 4, {28, 6, 28, 6}, false, float_sum},
        {"Float38 multiply", "rounded once to 27 bits", 0.5, 4, {28, 6, 28, 6}, false,
         float_product},
    };
}

}  // namespace umbra78::tools::study
