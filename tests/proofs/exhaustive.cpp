// The arithmetic at widths small enough to try everything, by the production templates: rounding,
// the two dividers, and a whole transform and comparison. The definitions beside them are written
// with whole quotients alone.
#include "fixed/divide.hpp"
#include "hw/clocked/divider.hpp"
#include "shadow/compare.hpp"
#include "tests/proofs/proofs.hpp"

#include <array>
#include <vector>

namespace umbra78::proofs {
namespace {

using fixed::Rounding;

// num / den rounded, den > 0, from the floor and the rest; `planted` takes ties the wrong way.
Wide rounded(Wide num, Wide den, Rounding r) {
    const Wide floor = floor_divide(num, den), rest = num - floor * den;
    const bool half = 2 * rest == den, above = 2 * rest > den;
    switch (r) {
        case Rounding::floor: return floor;
        case Rounding::ceiling: return floor + (rest > 0);
        case Rounding::to_zero: return floor + (rest > 0 && num < 0);
        case Rounding::half_up: return floor + (above || (half && !planted));
        case Rounding::half_to_zero: return floor + (above || (half && num < 0));
        case Rounding::half_away: return floor + (above || (half && num > 0));
        case Rounding::half_even: return floor + (above || (half && floor_modulo(floor, 2) == 1));
    }
    return 0;
}

bool roundings_hold() {
    Verdict v("rounding of 12 bits by every shift, and their quotients");
    for (const Rounding r : roundings)
        for (int word = -2048; word < 2048; ++word) {
            for (int n = 0; n <= 62; ++n)
                v.equal(fixed::round_shift(word, n, r), rounded(word, Wide{1} << n, r),
                        Given{word, n, Wide(r)});
            for (int n = 63; n <= 80; ++n)
                v.equal(fixed::scale_shift(word, n, r), rounded(word, Wide{1} << n, r),
                        Given{word, n, Wide(r)});
            for (int den = -40; den <= 40; ++den)
                if (den != 0)
                    v.equal(fixed::round_divide(word, den, r),
                            rounded(den < 0 ? -word : word, den < 0 ? -den : den, r),
                            Given{word, den, Wide(r)});
        }
    return v.tell();
}

// A quotient as section 5 of the specification has it.
fixed::Quotient divided(std::int64_t num, std::int64_t den, int shift, int bits, Rounding r) {
    if (den <= 0) return {0, fixed::DivideStatus::divisor_not_positive};
    const Wide up = shift > 0 ? Wide{1} << shift : 1, down = shift < 0 ? Wide{1} << -shift : 1;
    const Wide q = rounded(num * up, den * down, r), half = Wide{1} << (bits - 1);
    if (q < -half) return {static_cast<std::int64_t>(-half), fixed::DivideStatus::overflow};
    if (q >= half) return {static_cast<std::int64_t>(half - 1), fixed::DivideStatus::overflow};
    return {static_cast<std::int64_t>(q), fixed::DivideStatus::ok};
}

// Every dividend of 10 bits and divisor of 7: fixed::divide, and the clocked divider bit by bit.
bool dividers_hold() {
    Verdict v("dividers of 10 bits by 7");
    for (const Rounding r : roundings)
        for (int exponent = -3; exponent <= 4; exponent += exponent < 0 ? 3 : 2) {
            hw::MachineSpec spec;
            spec.xy_bits = 4, spec.fraction_bits = 1, spec.transform_rounding = r;
            hw::MatrixWords m;
            m.affine = false;
            m.exponent = {exponent, 0, 0, 0};
            const hw::DividePipeline plan(spec, hw::Timing{}, m);
            const int shift = plan.shift(0), bits = plan.bits(0);
            for (int num = -512; num < 512; ++num)
                for (int den = -1; den < 64; ++den) {
                    const Given in{num, den, shift, Wide(r)};
                    const fixed::Quotient wanted = divided(num, den, shift, bits, r);
                    const fixed::Quotient is = fixed::divide(num, den, shift, bits, r);
                    v.equal(is.value, wanted.value, in);
                    v.equal(Wide(is.status), Wide(wanted.status), in);
                    hw::DividerRegisters registers;
                    registers.load({num, 0, 0, den});
                    for (int k = 0; k <= plan.last_step(0); ++k) registers.step(plan, k);
                    v.equal(registers.row[0].result.value, wanted.value, in);
                    v.equal(Wide(registers.row[0].result.status), Wide(wanted.status), in);
                }
        }
    return v.tell();
}

// --- a whole transform and comparison ------------------------------------------------------------

// The smallest machine: 16 x 16 pixels, 16 codes, coefficients of 8 bits.
hw::MachineSpec small(int fraction_bits, Rounding r) {
    hw::MachineSpec m;
    m.xy_bits = m.z_bits = 4;
    m.coefficient_bits = 8;
    m.fraction_bits = fraction_bits;
    m.transform_rounding = r;
    return m;
}

constexpr int size = 16;

// A map whose texels differ from each other.
std::array<hw::Depth16, size * size> uneven_map() {
    std::array<hw::Depth16, size * size> map{};
    for (int k = 0; k < size * size; ++k)
        map[std::size_t(k)] = static_cast<hw::Depth16>((7 * k + k / 16 + k * k / 5) % 16);
    return map;
}

struct Rig {
    explicit Rig(const hw::MachineSpec& machine, shadow::Lookup lookup) : spec(machine) {
        test.machine = machine;
        test.lookup = lookup;
        map = shadow::light_map<hw::Depth16>({4, texels}, test);
    }
    hw::MachineSpec spec;
    std::array<hw::Depth16, size * size> texels = uneven_map();
    shadow::ShadowTest test;
    shadow::LightMap<hw::Depth16> map{};
};

// Section 11 from the accumulators on, in whole quotients.
bool in_shadow(const Rig& rig, std::array<Wide, 3> acc, const std::array<int, 4>& exponent,
               bool four) {
    const hw::MachineSpec& m = rig.spec;
    const int f = m.fraction_bits, one = 1 << f;
    std::array<Wide, 3> out{};
    for (std::size_t r = 0; r < 3; ++r) {  // shift = C - 2 + fraction - out - exponent
        const int shift = 6 + 1 - (r < 2 ? f : 0) - exponent[r];
        out[r] = shift > 0 ? rounded(acc[r], Wide{1} << shift, m.transform_rounding)
                           : acc[r] * (Wide{1} << -shift);
    }
    const Wide code = out[2] + 8;
    for (const Wide v : {out[0], out[1]})
        if (v < -8 * one || v >= 8 * one) return false;
    if (code < 0 || code > 14) return false;
    const auto at = [&](Wide x, Wide y) -> Wide {
        if (x < 0 || y < 0 || x >= size || y >= size) return 15;
        return rig.texels[std::size_t(16 * y + x)];
    };
    if (!four || f == 0)
        return code > at(floor_divide(out[0], one) + 8, floor_divide(out[1], one) + 8);
    const Wide x = out[0] - one / 2, y = out[1] - one / 2;
    const Wide tx = floor_divide(x, one) + 8, ty = floor_divide(y, one) + 8;
    const Wide fx = floor_modulo(x, one), fy = floor_modulo(y, one);
    return code * one * one > (one - fy) * ((one - fx) * at(tx, ty) + fx * at(tx + 1, ty)) +
                                  fy * ((one - fx) * at(tx, ty + 1) + fx * at(tx + 1, ty + 1));
}

void compare_point(Verdict& v, const Rig& rig, const hw::MatrixWords& m, const hw::Words& p) {
    std::array<Wide, 3> acc{};
    for (std::size_t r = 0; r < 3; ++r)
        acc[r] = Wide{m.word[r][0]} * p.x + Wide{m.word[r][1]} * p.y + Wide{m.word[r][2]} * p.z +
                 Wide{m.word[r][3]} * 8;
    const bool is =
        shadow::in_shadow(rig.map, hw::TransformUnit(rig.spec, m)(p), hw::DitherWords{0, 0});
    v.equal(is, in_shadow(rig, acc, m.exponent, rig.test.lookup == shadow::Lookup::bilinear),
            Given{m.word[0][0], m.word[0][3], m.word[2][2], m.word[2][3], p.x, p.y, p.z});
}

// Row Z: every c_z and c_1 of 8 bits, every code. Row X: every c_x and c_1, every column.
bool frames_hold() {
    Verdict v("transform and compare, 8-bit coefficients, 16 codes");
    hw::MatrixWords same;  // X, Y and Z as they are: 64 is 1.0
    same.word = {{{64, 0, 0, 0}, {0, 64, 0, 0}, {0, 0, 64, 0}, {0, 0, 0, 64}}};
    for (const shadow::Lookup lookup : {shadow::Lookup::nearest, shadow::Lookup::bilinear})
        for (const Rounding r : roundings)
            for (int f = 0; f <= 2; f += 2) {
                const Rig rig(small(f, r), lookup);
                const int step = r == Rounding::half_up ? 1 : 5;
                for (int a = -128; a < 128; ++a)
                    for (int b = -128; b < 128; b += step) {
                        hw::MatrixWords z = same, x = same;
                        z.word[2] = {0, 0, a, b};
                        z.exponent[2] = (a + b) & 1;
                        x.word[0] = {a, 0, 3, b};
                        x.exponent[0] = -((a + b) & 1);
                        for (int k = 0; k < 15; ++k) {
                            compare_point(v, rig, z, {2 * k - 15, 5, 2 * (k - 8)});
                            compare_point(v, rig, x, {2 * k - 15, 2 * (k % 7) - 7, k - 7});
                        }
                    }
            }
    return v.tell();
}

}  // namespace

bool exhaustive() {
    bool all = roundings_hold();
    all = dividers_hold() && all;
    return frames_hold() && all;
}

}  // namespace umbra78::proofs
