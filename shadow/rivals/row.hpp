// What class 1 needs of one row of pixels: the runs of one facet, a line's crossing of the row,
// and the sign of one line where another crosses the row.
//
// A pixel's centre is moved to (px + e, py + e^2) for every predicate (planes.hpp), so the row is
// at py + e^2 and passes no point where two lines meet unless the lines are one. The crossing of
// line a is at px = -a_m / a_x, with m = y py + c; it is never rounded. There line b has the value
// D / a_x,
//
//   D = a_x b_m - b_x a_m;  if that is 0, with the sign of its growth with py, a_x b_y - b_x a_y;
//
// if that is 0 too, the lines are one and the sign is 0.
//
// Bits. x and y of a line are products of a normal and an offset, twice, m has value_bits.
#pragma once

#include "shadow/rivals/visible.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

using RowSum = fixed::WideInt<5>;
inline constexpr int slope_bits = normal_bits + offset_bits + 2;
static_assert(slope_bits + value_bits + 1 < RowSum::bits);

// A line on the screen, in one row.
struct RowLine {
    ScreenLine line;
    Sum at_middle;  // its value where px = 0

    RowLine() = default;
    RowLine(const ScreenLine& l, const Space& space, int row)
        : line(l), at_middle(l.y * space.centre(row) + l.c) {}

    // As ScreenLine::sign_at.
    int sign_at(std::int32_t px) const {
        const int s = sign(line.x * px + at_middle);
        return s != 0 ? s : line.tie();
    }
};

// The sign of `other` where `crossing`, whose x is not 0, crosses the row; 0 if they are one line.
inline int sign_where(const RowLine& crossing, const RowLine& other) {
    const auto determinant = [&](const Sum& a, const Sum& b) {
        const RowSum d = RowSum(crossing.line.x) * RowSum(b) - RowSum(other.line.x) * RowSum(a);
        return d.is_negative() ? -1 : d.is_zero() ? 0 : 1;
    };
    int s = determinant(crossing.at_middle, other.at_middle);
    if (s == 0) s = determinant(crossing.line.y, other.line.y);
    return s * sign(crossing.line.x);
}

// The first column of a run at which the line's sign is not that of the run's first pixel; run.to
// if there is none. `up` is whether it becomes positive. A line that is none has no crossing.
struct Crossing {
    int column;
    bool up;
};
inline Crossing crossing_in(const RowLine& line, const Run& run, const Space& space, int row) {
    const int first = line.sign_at(space.centre(run.from));
    if (first == line.sign_at(space.centre(run.to - 1))) return {run.to, false};
    return {run_of(line.line, first, space, row).to, first < 0};
}

// The columns of a run, which is not empty, at which the line's sign is `wanted`.
inline Run run_within(const RowLine& line, int wanted, const Run& run, const Space& space,
                      int row) {
    const bool first = line.sign_at(space.centre(run.from)) == wanted;
    const bool last = line.sign_at(space.centre(run.to - 1)) == wanted;
    if (first && last) return run;
    if (!first && !last) return {run.from, run.from};
    return run & run_of(line.line, wanted, space, row);
}

// visit(row, run, facet) of each run of pixels that show one facet, row by row from the top.
template <class Visit>
void for_runs(const Space& space, std::span<const std::uint32_t> shown, Visit&& visit) {
    const int size = space.size_px();
    for (int row = 0; row < size; ++row) {
        const auto line = shown.subspan(static_cast<std::size_t>(row) *
                                        static_cast<std::size_t>(size));
        for (Run run{0, 0}; run.from < size; run.from = run.to) {
            const std::uint32_t on = line[static_cast<std::size_t>(run.from)];
            for (run.to = run.from + 1;
                 run.to < size && line[static_cast<std::size_t>(run.to)] == on;)
                ++run.to;
            if (on != nothing_seen) visit(row, run, on);
        }
    }
}

}  // namespace umbra78::shadow::rivals
