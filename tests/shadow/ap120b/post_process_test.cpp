// The AP-120B's post-process: against exact rationals rounded step by step, on the figures and in
// perspective; its memory map, run through the processor; its ledger.
#include "shadow/ap120b/cost.hpp"
#include "shadow/ap120b/post_process.hpp"

#include "raster/view.hpp"
#include "shadow/frame/ledger.hpp"
#include "shadow/frame/profiles.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/support/buffers.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::Float38;
using fixed::Rounding;
using hw::Rational;
using hw::ap120b::MemorySpeed;
using test::FigureScene;
using test::Frame;

Settings on_array(Settings s, MemorySpeed speed = MemorySpeed::standard) {
    apply(*find_profile(speed == MemorySpeed::fast ? "ap120b_fast" : "ap120b"), s);
    return s;
}

raster::View lamp() {
    raster::View v;
    v.projection = raster::Projection::perspective;
    raster::axes_from_points({-327680, 262144, 131072}, {}, v.axes);
    v.extent = 262144;
    v.distance = 439629;
    v.near_depth = 200000;
    v.far_depth = 700000;
    return v;
}

// --- the arithmetic again, on rationals ---------------------------------------------------------

Rational power(int n) {
    Rational p(1);
    for (int k = 0; k < (n < 0 ? -n : n); ++k) p = p * Rational(2);
    return n < 0 ? Rational(1) / p : p;
}
Rational value(const Float38& f) {
    if (f.is_zero()) return 0;
    return Rational(f.mantissa()) * power(f.biased_exponent() - 512 - 27);
}
// What the machine keeps of an exact value.
Rational kept(const Rational& exact) { return value(Float38::from_rational(exact)).reduced(); }

std::int64_t floor_of(const Rational& r) {
    std::int64_t v = 0;
    EXPECT_TRUE(r.round_scaled(0, Rounding::floor, v));
    return v;
}

// MACHINE.md's section 18 as it reads, for one pixel.
struct Model {
    const Settings& s;
    const FrameBuffers<hw::Depth16>& frame;
    hw::RationalMatrix exact;

    Rational entry(std::size_t r, std::size_t j) const { return kept(exact_entry(r, j)); }
    Rational exact_entry(std::size_t r, std::size_t j) const {
        const hw::MachineSpec& m = s.machine;
        const Rational half(m.half_px()), quanta = power(m.depth_fraction());
        const Rational o =
            Rational(s.registration == Registration::centre ? 1 : 0, 2) - half;
        const auto column = [&](std::size_t row) {
            const auto& c = exact[row];
            const Rational e = j < 2    ? c[j]
                               : j == 2 ? c[2] / quanta
                                        : c[3] + (c[0] + c[1]) * o;
            return affine() ? e / exact[3][3] : e;
        };
        if (r < 2) return column(r) + half * column(3);
        if (r == 2) return quanta * column(2) + Rational(m.depth_offset()) * column(3);
        return column(3);
    }
    bool affine() const {
        return exact[3][0].is_zero() && exact[3][1].is_zero() && exact[3][2].is_zero();
    }
    Rational texel(std::int64_t x, std::int64_t y) const {
        const int n = s.machine.size_px();
        if (x < 0 || y < 0 || x >= n || y >= n) return Rational(s.machine.background());
        return Rational(frame.lights[0].map.depth[frame.lights[0].map.address(static_cast<int>(x),
                                                              static_cast<int>(y))]);
    }
    Rational lerp(const Rational& a, const Rational& b, const Rational& f) const {
        return kept(a + kept(f * kept(b - a)));
    }
    bool shadow(int px, int py, std::uint32_t code, const hw::DitherWords& d,
                const std::array<std::array<Rational, 4>, 4>& matrix) const {
        const hw::MachineSpec& m = s.machine;
        const std::array<Rational, 4> in{px, py, std::int64_t{code} - m.depth_offset(), 1};
        std::array<Rational, 4> p;
        for (std::size_t r = 0; r < 4; ++r) {
            p[r] = kept(matrix[r][0] * in[0]);
            for (std::size_t j = 1; j < 4; ++j) p[r] = kept(p[r] + kept(matrix[r][j] * in[j]));
        }
        if (!affine()) {
            if (p[3] <= Rational(0)) return false;
            for (std::size_t r = 0; r < 3; ++r) p[r] = kept(p[r] / p[3]);
        }
        const Rational one = power(m.fraction_bits), n(m.size_px());
        const Rational x = kept(p[0] + Rational(d.x) / one), y = kept(p[1] + Rational(d.y) / one);
        const Rational k = p[2];
        if (x < Rational(0) || x >= n || y < Rational(0) || y >= n) return false;
        if (k < Rational(0) || k > Rational(m.deepest_drawn())) return false;
        if (s.lookup == Lookup::nearest) return k > texel(floor_of(x), floor_of(y));
        const Rational cx = kept(x + Rational(1, 2)), cy = kept(y + Rational(1, 2));
        const std::int64_t tx = floor_of(cx), ty = floor_of(cy);
        const Rational fx = kept(cx - Rational(tx)), fy = kept(cy - Rational(ty));
        const Rational z00 = texel(tx - 1, ty - 1), z10 = texel(tx, ty - 1);
        const Rational z01 = texel(tx - 1, ty), z11 = texel(tx, ty);
        const Rational none(m.background());
        if (s.background == Background::fall_back &&
            (z00 == none || z10 == none || z01 == none || z11 == none))
            return k > texel(floor_of(x), floor_of(y));
        return k > lerp(lerp(z00, z10, fx), lerp(z01, z11, fx), fy);
    }
};

