// Holds the models that the solvers are asked about to the code: the same function of the same
// words, on half a million boundary-weighted draws each.
#include "fixed/divide.hpp"
#include "fixed/overflow.hpp"
#include "hw/clocked/divider.hpp"
#include "hw/machine_spec.hpp"
#include "models.hpp"
#include "raster/block.hpp"
#include "raster/sampling.hpp"
#include "shadow/rivals/planes.hpp"
#include "tests/proofs/proofs.hpp"

#include <array>

namespace umbra78::proofs {
namespace {

constexpr int draws = 500'000;
constexpr Bits bits64(std::int64_t v) { return static_cast<std::uint64_t>(v); }
constexpr Wide signed64(Bits v) { return static_cast<std::int64_t>(static_cast<std::uint64_t>(v)); }
// A planted fault takes half up for half away.
Bits number(fixed::Rounding r) {
    return planted && r == fixed::Rounding::half_up ? 5 : static_cast<Bits>(r);
}

bool rounding_agrees(Words& words) {
    Verdict v("rounding");
    for (int k = 0; k < draws; ++k) {
        const std::int64_t word = words.word();
        const int n = words.number(0, 62), far = words.number(63, 72);
        const fixed::Rounding r = words.rounding();
        const Given in{word, n, far, static_cast<Wide>(r)};
        v.equal(signed64(rounding::round_shift(bits64(word), bits64(n), number(r))),
                fixed::round_shift(word, n, r), in);
        v.equal(signed64(rounding::far_shift(bits64(word), bits64(far), number(r))),
                fixed::scale_shift(word, far, r), in);
        v.equal(signed64(rounding::far_shift(bits64(word), bits64(far + 100), number(r))),
                fixed::scale_shift(word, far + 100, r), in);
    }
    return v.tell();
}

bool overflow_agrees(Words& words) {
    Verdict v("overflow");
    for (int k = 0; k < draws; ++k) {
        const std::int64_t word = words.word();
        const int n = words.number(1, 64);
        const Given in{word, n};
        const Bits w = bits64(word), b = bits64(n);
        v.equal(signed64(overflow::wrap(w, b)), fixed::wrap(word, n), in);
        v.equal(overflow::fits(w, b), fixed::fits(word, n), in);
        v.equal(signed64(overflow::saturate(w, b)), fixed::saturate(word, n), in);
        v.equal(signed64(overflow::saturate_symmetric(w, b)), fixed::saturate_symmetric(word, n),
                in);
        v.equal(signed64(overflow::min_signed(b)), fixed::min_signed(n), in);
    }
    return v.tell();
}

// The clocked divider's registers: a point's X through serial division.
fixed::Quotient clocked(const hw::MachineSpec& spec, std::int64_t num, std::int64_t den, int& shift,
                        int exponent) {
    hw::MatrixWords m;
    m.affine = false;
    m.exponent = {exponent, 0, 0, 0};
    const hw::DividePipeline plan(spec, hw::Timing{}, m);
    shift = plan.shift(0);
    hw::DividerRegisters registers;
    registers.load({num, 0, 0, den});
    for (int k = 0; k < plan.latency(); ++k) registers.step(plan, k);
    return registers.row[0].result;
}

// The same from the model's base, step and correction.
Wide model_divide(std::int64_t num, std::int64_t den, int shift, int bits, fixed::Rounding r) {
    const Bits magnitude = fixed::magnitude(num), d = bits64(den);
    const int up = shift - bits;
    Bits rem = up >= 0 ? magnitude << up : up < -63 ? 0 : magnitude >> -up, quotient = 0;
    for (int i = bits; i >= 0; --i) {
        const Bits bit = restoring::dividend_bit(magnitude, bits64(i - shift - 1));
        quotient = quotient << 1 | restoring::quotient_bit(rem, bit, d);
        rem = restoring::next_remainder(rem, bit, d);
    }
    const int dropped = -shift - 1;
    const bool lost = dropped > 0 && cut(magnitude << (64 - dropped), 64) != 0;
    return quotient::corrected(num < 0, static_cast<Wide>(quotient), rem != 0 || lost,
                               static_cast<Wide>(r));
}

bool divider_agrees(Words& words) {
    Verdict v("restoring and corrected");
    for (int k = 0; k < draws / 4; ++k) {
        hw::MachineSpec spec;
        spec.transform_rounding = words.rounding();
        const std::int64_t num = words.word(words.number(2, 60));
        const std::int64_t den = words.number(0, 1) == 0 ? words.number(1, 1 << 20)
                                                          : words.word(60) & INT64_MAX;
        if (den == 0) continue;
        int shift = 0;
        const fixed::Quotient is = clocked(spec, num, den, shift, words.number(-40, 20));
        const int bits = spec.xy_bits + spec.fraction_bits + 1;
        const Given in{num, den, shift, bits, static_cast<Wide>(spec.transform_rounding)};
        const fixed::Quotient wanted =
            fixed::divide(num, den, shift, bits, spec.transform_rounding);
        v.equal(is.value, wanted.value, in);
        if (wanted.status != fixed::DivideStatus::ok) continue;
        v.equal(is.value, model_divide(num, den, shift, bits, spec.transform_rounding), in);
    }
    return v.tell();
}

bool quotient_agrees(Words& words) {
    Verdict v("quotient");
    for (int k = 0; k < draws; ++k) {
        const std::int64_t num = words.word(), den = words.word();
        const fixed::Rounding r = words.rounding();
        const Given in{num, den, static_cast<Wide>(r)};
        if (den == 0 || (den == -1 && num == INT64_MIN)) continue;
        v.equal(quotient::divide_rounded(num, den, num / den, num % den, static_cast<Wide>(r)),
                fixed::round_divide(num, den, r), in);
        const int shift = words.number(0, 62);
        const Bits whole = Bits{fixed::magnitude(num)} << shift;
        if (den < 0 || whole / bits64(den) > Bits{1} << 61) continue;
        v.equal(quotient::signed_rounded(num < 0, static_cast<Wide>(whole / bits64(den)),
                                         static_cast<Wide>(whole % bits64(den)), den,
                                         static_cast<Wide>(r)),
                fixed::divide(num, den, shift, 63, r).value, in);
    }
    return v.tell();
}

// divide_wide's digit as wide_divide.smt2 has it.
Bits model_digit(Bits& upper, Bits next, Bits d) {
    const Bits d1 = d >> 32, d0 = d & 0xffffffff;
    Bits digit = upper / d1, rest = upper % d1;
    while (wide_divide::too_great(static_cast<Wide>(rest), static_cast<Wide>(next),
                                  static_cast<Wide>(digit * d0))) {
        --digit;
        rest += d1;
    }
    upper = (upper << 32 | next) - digit * d;
    return digit;
}

bool wide_divide_agrees(Words& words) {
    Verdict v("wide_divide");
    for (int k = 0; k < draws; ++k) {
        const Bits d = bits64(words.word()) | Bits{1} << 63;
        Bits upper = bits64(words.word()) % d;
        const std::uint64_t low = static_cast<std::uint64_t>(words.word());
        const auto is = fixed::divide_wide({static_cast<std::uint64_t>(upper), low},
                                           static_cast<std::uint64_t>(d));
        const Given in{static_cast<Wide>(upper), Wide{low}, static_cast<Wide>(d)};
        const Bits first = model_digit(upper, low >> 32, d);
        const Bits second = model_digit(upper, low & 0xffffffff, d);
        v.equal(static_cast<Wide>(first << 32 | second), Wide{is.quotient}, in);
        v.equal(static_cast<Wide>(upper), Wide{is.remainder}, in);
    }
    return v.tell();
}

bool accumulators_agree() {
    Verdict v("accumulators");
    for (int xy = 4; xy <= 12; ++xy)
        for (int z = 4; z <= 24; ++z)
            for (int c = 8; c <= 32; ++c)
                for (int most = 16; most <= 64; ++most) {
                    hw::MachineSpec m;
                    m.xy_bits = xy, m.z_bits = z, m.coefficient_bits = c;
                    m.max_accumulator_bits = most;
                    const auto b = [](int n) { return cut(static_cast<Bits>(Wide{n}), 80); };
                    const Given in{xy, z, c, most};
                    v.equal(as_signed(accumulators::spec_word_bits(b(xy), b(z)), 80),
                            m.word_bits(), in);
                    v.equal(as_signed(accumulators::accumulator_bits(b(xy), b(z), b(c)), 80),
                            m.accumulator_bits(), in);
                    v.equal(as_signed(accumulators::dropped_bits(b(xy), b(z), b(c), b(most)), 80),
                            m.dropped_bits(), in);
                }
    return v.tell();
}

// The row's lanes, and a leaf's weights, as their texts have them.
bool forms_agree(Words& words) {
    Verdict v("row_forms and centre_forms");
    for (int k = 0; k < draws; ++k) {
        const std::int64_t a = words.word(33), b = words.word(33);
        const int s = words.number(6, 28);
        const auto p = static_cast<std::int32_t>(words.word(31));
        const std::int64_t low = std::int64_t{1} << s;
        const auto part = [&](std::int64_t x) { return static_cast<std::int32_t>(x & (low - 1)); };
        const std::int32_t is = static_cast<std::int32_t>(fixed::floor_shift(a, s)) +
                                static_cast<std::int32_t>(fixed::floor_shift(b, s)) +
                                fixed::floor_shift(part(a) + part(b) + p, s);
        const Given in{a, b, p, s};
        v.equal(as_signed(row_forms::split_result(bits64(a), bits64(b),
                                                  static_cast<std::uint32_t>(p), bits64(s)), 32),
                is, in);
        std::array<std::int32_t, 6> c{};
        for (std::int32_t& x : c) x = static_cast<std::int32_t>(words.word(13));
        v.equal(centre_forms::edge(c[0], c[1], c[2], c[3], c[4], c[5]),
                raster::detail::turn({c[0], c[1], 0}, {c[2], c[3], 0}, c[4], c[5]), in);
    }
    return v.tell();
}

// A stage of words.txt against what the code makes of the same inputs.
template <class Stage, class Code>
bool stage_agrees(const char* name, Words& words, Code&& code) {
    Verdict v(name);
    std::array<Wide, Stage::inputs> in{};
    for (int k = 0; k < draws / 4; ++k) {
        for (int i = 0; i < Stage::inputs; ++i)
            in[std::size_t(i)] = words.between(Stage::range[i].low, Stage::range[i].high);
        const std::vector<Wide> model = Stage::model(in.data()), is = code(in.data());
        for (std::size_t i = 0; i < model.size(); ++i) v.equal(is[i], model[i], in);
    }
    return v.tell();
}

std::int32_t w32(Wide v) { return static_cast<std::int32_t>(v); }
std::int64_t w64(Wide v) { return static_cast<std::int64_t>(v); }

bool stages_agree(Words& words) {
    bool all = true;
    const auto stage = [&](bool ok) { all = all && ok; };
    stage(stage_agrees<stages::pixels_32>("pixels_32", words, [](const Wide* in) {
        return Given{raster::first_pixel(w32(in[0]), 8), raster::last_pixel(w32(in[0]), 8)};
    }));
    stage(stage_agrees<stages::halve_32>("halve_32", words, [](const Wide* in) {
        const raster::Halves h = raster::halve(w64(in[0]), w64(in[1]), w64(in[2]), w64(in[3]));
        return Given{h.f_mid, h.g_mid, h.g0};
    }));
    stage(stage_agrees<stages::leaf_mean_32>("leaf_mean_32", words, [](const Wide* in) {
        return Given{raster::half_up<std::int64_t>(w64(in[0] + in[1] + in[2] + in[3]), 2)};
    }));
    stage(stage_agrees<stages::bezier_64>("bezier_64", words, [](const Wide* in) {
        std::array<std::int64_t, 16> p{};
        for (std::size_t k = 0; k < 9; ++k) p[k / 3 + 4 * (k % 3)] = w64(in[k]);
        const raster::Component c = raster::component_from_bezier(p);
        return Given{c.gv[0], c.guv[0]};
    }));
    stage(stage_agrees<stages::edge_64>("edge_64", words, [](const Wide* in) {
        return Given{raster::detail::turn({w32(in[0]), w32(in[1]), 0}, {w32(in[2]), w32(in[3]), 0},
                                          w64(in[4]), w64(in[5]))};
    }));
    stage(stage_agrees<stages::view_axis_64>("view_axis_64", words, [](const Wide* in) {
        const bool tie = ((in[0] * in[1]) & (raster::axis_one - 1)) == raster::axis_one / 2;
        const std::int64_t out = raster::axis_product(w32(in[0]), w32(in[1]));
        const Wide down = (in[0] * in[1]) >> raster::axis_fraction;
        return Given{tie && out == down ? out + 1 : out};
    }));
    stage(stage_agrees<stages::plane_64>("plane_64", words, [](const Wide* in) {
        using shadow::rivals::Point;
        const auto p = [&](int k) { return Point{w32(in[k]), w32(in[k + 1]), w32(in[k + 2])}; };
        return Given{shadow::rivals::plane_of(p(0), p(3), p(6)).n[2]};
    }));
    stage(stage_agrees<stages::plane_through_64>("plane_through_64", words, [](const Wide* in) {
        const shadow::rivals::Centre o{w32(in[0]), w32(in[1]), 0, w32(in[6])};
        return Given{shadow::rivals::plane_through(o, {w32(in[2]), w32(in[3]), 0},
                                                   {w32(in[4]), w32(in[5]), 0})
                         .n[2]};
    }));
    return all;
}

}  // namespace

bool agree() {
    Words words;
    bool all = rounding_agrees(words);
    all = overflow_agrees(words) && all;
    all = divider_agrees(words) && all;
    all = quotient_agrees(words) && all;
    all = wide_divide_agrees(words) && all;
    all = accumulators_agree() && all;
    all = forms_agree(words) && all;
    return stages_agree(words) && all;
}

}  // namespace umbra78::proofs
