// The midpoint map against a sorted list of each texel's codes.
#include "shadow/midpoint.hpp"

#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace umbra78::shadow {
namespace {

template <class Depth>
class Maps {
public:
    explicit Maps(int z_bits) : map_(256), second_(256) {
        spec_.xy_bits = 4;
        spec_.z_bits = z_bits;
        nearest_.clear(spec_);
        behind_.clear(spec_);
    }
    MidpointSink<Depth> sink() { return {nearest_, behind_}; }
    Depth at(int x, int y) const { return map_[nearest_.address(x, y)]; }
    void finish() { take_midpoints<Depth>({}, second_, map_); }
    const hw::MachineSpec& spec() const { return spec_; }

private:
    hw::MachineSpec spec_;
    std::vector<Depth> map_, second_;
    hw::FrameStore<Depth> nearest_{4, map_, {}, {}}, behind_{4, second_, {}, {}};
};

template <class Depth>
void expect_midpoints_of_sorted_codes(int z_bits) {
    fixed::test::Random random;
    for (int n = 0; n < 200; ++n) {
        Maps<Depth> maps(z_bits);
        auto sink = maps.sink();
        std::vector<std::set<std::uint64_t>> codes(256);
        const std::int64_t deepest = maps.spec().deepest_drawn();
        for (int k = 0; k < 500; ++k) {
            raster::Sample s{};
            s.px = static_cast<int>(random.between(0, 15));
            s.py = static_cast<int>(random.between(0, 15));
            const std::int64_t code = n % 2 == 0 ? random.between(0, deepest)
                                                 : deepest - random.between(0, 3);
            sink.sample(s, static_cast<std::uint32_t>(code), nullptr);
            codes[static_cast<std::size_t>(16 * s.py + s.px)].insert(
                static_cast<std::uint64_t>(code));
        }
        maps.finish();
        for (int a = 0; a < 256; ++a) {
            std::vector<std::uint64_t> two(codes[static_cast<std::size_t>(a)].begin(),
                                           codes[static_cast<std::size_t>(a)].end());
            two.resize(std::max<std::size_t>(two.size(), 2), maps.spec().background());
            ASSERT_EQ(maps.at(a % 16, a / 16), (two[0] + two[1]) / 2) << "texel " << a;
        }
    }
}

TEST(Midpoint, IsThatOfTheTwoLeastDifferentCodes) {
    expect_midpoints_of_sorted_codes<hw::Depth16>(4);
    expect_midpoints_of_sorted_codes<hw::Depth16>(16);
    expect_midpoints_of_sorted_codes<hw::Depth32>(24);
}

// A footprint behind the first layer alone may hold the second.
TEST(Midpoint, HidesWhatIsBehindBothLayers) {
    Maps<hw::Depth16> maps(16);
    auto sink = maps.sink();
    const raster::Footprint f{3, 5, 3, 5, 1000, 2000};
    raster::Sample s{};
    s.px = 3;
    s.py = 5;
    sink.sample(s, 500, nullptr);
    EXPECT_FALSE(sink.hidden(f));
    sink.sample(s, 1000, nullptr);
    EXPECT_FALSE(sink.hidden(f)) << "an equal code";
    sink.sample(s, 999, nullptr);
    EXPECT_TRUE(sink.hidden(f));
}

}  // namespace
}  // namespace umbra78::shadow
