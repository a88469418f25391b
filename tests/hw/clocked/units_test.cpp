// The clocked transform, divider and noise source, step by step without stalls, against the
// functional units; and the registers that the slowest legal timing needs.
#include "hw/clocked/divider.hpp"
#include "hw/clocked/noise.hpp"
#include "hw/clocked/transform.hpp"

#include "tests/hw/transform_model.hpp"

#include <gtest/gtest.h>

#include <array>

namespace umbra78::hw {
namespace {

using test::Random;

constexpr std::array<int, 3> multipliers{1, 4, 16};

Timing random_timing(Random& random, int n) {
    if (n % 4 == 0) return slowest_legal;
    Timing t;
    t.clock_ns = static_cast<int>(random.between(100, 300));
    t.multiply_ns = static_cast<int>(random.between(1, 400));
    t.add_ns = static_cast<int>(random.between(1, 150));
    t.register_ns = static_cast<int>(random.between(0, 40));
    t.divider = random.bits() % 2 == 0 ? Divider::serial : Divider::pipelined;
    return t;
}

// Each step once; points that come after it in the stages have registers of their own.
TEST(ClockedTransform, RowsAreTheUnits) {
    Random random;
    for (int n = 0; n < 4000; ++n) {
        MachineSpec spec = test::random_spec(random);
        spec.multipliers = multipliers[static_cast<std::size_t>(n % 3)];
        const bool affine = random.bits() % 2 == 0;
        const MatrixWords m = test::random_matrix(random, spec, affine);
        const Timing timing = random_timing(random, n);
        ASSERT_EQ(check(timing), TimingStatus::ok);
        const TransformPipeline plan(spec, timing, m);
        TransformRegisters registers;
        const Words v = test::random_words(random, spec.word_bits());
        registers.load(plan, v);
        for (int step = 0; step < plan.latency(); ++step) registers.step(plan, step);
        const ProductCut cut = product_cut(spec);
        const std::int32_t one = spec.one_word();
        for (int r = 0; r < plan.rows(); ++r) {
            const auto k = static_cast<std::size_t>(r);
            ASSERT_EQ(registers.accumulator[k], accumulate(m, static_cast<Row>(r), v, one, cut))
                << "case " << n << ", row " << r << ", multipliers " << spec.multipliers;
        }
        if (!affine) continue;
        const Point p = TransformUnit(spec, m)(v);
        const std::array<std::int64_t, 3> expected{p.x, p.y, p.z};
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_EQ(registers.result[k], expected[k]) << "case " << n << ", row " << k;
    }
}

// Sixteen sums may be under way. Timings that would need more are refused, not computed wrong.
TEST(ClockedTransform, RefusesATimingWithTooManySumsUnderWay) {
    MachineSpec spec;
    const MatrixWords affine;
    const TransformPipeline slowest(spec, slowest_legal, affine);
    EXPECT_EQ(slowest.accumulate_step(0), 14);
    EXPECT_LT(slowest.accumulate_step(0), TransformPipeline::max_under_way);
    Timing beyond = slowest_legal;
    beyond.multiply_ns += 60;  // a stage more
    EXPECT_EQ(TransformPipeline(spec, beyond, affine).accumulate_step(0), 15);
    beyond.multiply_ns += 60;
    EXPECT_DEATH(TransformPipeline(spec, beyond, affine), "more sums under way");
}

TEST(ClockedDivider, QuotientsAreThoseOfDivide) {
    Random random;
    for (int n = 0; n < 4000; ++n) {
        const MachineSpec spec = test::random_spec(random);
        const MatrixWords m = test::random_matrix(random, spec, false);
        const DividePipeline plan(spec, random_timing(random, n), m);
        Accumulators acc{};
        for (std::int64_t& a : acc) {
            const std::int64_t word = random.word();
            a = word / 4;  // 62 bits, as accumulators have at most
        }
        if (n % 8 != 0 && acc[3] < 0) acc[3] = -acc[3];
        if (n % 3 == 0) {  // and quotients that are near the frame
            for (std::size_t r = 0; r < 3; ++r) acc[r] = acc[3] / 256 * random.between(-300, 300);
        }
        DividerRegisters registers;
        registers.load(acc);
        for (int step = 0; step < plan.latency(); ++step) registers.step(plan, step);
        for (int r = 0; r < 3; ++r) {
            const auto k = static_cast<std::size_t>(r);
            const Quotient expected = fixed::divide(acc[k], acc[3], plan.shift(r), plan.bits(r),
                                                    spec.transform_rounding);
            ASSERT_EQ(registers.row[k].result, expected)
                << "case " << n << ": " << acc[k] << " / " << acc[3] << " 2^" << plan.shift(r);
        }
    }
}

TEST(ClockedNoise, WordsAreTheSources) {
    Random random;
    const MachineSpec spec;
    for (const DitherShape shape : {DitherShape::none, DitherShape::uniform,
                                    DitherShape::triangular, DitherShape::normal4,
                                    DitherShape::normal}) {
        for (const int bits : {1, 7, 16, 64, 191, 192, 1024}) {
            Timing timing;
            timing.noise_bits = bits;
            const Dither dither{shape, 256, 0x12345678};
            const int need = 16 * uniforms(shape);
            const int cycles = ClockedNoise::cycles_per_pixel(dither, timing);
            EXPECT_GE(cycles * bits, need);
            EXPECT_TRUE(cycles == 1 || (cycles - 1) * bits < need);
            ClockedNoise noise(dither, spec, timing);
            NoiseSource source(shape == DitherShape::none ? Dither{DitherShape::uniform, 0, 1}
                                                          : dither, spec, 0, 0);
            for (int pixel = 0; pixel < 600; ++pixel) {
                for (int cycle = 0; cycle < cycles; ++cycle) noise.step(cycle);
                const DitherWords expected = source.next();
                ASSERT_EQ(noise.words().x, expected.x) << "pixel " << pixel << ", bits " << bits;
                ASSERT_EQ(noise.words().y, expected.y) << "pixel " << pixel << ", bits " << bits;
            }
        }
    }
}

}  // namespace
}  // namespace umbra78::hw