// Every pixel of every `stride`-th line, and the counts.
void expect_model(const char* what, const Scene& scene, const Settings& s, int stride) {
    const Frame<> drawn(scene, s);
    ASSERT_EQ(drawn.status, FrameStatus::ok) << what;
    const Model model{s, drawn.buffers,
                      raster::observer_to_light(scene.observer, scene.lights[0], s.machine,
                                                drawn.matrices.lights[0].bias_quanta_q16)};
    std::array<std::array<Rational, 4>, 4> matrix;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t j = 0; j < 4; ++j) {
            matrix[r][j] = model.entry(r, j).reduced();
            ASSERT_EQ(value(drawn.matrices.lights[0].array[r][j]), matrix[r][j]) << what << r << j;
        }
    const int n = s.machine.size_px();
    int seen = 0;
    for (int y = stride / 2; y < n; y += stride) {
        hw::Dither dither = s.dither;
        if (dither.shape == hw::DitherShape::none) dither.shape = hw::DitherShape::uniform;
        hw::NoiseSource noise(dither, s.machine, 0, y);
        for (int x = 0; x < n; ++x) {
            hw::DitherWords d = noise.next();
            if (s.dither.shape == hw::DitherShape::none) d = {0, 0};
            const std::size_t a = drawn.buffers.observer.address(x, y);
            const std::uint32_t code = drawn.buffers.observer.depth[a];
            if (code == s.machine.background()) {
                ASSERT_EQ(drawn.buffers.lights[0].mask[a], 0) << what << " x " << x << " y " << y;
                continue;
            }
            ++seen;
            ASSERT_EQ(drawn.buffers.lights[0].mask[a],
                      model.shadow(x, y, code, d, matrix) ? 255 : 0)
                << what << " x " << x << " y " << y;
        }
    }
    EXPECT_GT(seen, 500) << what;
}

TEST(ArrayPostProcess, IsItsDefinitionOnTheFigures) {
    const FigureScene f;
    expect_model("figure 3", f.scene(), on_array(figure_settings(3)), 32);
    Settings s = on_array(figure_settings(4));
    expect_model("figure 4", f.scene(), s, 32);
    s.background = Background::fall_back;
    s.registration = Registration::index;
    s.bias_q16 = 3 << 14;
    expect_model("figure 4, fall back, index", f.scene(), s, 48);
    s.machine.xy_bits = 7;
    s.machine.z_bits = 5;  // quanta larger than a pixel
    s.machine.fraction_bits = 0;
    expect_model("few bits", f.scene(), s, 4);
}

TEST(ArrayPostProcess, IsItsDefinitionInPerspective) {
    const FigureScene f;
    Scene scene = f.scene();
    scene.lights[0] = lamp();
    Settings s = on_array(figure_settings(4));
    s.machine.coefficient_bits = 24;
    expect_model("a lamp", scene, s, 64);
    scene.observer = lamp();
    raster::axes_from_points({196608, 131072, 262144}, {}, scene.observer.axes);
    s.lookup = Lookup::nearest;
    expect_model("a lamp, a near observer", scene, s, 64);
}

