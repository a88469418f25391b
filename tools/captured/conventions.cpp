#include "tools/captured/conventions.hpp"

#include "raster/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::captured {
namespace {

using hw::Rational;
using hw::RationalMatrix;

constexpr std::array<Convention, 3> known_conventions{{
    {"d3d", true, false, true, false},
    {"vulkan", false, false, true, false},
    {"opengl", true, true, false, false},
}};

constexpr std::array<DepthFormat, 7> known_formats{{
    {"codes", 0, false, false},
    {"d16", 16, false, false},
    {"d16_reversed", 16, false, true},
    {"d24", 24, false, false},
    {"d24_reversed", 24, false, true},
    {"d32f", 0, true, false},
    {"d32f_reversed", 0, true, true},
}};

// Entries are multiples of 2^-least_bit below 2^most_bit, so that no exact sum here grows beyond
// what a Rational holds.
constexpr int least_bit = 130, most_bit = 40;

// Exactly, but for what lies below 2^-least_bit.
Rational exact_of(double value) {
    int exponent = 0;
    const double part = std::frexp(value, &exponent);  // value = part 2^exponent
    const auto word = static_cast<std::int64_t>(std::ldexp(part, 53));
    const int shift = exponent - 53;
    if (shift >= 0) return Rational(Rational::Int(word) << shift, Rational::Int(1));
    if (-shift <= least_bit) return Rational(Rational::Int(word), Rational::Int(1) << -shift);
    const int down = std::min(-shift - least_bit, 62);
    return Rational(Rational::Int(fixed::round_shift(word, down, fixed::Rounding::half_even)),
                    Rational::Int(1) << least_bit);
}

// For column vectors.
RationalMatrix exact_of(const Matrix16& m, const Convention& c) {
    RationalMatrix exact;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            exact[i][j] = exact_of(c.row_vectors ? m[4 * j + i] : m[4 * i + j]);
    return exact;
}

// The frame's screen to the capture's normalized device coordinates: of (X, Y, Z, 1), with z as it
// is stored or, where that is the convention, as it was before.
RationalMatrix to_device(Sides sides, const Convention& c, const DepthFormat& format,
                         const hw::MachineSpec& spec) {
    const Rational half(spec.half_px()), far(far_code(format, spec));
    const Rational a_pixel_x(2, std::int64_t{sides.width});
    const Rational a_pixel_y(2, std::int64_t{sides.height});
    const std::int64_t up = c.y_up ? -1 : 1;
    RationalMatrix m{};
    m[0] = {a_pixel_x, 0, 0, a_pixel_x * half - 1};
    m[1] = {0, a_pixel_y * up, 0, (a_pixel_y * half - 1) * up};
    // The code is Z 2^depth_fraction + depth_offset, which is half_px 2^depth_fraction.
    Rational slope = Rational(spec.depth_offset()) / half / far;
    Rational at_zero = Rational(spec.depth_offset()) / far;
    if (format.reversed) {
        slope = -slope;
        at_zero = Rational(1) - at_zero;
    }
    if (c.z_from_minus_one) {
        slope = slope * 2;
        at_zero = at_zero * 2 - 1;
    }
    m[2] = {0, 0, slope, at_zero};
    m[3] = {0, 0, 0, 1};
    return m;
}

// The other way, which to_device()'s rows, each of one coordinate and the constant, make easy.
RationalMatrix from_device(const RationalMatrix& to) {
    RationalMatrix m{};
    for (std::size_t k = 0; k < 3; ++k) {
        m[k][k] = Rational(1) / to[k][k];
        m[k][3] = -(to[k][3] / to[k][k]);
    }
    m[3][3] = 1;
    return m;
}

// Whether elimination in double precision finds rows that say the same, each row brought to 1.
bool is_singular(const Matrix16& m) {
    std::array<std::array<double, 4>, 4> a{};
    for (std::size_t i = 0; i < 4; ++i) {
        double largest = 0;
        for (std::size_t j = 0; j < 4; ++j) largest = std::max(largest, std::abs(m[4 * i + j]));
        if (largest == 0) return true;
        for (std::size_t j = 0; j < 4; ++j) a[i][j] = m[4 * i + j] / largest;
    }
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < 4; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        if (std::abs(a[pivot][k]) < 1e-15) return true;
        std::swap(a[k], a[pivot]);
        for (std::size_t i = k + 1; i < 4; ++i)
            for (std::size_t j = 4; j-- > k;) a[i][j] -= a[k][j] * a[i][k] / a[k][k];
    }
    return false;
}

}  // namespace

std::span<const Convention> conventions() { return known_conventions; }
std::span<const DepthFormat> depth_formats() { return known_formats; }

const Convention* find_convention(std::string_view name) {
    for (const Convention& c : known_conventions)
        if (c.name == name) return &c;
    return nullptr;
}

const DepthFormat* find_depth_format(std::string_view name) {
    for (const DepthFormat& f : known_formats)
        if (f.name == name) return &f;
    return nullptr;
}

std::string names_of_depth_formats() {
    std::string names;
    for (const DepthFormat& f : known_formats)
        names += (names.empty() ? "" : ", ") + std::string(f.name);
    return names;
}

std::int64_t far_code(const DepthFormat& format, const hw::MachineSpec& spec) {
    return (std::int64_t{1} << spec.z_bits) - (format.unorm_bits > 0 ? 1 : 0);
}

RationalMatrix screen_to_screen(const Matrix16& m, const Convention& c, const DepthFormat& format,
                                Sides observer, Sides light, const hw::MachineSpec& spec,
                                std::int64_t bias_q16) {
    const RationalMatrix before = to_device(observer, c, format, spec);
    const RationalMatrix after = from_device(to_device(light, c, format, spec));
    RationalMatrix whole = raster::multiply(raster::multiply(after, exact_of(m, c)), before);
    const Rational quantum = Rational(spec.half_px()) / Rational(spec.depth_offset());
    const Rational bias = Rational(bias_q16, std::int64_t{1} << 16) * quantum;
    for (std::size_t j = 0; j < 4; ++j) whole[2][j] -= bias * whole[3][j];
    return whole;
}

std::string wrong_with(const Matrix16& m, const Convention& c) {
    for (std::size_t at = 0; at < m.size(); ++at) {
        if (!std::isfinite(m[at]))
            return fmt::format("its number {} of 16 is {}; give finite numbers", at + 1, m[at]);
        if (std::abs(m[at]) >= std::ldexp(1, most_bit))
            return fmt::format("its number {} of 16, {:g}, is 2^{} or more; divide all 16 by one "
                               "number, which changes no place", at + 1, m[at], most_bit);
    }
    if (std::all_of(m.begin(), m.end(), [](double v) { return v == 0; }))
        return "all of its 16 numbers are 0; give the light's view-projection times the inverse "
               "of the observer's";
    const std::size_t step = c.row_vectors ? 4 : 1, w = c.row_vectors ? 3 : 12;
    if (m[w] == 0 && m[w + step] == 0 && m[w + 2 * step] == 0 && m[w + 3 * step] == 0)
        return fmt::format("its row of w is 0, so that nothing can be divided by it; give "
                           "--vectors {} if it is meant for such vectors",
                           c.row_vectors ? "column" : "row");
    if (is_singular(m))
        return "it is singular: it takes the whole picture to one plane, or less; give the light's "
               "view-projection times the inverse of the observer's";
    return "";
}

}  // namespace umbra78::tools::captured
