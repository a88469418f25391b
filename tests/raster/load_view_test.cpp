// Which views can be drawn: a raster word and all that is made of it stay within 64 bits, or the
// view is refused.
#include "tests/support/drawing.hpp"
#include "tests/support/int128.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace umbra78::raster {
namespace {

// The greatest second differences there are: control points at the ends of the words, in turn.
Patch crumpled() {
    Patch p;
    for (std::size_t k = 0; k < 16; ++k) {
        const std::int32_t c = (k + k / 4) % 2 == 0 ? max_world : -max_world;
        p.control[k] = {c, c, c};
    }
    return p;
}

// The component once more in 128 bits, as far as its greatest correction: 9 D_j D_i p.
bool corrections_fit(const Component& c, const std::array<std::int64_t, 16>& p) {
    using Wide = umbra78::test::Int128;
    Wide twice = 0;
    constexpr std::array<int, 3> d{1, -2, 1};
    for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i) twice += Wide{d[i] * d[j]} * p[4 * j + i];
    const Wide exact = 9 * twice + 8;
    return exact == static_cast<std::int64_t>(exact) && c.guv[0] == exact >> 4;
}

// A window of 2^window and a depth of 2^depth quanta of the world, far away. Whether it is held.
bool held(const MachineSpec& spec, int window, int depth) {
    const Patch patch = crumpled();
    const WordFormat object = object_format(std::span(&patch, 1));
    const ObjectWords words = to_object_words(patch, object);
    View view = umbra78::test::orthographic(0, 0, 1);
    view.extent = std::int32_t{1} << window;
    view.near_depth = std::int64_t{131000} << 16;
    view.far_depth = view.near_depth + (std::int64_t{1} << depth);
    MatrixWords m;
    if (load_view(view, spec, object, m) != hw::LoadStatus::ok) return false;
    const auto c = affine_components(words, m, spec, object);
    const hw::TransformUnit unit(spec, m, object, {});
    const std::array<int, 3> out{raster_fraction, raster_fraction,
                                 spec.depth_fraction() + depth_guard(spec)};
    for (std::size_t r = 0; r < 3; ++r) {
        std::array<std::int64_t, 16> p{};
        for (std::size_t k = 0; k < 16; ++k)
            p[k] = unit.affine_row(static_cast<hw::Row>(r), words[k], out[r]);
        EXPECT_TRUE(corrections_fit(c[r], p))
            << spec.xy_bits << ' ' << spec.z_bits << ' ' << spec.coefficient_bits << " window 2^"
            << window << " depth 2^" << depth << " row " << r;
    }
    return true;
}

TEST(LoadView, WhatIsNotRefusedStaysWithin64Bits) {
    int can = 0, cannot = 0;
    MachineSpec spec;
    for (spec.xy_bits = 4; spec.xy_bits <= 12; spec.xy_bits += 4)
        for (spec.z_bits = 4; spec.z_bits <= 24; spec.z_bits += 10)
            for (const int bits : {8, 20, 32})
                for (int window = 0; window <= 30; window += 3)
                    for (int depth = 0; depth <= 30; depth += 3) {
                        spec.coefficient_bits = bits;
                        ++(held(spec, window, depth) ? can : cannot);
                    }
    EXPECT_GT(can, 500);
    EXPECT_GT(cannot, 100);
    std::cout << "[ measured ] " << can << " views held, " << cannot << " refused\n";
}

// hw/MACHINE.md, section 6: a matrix is refused if a row's exponent is more than 37 + f - out, and
// no other that can be loaded is. Every power of two of the window and of the depth is asked.
TEST(LoadView, IsRefusedFromTheTextsExponentOn) {
    int at_limit = 0, beyond = 0;
    MachineSpec spec;
    for (spec.xy_bits = 4; spec.xy_bits <= 12; spec.xy_bits += 4)
        for (spec.z_bits = 4; spec.z_bits <= 24; spec.z_bits += 5)
            for (spec.coefficient_bits = 8; spec.coefficient_bits <= 32;
                 spec.coefficient_bits += 12)
                for (const int fraction : {0, 5, 14})
                    for (int window = 0; window <= 30; ++window)
                        for (const int depth : {0, 1, window, 30}) {
                            View view = umbra78::test::orthographic(0, 0, 1);
                            view.extent = std::int32_t{1} << window;
                            view.near_depth = 0;
                            view.far_depth = std::int64_t{1} << depth;
                            const WordFormat object{object_bits, fraction};
                            MatrixWords m, plain;
                            const bool refused =
                                load_view(view, spec, object, m) != hw::LoadStatus::ok;
                            if (hw::load_matrix(world_to_screen(view, spec), spec, object,
                                                plain) != hw::LoadStatus::ok) {
                                ASSERT_TRUE(refused);
                                continue;
                            }
                            const int guard = spec.z_bits > 20 ? 26 - spec.z_bits : 6;
                            int over = -100;
                            for (std::size_t r = 0; r < 3; ++r) {
                                const int out =
                                    r == 2 ? spec.z_bits - spec.xy_bits + guard : 13;
                                over = std::max(over, plain.exponent[r] - (37 + fraction - out));
                            }
                            ASSERT_EQ(refused, over > 0)
                                << spec.xy_bits << ' ' << spec.z_bits << ' '
                                << spec.coefficient_bits << " window 2^" << window << " depth 2^"
                                << depth;
                            at_limit += over == 0 ? 1 : 0;
                            beyond += over == 1 ? 1 : 0;
                        }
    EXPECT_GT(at_limit, 10);
    EXPECT_GT(beyond, 10);
}

// Object words: the largest fraction that holds every control point, and words rounded half up.
TEST(ObjectWords, HaveTheLargestFractionThatHoldsTheScene) {
    for (int fraction = 0; fraction <= 14; ++fraction) {
        // The greatest world word that rounds to 32767 at this fraction, and one more.
        const std::int64_t step = std::int64_t{1} << (16 - fraction);
        const std::int64_t largest = 32767 * step + step / 2 - 1;
        for (const bool negative : {false, true}) {
            Patch p;
            const auto of = [&](std::int64_t v) {
                p.control[7].y = static_cast<std::int32_t>(negative ? -v : v);
                return object_format(std::span(&p, 1));
            };
            EXPECT_EQ(of(largest).fraction, fraction) << negative;
            EXPECT_EQ(of(largest).bits, 16);
            EXPECT_EQ(to_object_words(p, of(largest))[7].y, negative ? -32767 : 32767);
            if (fraction == 0) continue;
            EXPECT_EQ(of(largest + 1).fraction, fraction - 1) << negative;
        }
    }
    Patch p;
    p.control[0] = {2, -2, 3};
    p.control[1] = {6, -6, 5};
    const ObjectWords w = to_object_words(p, {16, 14});  // quarters: ties go up
    EXPECT_TRUE(w[0].x == 1 && w[0].y == 0 && w[0].z == 1);
    EXPECT_TRUE(w[1].x == 2 && w[1].y == -1 && w[1].z == 1);
}

TEST(LoadView, AnOrdinaryViewIsHeldAtEveryWidth) {
    const WordFormat object{object_bits, 14};
    for (int z_bits = 4; z_bits <= 24; ++z_bits)
        for (int xy_bits = 4; xy_bits <= 12; ++xy_bits) {
            MachineSpec spec;
            spec.xy_bits = xy_bits;
            spec.z_bits = z_bits;
            MatrixWords m;
            EXPECT_EQ(load_view(umbra78::test::orthographic(-100, 20, 2), spec, object, m),
                      hw::LoadStatus::ok);
        }
}

}  // namespace
}  // namespace umbra78::raster
