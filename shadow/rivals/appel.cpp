#include "shadow/rivals/appel.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

enum class Carried : std::uint8_t { yes, not_joined, contour, vertex, border_on_edge };

class Carrier {
public:
    Carrier(const Setting& s, const LightGrid* grid, const Borders& borders,
            std::span<CounterChange> room, AppelCounts& counts)
        : s_(s), grid_(grid), borders_(borders), room_(room), counts_(counts) {}

    std::int32_t seed(std::uint32_t on, int column, int row) {
        const std::int32_t px = s_.space.centre(column), py = s_.space.centre(row);
        std::int32_t count = 0;
        const auto ask = [&](std::uint32_t f) {
            ++counts_.seed_facets;
            count += s_.hides(s_.light, f, on, px, py) ? 1 : 0;
        };
        if (grid_ != nullptr) {
            for (const std::uint32_t f : grid_->facets_at(
                     grid_->picture().place(s_.planes[on], s_.space.eye(), px, py)))
                ask(f);
        } else {
            for (std::uint32_t f = 0; f < s_.mesh.facets.size(); ++f) ask(f);
        }
        return count;
    }

    // From the last pixel of facet `from`, in the column before `column`, to facet `to` there.
    Carried carry(std::uint32_t from, std::uint32_t to, int column, int row,
                  std::int32_t& number) {
        const std::size_t k = shared_side(from, to);
        if (k == 3) return Carried::not_joined;
        const Edge& edge = s_.mesh.edges[s_.mesh.sides[from][k] / 2];
        if (multiplicity(s_, edge) != 0) return Carried::contour;
        // The eye is on the light's side of both facets, so for it, too, they lie on either side of
        // the edge, which so parts the two pixels.
        const RowLine seen_edge = eye_line(from, k, row);
        const Run step{column - 1, column + 1};
        for (std::size_t j = 0; j < 3; ++j)
            if (j != k && sign_where(seen_edge, eye_line(from, j, row)) !=
                              s_.eye.inside(s_.mesh, from, j))
                return Carried::vertex;
        std::int32_t sum = number;
        if (!add_step(from, to, seen_edge, column - 1, step, row, sum) ||
            !add_step(to, from, seen_edge, column, step, row, sum))
            return Carried::border_on_edge;
        number = sum;
        return Carried::yes;
    }

    // Along a run; `number` is that of the first pixel, then of the last.
    void along(std::uint32_t on, int row, const Run& run, std::span<std::int32_t> row_of_numbers,
               std::int32_t& number) {
        std::size_t size = 0;
        for (const Border& border : borders_.of(on)) {
            BorderCrossing c;
            if (!cross(on, border, row, run, c)) continue;
            if (size < room_.size()) room_[size] = {c.column, c.change};
            ++size;
        }
        fits_ = fits_ && size <= room_.size();
        counts_.longest = std::max<std::uint64_t>(counts_.longest, size);
        const std::span changes = room_.first(std::min(size, room_.size()));
        counts_.compares += sort_changes(changes);
        int column = run.from;
        for (const CounterChange& c : changes) {
            for (; column < c.column; ++column)
                row_of_numbers[static_cast<std::size_t>(column)] = number;
            number += c.change;
        }
        for (; column < run.to; ++column)
            row_of_numbers[static_cast<std::size_t>(column)] = number;
    }

    // Whether every list has fitted.
    bool fit() const { return fits_; }

private:
    // The side of `from` that is an edge of these two facets alone; 3 if there is none.
    std::size_t shared_side(std::uint32_t from, std::uint32_t to) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge& edge = s_.mesh.edges[s_.mesh.sides[from][k] / 2];
            if (edge.count != 2) continue;
            for (const HalfEdge& h : s_.mesh.half_edges.subspan(edge.first, edge.count))
                if (h.facet == to) return k;
        }
        return 3;
    }
    RowLine eye_line(std::uint32_t facet, std::size_t k, int row) const {
        return {line_of(s_.eye.edge(s_.mesh, facet, k)), s_.space, row};
    }
    bool cross(std::uint32_t on, const Border& border, int row, const Run& run,
               BorderCrossing& out) {
        ++counts_.borders;
        CrossingCounts counts;
        const bool changes = crosses(s_, on, border, row, run, out, counts);
        counts_.crossings += changes ? 1 : 0;
        return changes;
    }
    // Adds the borders on facet `on` between the pixel in `column` and the edge to facet `other`.
    // False if one falls on the edge. The other facet's own plane does, and is no border on this
    // side of the edge, as the two lie on either side of it from the light, too.
    bool add_step(std::uint32_t on, std::uint32_t other, const RowLine& edge, int column,
                  const Run& step, int row, std::int32_t& sum) {
        const int here = edge.sign_at(s_.space.centre(column));
        for (const Border& border : borders_.of(on)) {
            if (border.side == Border::own_plane && border.facet == other) continue;
            BorderCrossing c;
            if (!cross(on, border, row, step, c)) continue;
            const int at = sign_where(c.line, edge);
            if (at == 0) return false;
            if (at == here) sum += c.change;
        }
        return true;
    }

    const Setting& s_;
    const LightGrid* grid_;
    const Borders& borders_;
    std::span<CounterChange> room_;
    AppelCounts& counts_;
    bool fits_ = true;
};

void count_seed(Carried why, AppelCounts& counts) {
    if (why == Carried::not_joined) ++counts.not_joined;
    if (why == Carried::contour) ++counts.contour;
    if (why == Carried::vertex) ++counts.vertex;
    if (why == Carried::border_on_edge) ++counts.border_on_edge;
}

}  // namespace

bool appel(const Setting& setting, std::span<const std::uint32_t> shown, const LightGrid* grid,
           const Borders& borders, const AppelOptions& options, std::span<CounterChange> room,
           std::span<std::int32_t> surfaces, AppelCounts& counts) {
    const auto size = static_cast<std::size_t>(setting.space.size_px());
    Carrier carrier(setting, grid, borders, room, counts);
    std::fill(surfaces.begin(), surfaces.end(), 0);
    std::uint32_t last = nothing_seen;  // facet, whose number at (last_end - 1, last_row) is known
    int last_row = -1, last_end = 0;
    std::int32_t number = 0;
    for_runs(setting.space, shown, [&](int row, const Run& run, std::uint32_t on) {
        if (setting.attached(on)) return;
        ++counts.runs;
        const bool follows = options.carry && last_row == row && last_end == run.from;
        Carried carried = Carried::not_joined;
        if (follows) {
            carried = carrier.carry(last, on, run.from, row, number);
            count_seed(carried, counts);
        } else {
            ++counts.first;
        }
        if (carried == Carried::yes) {
            ++counts.carried;
        } else {
            ++counts.seeds;
            number = carrier.seed(on, run.from, row);
        }
        carrier.along(on, row, run, surfaces.subspan(static_cast<std::size_t>(row) * size, size),
                      number);
        last = on, last_row = row, last_end = run.to;
    });
    return carrier.fit();
}

}  // namespace umbra78::shadow::rivals
