// The frame store: addresses, the background, what may be written, and whose store it is.
#include "hw/frame_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

namespace umbra78::hw {
namespace {

template <class Store>
concept clears = requires(Store store, const MachineSpec& spec) { store.clear(spec); };

TEST(FrameStore, RowZeroIsTheTopAndEveryPixelHasItsWord) {
    for (int bits = 4; bits <= 9; ++bits) {
        const FrameStore<Depth16> store{bits, {}, {}};
        EXPECT_EQ(store.size_px(), 1 << bits);
        std::size_t next = 0;
        for (int y = 0; y < store.size_px(); ++y)
            for (int x = 0; x < store.size_px(); ++x) ASSERT_EQ(store.address(x, y), next++);
    }
}

TEST(FrameStore, ClearingLeavesBackgroundAndBlack) {
    for (const int z_bits : {4, 12, 16}) {
        MachineSpec spec;
        spec.xy_bits = 4;
        spec.z_bits = z_bits;
        std::vector<Depth16> depth(256, 5);
        std::vector<std::uint8_t> intensity(256, 7), direct(256, 9);
        FrameStore<Depth16> store{4, depth, intensity, direct};
        store.clear(spec);
        EXPECT_EQ(std::count(depth.begin(), depth.end(), (1 << z_bits) - 1), 256);
        EXPECT_EQ(std::count(intensity.begin(), intensity.end(), 0), 256);
        EXPECT_EQ(std::count(direct.begin(), direct.end(), 0), 256);
    }
    MachineSpec wide;
    wide.xy_bits = 4;
    wide.z_bits = 24;
    std::vector<Depth32> depth(256);
    FrameStore<Depth32> light{4, depth, {}};  // a light's view has no intensity
    light.clear(wide);
    EXPECT_EQ(std::count(depth.begin(), depth.end(), 0xffffffu), 256);
}

// A stage that reads takes a store whose words cannot be written through; the store converts.
TEST(FrameStore, ReadersCannotWrite) {
    using Read = FrameStore<const Depth16>;
    static_assert(std::is_convertible_v<FrameStore<Depth16>, Read>);
    static_assert(!std::is_convertible_v<Read, FrameStore<Depth16>>);
    static_assert(!std::is_convertible_v<FrameStore<Depth32>, Read>);
    static_assert(std::is_same_v<decltype(Read{}.depth[0]), const Depth16&>);
    static_assert(std::is_same_v<decltype(Read{}.intensity[0]), const std::uint8_t&>);
    static_assert(!clears<Read> && clears<FrameStore<Depth16>>);
    std::vector<Depth16> depth(256, 5);
    std::vector<std::uint8_t> intensity(256, 7);
    const FrameStore<Depth16> store{4, depth, intensity};
    const Read read = store;
    EXPECT_EQ(read.xy_bits, 4);
    EXPECT_EQ(read.depth.data(), depth.data());
    EXPECT_EQ(read.depth.size(), 256u);
    EXPECT_EQ(read.intensity.data(), intensity.data());
    EXPECT_EQ(read.intensity.size(), 256u);
}

// The store and the machine both have a width; both planes have the machine's size.
TEST(FrameStore, FitsOneMachine) {
    MachineSpec spec;
    spec.xy_bits = 5;
    std::vector<Depth16> depth(1024);
    std::vector<std::uint8_t> intensity(1024);
    const FrameStore<Depth16> store{5, depth, intensity};
    EXPECT_TRUE(store.fits(spec));
    EXPECT_TRUE((FrameStore<Depth16>{5, depth, {}}.fits(spec)));  // a light's view
    EXPECT_TRUE((FrameStore<const Depth16>(store).fits(spec)));
    for (const int bits : {4, 6}) {
        EXPECT_FALSE((FrameStore<Depth16>{bits, depth, intensity}.fits(spec)));
        MachineSpec other = spec;
        other.xy_bits = bits;
        EXPECT_FALSE(store.fits(other));
        EXPECT_FALSE((FrameStore<Depth16>{bits, depth, intensity}.fits(other)));
    }
    const std::span planes(depth);
    EXPECT_FALSE((FrameStore<Depth16>{5, planes.first(1023), intensity}.fits(spec)));
    EXPECT_FALSE((FrameStore<Depth16>{5, {}, {}}.fits(spec)));
    const std::span bytes(intensity);
    EXPECT_FALSE((FrameStore<Depth16>{5, depth, bytes.first(1023)}.fits(spec)));
    EXPECT_FALSE((FrameStore<Depth16>{5, depth, bytes, bytes.first(1023)}.fits(spec)));
    EXPECT_TRUE((FrameStore<Depth16>{5, depth, bytes, bytes}.fits(spec)));
    EXPECT_TRUE((FrameStore<Depth16>{5, depth, bytes, bytes}.shades()));
    EXPECT_FALSE((FrameStore<Depth16>{5, depth, bytes}.shades()));
    spec.z_bits = 17;  // a code would not fit its word
    EXPECT_FALSE(store.fits(spec));
    std::vector<Depth32> wide(1024);
    EXPECT_TRUE((FrameStore<Depth32>{5, wide, intensity}.fits(spec)));
}

}  // namespace
}  // namespace umbra78::hw
