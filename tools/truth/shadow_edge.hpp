// The exact edge of a scene's shadow as the observer sees it, and where a drawn contour is from it.
//
// Between two neighbouring pixels of one surface, one lit and one in shadow, the edge is found by
// bisection of the closed form, to a thousandth of a pixel; between such places it is taken as
// straight. Where two surfaces meet in the picture there is no edge of a shadow.
#pragma once

#include "tools/truth/contour.hpp"
#include "tools/truth/scene_truth.hpp"

#include <optional>
#include <vector>

namespace umbra78::tools {

// A surface that turns away from the light shadows itself; another surface casts its shadow.
enum class EdgeKind : std::uint8_t { cast, self };

// A piece of the edge, all of one kind, with the shadow on its right hand.
struct ShadowEdge {
    EdgeKind kind;
    Contour line;
};

// 1 at a pixel if it, its right, its lower and its lower right neighbour are one surface in truth
// and all drawn (`drawn` may be empty: all are).
std::vector<std::uint8_t> cells_of_one_surface(const Truth&, std::span<const std::uint8_t> drawn);

// Requires closed form.
std::vector<ShadowEdge> shadow_edges(const SceneTruth&, std::span<const std::uint8_t> cells);

// Finds the place of the edges that is nearest to a point.
class NearestEdge {
public:
    // Farther than `reach_px` nothing is found. The edges must live.
    NearestEdge(std::span<const ShadowEdge> edges, int size, double reach_px);

    struct Place {
        std::size_t edge;  // its number
        double along;      // pixels from its beginning
        double distance;   // pixels, positive on the lit side
    };
    std::optional<Place> operator()(const ImagePoint&) const;

private:
    struct Piece {
        std::size_t edge;
        double along;  // of its beginning
        ImagePoint from, to;
    };
    std::size_t tile(double column, double row) const;

    int tiles_;
    double reach_;
    std::vector<std::vector<Piece>> pieces_;  // of each tile, those within reach of it
};

}  // namespace umbra78::tools
