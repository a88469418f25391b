#include "tools/bias/trial.hpp"

#include "tools/study/bias/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace umbra78::tools::bias {
namespace {

constexpr int map_px = 32, border_px = 8;  // the taps of points in the middle stay inside
constexpr int place_fraction = 12;         // of a texel
constexpr std::int64_t texel = 1 << place_fraction;
constexpr int steps = 64;  // a slope factor and an offset are searched in parts of 1

// Places in a texel: all over it, and as close as can be to its borders and to its middle, where
// odd and even windows step.
constexpr std::array<std::int64_t, 8> places{0,    700,  1400, texel / 2 - 1, texel / 2,
                                             2700, 3400, texel - 1};

std::int64_t word(double depth) {
    return static_cast<std::int64_t>(std::llround(std::ldexp(depth, depth_fraction)));
}

struct Bias {
    int constant = 0;
    int slope = 0, normal = 0;  // in 1/64
};

class PlaneInMap {
public:
    explicit PlaneInMap(const MapSetup& s)
        : setup_(s), slope_x_(word(s.along_x() * s.texel() / s.range)),
          slope_y_(word(s.along_y() * s.texel() / s.range)), middle_(word(s.depth)),
          stored_(map_px * map_px) {
        const double cosine = 1 / std::sqrt(1 + s.tangent() * s.tangent());
        // Of an offset of one texel along the normal: places, and depth toward the light.
        move_x_ = std::llround(s.along_x() * cosine * texel);
        move_y_ = std::llround(s.along_y() * cosine * texel);
        move_depth_ = word(s.texel() * cosine / s.range);
        const std::int64_t corner = depth_at(map_px * texel, map_px * texel);
        const std::int64_t max = s.reversed ? far_depth - depth_at(0, 0) : corner;
        unit_ = bias_unit(s.format, max);
    }

    bool is_free(const Bias& bias) {
        draw(bias);
        for (std::int64_t y = border_px; y < map_px - border_px; ++y)
            for (std::int64_t x = border_px; x < map_px - border_px; ++x)
                for (const std::int64_t v : places)
                    for (const std::int64_t u : places)
                        if (shadowed(x * texel + u, y * texel + v, bias)) return false;
        return true;
    }

private:
    // At a place of the map.
    std::int64_t depth_at(std::int64_t x, std::int64_t y) const {
        const std::int64_t from = map_px * texel / 2;
        return middle_ + ((slope_x_ * (x - from) + slope_y_ * (y - from)) >> place_fraction);
    }
    std::uint32_t code(std::int64_t depth) const {
        return encode(setup_.format, setup_.reversed ? far_depth - depth : depth);
    }

    void draw(const Bias& bias) {
        const std::int64_t added = bias.constant * unit_ +
                                   std::max(slope_x_, slope_y_) * bias.slope / steps;
        for (std::int64_t y = 0; y < map_px; ++y)
            for (std::int64_t x = 0; x < map_px; ++x)
                stored_[static_cast<std::size_t>(y * map_px + x)] =
                    code(depth_at(x * texel + texel / 2, y * texel + texel / 2) + added);
    }

    // Whether any tap of a place has something nearer than the place.
    bool shadowed(std::int64_t x, std::int64_t y, const Bias& bias) const {
        const std::int64_t depth = depth_at(x, y) - move_depth_ * bias.normal / steps;
        const std::uint32_t reference = code(depth);
        const int side = taps_a_side(setup_.filter);
        const auto first = [&](std::int64_t at, std::int64_t move) {
            const std::int64_t moved = at + move * bias.normal / steps;
            // An even window begins half a texel earlier than an odd one.
            return ((moved + (side % 2 == 0 ? texel / 2 : 0)) >> place_fraction) - side / 2;
        };
        const std::int64_t x0 = first(x, move_x_), y0 = first(y, move_y_);
        for (std::int64_t j = y0; j < y0 + side; ++j)
            for (std::int64_t i = x0; i < x0 + side; ++i) {
                if (i < 0 || j < 0 || i >= map_px || j >= map_px) return true;  // moved too far
                const std::uint32_t there = stored_[static_cast<std::size_t>(j * map_px + i)];
                if (setup_.reversed ? there > reference : there < reference) return true;
            }
        return false;
    }

    const MapSetup& setup_;
    std::int64_t slope_x_, slope_y_;  // window depth a texel
    std::int64_t middle_, unit_ = 0, move_x_ = 0, move_y_ = 0, move_depth_ = 0;
    std::vector<std::uint32_t> stored_;
};

std::optional<double> in_steps(std::optional<int> found) {
    if (!found) return {};
    return static_cast<double>(*found) / steps;
}

}  // namespace

Found experiment(const MapSetup& setup) {
    PlaneInMap plane(setup);
    const Need need = need_of(setup);
    const auto max = static_cast<int>(std::min(4 * need.constant() / need.step + 16, 1e9));
    const int max_parts = 16 * steps;
    Found found;
    found.constant = study::bisect(max, [&](int c) { return plane.is_free({c, 0, 0}); });
    found.slope = in_steps(
        study::bisect(max_parts, [&](int f) { return plane.is_free({1, f, 0}); }));
    // More of an offset moves the point farther, which the border allows up to 4 texels.
    found.normal = in_steps(
        study::bisect(4 * steps, [&](int n) { return plane.is_free({1, 0, n}); }));
    return found;
}

}  // namespace umbra78::tools::bias
