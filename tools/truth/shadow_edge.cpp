#include "tools/truth/shadow_edge.hpp"

#include "fixed/trap.hpp"
#include "tools/truth/image_walk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace umbra78::tools {
namespace {

constexpr int bisections = 10;  // to 1/1024 pixel
constexpr double tile_px = 8;

// The place where the light ends between two pixels of one surface, and the kind of the edge there.
std::pair<ImagePoint, EdgeKind> edge_between(const SceneTruth& t, std::size_t dark,
                                             std::size_t lit) {
    const int surface = t.truth.surface[dark];
    ImagePoint in = pixel_centre(dark, t.truth.size), out = pixel_centre(lit, t.truth.size);
    EdgeKind kind = t.truth.n_dot_l[dark] > 0 ? EdgeKind::cast : EdgeKind::self;
    for (int k = 0; k < bisections; ++k) {
        const ImagePoint middle = between(in, out, 0.5);
        const Ray sight = t.observer.ray(middle.column, middle.row);
        const double depth = depth_of(t.scene, surface, t.observer, sight);
        const SurfacePoint point = surface_point(t.scene, surface, t.light, sight, depth);
        if (!point.lit) kind = point.n_dot_l > 0 ? EdgeKind::cast : EdgeKind::self;
        (point.lit ? out : in) = middle;
    }
    return {between(in, out, 0.5), kind};
}

}  // namespace

std::vector<std::uint8_t> cells_of_one_surface(const Truth& truth,
                                               std::span<const std::uint8_t> drawn) {
    const int size = truth.size;
    if (!drawn.empty()) expect_image(drawn.size(), size);
    std::vector<std::uint8_t> cells(truth.visible.size());
    for (int row = 0; row + 1 < size; ++row) {
        for (int column = 0; column + 1 < size; ++column) {
            const auto at = static_cast<std::size_t>(row) * size + column;
            bool one = true;
            for (const std::size_t corner : {at, at + 1, at + size, at + size + 1})
                one &= truth.visible[corner] && truth.surface[corner] == truth.surface[at] &&
                       (drawn.empty() || drawn[corner]);
            cells[at] = one;
        }
    }
    return cells;
}

std::vector<ShadowEdge> shadow_edges(const SceneTruth& t, std::span<const std::uint8_t> cells) {
    fixed::require(t.closed_form, "shadow_edges: the truth has no closed form");
    std::vector<std::uint8_t> dark(t.truth.lit.size());
    for (std::size_t at = 0; at < dark.size(); ++at) dark[at] = !t.truth.lit[at];
    std::vector<EdgeKind> kinds;  // of the places in the order in which contours() asks
    std::vector<ShadowEdge> edges;
    const auto lines = contours(t.truth.size, dark, cells, [&](std::size_t in, std::size_t out) {
        const auto [place, kind] = edge_between(t, in, out);
        kinds.push_back(kind);
        return place;
    });
    std::size_t asked = 0;
    for (const Contour& line : lines) {
        const bool closed = line.front().column == line.back().column &&
                            line.front().row == line.back().row;
        const auto kind_of = [&](std::size_t k) {
            return kinds[asked + (closed && k + 1 == line.size() ? 0 : k)];
        };
        for (std::size_t k = 1; k < line.size(); ++k) {
            // A step between places of two kinds belongs to the one that it comes from.
            if (k == 1 || kind_of(k - 1) != edges.back().kind)
                edges.push_back({kind_of(k - 1), {line[k - 1]}});
            edges.back().line.push_back(line[k]);
        }
        asked += line.size() - (closed ? 1 : 0);
    }
    return edges;
}

NearestEdge::NearestEdge(std::span<const ShadowEdge> edges, int size, double reach_px)
    : tiles_(static_cast<int>(std::ceil(size / tile_px))), reach_(reach_px),
      pieces_(static_cast<std::size_t>(tiles_) * tiles_) {
    const auto tile_of = [&](double at) {
        return std::clamp(static_cast<int>(std::floor(at / tile_px)), 0, tiles_ - 1);
    };
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        double along = 0;
        const Contour& line = edges[edge].line;
        for (std::size_t k = 1; k < line.size(); ++k) {
            const Piece piece{edge, along, line[k - 1], line[k]};
            const auto [left, right] = std::minmax(piece.from.column, piece.to.column);
            const auto [top, bottom] = std::minmax(piece.from.row, piece.to.row);
            for (int y = tile_of(top - reach_); y <= tile_of(bottom + reach_); ++y)
                for (int x = tile_of(left - reach_); x <= tile_of(right + reach_); ++x)
                    pieces_[static_cast<std::size_t>(y) * tiles_ + x].push_back(piece);
            along += pixels_between(piece.from, piece.to);
        }
    }
}

std::optional<NearestEdge::Place> NearestEdge::operator()(const ImagePoint& p) const {
    std::optional<Place> best;
    double nearest = reach_;
    for (const Piece& piece : pieces_[tile(p.column, p.row)]) {
        const double dx = piece.to.column - piece.from.column, dy = piece.to.row - piece.from.row;
        const double px = p.column - piece.from.column, py = p.row - piece.from.row;
        const double length = std::hypot(dx, dy);
        const double part =
            length > 0 ? std::clamp((px * dx + py * dy) / (length * length), 0.0, 1.0) : 0;
        const double away = pixels_between(p, between(piece.from, piece.to, part));
        if (away >= nearest) continue;
        nearest = away;
        // Rows go down, so the left hand of (dx, dy), the lit side, is where this is negative.
        const bool shadow_side = dx * py - dy * px > 0;
        best = Place{piece.edge, piece.along + part * length, shadow_side ? -away : away};
    }
    return best;
}

std::size_t NearestEdge::tile(double column, double row) const {
    const auto clamped = [&](double at) {
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>(std::floor(at / tile_px)), 0, tiles_ - 1));
    };
    return clamped(row) * static_cast<std::size_t>(tiles_) + clamped(column);
}

}  // namespace umbra78::tools
