#include "tools/captured/judge.hpp"

#include "tools/study/bias/search.hpp"
#include "tools/truth/image_walk.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools::captured {
namespace {

constexpr std::array<int, 3> window_sides{128, 64, 32};

Truth truth_of(const CapturedFrame& frame, std::span<const std::uint8_t> given) {
    Truth truth;  // its other planes are not asked for
    truth.size = frame.spec().size_px();
    truth.visible = frame.visible();
    const std::vector<std::uint8_t> estimate =
        given.empty() ? frame.mask_of_planes(std::int64_t{estimate_bias(frame.spec())} << 16)
                      : std::vector<std::uint8_t>{};
    const std::span<const std::uint8_t> dark = given.empty() ? std::span(estimate) : given;
    truth.lit.resize(dark.size());
    for (std::size_t at = 0; at < dark.size(); ++at) truth.lit[at] = dark[at] < 128;
    return truth;
}

// Pixels beside a shadow or the background: what is wrong there is the edge's, and no bias mends
// it.
std::vector<std::uint8_t> edge_band(const Truth& truth) {
    std::vector<std::uint8_t> band(truth.lit.size());
    for (std::size_t at = 0; at < band.size(); ++at)
        if (truth.lit[at] == 0 || truth.visible[at] == 0)
            for_disc(truth.size, at, edge_px, [&](std::size_t near) { band[near] = 1; });
    return band;
}

std::size_t at_of(int x, int y, int size) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(x);
}

// Sums over rectangles of an image, from its corner.
class Sums {
public:
    template <class Of>
    Sums(int size, Of&& of)
        : row_(size + 1), sum_(static_cast<std::size_t>(row_) * static_cast<std::size_t>(row_)) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                at(x + 1, y + 1) = at(x, y + 1) + at(x + 1, y) - at(x, y) + of(at_of(x, y, size));
    }
    int of(int left, int top, int side) {
        return at(left + side, top + side) - at(left, top + side) - at(left + side, top) +
               at(left, top);
    }

private:
    int& at(int x, int y) { return sum_[at_of(x, y, row_)]; }
    int row_;
    std::vector<int> sum_;
};

// What the results at three corners of the window say of the two grids.
std::optional<study::GridBeat> beat_of(const CapturedFrame& frame, const Window& w) {
    const int far = w.side - 1;
    const hw::Point here = frame.point(w.left, w.top), right = frame.point(w.left + far, w.top),
                    below = frame.point(w.left, w.top + far);
    for (const hw::Point* p : {&here, &right, &below})
        if (p->status != hw::DivideStatus::ok) return {};
    const double texel = std::ldexp(1, frame.spec().fraction_bits) * far;
    const auto step = [&](const hw::Point& to) {
        return std::array<double, 3>{static_cast<double>(to.x - here.x) / texel,
                                     static_cast<double>(to.y - here.y) / texel,
                                     static_cast<double>(to.z - here.z) / far};
    };
    const auto a = step(right), b = step(below);
    const double area = a[0] * b[1] - a[1] * b[0];
    if (area == 0) return {};
    study::GridBeat beat{{a[0], b[0]}, {a[1], b[1]}, 0, 0};
    beat.zu = (a[2] * b[1] - b[2] * a[1]) / area;
    beat.zv = (b[2] * a[0] - a[2] * b[0]) / area;
    return beat;
}

std::optional<Window> busiest_window(const CapturedFrame& frame, std::span<const double> error,
                                     std::span<const std::uint8_t> lit) {
    const int size = frame.spec().size_px();
    Sums errors(size, [&](std::size_t at) { return error[at] > 0 ? 1 : 0; });
    Sums lit_sums(size, [&](std::size_t at) { return lit[at] ? 1 : 0; });
    for (const int side : window_sides) {
        Window best;
        int most = 0;
        for (int top = 0; top + side <= size; top += side / 4)
            for (int left = 0; left + side <= size; left += side / 4) {
                if (lit_sums.of(left, top, side) != side * side) continue;
                const int count = errors.of(left, top, side);
                if (count <= most || count == side * side) continue;
                most = count;
                best.left = left;
                best.top = top;
            }
        if (most < side) continue;  // too few for a spectrum
        best.side = side;
        const std::vector<double> cut = cut_window(error, size, best.left, best.top, side);
        best.power = periodogram(cut, side);
        best.peak = highest_peak(best.power, side);
        best.fisher = fisher_test(cut, side);
        best.beat = beat_of(frame, best);
        return best;
    }
    return {};
}

}  // namespace

Judged judge(const CapturedFrame& frame, std::span<const std::uint8_t> mask,
             std::span<const std::uint8_t> given) {
    const Truth truth = truth_of(frame, given);
    const MachineMask shown{mask, truth.visible};
    Judged judged;
    judged.estimated = given.empty();
    judged.error = shadow_error(truth, shown);
    judged.isolated_pixels = isolated_pixels(shown, truth.size);
    judged.error_image = error_image(truth, shown);
    const std::vector<std::uint8_t> lit = lit_pixels(truth, shown);
    judged.flatness = median_local_flatness(judged.error_image, truth.size, lit);
    judged.window = busiest_window(frame, judged.error_image, lit);
    return judged;
}

std::optional<LeastBias> least_bias(const CapturedFrame& frame,
                                    std::span<const std::uint8_t> given) {
    const Truth truth = truth_of(frame, given);
    const std::vector<std::uint8_t> band = edge_band(truth);
    const auto error = [&](int quanta, std::span<const std::uint8_t> leave_out) {
        const std::vector<std::uint8_t> mask = frame.mask(std::int64_t{quanta} << 16);
        return shadow_error(truth, {mask, truth.visible}, leave_out);
    };
    const std::optional<int> found =
        study::bisect(study::max_bias_quanta(frame.spec()), [&](int quanta) {
            return error(quanta, band).false_shadow_rate() < tolerated_false_shadow;
        });
    if (!found) return {};
    return LeastBias{*found, error(*found, {})};
}

}  // namespace umbra78::tools::captured
