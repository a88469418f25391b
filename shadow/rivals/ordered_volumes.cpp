#include "shadow/rivals/ordered_volumes.hpp"

#include "shadow/rivals/row.hpp"

#include <algorithm>
#include <cstdint>

namespace umbra78::shadow::rivals {
namespace {

constexpr int never = INT32_MAX, unknown = -1;

// A side in one line of pixels.
struct SideRun {
    Run run;
    std::uint32_t side;
};

// A side in the list. It changes places with the next one at column swap_at, or never.
struct OpenSide {
    std::uint32_t side;
    int to, swap_at;
};

struct RunParts {
    std::span<ShadowSide> sides;
    std::span<SideRun> runs;
    std::span<int> rows;
    std::span<OpenSide> open;
};

RunParts run_parts(Carver& carver, std::size_t sides) {
    return {carver.take<ShadowSide>(sides), carver.take<SideRun>(sides),
            carver.take<int>(sides), carver.take<OpenSide>(sides)};
}

// The sides that cover a pixel of a line, by their first columns: nearly as in the line above.
class LineRuns {
public:
    LineRuns(const Space& space, std::span<const ShadowSide> sides, const RunParts& pieces,
             OrderedCounts& counts)
        : space_(space), sides_(sides), runs_(pieces.runs), rows_(pieces.rows), counts_(counts) {
        std::fill(rows_.begin(), rows_.end(), -1);
    }

    std::span<const SideRun> of(int row) {
        counts_.rows += sides_.size();
        const std::size_t above = size_;
        size_ = 0;
        for (std::size_t at = 0; at < above; ++at) put(runs_[at].side, row);
        for (std::uint32_t n = 0; n < sides_.size(); ++n)
            if (rows_[n] != row) put(n, row);
        sort();
        return runs_.first(size_);
    }

private:
    void put(std::uint32_t n, int row) {
        rows_[n] = row;
        const Run run = sides_[n].covered_run(space_, row);
        if (!run.empty()) runs_[size_++] = {run, n};
    }
    void sort() {
        for (std::size_t at = 1; at < size_; ++at)
            for (std::size_t k = at; k > 0; --k) {
                ++counts_.sorts;
                if (runs_[k - 1].run.from <= runs_[k].run.from) break;
                std::swap(runs_[k - 1], runs_[k]);
            }
    }

    const Space& space_;
    std::span<const ShadowSide> sides_;
    std::span<SideRun> runs_;
    std::span<int> rows_;  // in which each was asked last
    OrderedCounts& counts_;
    std::size_t size_ = 0;
};

// The open sides of a line of pixels, from the nearest to the farthest, and the visible surface
// between them.
class DepthList {
public:
    DepthList(const Setting& setting, std::span<const ShadowSide> sides, std::span<OpenSide> room,
              OrderedCounts& counts)
        : setting_(setting), sides_(sides), open_(room), counts_(counts) {}

    // The sides of a line, by their first columns.
    void start_line(int row, std::span<const SideRun> runs) {
        row_ = row;
        runs_ = runs;
        next_ = size_ = before_ = 0;
        sum_ = 0;
        last_shown_ = nothing_seen;
    }
    // Puts all in order at the first pixel of `stretch`, which shows facet `on` as far as it goes.
    // Returns the column before which nothing changes.
    int settle(const Run& stretch, std::uint32_t on) {
        column_ = stretch.from;
        close_sides();
        open_sides();
        sort();
        const int next = std::min({stretch.to, next_change(), next_run()});
        const std::uint64_t asked = counts_.asked;
        place_visible(on);
        if (on != last_shown_) {
            ++counts_.changes;
            counts_.open_at_changes += size_;
            counts_.asked_at_changes += counts_.asked - asked;
            last_shown_ = on;
        }
        return crossing_of_visible(on, {column_, next});
    }
    // What the sides before the visible surface change.
    std::int32_t sum() const { return sum_; }

private:
    const ShadowSide& side(std::size_t at) const { return sides_[open_[at].side]; }
    std::int32_t px() const { return setting_.space.centre(column_); }
    std::int32_t py() const { return setting_.space.centre(row_); }

