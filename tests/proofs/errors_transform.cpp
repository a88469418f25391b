// Worst errors of the transform unit's stages, by the production code on adversarial words.
#include "fixed/divide.hpp"
#include "fixed/dither.hpp"
#include "hw/ap120b/transform.hpp"
#include "hw/transform_unit.hpp"
#include "tests/proofs/search.hpp"

namespace umbra78::proofs {
namespace {

constexpr std::int32_t one = 1 << 14;

hw::MatrixWords x_row(const std::array<std::int32_t, 4>& c, int exponent = 0) {
    hw::MatrixWords m;
    m.word = {{c, c, c, {0, 0, 0, 1 << 14}}};
    m.exponent = {exponent, exponent, exponent, 0};
    return m;
}

std::int32_t word16(Words& words) { return static_cast<std::int32_t>(words.word(16)); }

Wide exact_sum(const std::array<std::int32_t, 4>& c, const hw::Words& v) {
    return Wide{c[0]} * v.x + Wide{c[1]} * v.y + Wide{c[2]} * v.z + Wide{c[3]} * one;
}

Given given(const std::array<std::int32_t, 4>& c, const hw::Words& v) {
    return {c[0], c[1], c[2], c[3], v.x, v.y, v.z};
}

// Against the exact sum: one rounding, and cut products.
void sums(Words& words) {
    Worst once("sum_once"), cut("sum_cut"), near("sum_cut_near");
    hw::MachineSpec narrow;
    narrow.max_accumulator_bits = 22;
    for (int k = 0; k < 300'000; ++k) {
        const std::array<std::int32_t, 4> c{word16(words), word16(words), word16(words),
                                            word16(words)};
        hw::Words v{word16(words), word16(words), word16(words)};
        const Wide exact = exact_sum(c, v);
        once.add(ratio(Wide{hw::TransformUnit({}, x_row(c))(v).x} * one - exact, one),
                 given(c, v));
        // Words with c v = -1 modulo 2^13 lose the most.
        std::array<std::int32_t, 4> d = c;
        const auto against = [&](std::int32_t& coefficient, std::int32_t& word) {
            coefficient |= 1;
            std::int32_t inverse = coefficient;
            for (int i = 0; i < 4; ++i) inverse *= 2 - coefficient * inverse;
            word = static_cast<std::int16_t>((word & ~0x1fff) | (-inverse & 0x1fff));
        };
        against(d[0], v.x), against(d[1], v.y), against(d[2], v.z);
        narrow.product_rounding = fixed::Rounding::floor;
        cut.add(ratio(Wide{hw::TransformUnit(narrow, x_row(d))(v).x} * one - exact_sum(d, v), one),
                given(d, v));
        // And with c v at a half of 2^13, where all three round up.
        for (std::int32_t* word : {&v.x, &v.y, &v.z})
            *word = static_cast<std::int16_t>((*word & ~0x1fff) | 0x1000);
        narrow.product_rounding = fixed::Rounding::half_up;
        near.add(ratio(Wide{hw::TransformUnit(narrow, x_row(d))(v).x} * one - exact_sum(d, v),
                       one), given(d, v));
    }
}

// Against a matrix whose coefficients lie half a word from the words, to the worse side.
void rounded_words(Words& words) {
    for (int e = -4; e <= 4; ++e) {
        Worst worst("affine_words_" + std::to_string(e));
        const double per_lsb = static_cast<double>(1 << (14 - e));
        for (int k = 0; k < 100'000; ++k) {
            const std::array<std::int32_t, 4> c{word16(words), word16(words), word16(words),
                                                word16(words)};
            hw::Words v{word16(words), word16(words), word16(words)};
            if (words.bits() % 2 == 0) v = {-32768, -32768, -32768};
            const Wide acc = exact_sum(c, v);
            const Wide out = hw::TransformUnit({}, x_row(c, e))(v).x;
            const auto size = [](Wide a) { return static_cast<double>(a < 0 ? -a : a); };
            const double half = (size(v.x) + size(v.y) + size(v.z) + one) / 2;
            worst.add((size(out * (Wide{1} << (14 - e)) - acc) + half) / per_lsb, given(c, v));
        }
    }
    Worst bias("bias");
    for (int k = 0; k < 100'000; ++k) {
        const std::array<std::int32_t, 4> c{word16(words), 0, 0, word16(words)};
        const hw::Words v{word16(words), 0, 0};
        const double left = ratio(Wide{hw::TransformUnit({}, x_row(c))(v).z} * one -
                                      exact_sum(c, v), one);
        bias.add((left < 0 ? -left : left) + 0.5, given(c, v));
    }
}

hw::MatrixWords perspective() {
    hw::MatrixWords m;
    m.affine = false;
    m.word[3] = {1, 0, 0, 1};
    return m;
}

// The quotient against X / W, in 2^-7.
double quotient_error(Wide q, double x, double w) {
    return static_cast<double>(static_cast<long double>(q) -
                               128.0L * static_cast<long double>(x) / static_cast<long double>(w));
}

void divides(Words& words) {
    hw::MachineSpec first;
    first.divide_order = hw::DivideOrder::round_first;
    const hw::TransformUnit rounding_first(first, perspective()), exact({}, perspective());
    for (int j = 7; j <= 20; ++j) {
        Worst worst("divide_first_" + std::to_string(j));
        for (int k = 0; k < 100'000; ++k) {
            // W just above a half, so that it is rounded up; X just below one, or the other way.
            const std::int64_t w = words.number(1 << j, (1 << j) + (1 << j) / 64);
            const std::int64_t q = words.number(65000, 65535);
            const bool up = words.bits() % 2 == 0;
            const std::int64_t x = ((2 * q + 1) * w + (up ? -1 : 255)) / 256;  // about a tie
            const std::int64_t acc_w = w * one + (up ? -one / 2 : one / 2 - 1);
            const std::int64_t acc_x = x * one + (up ? one / 2 - 1 : -one / 2);
            if (2 * acc_w < (std::int64_t{2} << j) * one + one) continue;  // w from 2^j + 1/2 on
            const hw::Point p = rounding_first.quotients({acc_x, 0, 0, acc_w});
            if (p.status != hw::DivideStatus::ok) continue;
            worst.add(quotient_error(p.x, static_cast<double>(acc_x), static_cast<double>(acc_w)),
                      {acc_x, acc_w});
        }
    }
    Worst once("divide_exact");
    for (int k = 0; k < 300'000; ++k) {
        const std::int64_t w = words.word(34) & INT64_MAX, x = words.word(34);
        const hw::Point p = exact.quotients({x, 0, 0, w});
        if (p.status != hw::DivideStatus::ok) continue;
        once.add(ratio(Wide{p.x} * w - Wide{x} * 128, w), {x, w});
    }
    for (int j = 24; j <= 31; ++j) {
        Worst worst("divide_words_" + std::to_string(j));
        constexpr std::int64_t off = 57344;  // half of each word's magnitude
        for (int k = 0; k < 100'000; ++k) {
            const std::int64_t least = (std::int64_t{1} << j) + off;
            const std::int64_t w = least + words.number(0, 1 << (j - 8));
            const std::int64_t q = words.number(65000, 65535);
            const std::int64_t x = ((2 * q + 1) * w - 1) / 256;  // just below a tie
            const hw::Point p = exact.quotients({x, 0, 0, w});
            if (p.status != hw::DivideStatus::ok) continue;
            worst.add(quotient_error(p.x, static_cast<double>(x + off),
                                     static_cast<double>(w - off)), {x, w});
        }
    }
}

void dither(Words& words) {
    Worst worst("dither");
    for (int k = 0; k < 300'000; ++k) {
        const int n = words.number(1, 12), sum = words.number(0, 255 * n);
        const auto amplitude = static_cast<std::int32_t>(words.word(24));
        const Wide exact = (Wide{2} * sum - Wide{255} * n) * amplitude;
        worst.add(ratio(Wide{fixed::dither_word(sum, n, amplitude)} * 65536 - exact, 65536),
                  {sum, n, amplitude});
    }
}

// A coefficient's odd mantissa of 27 bits whose product with a word of 15 bits lies just beside a
// half of what is rounded off.
fixed::Float38 beside_half(Words& words, std::uint32_t word, bool above) {
    std::uint32_t inverse = word;
    for (int i = 0; i < 4; ++i) inverse *= 2 - word * inverse;
    const std::uint32_t low = (inverse * ((1u << 14) + (above ? 1 : -1))) & 0x7fff;
    return fixed::Float38::from_parts(words.number(0xf00, 0xfff) << 15 | static_cast<int>(low),
                                      512);
}

void array_rows(Words& words) {
    Worst worst("array_row");
    using hw::ap120b::Vector;
    for (int k = 0; k < 300'000; ++k) {
        const bool above = words.bits() % 2 == 0;
        std::array<std::int32_t, 3> v{};
        hw::ap120b::Matrix m{};
        Vector in{};
        in[3] = fixed::Float38::from_host(1).normalised();
        Given given;
        Wide exact = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            v[j] = 2 * words.number(16000, 16383) + 1;
            in[j] = fixed::Float38::from_host(static_cast<std::int16_t>(v[j])).normalised();
            m[0][j] = beside_half(words, static_cast<std::uint32_t>(v[j]), above);
            exact += Wide{m[0][j].mantissa()} * v[j];
            given.insert(given.end(), {m[0][j].mantissa(), v[j]});
        }
        m[0][3] = fixed::Float38::from_parts(words.number(1 << 26, (1 << 27) - 1), 512);
        exact += m[0][3].mantissa();
        given.push_back(m[0][3].mantissa());
        const fixed::Float38 out = hw::ap120b::times(m, in)[0];
        // Its last bit counts 2^-27 2^(exponent - 512) of a word, exact's 2^-27.
        const Wide of_out = Wide{out.mantissa()} << (out.biased_exponent() - 512);
        worst.add(ratio(of_out - exact, Wide{1} << 27), given);
    }
}

}  // namespace

void transform_errors() {
    Words words;
    sums(words);
    rounded_words(words);
    divides(words);
    dither(words);
    array_rows(words);
}

}  // namespace umbra78::proofs
