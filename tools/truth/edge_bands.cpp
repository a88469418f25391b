#include "tools/truth/edge_bands.hpp"

#include "tools/truth/image_walk.hpp"
#include "tools/truth/real3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools {
namespace {

// A surface point P is slid over its surface: the ray from a point beside P to the light meets the
// surface again at t.
struct Slid {
    double t = 0;
    bool over_the_edge = true;  // the surface ends before it
};

// Of a sphere's two crossings the later one is on the side whose outside faces the light.
// Beside a plane
// that faces the light there is nothing of it that could cast a shadow, so it counts as unbounded.
Slid slide(const TruthScene& scene, int surface, bool faces_light, bool inside,
           const Ray& to_light) {
    const int spheres = static_cast<int>(scene.spheres.size());
    if (surface < spheres) {
        const auto hit = crossings(scene.spheres[surface], to_light);
        return hit ? Slid{(*hit)[faces_light != inside ? 1 : 0], false} : Slid{};
    }
    const auto hit = crossing(scene.planes[surface - spheres], to_light);
    return hit ? Slid{hit->t, !faces_light && !hit->inside} : Slid{};
}

// Where the ray leaves the sphere.
double last_of(const TruthScene& scene, int surface, const Ray& ray) {
    const auto hit = crossings(scene.spheres[surface], ray);
    return hit ? (*hit)[1] : 0;
}

// Where the light sees what the observer's pixels see.
class LightImage {
public:
    LightImage(const TruthView& light_view, const Truth& truth)
        : view_(light_view), truth_(truth), seen_(truth.visible.size()) {
        for (std::size_t at = 0; at < seen_.size(); ++at)
            if (truth.visible[at]) seen_[at] = view_.project(truth.position[at]);
    }

    // Cells of `reach` texels a side; what lies outside the image is in its outermost cells.
    std::size_t cells() const { return static_cast<std::size_t>(view_.size) * view_.size; }
    std::size_t cell(std::size_t at, double reach) const {
        const auto [x, y] = place(at, reach);
        return static_cast<std::size_t>(y) * view_.size + x;
    }
    template <class Visit>
    void for_cells_around(std::size_t at, double reach, Visit visit) const {
        const auto [x, y] = place(at, reach);
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, view_.size - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, view_.size - 1); ++u)
                visit(static_cast<std::size_t>(v) * view_.size + u);
    }

    // Whether two pixels are near each other in the light's image and on one piece of surface.
    bool reaches(std::size_t a, std::size_t b, double texels) const {
        const Real3 way = minus(seen_[a], seen_[b]);
        if (way[0] * way[0] + way[1] * way[1] > texels * texels) return false;
        const double texel =
            view_.pixel() * (view_.perspective ? seen_[a][2] / view_.distance : 1);
        const double slope = std::min(tangent(a), tangent(b));
        return std::abs(way[2]) <= texels * texel * (1 + 3 * slope);
    }

private:
    std::array<int, 2> place(std::size_t at, double reach) const {
        const auto inside = [&](double x) {  // and a number, even where the light itself is seen
            return x > 0 ? static_cast<int>(std::min(x / reach, view_.size - 1.0)) : 0;
        };
        return {inside(seen_[at][0]), inside(seen_[at][1])};
    }
    // Of the angle between the surface's normal and the light.
    double tangent(std::size_t at) const {
        const double cosine = std::abs(truth_.n_dot_l[at]);
        return std::sqrt(std::max(1 - cosine * cosine, 0.0)) / std::max(cosine, 1e-9);
    }

    const TruthView& view_;
    const Truth& truth_;
    std::vector<Real3> seen_;  // column, row, depth
};

}  // namespace

// The nearest pixel of the other answer has a neighbour of this one's, so only such pixels need
// a disc; if an unseen pixel stands between, the two are not on one edge.
Band edge_band(const Truth& truth, double radius_px) {
    const int size = truth.size;
    Band band(truth.visible.size());
    for (std::size_t at = 0; at < band.size(); ++at) {
        const auto differs = [&](std::size_t other) {
            return truth.visible[at] && truth.visible[other] && truth.lit[at] != truth.lit[other];
        };
        bool edge = false;
        for_disc(size, at, 1, [&](std::size_t other) { edge |= differs(other); });
        if (!edge) continue;
        for_disc(size, at, radius_px, [&](std::size_t other) { band[other] |= differs(other); });
    }
    return band;
}

Band light_texel_band(const TruthScene& scene, const TruthLight& light, const TruthView& light_view,
                      const Truth& truth, double filter_radius_px, double reach_texels) {
    const Real3 &right = light_view.rotation[0], &up = light_view.rotation[1];
    const auto texel = [&](std::size_t at) {
        const double depth = light_view.project(truth.position[at])[2];
        return light_view.pixel() * (light_view.perspective ? depth / light_view.distance : 1);
    };
    // Whether truth's answer changes where the pixel's point slides by (x, y) in the light's image.
    const auto changes = [&](std::size_t at, double x, double y) {
        const int surface = truth.surface[at];
        const bool faces_light = truth.n_dot_l[at] > 0;
        const Ray ray = light.ray(along(along(truth.position[at], x, right), y, up));
        const bool inside =
            seen_from_inside(scene, surface, truth.position[at], truth.normal[at]);
        const Slid slid = slide(scene, surface, faces_light, inside, ray);
        const bool by_itself = inside && !slid.over_the_edge && faces_light &&
                               last_of(scene, surface, ray) < light.reach();
        if (by_itself || blocked(scene, ray, slid.t, light.reach(), surface))
            return truth.lit[at] != 0;
        return slid.over_the_edge || faces_light != (truth.lit[at] != 0);
    };

    std::array<std::array<double, 2>, 16> ways;
    for (int i = 0; i < 16; ++i) {
        const double reach = reach_texels * (i < 8 ? 1 : 0.5), angle = i * pi / 4;
        ways[i] = {reach * std::cos(angle), reach * std::sin(angle)};
    }
    Band band(truth.visible.size());
    for (std::size_t at = 0; at < band.size(); ++at) {
        if (!truth.visible[at]) continue;
        const double unit = texel(at);
        const bool inside = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
            return changes(at, way[0] * unit, way[1] * unit);
        });
        band[at] = inside;
    }
    return widened(band, truth.size, filter_radius_px);
}

Band seen_texel_band(const TruthView& light_view, const Truth& truth, double reach_texels) {
    const LightImage image(light_view, truth);
    const Band edge = edge_band(truth, 1);
    std::vector<std::vector<std::size_t>> in_cell(image.cells());  // edge pixels, a cell a reach
    for (std::size_t at = 0; at < edge.size(); ++at)
        if (edge[at]) in_cell[image.cell(at, reach_texels)].push_back(at);
    Band band = edge;
    for (std::size_t at = 0; at < band.size(); ++at) {
        if (!truth.visible[at] || edge[at]) continue;
        image.for_cells_around(at, reach_texels, [&](std::size_t cell) {
            for (const std::size_t other : in_cell[cell])
                band[at] |= truth.lit[at] != truth.lit[other] &&
                            image.reaches(at, other, reach_texels);
        });
    }
    return band;
}

Band widened(const Band& band, int size, double radius_px) {
    expect_image(band.size(), size);
    Band wider = band;
    for (std::size_t at = 0; at < band.size() && radius_px >= 1; ++at)
        if (band[at])
            for_disc(size, at, radius_px, [&](std::size_t near) { wider[near] = 1; });
    return wider;
}

}  // namespace umbra78::tools