    void close_sides() {
        std::size_t kept = 0, before = 0;
        for (std::size_t at = 0; at < size_; ++at) {
            if (open_[at].to <= column_) {
                if (at < before_) sum_ -= side(at).change();
                if (kept > 0) open_[kept - 1].swap_at = unknown;
                continue;
            }
            before += at < before_ ? 1 : 0;
            open_[kept++] = open_[at];
        }
        size_ = kept;
        before_ = before;
    }
    // At the list's end; sort() brings them to their places.
    void open_sides() {
        sorted_ = size_;
        for (; next_ < runs_.size() && runs_[next_].run.from <= column_; ++next_) {
            if (runs_[next_].run.to <= column_) continue;
            if (size_ > 0) open_[size_ - 1].swap_at = unknown;
            open_[size_++] = {runs_[next_].side, runs_[next_].run.to, unknown};
            ++counts_.inserts;
        }
        counts_.longest = std::max<std::uint64_t>(counts_.longest, size_);
    }
    // By insertion, since nearly all are in order.
    void sort() {
        for (std::size_t at = 1; at < size_; ++at)
            for (std::size_t k = at; k > 0 && open_[k - 1].swap_at <= column_; --k) {
                if (in_order(k - 1)) break;
                counts_.swaps += at < sorted_ ? 1 : 0;
                exchange(k - 1);
            }
    }
    // Whether the next one does not lie before it.
    bool in_order(std::size_t at) {
        ++counts_.compares;
        const ShadowSide& next = side(at + 1);
        return next.crossed(side(at).plane()).sign_at(px(), py()) != next.crossed_sign();
    }
    void exchange(std::size_t at) {
        if (at + 1 == before_) sum_ += side(at + 1).change() - side(at).change();
        std::swap(open_[at], open_[at + 1]);
        for (std::size_t k = at == 0 ? 0 : at - 1; k < at + 2; ++k) open_[k].swap_at = unknown;
    }
    // The first column at which a side ends or two change places.
    int next_change() {
        int first = never;
        for (std::size_t at = 0; at < size_; ++at) {
            OpenSide& o = open_[at];
            first = std::min(first, o.to);
            if (at + 1 == size_) break;
            if (o.swap_at <= column_) {
                const Run both{column_, std::min(o.to, open_[at + 1].to)};
                const int column = crossing(side(at + 1).crossed(side(at).plane()), both);
                o.swap_at = column == both.to ? never : column;
            }
            first = std::min(first, o.swap_at);
        }
        return first;
    }
    int next_run() const { return next_ < runs_.size() ? runs_[next_].run.from : never; }
    int crossing(const ScreenLine& line, const Run& run) {
        const RowLine in_row(line, setting_.space, row_);
        const int column = crossing_in(in_row, run, setting_.space, row_).column;
        ++counts_.foreseen;
        counts_.crossings += column < run.to ? 1 : 0;
        return column;
    }

    // Walks from the place that it had to the one it has: those before it lie together.
    void place_visible(std::uint32_t on) {
        const std::size_t was = before_;
        for (; before_ > 0 && !is_before(before_ - 1, on); --before_)
            sum_ -= side(before_ - 1).change();
        if (before_ < was) return;
        for (; before_ < size_ && is_before(before_, on); ++before_)
            sum_ += side(before_).change();
    }
    bool is_before(std::size_t at, std::uint32_t on) {
        ++counts_.asked;
        return side(at).crossed(setting_.planes[on]).sign_at(px(), py()) ==
               side(at).crossed_sign();
    }
    // The first column of a run at which it changes places with a neighbour.
    int crossing_of_visible(std::uint32_t on, Run run) {
        const SeenPlane& plane = setting_.planes[on];
        if (before_ > 0) run.to = crossing(side(before_ - 1).crossed(plane), run);
        if (before_ < size_) run.to = crossing(side(before_).crossed(plane), run);
        return run.to;
    }

    const Setting& setting_;
    std::span<const ShadowSide> sides_;
    std::span<OpenSide> open_;
    OrderedCounts& counts_;
    std::span<const SideRun> runs_{};
    int row_ = 0, column_ = 0;
    std::size_t next_ = 0;               // of runs_, not yet open
    std::size_t size_ = 0, sorted_ = 0;  // of the list; of it, what was there before
    std::size_t before_ = 0;             // how many lie before the visible surface
    std::int32_t sum_ = 0;
    std::uint32_t last_shown_ = nothing_seen;
};

std::span<const ShadowSide> sides_of(const Setting& setting, std::span<const ContourEdge> contour,
                                     std::span<ShadowSide> out) {
    std::size_t count = 0;
    for (const ContourEdge& edge : contour)
        if (const ShadowSide side(setting, edge); side.is_seen()) out[count++] = side;
    return out.first(count);
}

}  // namespace

bool order_volumes(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, std::span<std::byte> memory,
                   std::span<std::int32_t> surfaces, OrderedCounts& counts) {
    Carver carver(memory);
    const RunParts pieces = run_parts(carver, contour.size());
    counts.bytes = carver.used();
    if (!carver.fits()) return false;
    const Space& space = setting.space;
    const std::span sides = sides_of(setting, contour, pieces.sides);
    counts.facets += setting.mesh.facets.size();
    counts.edges += setting.mesh.edges.size();
    counts.contour += contour.size();
    counts.sides += sides.size();
    counts.start_tests += count_at_eye(setting, shown, surfaces);
    LineRuns runs(space, sides, pieces, counts);
    DepthList list(setting, sides, pieces.open, counts);
    int line = -1;
    for_runs(space, shown, [&](int row, const Run& run, std::uint32_t on) {
        if (row != line) {
            line = row;
            ++counts.lines;
            list.start_line(row, runs.of(row));
        }
        counts.pixels += static_cast<std::uint64_t>(run.to - run.from);
        const std::span out = surfaces.subspan(static_cast<std::size_t>(row) *
                                               static_cast<std::size_t>(space.size_px()));
        for (Run rest = run; !rest.empty();) {
            const int next = list.settle(rest, on);
            ++counts.stretches;
            for (; rest.from < next; ++rest.from)
                out[static_cast<std::size_t>(rest.from)] += list.sum();
        }
    });
    return true;
}

}  // namespace umbra78::shadow::rivals