// How far the figures' points are from the exact matrix's: the fixed machine rounds X and Y to
// 2^-8 texel and Z to half a code, and its coefficients to 16 bits.
TEST(ArrayPostProcess, PointsAreExactToAFewOfTheirLastBits) {
    const FigureScene f;
    const Settings s = on_array(figure_settings(3));
    const Frame<> frame(f.scene(), s);
    const Model model{s, frame.buffers,
                      raster::observer_to_light(f.scene().observer, f.scene().lights[0], s.machine,
                                                frame.matrices.lights[0].bias_quanta_q16)};
    std::array<Rational, 3> worst;
    for (int y = 3; y < 512; y += 29)
        for (int x = 0; x < 512; x += 7) {
            const std::uint32_t code =
                frame.buffers.observer.depth[frame.buffers.observer.address(x, y)];
            if (code == s.machine.background()) continue;
            const auto v = hw::ap120b::times(frame.matrices.lights[0].array,
                                             array_words(x, y, code, s.machine));
            const std::array<Rational, 4> in{x, y, std::int64_t{code} - 32768, 1};
            for (std::size_t r = 0; r < 3; ++r) {
                Rational off = value(v[r]);
                for (std::size_t j = 0; j < 4; ++j) off -= model.exact_entry(r, j) * in[j];
                if (off.is_negative()) off = -off;
                if (off > worst[r]) worst[r] = off;
            }
        }
    for (const Rational& w : worst) {
        std::int64_t q24 = 0;
        ASSERT_TRUE(w.round_scaled(24, Rounding::ceiling, q24));
        std::cout << "worst error: " << q24 << " / 2^24\n";
    }
    EXPECT_LT(worst[0], power(-17));  // texels
    EXPECT_LT(worst[1], power(-17));
    EXPECT_LT(worst[2], power(-10));  // codes
}

TEST(ArrayPostProcess, IsNearTheFixedMachine) {
    const FigureScene f;
    for (const int figure : {3, 4}) {
        const Frame<> fixed(f.scene(), figure_settings(figure));
        const Settings s = on_array(figure_settings(figure));
        const Frame<> array(f.scene(), s);
        EXPECT_EQ(array.counts.lights[0].post_process.visible,
                  fixed.counts.lights[0].post_process.visible);
        const hw::TransformUnit unit(s.machine, fixed.matrices.lights[0].observer_to_light);
        for (int y = 100; y < 400; y += 7)
            for (int x = 0; x < 512; x += 5) {
                const std::uint32_t code =
                    fixed.buffers.observer.depth[fixed.buffers.observer.address(x, y)];
                if (code == s.machine.background()) continue;
                const hw::Point p = unit(pixel_words(x, y, code, s));
                const auto v = hw::ap120b::times(array.matrices.lights[0].array,
                                                 array_words(x, y, code, s.machine));
                // In 1/128 pixel and in codes: half a unit of rounding and coefficients of 16 bits.
                const auto off = [](const Float38& a, std::int64_t b, int scale) {
                    const Float38 scaled = a * Float38::from_scaled(1, scale);
                    return (scaled - Float38::from_scaled(b, 0)).fix(32);
                };
                EXPECT_LE(std::abs(off(v[0], p.x + 256 * 128, 7)), 1) << x << " " << y;
                EXPECT_EQ(off(v[1], p.y + 256 * 128, 7), 0) << x << " " << y;
                EXPECT_LE(std::abs(off(v[2], p.z + 32768, 0)), 1) << x << " " << y;
                EXPECT_EQ(v[3], Float38::from_scaled(1, 0));
            }
    }
}

TEST(ArrayPostProcess, MemorySpeedAndClockChangeNoBit) {
    const FigureScene f;
    const Frame<> slow(f.scene(), on_array(figure_settings(4)));
    const Frame<> fast(f.scene(), on_array(figure_settings(4), MemorySpeed::fast));
    umbra78::test::expect_equal_buffers("mask", 512, slow.buffers.lights[0].mask,
                                        fast.buffers.lights[0].mask);
}

TEST(ArrayPostProcess, RefusesWhatItsHostCannotSend) {
    const FigureScene f;
    Settings s = on_array(figure_settings(3));
    FrameMatrices matrices;
    EXPECT_EQ(load_matrices(f.scene(), s, matrices), FrameStatus::ok);
    s.machine.z_bits = 17;
    EXPECT_EQ(load_matrices(f.scene(), s, matrices), FrameStatus::spec_out_of_range);
    s.machine.z_bits = 16;
    s.form = Form::correct;
    EXPECT_EQ(load_matrices(f.scene(), s, matrices), FrameStatus::spec_out_of_range);
}

