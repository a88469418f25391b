// The matrix for the AP-120B, and the pass in its arithmetic: every operation is Float38's, which
// rounds each result once.
#include "shadow/ap120b/post_process.hpp"

namespace umbra78::shadow {
namespace {

using fixed::Float38;
using hw::Rational;
using hw::ap120b::Matrix;
using hw::ap120b::Vector;

constexpr Float38 whole(std::int64_t v) { return Float38::from_scaled(v, 0); }

// 2^n, exactly.
Rational power_of_two(int n) {
    const Rational p(std::int64_t{1} << (n < 0 ? -n : n));
    return n < 0 ? Rational(1) / p : p;
}

int texel_of(const Float38& v) { return v.fix(16, fixed::Rounding::to_zero); }

// Interpolates from a to b.
Float38 between(const Float38& a, const Float38& b, const Float38& fraction) {
    return a + fraction * (b - a);
}

template <class Depth>
bool nearest(const LightMap<Depth>& map, const Float38& x, const Float38& y, const Float38& k) {
    return k > whole(map.texel(texel_of(x), texel_of(y)));
}

// Half a texel to the right and below, a texel's number is that of the cell's lower right corner:
// so nothing is negative, and toward zero is the floor.
template <class Depth>
bool bilinear(const LightMap<Depth>& map, const Float38& x, const Float38& y, const Float38& k) {
    constexpr Float38 half = Float38::from_scaled(1, -1);
    const Float38 cx = x + half, cy = y + half;
    const int tx = texel_of(cx), ty = texel_of(cy);
    const Float38 fx = cx - whole(tx), fy = cy - whole(ty);
    const FourCodes z = map.four(tx - 1, ty - 1);
    if (falls_back(map.spec, map.background, z)) return nearest(map, x, y, k);
    const Float38 upper = between(whole(z[0]), whole(z[1]), fx);
    const Float38 lower = between(whole(z[2]), whole(z[3]), fx);
    return k > between(upper, lower, fy);
}

}  // namespace

Matrix array_matrix(const hw::RationalMatrix& exact, const ShadowTest& settings) {
    const hw::MachineSpec& spec = settings.machine;
    const bool affine =
        exact[3][0].is_zero() && exact[3][1].is_zero() && exact[3][2].is_zero();
    const Rational half(spec.half_px());
    const Rational centre = settings.registration == Registration::centre ? Rational(1, 2) : 0;
    const Rational quanta = power_of_two(spec.depth_fraction());  // a pixel has so many
    // Columns: from (px, py, code - 2^(b-1), 1) to pixels from the cube's centre.
    hw::RationalMatrix m = exact;
    for (auto& row : m) {
        if (affine)
            for (Rational& c : row) c = c / exact[3][3];
        row[3] += (row[0] + row[1]) * (centre - half);
        row[2] = row[2] / quanta;
    }
    // Rows: to texels from the map's corner and to codes.
    Matrix words{};
    for (std::size_t j = 0; j < 4; ++j) {
        const Rational w = m[3][j];
        words[0][j] = Float38::from_rational(m[0][j] + half * w);
        words[1][j] = Float38::from_rational(m[1][j] + half * w);
        words[2][j] = Float38::from_rational(m[2][j] * quanta + Rational(spec.depth_offset()) * w);
        words[3][j] = Float38::from_rational(w);
    }
    return words;
}

template <class Depth>
bool array_in_shadow(const LightMap<Depth>& map, Vector p, bool affine,
                     const hw::DitherWords& d) {
    auto& [x, y, k, w] = p;
    if (!affine) {
        if (w <= Float38()) return false;
        x = x / w;
        y = y / w;
        k = k / w;
    }
    x = x + Float38::from_scaled(d.x, -map.spec.fraction_bits);
    y = y + Float38::from_scaled(d.y, -map.spec.fraction_bits);
    const Float38 edge = whole(map.spec.size_px());
    if (x < Float38() || x >= edge || y < Float38() || y >= edge) return false;
    if (k < Float38() || k > whole(map.spec.deepest_drawn())) return false;
    return map.lookup == Lookup::nearest ? nearest(map, x, y, k) : bilinear(map, x, y, k);
}

template <class Depth>
PostProcessCounts array_post_process(const DepthMaps<Depth>& maps, const Matrix& matrix,
                                     bool affine, const ShadowTest& test,
                                     std::span<std::uint8_t> mask, hw::Band band) {
    const hw::MachineSpec& spec = test.machine;
    check(maps, spec, mask);
    fixed::require(!has_window(test.lookup), "AP-120B: it looks up one texel or four, no window");
    fixed::require(test.receiver == Receiver::point,
                   "AP-120B: it takes no receiver's plane or normal");
    fixed::require(spec.z_bits <= 16, "AP-120B: its host sends Z codes of up to 16 bits");
    const hw::FrameStore<const Depth>& observer = maps.observer;
    const LightMap<Depth> map = light_map(maps.light, test);
    const bool dithered = !hw::silent(test.dither, spec);
    PostProcessCounts counts;
    band = band.within(spec.size_px());
    for (int y = band.first; y < band.end; ++y) {
        hw::NoiseSource noise(drawn_dither(test), spec, 0, y);
        const std::uint64_t before = counts.visible;
        for (int x = 0; x < spec.size_px(); ++x) {
            const hw::DitherWords d = dithered ? noise.next() : hw::DitherWords{0, 0};
            const std::size_t a = observer.address(x, y);
            const std::uint32_t code = observer.depth[a];
            mask[a] = mask_lit;
            if (code == spec.background()) continue;
            ++counts.visible;
            const Vector p = hw::ap120b::times(matrix, array_words(x, y, code, spec));
            if (!array_in_shadow(map, p, affine, d)) continue;
            ++counts.shadowed;
            mask[a] = mask_shadow;
        }
        counts.lines += counts.visible != before;
    }
    return counts;
}

#define UMBRA78_ARRAY(Depth)                                                                      \
    template bool array_in_shadow(const LightMap<Depth>&, Vector, bool, const hw::DitherWords&);  \
    template PostProcessCounts array_post_process(const DepthMaps<Depth>&, const Matrix&, bool,   \
                                                  const ShadowTest&, std::span<std::uint8_t>,   \
                                                  hw::Band);
UMBRA78_ARRAY(hw::Depth16)
UMBRA78_ARRAY(hw::Depth32)
#undef UMBRA78_ARRAY

}  // namespace umbra78::shadow
