#include "shadow/rivals/visible.hpp"

#include "fixed/rounding.hpp"

namespace umbra78::shadow::rivals {
namespace {

using fixed::Rounding;

// A vertex's Y on the screen: floor and ceiling. False if it does not lie before the eye.
bool screen_y(const Point& p, const Centre& eye, std::int64_t& floor, std::int64_t& ceiling) {
    if (eye.w == 0) {
        floor = ceiling = p.y;
        return true;
    }
    const std::int64_t distance = -std::int64_t{eye.z}, depth = p.z + distance;
    if (depth <= 0) return false;
    floor = fixed::round_divide(p.y * distance, depth, Rounding::floor);
    ceiling = fixed::round_divide(p.y * distance, depth, Rounding::ceiling);
    return true;
}

// Puts facet f where it is nearer than what a run of pixels shows.
class Nearer {
public:
    Nearer(const Setting& setting, std::uint32_t facet, VisibleCounts& counts)
        : setting_(setting), facet_(facet), counts_(counts) {}

    void put(std::uint32_t& shown, std::int32_t px, std::int32_t py) {
        if (shown != nothing_seen) {
            if (shown != on_) {
                on_ = shown;
                line_ = meet(setting_.planes[on_], setting_.planes[facet_]);
            }
            ++counts_.compares;
            if (line_.sign_at(px, py) != -setting_.eye.sides[facet_]) return;
        }
        shown = facet_;
    }

private:
    const Setting& setting_;
    std::uint32_t facet_;
    VisibleCounts& counts_;
    std::uint32_t on_ = nothing_seen;
    ScreenLine line_;
};

}  // namespace

Run rows_of(const Setting& setting, std::size_t facet) {
    const Space& space = setting.space;
    std::int64_t top = INT64_MAX, bottom = INT64_MIN;
    for (const Point& p : setting.mesh.corners(facet)) {
        std::int64_t floor = 0, ceiling = 0;
        if (!screen_y(p, space.eye(), floor, ceiling)) return {0, space.size_px()};
        top = std::min(top, floor);
        bottom = std::max(bottom, ceiling);
    }
    const auto in_frame = [&](std::int64_t row) {
        return static_cast<int>(std::clamp<std::int64_t>(row, 0, space.size_px()));
    };
    return {in_frame(space.first_not_below(top)), in_frame(space.first_not_below(bottom + 1))};
}

void find_visible(const Setting& setting, std::span<std::uint32_t> shown, VisibleCounts& counts) {
    const Space& space = setting.space;
    std::fill(shown.begin(), shown.end(), nothing_seen);
    for (std::uint32_t f = 0; f < setting.mesh.facets.size(); ++f) {
        if (setting.eye.sides[f] == 0) continue;
        Nearer nearer(setting, f, counts);
        const Run rows = rows_of(setting, f);
        for (int row = rows.from; row < rows.to; ++row) {
            const Run run = setting.covered_run(f, row);
            ++counts.rows;
            const std::span line = shown.subspan(static_cast<std::size_t>(row) *
                                                 static_cast<std::size_t>(space.size_px()));
            for (int column = run.from; column < run.to; ++column) {
                ++counts.covered;
                nearer.put(line[static_cast<std::size_t>(column)], space.centre(column),
                           space.centre(row));
            }
        }
    }
}

}  // namespace umbra78::shadow::rivals