// Scan line 300 in the processor's memory, transformed in place by its own program.
TEST(ArrayMemory, AScanLineRunsInPlaceOnTheProcessor) {
    const FigureScene f;
    const Settings s = on_array(figure_settings(3));
    const Frame<> frame(f.scene(), s);
    const ArrayMemoryMap map = array_memory_map(512);
    std::vector<Float38> memory(hw::ap120b::memory_words);
    std::vector<hw::ap120b::Vector> expected;
    std::size_t at = map.points;
    for (int x = 0; x < 512; ++x) {
        const auto& observer = frame.buffers.observer;
        const std::uint32_t code = observer.depth[observer.address(x, 300)];
        if (code == s.machine.background()) continue;
        const auto v = array_words(x, 300, code, s.machine);
        std::copy(v.begin(), v.end(), memory.begin() + static_cast<std::ptrdiff_t>(at));
        expected.push_back(hw::ap120b::times(frame.matrices.lights[0].array, v));
        at += 4;
    }
    ASSERT_GT(expected.size(), 100u);
    hw::ap120b::Processor processor(
        std::span<Float38, hw::ap120b::memory_words>(memory.data(), memory.size()),
        s.array_memory);
    const auto points = static_cast<std::uint16_t>(map.points);
    run_transform(processor, frame.matrices.lights[0].array, points, points,
                  static_cast<std::uint16_t>(expected.size()));
    for (std::size_t k = 0; k < expected.size(); ++k)
        for (std::size_t r = 0; r < 4; ++r)
            ASSERT_EQ(memory[map.points + 4 * k + r].bits(), expected[k][r].bits())
                << k << " " << r;
}

// hw/MACHINE.md, section 18: the table of a scan line's memory, for the narrowest frame, 1978's and
// the widest; 64K words.
TEST(ArrayMemory, MapIsPublished) {
    const auto map = [](int pixels) {
        const ArrayMemoryMap m = array_memory_map(pixels);
        return std::array{m.constants, m.points, m.dither, m.texels,
                          m.fractions, m.codes,  m.mask,   m.end};
    };
    EXPECT_EQ(map(16), (std::array<std::uint32_t, 8>{0, 64, 128, 160, 192, 224, 288, 304}));
    EXPECT_EQ(map(512),
              (std::array<std::uint32_t, 8>{0, 64, 2112, 3136, 4160, 5184, 7232, 7744}));
    EXPECT_EQ(map(4096), (std::array<std::uint32_t, 8>{0, 64, 16448, 24640, 32832, 41024, 57408,
                                                       61504}));
    EXPECT_EQ(hw::ap120b::memory_words, 65536u);
}

// The frame's ledger: the published times, and the transform's from the replay.
TEST(ArrayCost, IsTheSumOfItsSteps) {
    const FigureScene f;
    struct Expected {
        int figure;
        MemorySpeed speed;
        int cycles_a_pixel;
        std::uint64_t calls;
        int bytes;
        std::uint64_t transfer_us;  // 2 us a 16-bit word
    };
    for (const Expected e : {Expected{3, MemorySpeed::standard, 114, 6227, 13, 1'388'036},
                             Expected{3, MemorySpeed::fast, 84, 6227, 13, 1'388'036},
                             Expected{4, MemorySpeed::standard, 273, 14849, 19, 2'028'668},
                             Expected{4, MemorySpeed::fast, 193, 14849, 19, 2'028'668}}) {
        const Settings s = on_array(figure_settings(e.figure), e.speed);
        const Frame<> frame(f.scene(), s);
        const ArrayCost c = array_cost(frame.counts.lights[0].post_process, s, s.array_memory,
                                       true);
        EXPECT_EQ(c.pixels, 106772u);
        EXPECT_EQ(c.lines, 479u);
        EXPECT_EQ(c.cycles(), c.pixels * static_cast<std::uint64_t>(e.cycles_a_pixel));
        EXPECT_EQ(c.calls(), e.calls);
        EXPECT_EQ(c.host_bytes, e.bytes);
        EXPECT_EQ(c.transfer_us(), e.transfer_us);
        EXPECT_EQ(c.longest().name, e.figure == 3 ? "inside the volume?" : "interpolate");
    }
    EXPECT_EQ(array_call_min_us, 100);
    EXPECT_EQ(array_call_max_us, 1000);
}

