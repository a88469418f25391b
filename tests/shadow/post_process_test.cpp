// The post-process: the definition against a slow model, bit for bit.
#include "shadow/post_process.hpp"

#include "tests/shadow/random_frames.hpp"
#include "tests/shadow/same_masks.hpp"
#include "tests/shadow/slow_lookup.hpp"
#include "tests/shadow/slow_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

namespace umbra78::shadow {
namespace {

using test::OwnedStore;
using test::Random;
using test::describe;
using test::expect_same;
using test::maps_of;

// --- the slow model -----------------------------------------------------------------------------

TEST(PostProcess, IsTheSlowModel) {
    Random random;
    std::uint64_t shadowed = 0, graded = 0;
    for (int round = 0; round < 150; ++round) {
        Settings s = test::random_settings(random, false);
        s.machine.xy_bits = 4;
        const hw::MachineSpec& m = s.machine;
        const std::size_t pixels = 256;
        OwnedStore<hw::Depth32> observer(4), light(4);
        test::fill_depth(random, m, observer.depth);
        test::fill_depth(random, m, light.depth);
        const hw::MatrixWords matrix = test::random_matrix(random, m, random.bits() % 2 == 0);
        const LightMap<hw::Depth32> map = light_map<hw::Depth32>(light.store, s);
        const test::SlowNoise noise(s.dither, m);
        const test::SlowTapNoise taps(s);

        std::vector<std::uint8_t> expected(pixels), mask(pixels, 7);
        PostProcessCounts count;
        for (std::size_t a = 0; a < pixels; ++a) {
            if (observer.depth[a] == m.background()) continue;
            ++count.visible;
            const hw::Point p = test::slow_transform(
                matrix, m,
                test::slow_words(s, static_cast<int>(a % 16), static_cast<int>(a / 16),
                                 observer.depth[a]));
            const int dark = test::slow_darkness(map, p, noise.words(a), taps.bytes(a));
            count.shadowed += dark != 0;
            graded += dark != 0 && dark != 255;
            expected[a] = static_cast<std::uint8_t>(dark);
        }
        const PostProcessCounts got = post_process(maps_of(observer, light), matrix, s, mask);
        EXPECT_EQ(got.visible, count.visible) << describe(s);
        EXPECT_EQ(got.shadowed, count.shadowed) << describe(s);
        expect_same(expected, mask, 16, describe(s));
        if (HasFailure()) return;
        shadowed += got.shadowed;
    }
    EXPECT_GT(shadowed, 2000u) << "too little in shadow for a test";
    EXPECT_GT(graded, 200u) << "too few partly in shadow for a test";
}

std::uint64_t empty_lines(std::span<const hw::Depth32> depth, std::uint32_t background) {
    std::uint64_t n = 0;
    for (std::size_t a = 0; a < depth.size(); a += 16)
        n += std::count(depth.begin() + a, depth.begin() + a + 16, background) == 16;
    return n;
}

// Work that can change nothing changes nothing: constant products and the W row anew for each
// point, the division by a constant, noise that is silent, and pixels and lines where nothing was
// drawn. The background's code lies in the light's volume here, in front of which others are drawn,
// so a background pixel would be in shadow.
TEST(PostProcess, WorkForNothingChangesNothing) {
    Random random;
    std::uint64_t background_in_shadow = 0;
    for (int round = 0; round < 80 && !HasFailure(); ++round) {
        Settings s = test::random_settings(random, false);
        s.machine.xy_bits = 4;
        OwnedStore<hw::Depth32> observer(4), light(4);
        test::fill_depth(random, s.machine, observer.depth);
        test::fill_depth(random, s.machine, light.depth);
        for (const int y : {0, 6, 7, 15})  // lines with nothing visible
            std::fill_n(observer.depth.begin() + 16 * y, 16, s.machine.background());
        const std::uint64_t lines = 16 - empty_lines(observer.depth, s.machine.background());
        const hw::MatrixWords matrix = test::random_matrix(random, s.machine, true);
        std::vector<std::uint8_t> plain(256, 1), more(256, 2);
        const PostProcessCounts a = post_process(maps_of(observer, light), matrix, s, plain);
        for (int bits = 0; bits < 32; ++bits) {
            PostProcessWork work;
            work.unit.constant_product = (bits & 1) != 0;
            work.unit.w_row = (bits & 2) != 0;
            work.background = (bits & 4) != 0;
            work.noise = (bits & 8) != 0 || needed_work(s).noise;
            work.empty_lines = (bits & 16) != 0;
            const PostProcessCounts b =
                post_process(maps_of(observer, light), matrix, s, work, more);
            expect_same(plain, more, 16, describe(s));
            EXPECT_EQ(b.shadowed, a.shadowed);
            EXPECT_EQ(b.visible, !work.background    ? a.visible
                                 : work.empty_lines ? 256
                                                    : 16 * lines);
        }
        const LightMap<hw::Depth32> map = light_map<hw::Depth32>(light.store, s);
        const test::SlowNoise noise(s.dither, s.machine);
        const test::SlowTapNoise taps(s);
        for (std::size_t k = 0; k < 256; ++k)
            background_in_shadow +=
                observer.depth[k] == s.machine.background() &&
                0 != test::slow_darkness(
                    map,
                    test::slow_transform(matrix, s.machine,
                                         test::slow_words(s, static_cast<int>(k % 16),
                                                          static_cast<int>(k / 16),
                                                          observer.depth[k])),
                    noise.words(k), taps.bytes(k));
    }
    EXPECT_GT(background_in_shadow, 300u) << "too few for a test";
}

}  // namespace
}  // namespace umbra78::shadow
