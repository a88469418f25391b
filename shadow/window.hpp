// The window of texels that a lookup reads: which they are, and in what order they are fetched.
//
//   grid       first = floor((2 X' - (k - 1) 2^F) / 2^(F+1)) + half_px,  taps first + 0 .. k - 1
//   jittered   tap i = floor((512 X' + (512 i - 256 k + 2 u + 1) 2^F) / 2^(F+9)) + half_px
//   darkness   half_up(255 count / k^2)                                         (Y alike)
//
// k taps a side: 1 of nearest lookup, 2 of bilinear lookup, 2 to 5 of the others. A grid's taps are
// the k x k texels whose middle lies nearest to the point. Jittered, a tap lies in its own cell of
// a texel's size, at u (0..255) and a half 256ths of it. Taps are numbered row by row. A tap may
// lie outside the map, where it reads background: -3 .. size_px + 2.
// In, and exactly where: shadow/light_place.hpp; hw/MACHINE.md, sections 10, 11 and 16.
#pragma once

#include "shadow/light_place.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace umbra78::shadow {

inline constexpr int max_taps_a_side = 5;
static_assert(max_taps_a_side * max_taps_a_side == hw::max_taps);

struct Window {
    int side = 1;
    bool jittered = false;

    constexpr int taps() const { return side * side; }
    // Taps that noise is drawn for.
    constexpr int noisy_taps() const { return jittered ? taps() : 0; }
};

constexpr bool window_in_range(const ShadowTest& test) {
    return !has_window(test.lookup) || (test.taps >= 2 && test.taps <= max_taps_a_side);
}

constexpr Window window_of(const ShadowTest& test) {
    if (hw::built(hw::Feature::windows) && has_window(test.lookup))
        return {test.taps, test.tap_places == TapPlaces::jittered};
    return {interpolates(test.machine, test.lookup) ? 2 : 1, false};
}

// --- the taps' texels ---------------------------------------------------------------------------

struct Texel {
    int x, y;
    constexpr bool operator==(const Texel&) const = default;
};

// X or Y of a point; so is what follows.
constexpr std::int32_t first_texel(const hw::MachineSpec& spec, const Window& w, std::int64_t v) {
    const int f = spec.fraction_bits;
    const std::int64_t before = (w.side - 1) * (std::int64_t{1} << f);
    return static_cast<std::int32_t>(fixed::floor_shift(2 * v - before, f + 1)) + spec.half_px();
}
constexpr std::int32_t jittered_texel(const hw::MachineSpec& spec, const Window& w, int i,
                                      std::uint8_t byte, std::int64_t v) {
    const int f = spec.fraction_bits;
    const std::int64_t off = (512 * i - 256 * w.side + 2 * byte + 1) * (std::int64_t{1} << f);
    return static_cast<std::int32_t>(fixed::floor_shift(512 * v + off, f + 9)) + spec.half_px();
}

// Tap t of a point inside the volume. `noise` is the place's; a grid does not read it.
constexpr Texel tap_texel(const hw::MachineSpec& spec, const Window& w, int t,
                          const LightPlace& at, const hw::TapBytes& noise) {
    const int i = t % w.side, j = t / w.side;
    if (!w.jittered) return {first_texel(spec, w, at.x) + i, first_texel(spec, w, at.y) + j};
    const auto k = static_cast<std::size_t>(t);
    return {jittered_texel(spec, w, i, noise.x[k], at.x),
            jittered_texel(spec, w, j, noise.y[k], at.y)};
}

constexpr std::uint8_t share_of_dark(int count, const Window& w) {
    return static_cast<std::uint8_t>((510 * count + w.taps()) / (2 * w.taps()));
}

// --- the order of fetching ----------------------------------------------------------------------

// Four banks give 2 x 2 texels in a cycle; one bank gives one, and jittered taps lie anywhere.
constexpr bool fetches_blocks(const Window& w, int banks) { return banks == 4 && !w.jittered; }
constexpr int fetch_cycles(const Window& w, int banks) {
    const int blocks = (w.side + 1) / 2;
    return fetches_blocks(w, banks) ? blocks * blocks : w.taps();
}
// The cycle in which tap t is fetched.
constexpr int fetch_cycle(const Window& w, int banks, int t) {
    if (!fetches_blocks(w, banks)) return t;
    return t / w.side / 2 * ((w.side + 1) / 2) + t % w.side / 2;
}

// The texels on the map that a point's comparison reads, in the order in which it reads them: none
// outside the volume. `at` and `cycle` have `count` elements; those of a cycle are one request.
struct Texels {
    std::size_t count = 0;
    std::array<Texel, hw::max_taps> at{};
    std::array<int, hw::max_taps> cycle{};
};

constexpr Texels lookup_texels(const ShadowTest& test, int banks, const hw::Point& p,
                               const hw::DitherWords& d, const hw::TapBytes& noise) {
    const hw::MachineSpec& spec = test.machine;
    Texels texels;
    const LightPlace place = light_place(spec, p, d);
    if (!place.inside) return texels;
    const Window w = window_of(test);
    for (int c = 0; c < fetch_cycles(w, banks); ++c)
        for (int t = 0; t < w.taps(); ++t) {
            if (fetch_cycle(w, banks, t) != c) continue;
            const Texel texel = tap_texel(spec, w, t, place, noise);
            if (!on_map(spec, texel.x, texel.y)) continue;
            texels.at[texels.count] = texel;
            texels.cycle[texels.count++] = c;
        }
    return texels;
}

}  // namespace umbra78::shadow
