// The row forms of the post-process against its definition, bit for bit.
#include "shadow/post_process.hpp"

#include "shadow/frame/frame.hpp"
#include "shadow/row_form.hpp"
#include "tests/shadow/frame/figure_frame.hpp"
#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/same_masks.hpp"
#include "tests/support/effort.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace umbra78::shadow {
namespace {

using fixed::Rounding;
using test::OwnedStore;
using test::Random;
using test::describe;
using test::expect_same;
using test::maps_of;

// One frame, or a band of it, by every form that this processor has, from masks that held different
// rubbish before.
void expect_forms_agree(const DepthMaps<hw::Depth16>& maps, const hw::MatrixWords& matrix,
                        const Settings& s, const std::string& where, std::uint64_t& shadowed,
                        const hw::Band& band = {}) {
    ASSERT_TRUE(rows_cover(s, matrix)) << where << describe(s);
    static const auto memory = std::make_unique<RowMemory>();
    std::vector<std::uint8_t> plain(maps.observer.depth.size(), 1);
    const PostProcessCounts a = post_process(maps, matrix, s, needed_work(s), plain, {}, band);
    for (const RowForm& form : row_forms()) {
        if (!form.supported()) continue;
        std::vector<std::uint8_t> rows(plain.size(), band.all() ? 2 : 1);
        const PostProcessCounts b = post_process_rows(maps, matrix, s, *memory, rows, form, band);
        const std::string which = std::string(form.name) + ": " + where + describe(s);
        EXPECT_EQ(a.visible, b.visible) << which;
        EXPECT_EQ(a.shadowed, b.shadowed) << which;
        expect_same(plain, rows, maps.observer.size_px(), which);
    }
    shadowed += a.shadowed;
}

TEST(PostProcessRows, RandomMatricesAndFrames) {
    Random random;
    std::uint64_t shadowed = 0;
    for (int round = 0; round < 600 && !::testing::Test::HasFailure(); ++round) {
        const Settings s = test::random_settings(random, true);
        OwnedStore<hw::Depth16> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        hw::MatrixWords m = test::random_matrix(random, s.machine, true);
        if (!rows_cover(s, m)) m.exponent = {};  // narrow coefficients: keep the shift in range
        if (!rows_cover(s, m)) continue;
        expect_forms_agree(maps_of(observer, light), m, s,
                           "round " + std::to_string(round) + " ", shadowed);
    }
    EXPECT_GT(shadowed, 100000u) << "too little in shadow for a test";
}

// In perspective, with wide coefficients and with any exponents: what wide lanes transform.
TEST(PostProcessRows, RandomMatricesThatDivideOrAreWide) {
    Random random;
    std::uint64_t shadowed = 0;
    int divides = 0, wide = 0, refused = 0;
    for (int round = 0; round < 600 && !::testing::Test::HasFailure(); ++round) {
        Settings s = test::random_settings(random, true);
        s.machine.coefficient_bits = static_cast<int>(random.between(8, 32));
        if (round % 2 == 0) s.machine.coefficient_bits = test::pick(random, {16, 24});
        OwnedStore<hw::Depth16> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        hw::MatrixWords m = test::random_matrix(random, s.machine, round % 3 == 0);
        if (round % 3 == 1) test::make_w_row(random, s.machine, m);
        if (round % 8 == 0)
            for (int& e : m.exponent) e = static_cast<int>(random.between(-20, 20));
        if (!rows_cover(s, m)) {
            ++refused;
            continue;
        }
        divides += m.affine ? 0 : 1;
        wide += s.machine.coefficient_bits > 16 ? 1 : 0;
        expect_forms_agree(maps_of(observer, light), m, s,
                           "round " + std::to_string(round) + " ", shadowed);
    }
    EXPECT_GT(shadowed, 50000u) << "too little in shadow for a test";
    EXPECT_GT(divides, 300);
    EXPECT_GT(wide, 200);
    EXPECT_LT(refused, 100);
}

// A line's twelve bytes a sum follow from the line before, unless nothing was drawn there.
TEST(PostProcessRows, NoiseFollowsFromTheLineBefore) {
    Random random;
    std::uint64_t shadowed = 0;
    for (int round = 0; round < 60 && !::testing::Test::HasFailure(); ++round) {
        Settings s = test::random_settings(random, true);
        s.machine.xy_bits = 4 + round % 6;
        s.dither.shape = hw::DitherShape::normal;
        s.dither.size_q8 = static_cast<std::int32_t>(random.between(64, 512));
        OwnedStore<hw::Depth16> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        const int size = s.machine.size_px();
        const auto none = static_cast<hw::Depth16>(s.machine.background());
        for (int y = 0; y < size; ++y) {
            const int drawn = static_cast<int>(random.between(-size, size));
            const int first = std::max(drawn, 0), all = drawn < -size / 2 ? size : first;
            std::fill_n(observer.depth.begin() + y * size, all, none);
        }
        const hw::MatrixWords m = test::random_matrix(random, s.machine, true);
        if (!rows_cover(s, m)) continue;
        const int line = static_cast<int>(random.between(0, size - 1));
        const hw::Band band = round % 2 == 0 ? hw::Band{} : hw::Band{line, size};
        expect_forms_agree(maps_of(observer, light), m, s,
                           "round " + std::to_string(round) + " ", shadowed, band);
    }
    EXPECT_GT(shadowed, 20000u) << "too little in shadow for a test";
}

// Frames of several strips of columns, of which the noise runs on from strip to strip; of most a
// band of lines alone.
TEST(PostProcessRows, FramesWiderThanAStrip) {
    Random random;
    std::uint64_t shadowed = 0;
    for (int round = 0; round < 42 && !::testing::Test::HasFailure(); ++round) {
        if (umbra78::test::sanitized && round > 11 && round < 40) continue;
        Settings s = test::random_settings(random, true);
        s.machine.xy_bits = round < 38 ? 10 : round < 41 ? 11 : 12;
        if (round % 3 == 0) s.machine.coefficient_bits = 24;
        OwnedStore<hw::Depth16> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        hw::MatrixWords m = test::random_matrix(random, s.machine, round % 4 != 1);
        if (round % 4 == 1) test::make_w_row(random, s.machine, m);
        if (!rows_cover(s, m)) continue;
        const int first = static_cast<int>(random.between(0, s.machine.size_px() - 20));
        const hw::Band band = round == 2 ? hw::Band{} : hw::Band{first, first + 20};
        expect_forms_agree(maps_of(observer, light), m, s,
                           "round " + std::to_string(round) + " ", shadowed, band);
    }
    EXPECT_GT(shadowed, umbra78::test::sanitized ? 10000u : 50000u)
        << "too little in shadow for a test";
}

// The figures' views at every size, and biases from absurd to negative.
TEST(PostProcessRows, TheFiguresMatrixAtEverySizeAndBias) {
    Random random;
    std::uint64_t shadowed = 0;
    const test::FigureScene figures;
    for (int xy = 4; xy <= (umbra78::test::sanitized ? 7 : 10); ++xy) {
        Settings s = test::random_settings(random, true);
        s.machine = {};
        s.machine.xy_bits = xy;
        test::Frame<> frame(figures.scene(), s);
        ASSERT_EQ(frame.status, FrameStatus::ok);
        for (const Lookup lookup : test::row_lookups)
            for (const std::int64_t bias : {-100000, -64, 0, 1, 64, 192, 32767, 65535, 1 << 20}) {
                s.lookup = lookup;
                s.bias_q16 = bias << 16;
                s.dither.shape = static_cast<hw::DitherShape>(random.bits() % 5);
                s.background = test::pick(random, {Background::blend, Background::fall_back});
                s.registration = test::pick(random, {Registration::centre, Registration::index});
                ASSERT_EQ(load_matrices(figures.scene(), s, frame.matrices), FrameStatus::ok);
                expect_forms_agree(frame.buffers.maps(),
                                   frame.matrices.lights[0].observer_to_light, s, "figures ",
                                   shadowed);
                if (HasFailure()) return;
            }
    }
    EXPECT_GT(shadowed, umbra78::test::sanitized ? 10000u : 100000u);
}

// Every shape of noise, lookup, background and registration, on one frame each.
TEST(PostProcessRows, EverySettingOnce) {
    std::uint64_t shadowed = 0;
    const test::FigureScene figures;
    Settings s;
    s.machine.xy_bits = 6;
    test::Frame<> frame(figures.scene(), s);
    for (int shape = 0; shape < 5; ++shape)
        for (unsigned bits = 0; bits < 16; ++bits)
            for (const int size : {0, 64, 256, 1024}) {
                s.dither.shape = static_cast<hw::DitherShape>(shape);
                s.dither.size_q8 = size;
                s.lookup = test::row_lookups[bits % 4];
                s.background = (bits & 8) != 0 ? Background::fall_back : Background::blend;
                s.registration = (bits & 4) != 0 ? Registration::index : Registration::centre;
                ASSERT_EQ(load_matrices(figures.scene(), s, frame.matrices), FrameStatus::ok);
                expect_forms_agree(frame.buffers.maps(),
                                   frame.matrices.lights[0].observer_to_light, s, "", shadowed);
                if (HasFailure()) return;
            }
    EXPECT_GT(shadowed, 10000u);
}

// A matrix that only scales the light's position to each texel's edge, a step to either side of
// it, and the Z codes at the ends of the range.
TEST(PostProcessRows, TexelEdgesAndExtremeCodes) {
    std::uint64_t shadowed = 0;
    Settings s;
    s.machine.xy_bits = 4;
    OwnedStore<hw::Depth16> observer(4), light(4);
    for (std::size_t a = 0; a < 256; ++a) {
        observer.depth[a] = std::array<hw::Depth16, 4>{0, 1, 65534, 65535}[a % 4];
        light.depth[a] = std::array<hw::Depth16, 3>{0, 65533, 65535}[a / 16 % 3];
    }
    hw::MatrixWords m;
    m.word = {{{1 << 14, 0, 0, 0}, {0, 1 << 14, 0, 0}, {0, 0, 1 << 14, 0}, {0, 0, 0, 1 << 14}}};
    const int shift = hw::affine_shift(m, hw::Row::x, s.machine, hw::screen_words(s.machine),
                                       s.machine.fraction_bits);
    ASSERT_EQ(shift, 19);
    // The fourth word moves X and Y by its 32nd part of 2^-7 texel, and Z by itself: 16 is half a
    // step, 2048 half a texel, which brings a pixel's centre to the edge of a texel.
    for (const int fine : {-17, -16, -15, -1, 0, 1, 15, 16, 17, 2048 - 16, 2048, 2048 + 16})
        for (const int z : {-32768, -1, 0, 1, 8, 32767})
            for (const Registration registration : {Registration::centre, Registration::index})
                for (const Lookup lookup : test::row_lookups) {
                    m.word[0][3] = m.word[1][3] = fine;
                    m.word[2][3] = z;
                    s.registration = registration;
                    s.lookup = lookup;
                    expect_forms_agree(maps_of(observer, light), m, s,
                                       std::to_string(fine) + " ", shadowed);
                    if (HasFailure()) return;
                }
    EXPECT_GT(shadowed, 1000u);
}

// The form that is taken without a name is one that the processor has; one that it has not traps.
TEST(PostProcessRows, TakeAFormThatTheProcessorHas) {
    EXPECT_EQ(row_forms()[0].name, "plain");
    EXPECT_TRUE(row_forms()[0].supported());
    EXPECT_TRUE(fastest_row_form().supported());
    RowForm absent = row_forms()[0];
    absent.supported = [] { return false; };
    Settings s;
    s.machine.xy_bits = 4;
    OwnedStore<hw::Depth16> observer(4), light(4);
    hw::MatrixWords m;
    m.word = {{{1 << 14, 0, 0, 0}, {0, 1 << 14, 0, 0}, {0, 0, 1 << 14, 0}, {0, 0, 0, 1 << 14}}};
    const auto memory = std::make_unique<RowMemory>();
    std::vector<std::uint8_t> mask(256);
    EXPECT_DEATH(post_process_rows(maps_of(observer, light), m, s, *memory, mask, absent),
                 "has not the row form's lanes");
}

// Which of 64 codes are visible, by every form: words of one code each but for one, and any codes.
TEST(PostProcessRows, FindWhatIsDrawn) {
    Random random;
    constexpr std::size_t words = 3;
    for (int round = 0; round < 400; ++round) {
        const auto none = static_cast<hw::Depth16>(random.bits());
        std::vector<hw::Depth16> codes(64 * words, round % 2 == 0 ? none : hw::Depth16{7});
        for (std::uint64_t k = random.bits() % 4; k > 0; --k)
            codes[random.bits() % codes.size()] = static_cast<hw::Depth16>(random.bits());
        if (round % 4 == 3)
            for (hw::Depth16& code : codes)
                code = static_cast<hw::Depth16>(none + (random.bits() % 3 == 0 ? 1 : 0));
        for (const RowForm& form : row_forms()) {
            if (!form.supported()) continue;
            std::array<std::uint64_t, words> drawn{};
            form.find_drawn(codes.data(), words, none, drawn.data());
            for (std::size_t k = 0; k < codes.size(); ++k)
                ASSERT_EQ(drawn[k / 64] >> (k % 64) & 1, codes[k] != none) << form.name << k;
        }
    }
}

// The light map ends where no memory follows, or begins where none is before it: a read beyond it
// ends the test. Every texel is looked up, the first and the last among them.
TEST(PostProcessRows, ReadNothingBesideTheMap) {
    std::uint64_t shadowed = 0;
    Settings s;
    s.machine.xy_bits = 5;
    OwnedStore<hw::Depth16> observer(5);
    std::fill(observer.depth.begin(), observer.depth.end(), hw::Depth16{40000});
    hw::MatrixWords m;
    m.word = {{{1 << 14, 0, 0, 0}, {0, 1 << 14, 0, 0}, {0, 0, 1 << 14, 0}, {0, 0, 0, 1 << 14}}};
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = 2 * observer.depth.size();
    ASSERT_LE(bytes, page);
    void* memory = mmap(nullptr, 3 * page, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    std::byte* middle = static_cast<std::byte*>(memory) + page;
    ASSERT_EQ(mprotect(middle, page, PROT_READ | PROT_WRITE), 0);
    for (std::byte* at : {middle, middle + page - bytes}) {
        const std::span depth(reinterpret_cast<hw::Depth16*>(at), observer.depth.size());
        std::fill(depth.begin(), depth.end(), hw::Depth16{40001});
        depth.front() = depth.back() = 39999;
        DepthMaps<hw::Depth16> maps = maps_of(observer, observer);
        maps.light.depth = depth;
        for (const Lookup lookup : test::row_lookups) {
            s.lookup = lookup;
            expect_forms_agree(maps, m, s, "pages ", shadowed);
        }
    }
    munmap(memory, 3 * page);
    EXPECT_GE(shadowed, 4u);
}

TEST(PostProcessRows, CoverWhatTheySay) {
    const test::FigureScene figures;
    FrameMatrices matrices;
    const Settings base;
    ASSERT_EQ(load_matrices(figures.scene(), base, matrices), FrameStatus::ok);
    const hw::MatrixWords m = matrices.lights[0].observer_to_light;
    EXPECT_TRUE(rows_cover(base, m));

    const auto covers = [&](auto change) {
        Settings s = base;
        hw::MatrixWords words = m;
        change(s, words);
        return rows_cover(s, words);
    };
    using W = hw::MatrixWords;
    EXPECT_TRUE(covers([](Settings&, W& w) { w.affine = false; }));
    EXPECT_FALSE(covers([](Settings& s, W& w) {
        w.affine = false;
        s.machine.divide_order = hw::DivideOrder::round_first;
    }));
    for (const Lookup lookup : {Lookup::percentage, Lookup::filtered_depth})
        for (const TapPlaces places : {TapPlaces::grid, TapPlaces::jittered})
            EXPECT_EQ(covers([&](Settings& s, W&) {
                s.lookup = lookup;
                s.tap_places = places;
            }), places == TapPlaces::grid);
    EXPECT_FALSE(covers([](Settings& s, W&) { s.machine.z_bits = 17; }));
    EXPECT_TRUE(covers([](Settings& s, W&) { s.machine.coefficient_bits = 24; }));
    // 35 bits: with one bit less a product is cut, and is no sum of shares.
    for (const int bits : {16, 33, 34, 35, 36, 64})
        EXPECT_EQ(covers([&](Settings& s, W&) { s.machine.max_accumulator_bits = bits; }),
                  bits >= 35) << bits;
    for (int xy = 4; xy <= 12; ++xy)
        EXPECT_TRUE(covers([&](Settings& s, W&) { s.machine.xy_bits = xy; })) << xy;
    for (int f = 0; f <= 12; ++f)
        EXPECT_EQ(covers([&](Settings& s, W&) { s.machine.fraction_bits = f; }), f >= 1 && f <= 7)
            << f;
    for (const Rounding r : fixed::test::all_roundings)
        EXPECT_EQ(covers([&](Settings& s, W&) { s.machine.transform_rounding = r; }),
                  r == Rounding::half_up || r == Rounding::floor);
    // The shift is 14 - e here; from 1 on wide lanes hold all parts.
    for (std::size_t row = 0; row < 3; ++row)
        for (int e = hw::min_exponent; e <= hw::max_exponent; ++e)
            EXPECT_EQ(covers([&](Settings&, W& w) { w.exponent[row] = e; }), e <= 13)
                << "row " << row << " exponent " << e;
    EXPECT_TRUE(covers([](Settings&, W& w) { w.exponent[3] = 31; })) << "the W row is not used";
}

// At the first and last shift it covers, the row form still has room.
TEST(PostProcessRows, ExtremeShifts) {
    Random random;
    std::uint64_t shadowed = 0;
    int rounds = 0;
    for (int round = 0; round < 200 && !::testing::Test::HasFailure(); ++round) {
        Settings s = test::random_settings(random, true);
        s.machine.z_bits = s.machine.coefficient_bits = 16;
        OwnedStore<hw::Depth16> observer(s.machine.xy_bits), light(s.machine.xy_bits);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        hw::MatrixWords m = test::random_matrix(random, s.machine, true);
        for (std::size_t r = 0; r < 3; ++r) {
            m.exponent[r] = 0;
            const int shift =
                hw::affine_shift(m, static_cast<hw::Row>(r), s.machine,
                                 hw::screen_words(s.machine),
                                 r == 2 ? s.machine.depth_fraction() : s.machine.fraction_bits);
            m.exponent[r] = shift - test::pick(random, {6, 7, 27, 28});
            for (std::int32_t& w : m.word[r])
                if (random.bits() % 2 == 0) w = test::pick(random, {-32768, 32767});
        }
        ++rounds;
        expect_forms_agree(maps_of(observer, light), m, s, "", shadowed);
    }
    EXPECT_EQ(rounds, 200);
    EXPECT_GT(shadowed, 1000u);
}

}  // namespace
}  // namespace umbra78::shadow
