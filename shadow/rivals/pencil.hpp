// Pencils: the planes through a centre of projection and every edge of a mesh.
//
// The eye's pencil says what covers a pixel, and a light's says what shadows a point: one
// question, asked from two places. On the ray from the centre o through a point P the facet F lies
// before P if
//
//   the three planes through o and F's edges have F's inside and P on one side, and
//   F's own plane parts o from P.
//
// `side` is the side of a facet's plane on which the centre lies: 1 or -1, and 0 where the facet
// is seen edge-on, or has no inside; then it hides nothing.
#pragma once

#include "shadow/rivals/mesh.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

struct Pencil {
    Centre centre{};
    std::span<const SeenPlane> edges;    // from low to high vertex
    std::span<const std::int8_t> sides;  // of each facet

    // The sign that the plane of side k of a facet has inside the facet.
    int inside(const Mesh& mesh, std::size_t facet, std::size_t k) const {
        const bool forward = mesh.sides[facet][k] % 2 == 0;
        return forward ? -sides[facet] : sides[facet];
    }
    const SeenPlane& edge(const Mesh& mesh, std::size_t facet, std::size_t k) const {
        return edges[mesh.sides[facet][k] / 2];
    }
};

// A mesh with what the eye and one light make of it.
struct Setting {
    Space space{};
    Mesh mesh{};
    std::span<const SeenPlane> planes;  // of the facets
    Pencil eye{}, light{};

    // A facet is lit only where the light is on the side that is seen.
    bool attached(std::size_t facet) const { return eye.sides[facet] != light.sides[facet]; }
    // Whether facet f lies between `from` and the point of the facet `on` that a pixel shows.
    bool hides(const Pencil& from, std::size_t f, std::size_t on, std::int32_t px,
               std::int32_t py) const;
    // The columns of a row at which it does.
    Run hidden_run(const Pencil& from, std::size_t f, std::size_t on, int row) const;
    // The columns of a row that a facet covers, whatever lies before it.
    Run covered_run(std::size_t facet, int row) const;
};

// Setting::hides for the light, of points that often show the facet of the one before: the four
// lines on it, by which it is told, are kept.
class HidingLines {
public:
    bool hide(const Setting& s, std::uint32_t facet, std::uint32_t on, std::int32_t px,
              std::int32_t py);

private:
    const ScreenLine& line(const Setting& s, std::size_t i);

    std::uint32_t facet_ = UINT32_MAX, on_ = UINT32_MAX;
    std::size_t made_ = 0;
    std::array<ScreenLine, 4> lines_;  // the facet's plane, its edges
};

std::size_t setting_bytes(std::size_t facets, std::size_t edges);
// False if the memory is too small.
bool make_setting(const Space& space, const Mesh& mesh, const Centre& light,
                  std::span<std::byte> memory, Setting& out);

}  // namespace umbra78::shadow::rivals
