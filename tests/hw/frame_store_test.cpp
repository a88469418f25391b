// The frame store: addresses, the background, and the count of accesses.
#include "hw/frame_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace umbra78::hw {
namespace {

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
        std::vector<std::uint8_t> intensity(256, 7);
        FrameStore<Depth16> store{4, depth, intensity};
        store.clear(spec);
        EXPECT_EQ(std::count(depth.begin(), depth.end(), (1 << z_bits) - 1), 256);
        EXPECT_EQ(std::count(intensity.begin(), intensity.end(), 0), 256);
    }
    MachineSpec wide;
    wide.xy_bits = 4;
    wide.z_bits = 24;
    std::vector<Depth32> depth(256);
    FrameStore<Depth32> light{4, depth, {}};  // a light's view has no intensity
    light.clear(wide);
    EXPECT_EQ(std::count(depth.begin(), depth.end(), 0xffffffu), 256);
}

TEST(FrameStore, AnAccessIsACycle) {
    EXPECT_EQ((AccessCount{1000, 234}.cycles()), 1234u);
}

}  // namespace
}  // namespace umbra78::hw