// Section 18's two tables: a routine's clocks an element, fast and standard; a step's elements a
// visible pixel and its calls a scan line.
TEST(ArrayCost, EveryStepIsPublished) {
    using enum ArrayCycleSource;
    struct Step {
        std::string_view name;
        ArrayCycleSource source;
        int fast, standard;                    // clocks an element
        int nearest, nearest_calls;
        int bilinear, bilinear_calls;
        int falls_back, falls_back_calls;      // bilinear, background = fall_back
    };
    const auto steps = [](int divides, int compares) {
        return std::array{
            Step{"float x, y, z", assumed, 4, 5, 3, 1, 3, 1, 3, 1},
            Step{"4 x 4 transform", replayed, 20, 23, 1, 1, 1, 1, 1, 1},
            Step{"divide by w", published, 10, 10, divides, 3, divides, 3, divides, 3},
            Step{"dither: random words", published, 7, 7, 2, 1, 2, 1, 2, 1},
            Step{"dither: add", published, 5, 8, 2, 2, 2, 2, 2, 2},
            Step{"inside the volume?", published, 5, 8, compares, compares, compares, compares,
                 compares, compares},
            Step{"fix texel", published, 4, 5, 2, 2, 2, 2, 4, 4},
            Step{"texel's fraction", published, 5, 8, 0, 0, 4, 4, 4, 4},
            Step{"float texel and codes", assumed, 4, 5, 1, 1, 6, 3, 6, 3},
            Step{"interpolate", published, 5, 8, 0, 0, 9, 9, 9, 9},
            Step{"compare", published, 5, 8, 1, 1, 1, 1, 5, 5},
            Step{"pack mask", published, 5, 5, 1, 1, 1, 1, 1, 1},
        };
    };
    for (int bits = 0; bits < 24; ++bits) {
        const bool affine = (bits & 1) != 0, dithered = (bits & 2) != 0, fast = (bits & 4) != 0;
        const int lookup = bits / 8;
        ShadowTest s;
        s.dither.shape = dithered ? hw::DitherShape::normal4 : hw::DitherShape::none;
        s.lookup = lookup == 0 ? Lookup::nearest : Lookup::bilinear;
        s.background = lookup == 2 ? Background::fall_back : Background::blend;
        const ArrayCost c =
            array_cost({.visible = 10, .shadowed = 4, .lines = 2}, s,
                       fast ? MemorySpeed::fast : MemorySpeed::standard, affine);
        SCOPED_TRACE(bits);
        std::size_t k = 0;
        std::uint64_t cycles = 0, calls = 0;
        for (const Step& e : steps(affine ? 0 : 3, affine ? 6 : 7)) {
            const std::array elements{e.nearest, e.bilinear, e.falls_back};
            const std::array routine_calls{e.nearest_calls, e.bilinear_calls, e.falls_back_calls};
            const int n = elements[static_cast<std::size_t>(lookup)];
            if (n == 0 || (!dithered && e.name.starts_with("dither"))) continue;
            ASSERT_LT(k, c.steps);
            const ArrayCostStep& got = c.list()[k++];
            EXPECT_EQ(got.name, e.name);
            EXPECT_EQ(got.source, e.source) << e.name;
            EXPECT_EQ(got.elements, n) << e.name;
            EXPECT_EQ(got.cycles, fast ? e.fast : e.standard) << e.name;
            EXPECT_EQ(got.calls, routine_calls[static_cast<std::size_t>(lookup)]) << e.name;
            cycles += 10 * static_cast<std::uint64_t>(n * (fast ? e.fast : e.standard));
            calls += 2 * static_cast<std::uint64_t>(got.calls);
        }
        EXPECT_EQ(k, c.steps);
        EXPECT_EQ(c.cycles(), cycles);
        EXPECT_EQ(c.calls(), calls);
        // In: px, py and the code; out: the texel's numbers; in: one code or four; out: the mask.
        EXPECT_EQ(c.host_bytes, lookup == 0 ? 13 : 19);
    }
}

// The frame's ledger takes it in place of the clocked stages, and the same operations of drawing
// and filters on its one adder and one multiplier.
TEST(ArrayCost, StandsInTheFramesLedger) {
    const FigureScene f;
    const Settings s = on_array(figure_settings(6));
    const auto ledger = [&](const Settings& settings) {
        const Frame<> frame(f.scene(), settings);
        return frame_ledger({f.scene(), settings, frame.matrices}, frame.buffers, frame.counts);
    };
    const FrameLedger array = ledger(s), fixed = ledger(figure_settings(6));
    EXPECT_TRUE(array.on_array && !fixed.on_array);
    EXPECT_EQ(array.transformation(true), 106772u * 273);
    EXPECT_EQ(array.transformation(false), array.transformation(true));
    EXPECT_EQ(array.bottleneck(), "interpolate");
    EXPECT_EQ(array.post_process.total, 0u);
    EXPECT_EQ(array.light.operations.adds, fixed.light.operations.adds);
    EXPECT_EQ(array.light.units.adders, fixed.light.operations.adds);
    EXPECT_EQ(array.light.units.multipliers, fixed.light.operations.products);
    EXPECT_EQ(array.composite.units.store, 2 * fixed.composite.operations.accesses);
}

}  // namespace
}  // namespace umbra78::shadow
