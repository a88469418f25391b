#include "shadow/rivals/stencil.hpp"

#include "shadow/rivals/row.hpp"

#include <algorithm>

namespace umbra78::shadow::rivals {
namespace {

// A plane's value far along each pixel's ray, or one of its sign.
ScreenLine line_at_end(const SeenPlane& plane, const Centre& eye) {
    if (eye.w != 0) return {plane.x, plane.y, plane.c - plane.e};
    return plane.e.is_zero() ? line_of(plane) : ScreenLine{0, 0, -plane.e};
}

// A side, where the eye's rays come to its plane. If the light is at a place its rays part, and the
// lines that bound the side have their signs beyond its horizon, too.
struct DrawnSide {
    const ShadowSide& side;
    ScreenLine horizon;

    Run covered_run(const Space& space, int row) const {
        const Run run = side.covered_run(space, row);
        return run.empty() ? run : run & run_of(horizon, side.crossed_sign(), space, row);
    }
};

// The far end of a facet's volume: where the facet's plane and those through the light and its
// edges have the signs that they have in the volume, infinitely far away.
class FarEnd {
public:
    FarEnd(const Setting& s, std::size_t f)
        : lines_{line_at_end(s.planes[f], s.eye.centre)}, inside_{-s.light.sides[f]} {
        for (std::size_t k = 0; k < 3; ++k) {
            lines_[k + 1] = line_at_end(s.light.edge(s.mesh, f, k), s.eye.centre);
            inside_[k + 1] = s.light.inside(s.mesh, f, k);
        }
    }
    // False if one of its lines has the frame's four corners outside.
    bool may_be_seen(const Space& space) const {
        const std::int32_t first = space.centre(0), last = space.centre(space.size_px() - 1);
        for (std::size_t k = 0; k < 4; ++k) {
            bool inside = false;
            for (const std::int32_t py : {first, last})
                for (const std::int32_t px : {first, last})
                    inside = inside || lines_[k].sign_at(px, py) == inside_[k];
            if (!inside) return false;
        }
        return true;
    }
    Run covered_run(const Space& space, int row) const {
        Run run = whole_row(space);
        for (std::size_t k = 0; k < 4 && !run.empty(); ++k)
            run = run & run_of(lines_[k], inside_[k], space, row);
        return run;
    }

private:
    std::array<ScreenLine, 4> lines_;
    std::array<int, 4> inside_;
};

class Stencil {
public:
    Stencil(const Setting& s, std::span<const std::uint32_t> shown, const DepthScale& scale,
            const StencilOptions& options, const StencilStore& store, StencilCounts& counts)
        : s_(s), shown_(shown), scale_(scale), options_(options), store_(store), counts_(counts) {}

    void start() {
        if (options_.pass == StencilPass::z_pass) {
            counts_.start_tests += count_at_eye(s_, shown_, store_.counters);
            for (std::int32_t& n : store_.counters) n = wrapped(n);
        } else {
            std::fill(store_.counters.begin(), store_.counters.end(), 0);
        }
    }
    void write_codes() {
        std::fill(store_.codes.begin(), store_.codes.end(), scale_.background());
        for_runs(s_.space, shown_, [&](int row, const Run& run, std::uint32_t on) {
            const PlaneCodes codes(s_.planes[on], s_.space, scale_);
            for (int column = run.from; column < run.to; ++column)
                store_.codes[place(column, row)] = codes.at(s_.space.centre(column),
                                                            s_.space.centre(row));
        });
    }
    void draw_sides(std::span<const ContourEdge> contour) {
        for (const ContourEdge& edge : contour) {
            const ShadowSide side(s_, edge);
            if (!side.is_seen()) continue;
            ++counts_.sides;
            const PlaneCodes codes(side.plane(), s_.space, scale_);
            const DrawnSide drawn{side, line_at_end(side.plane(), s_.eye.centre)};
            draw({0, s_.space.size_px()}, side.change(), drawn,
                 [&](std::int32_t px, std::int32_t py) { return codes.at(px, py); });
        }
    }
    // Each begins a volume where the eye and the light are on one side of it, else ends one.
    void draw_near_ends() {
        for (std::size_t f = 0; f < s_.mesh.facets.size(); ++f) {
            const int weight = s_.eye.sides[f] * s_.light.sides[f];
            if (weight == 0) continue;
            ++counts_.near_ends;
            const PlaneCodes codes(s_.planes[f], s_.space, scale_);
            draw(rows_of(s_, f), weight, NearEnd{s_, f},
                 [&](std::int32_t px, std::int32_t py) { return codes.at(px, py); });
        }
    }
    void draw_far_ends() {
        counts_.end_tests += s_.mesh.facets.size();
        for (std::size_t f = 0; f < s_.mesh.facets.size(); ++f) {
            if (s_.light.sides[f] == 0) continue;
            const FarEnd end(s_, f);
            if (!end.may_be_seen(s_.space)) continue;
            ++counts_.far_ends;
            draw({0, s_.space.size_px()}, -1, end,
                 [&](std::int32_t, std::int32_t) { return scale_.deepest(); });
        }
    }

private:
    struct NearEnd {
        const Setting& s;
        std::size_t facet;
        Run covered_run(const Space&, int row) const { return s.covered_run(facet, row); }
    };

    std::size_t place(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(s_.space.size_px()) +
               static_cast<std::size_t>(column);
    }
    // Takes a polygon's weight where its code passes or fails.
    template <class Polygon, class CodeAt>
    void draw(const Run& rows, int weight, const Polygon& polygon, CodeAt&& code_at) {
        const bool passes = options_.pass == StencilPass::z_pass;
        for (int row = rows.from; row < rows.to; ++row) {
            const Run run = polygon.covered_run(s_.space, row);
            ++counts_.rows;
            for (int column = run.from; column < run.to; ++column) {
                const std::size_t at = place(column, row);
                ++counts_.fills;
                if (shown_[at] == nothing_seen) continue;
                const bool before = code_at(s_.space.centre(column), s_.space.centre(row)) <
                                    store_.codes[at];
                if (before == passes) add(at, passes ? weight : -weight);
            }
        }
    }
    void add(std::size_t at, int n) {
        ++counts_.updates;
        store_.counters[at] = wrapped(store_.counters[at] + n);
    }
    std::int32_t wrapped(std::int32_t n) const {
        return n & ((std::int32_t{1} << options_.counter_bits) - 1);
    }

    const Setting& s_;
    std::span<const std::uint32_t> shown_;
    const DepthScale& scale_;
    const StencilOptions& options_;
    const StencilStore& store_;
    StencilCounts& counts_;
};

}  // namespace

void count_stencil(const Setting& setting, std::span<const std::uint32_t> shown,
                   std::span<const ContourEdge> contour, const DepthScale& scale,
                   const StencilOptions& options, const StencilStore& store,
                   StencilCounts& counts) {
    counts.facets += setting.mesh.facets.size();
    counts.edges += setting.mesh.edges.size();
    counts.contour += contour.size();
    Stencil stencil(setting, shown, scale, options, store, counts);
    stencil.write_codes();
    stencil.start();
    stencil.draw_sides(contour);
    if (options.pass == StencilPass::z_pass) return;
    stencil.draw_near_ends();
    stencil.draw_far_ends();
}

}  // namespace umbra78::shadow::rivals
