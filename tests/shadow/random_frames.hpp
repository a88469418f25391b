// Random frame stores, matrices and settings, with the places where things go wrong well
// represented: the ends of every range, the background, and surfaces as well as noise.
#pragma once

#include "shadow/frame/settings.hpp"
#include "shadow/post_process.hpp"
#include "tests/fixed/boundary.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace umbra78::shadow::test {

using fixed::test::Random;

template <class Depth>
struct OwnedStore {
    explicit OwnedStore(int xy_bits)
        : depth(std::size_t{1} << (2 * xy_bits)), intensity(depth.size()),
          direct(depth.size()), store{xy_bits, depth, intensity, direct} {}
    OwnedStore(const OwnedStore&) = delete;
    OwnedStore& operator=(const OwnedStore&) = delete;

    std::vector<Depth> depth;
    std::vector<std::uint8_t> intensity, direct;
    hw::FrameStore<Depth> store;
};

// Two stores as a pass takes them.
template <class Depth>
DepthMaps<Depth> maps_of(const OwnedStore<Depth>& observer, const OwnedStore<Depth>& light) {
    return {.observer = observer.store, .light = light.store};
}

template <class T>
T pick(Random& random, std::initializer_list<T> of) {
    return of.begin()[random.bits() % of.size()];
}

// Noise, the ends of the range, a slanted plane with holes, or nothing at all.
template <class Depth>
void fill_depth(Random& random, const hw::MachineSpec& spec, std::vector<Depth>& depth) {
    const std::int64_t none = spec.background(), deepest = spec.deepest_drawn();
    const std::uint64_t kind = random.bits() % 8, holes = 1 + random.bits() % 8;
    const std::int64_t a = random.between(-300, 300), b = random.between(-300, 300);
    const std::int64_t c = random.between(0, deepest);
    const int size = spec.size_px();
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            std::int64_t z = random.between(0, none);
            if (kind < 5) z = std::clamp(c + ((a * x + b * y) >> 4), std::int64_t{0}, deepest);
            if (kind == 5) z = pick(random, {std::int64_t{0}, std::int64_t{1}, deepest, none});
            if (kind == 6) z = none;
            if (kind < 5 && random.bits() % 16 < holes) z = none;
            depth[static_cast<std::size_t>(y * size + x)] = static_cast<Depth>(z);
        }
}

// Any words at exponents that leave the results within reach of the map, or far outside.
inline hw::MatrixWords random_matrix(Random& random, const hw::MachineSpec& spec, bool affine) {
    hw::MatrixWords m;
    m.affine = affine;
    const std::int64_t max = (std::int64_t{1} << (spec.coefficient_bits - 1)) - 1;
    for (std::size_t r = 0; r < 4; ++r) {
        m.exponent[r] = static_cast<int>(random.between(-3, 2));
        for (std::int32_t& w : m.word[r]) {
            w = static_cast<std::int32_t>(random.between(-max - 1, max));
            if (random.bits() % 8 == 0)
                w = static_cast<std::int32_t>(pick(random, {-max - 1, max, std::int64_t{0}}));
        }
    }
    if (affine) m.word[3] = {};
    return m;
}

// A W row like a view's: its constant outweighs the rest as a rule, and W may be small or negative.
inline void make_w_row(Random& random, const hw::MachineSpec& spec, hw::MatrixWords& m) {
    const std::int64_t max = (std::int64_t{1} << (spec.coefficient_bits - 1)) - 1;
    const std::int64_t small = std::int64_t{1} << random.between(0, spec.coefficient_bits - 2);
    for (std::size_t c = 0; c < 3; ++c)
        m.word[3][c] = static_cast<std::int32_t>(random.between(-small, small));
    m.word[3][3] = static_cast<std::int32_t>(random.between(max / 8, max));
}

// The settings that are not the defaults, for a failure's message.
inline std::string describe(const Settings& s) {
    std::string text;
    for (const Setting& row : settings_table())
        if (row.get(s) != row.get(Settings{}))
            text += std::string(row.key) + "=" + std::to_string(row.get(s)) + " ";
    return text;
}

// The lookups that have a row form.
inline constexpr Lookup row_lookups[] = {Lookup::nearest, Lookup::bilinear, Lookup::percentage,
                                         Lookup::filtered_depth};

// Settings of what the post-process reads; `rows` keeps to what the row form covers.
inline Settings random_settings(Random& random, bool rows) {
    Settings s;
    hw::MachineSpec& m = s.machine;
    const auto between = [&](int low, int high) {
        return static_cast<int>(random.between(low, high));
    };
    m.xy_bits = between(4, 7);
    m.z_bits = random.bits() % 2 == 0 ? 16 : between(4, rows ? 16 : 24);
    m.coefficient_bits = random.bits() % 2 == 0 ? 16 : between(8, rows ? 16 : 32);
    m.fraction_bits = rows ? between(1, 7) : between(0, 12);
    m.transform_rounding = rows ? pick(random, {fixed::Rounding::half_up, fixed::Rounding::floor})
                                : random.rounding();
    s.registration = pick(random, {Registration::centre, Registration::index});
    s.lookup = rows ? row_lookups[random.bits() % 4]
                    : pick(random, {Lookup::nearest, Lookup::bilinear, Lookup::bilinear,
                                    Lookup::percentage, Lookup::filtered_depth});
    s.taps = between(2, 5);
    s.tap_places = rows ? TapPlaces::grid
                        : pick(random, {TapPlaces::grid, TapPlaces::jittered});
    s.background = pick(random, {Background::blend, Background::fall_back});
    s.dither.shape = static_cast<hw::DitherShape>(random.bits() % 5);
    s.dither.size_q8 = pick(random, {0, 1, 64, 255, 256, 257, 700, 1024});
    s.dither.seed = static_cast<std::uint32_t>(random.between(1, 0x7fffffff));
    if (!rows && random.bits() % 4 == 0) {
        m.max_accumulator_bits = between(16, 48);
        m.product_rounding = random.rounding();
    }
    return s;
}

}  // namespace umbra78::shadow::test
