#include "tools/truth/coverage.hpp"

#include "tools/truth/image_walk.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

constexpr double allowed_codes = 4;

// The code of a depth before it is rounded: 0 at the near plane, maxval + 1 at the far one.
double exact_code(const TruthView& view, double depth, std::uint32_t maxval) {
    const double in_range = (depth - view.near_depth) / (view.far_depth - view.near_depth);
    return (view.perspective ? in_range * view.far_depth / depth : in_range) * (maxval + 1.0);
}

class Walk {
public:
    Walk(const Truth& truth, const Buffer& depths, const TruthView& view)
        : truth_(truth), depths_(depths), view_(view) {
        expect_image(depths.pixels(), truth.size);
    }

    Covered at(std::size_t pixel) const {
        const bool seen = sees(pixel), drawn = draws(pixel);
        if (!seen && !drawn) return Covered::right;
        if (seen && drawn && is_near(pixel)) return Covered::right;
        return among_neighbours(pixel, seen, drawn);
    }

    bool sees(std::size_t pixel) const { return truth_.visible[pixel] != 0; }
    bool draws(std::size_t pixel) const { return depths_.at(pixel) != depths_.maxval; }

private:
    double exact_code_at(std::size_t pixel) const {
        return exact_code(view_, truth_.depth[pixel], depths_.maxval);
    }
    // Whether it is right whatever its neighbours are: their depths only widen what is allowed.
    bool is_near(std::size_t pixel) const {
        const double exact = exact_code_at(pixel), code = depths_.at(pixel);
        return code >= exact - allowed_codes && code <= exact + allowed_codes;
    }
    Covered among_neighbours(std::size_t pixel, bool seen, bool drawn) const {
        int seen_beside = 0, drawn_beside = 0, all = 0;
        double low = HUGE_VAL, high = -HUGE_VAL;
        bool one_surface = true;
        for_disc(truth_.size, pixel, 1.5, [&](std::size_t other) {
            ++all;
            seen_beside += sees(other);
            drawn_beside += draws(other);
            one_surface &= truth_.surface[other] == truth_.surface[pixel];
            const double code = exact_code_at(other);
            low = std::min(low, code);
            high = std::max(high, code);
        });
        if (seen && !drawn)
            return seen_beside == all || drawn_beside == 0 ? Covered::missing : Covered::right;
        if (!seen && drawn)
            return drawn_beside == all || seen_beside == 0 ? Covered::extra : Covered::right;
        if (!seen || !one_surface) return Covered::right;
        const double allowed = high - low + allowed_codes, code = depths_.at(pixel);
        return code < low - allowed || code > high + allowed ? Covered::misplaced : Covered::right;
    }

    const Truth& truth_;
    const Buffer& depths_;
    const TruthView& view_;
};

}  // namespace

std::vector<Covered> coverage_image(const Truth& truth, const Buffer& depths,
                                    const TruthView& view) {
    const Walk walk(truth, depths, view);
    std::vector<Covered> image(truth.visible.size());
    for (std::size_t at = 0; at < image.size(); ++at) image[at] = walk.at(at);
    std::vector<Covered> kept = image;
    for (std::size_t at = 0; at < image.size(); ++at) {
        if (image[at] != Covered::misplaced) continue;
        int misplaced = 0;  // itself among them
        for_disc(truth.size, at, 1.5, [&](std::size_t other) {
            misplaced += image[other] == Covered::misplaced;
        });
        if (misplaced == 1) kept[at] = Covered::right;
    }
    return kept;
}

Coverage coverage(const Truth& truth, const Buffer& depths, const std::vector<Covered>& image) {
    Coverage sum;
    for (std::size_t at = 0; at < image.size(); ++at) {
        const bool seen = truth.visible[at] != 0, drawn = depths.at(at) != depths.maxval;
        sum.seen += seen;
        sum.drawn += drawn;
        sum.missing += image[at] == Covered::missing;
        sum.extra += image[at] == Covered::extra;
        sum.misplaced += image[at] == Covered::misplaced;
        sum.beyond_edge += drawn && !seen && image[at] == Covered::right;
    }
    return sum;
}

}  // namespace umbra78::tools
