#include "tools/study/contours/small_shadows.hpp"

#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "tools/truth/real3.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace umbra78::tools::study {
namespace {

constexpr int xy_bits = 6, size = 1 << xy_bits;
constexpr double bar_length = 32;
constexpr int directions = 12, places = 4;  // places a pixel, in X and in Y
constexpr hw::Depth16 seen = 0, background = 0xffff;

int dark_pixels(const std::vector<std::uint8_t>& mask) {
    return static_cast<int>(std::count_if(mask.begin(), mask.end(),
                                          [](std::uint8_t m) { return m >= 128; }));
}

// A frame in which every pixel is drawn, and the filters' memory.
class Bench {
public:
    template <class Inside>
    void shade(Inside inside) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                mask_[static_cast<std::size_t>(y) * size + x] =
                    inside(x + 0.5 - size / 2, y + 0.5 - size / 2) ? 255 : 0;
    }
    int dark() const { return dark_pixels(mask_); }
    void filter(Passes passes) {
        const hw::FrameStore<const hw::Depth16> observer{xy_bits, depth_};
        if (passes.dequantize > 0)
            shadow::dequantize<hw::Depth16>(mask_, observer, background, passes.dequantize,
                                            {visited_, coverage_}, mask_);
        for (int k = 0; k < passes.low_pass; ++k) {
            shadow::low_pass<hw::Depth16>(mask_, observer, background, smooth_);
            mask_.swap(smooth_);
        }
    }

private:
    std::vector<hw::Depth16> depth_ = std::vector<hw::Depth16>(size * size, seen);
    std::vector<std::uint8_t> mask_ = std::vector<std::uint8_t>(size * size), smooth_ = mask_;
    std::vector<std::uint32_t> visited_ =
        std::vector<std::uint32_t>(shadow::edge_visited_words(xy_bits));
    std::vector<std::int16_t> coverage_ =
        std::vector<std::int16_t>(shadow::edge_coverage_words(xy_bits));
};

}  // namespace

double lost_area(SmallShadow shape, double width_px, Passes passes) {
    Bench bench;
    int before = 0, after = 0;
    const int turns = shape == SmallShadow::bar ? directions : 1;  // a spot has no direction
    for (int turn = 0; turn < turns; ++turn) {
        const double angle = turn * pi / directions;
        for (int place = 0; place < places * places; ++place) {
            const double dx = (place % places + 0.5) / places, dy = (place / places + 0.5) / places;
            bench.shade([&](double x, double y) {
                const double along = (x - dx) * std::cos(angle) + (y - dy) * std::sin(angle);
                const double across = (y - dy) * std::cos(angle) - (x - dx) * std::sin(angle);
                return shape == SmallShadow::bar
                           ? std::abs(along) < bar_length / 2 && std::abs(across) < width_px / 2
                           : std::hypot(along, across) < width_px / 2;
            });
            before += bench.dark();
            bench.filter(passes);
            after += bench.dark();
        }
    }
    return 1 - static_cast<double>(after) / before;
}

}  // namespace umbra78::tools::study
