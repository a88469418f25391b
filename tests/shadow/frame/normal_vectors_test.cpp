// Vectors of kept normals (section 27): what is kept of leaves and facets, and what the test makes
// of it in a light's view.
#include "raster/draw.hpp"
#include "shadow/bias.hpp"
#include "tests/shadow/frame/vectors.hpp"

#include <array>

namespace umbra78::test {
namespace {

raster::UnitVector some_direction(Inputs& in) {
    return raster::unit_vector({in.word(20), in.word(20), in.word(20) + 1});
}

raster::Toward some_viewer(Inputs& in, bool to_point, Line& line) {
    raster::Toward viewer{to_point, some_direction(in), {in.word(24), in.word(24), in.word(24)}};
    line << (to_point ? "point" : "direction");
    for (std::size_t k = 0; k < 3; ++k)
        line << (to_point ? viewer.point[k] : std::int64_t{viewer.direction[k]});
    return viewer;
}

// Blocks of every size, some of them without extent in a direction.
void add_leaves(Inputs& in, Lines& lines) {
    const raster::Material material{};
    for (int k = 0; k < 32; ++k) {
        std::array<raster::Component, 3> place{};
        Line line;
        line << "leaf";
        for (raster::Component& c : place) {
            const std::int64_t at = in.word(21);
            for (std::size_t corner = 0; corner < 4; ++corner) {
                c.f[corner] = at + in.word(k % 8 == 3 ? 1 : 18);
                for (auto* g : {&c.gu, &c.gv, &c.guv}) (*g)[corner] = in.word(10);
            }
            if (k % 16 == 5) c = {{at, at, at, at}, {}, {}, {}};
            line << c;
        }
        raster::ShadingSpec spec;
        spec.keeps_normals = true;
        spec.rule = k % 2 == 0 ? raster::ShadingRule::none : raster::ShadingRule::phong;
        spec.viewer = some_viewer(in, k % 4 == 1, line);
        raster::Sample s{};
        s.leaf_i = static_cast<int>(in.between(0, 15));
        s.leaf_j = static_cast<int>(in.between(0, 15));
        line << s.leaf_i << s.leaf_j << "->";
        for (const std::int32_t n : raster::BlockShading(place, spec, material).normal(s))
            line << n;
        lines.push_back(line.text());
    }
}

void add_facets(Inputs& in, Lines& lines) {
    const raster::Material material{};
    for (int k = 0; k < 24; ++k) {
        std::array<raster::FacetVertex, 3> v;
        std::array<raster::WideVector, 3> facet;
        Line line;
        line << "facet";
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                v[c].world[axis] = facet[c][axis] = c == 2 && k % 12 == 7 ? facet[1][axis]
                                                                          : in.word(22);
                line << facet[c][axis];
            }
        raster::ShadingSpec spec;
        spec.keeps_normals = true;
        spec.viewer = some_viewer(in, k % 2 == 1, line);
        const raster::FacetTriangle t{{&v[0], &v[1], &v[2]}, {}};
        line << "->";
        for (const std::int32_t n :
             raster::FacetShading(t, facet, k % 4 < 2, spec, material).normal({}))
            line << n;
        lines.push_back(line.text());
    }
}

shadow::LightNormal word_of_light(Inputs& in, int k) {
    const std::int64_t most = k % 6 == 5 ? (1 << 23) - 1 : std::int64_t{1} << in.between(0, 22);
    const auto one = [&] { return in.between(-most, most); };
    shadow::LightNormal m{one(), one(), one()};
    if (k % 16 == 3) m[2] = 0;
    if (k % 16 == 7) m = {};
    return m;
}

// Normals in light's views at any angle, and edge-on.
void add_turned(Inputs& in, Lines& lines) {
    for (int k = 0; k < 24; ++k) {
        raster::View view{};
        const auto elevation = static_cast<std::int32_t>(in.between(-90, 90)) << 16;
        const auto azimuth = static_cast<std::int32_t>(in.between(-180, 180)) << 16;
        view.axes = raster::axes_from_angles(azimuth, elevation);
        Line line;
        line << "light";
        for (const raster::Axis& axis : {view.axes.right, view.axes.up, view.axes.back})
            for (const std::int32_t a : axis) line << a;
        raster::UnitVector n = some_direction(in);
        if (k == 5) n = {16384, 16384, 16384};
        for (const std::int32_t a : n) line << a;
        line << "->";
        for (const std::int64_t m : shadow::in_light(n, shadow::light_axes(view))) line << m;
        lines.push_back(line.text());
    }
}

// The slopes and the moves of all that a light's words can be.
void add_tested(Inputs& in, Lines& lines) {
    for (int k = 0; k < 96; ++k) {
        const bool moves = k % 2 == 1;
        const int fraction = static_cast<int>(in.between(0, 12));
        Line line;
        line << (moves ? "moved" : "plane") << fraction;
        shadow::LightScale light;
        if (k % 4 < 2) {
            light.quanta_q16 = k % 12 == 0 ? shadow::max_texel_quanta : in.between(1, 1 << 26);
            line << light.quanta_q16;
        } else {
            light.focal_q8 = in.between(1, 1 << in.between(1, 30));
            light.reach_q8 = in.between(-1000, std::int64_t{1} << in.between(16, 40));
            line << "lamp" << light.reach_q8 << light.focal_q8;
        }
        const shadow::LightNormal m = word_of_light(in, k);
        const hw::Point at{in.word(18), in.word(18), in.word(17), hw::DivideStatus::ok};
        for (const std::int64_t word : m) line << word;
        line << at.x << at.y << at.z;
        if (moves) {
            const std::int64_t c = in.between(0, 16 << 8);
            const hw::Point p = shadow::moved_along(at, m, c, light.at(at, fraction), fraction);
            line << c << "->" << p.x << p.y << p.z;
        } else {
            const std::int64_t x2 = 2 * at.x + in.word(10), y2 = 2 * at.y + in.word(10);
            const shadow::ReceiverPlane plane =
                shadow::plane_of_normal(at, m, light, fraction, INT64_MAX);
            line << x2 << y2 << "->" << plane.slope_x << plane.slope_y << plane.change(x2, y2);
        }
        lines.push_back(line.text());
    }
}

TEST(Vectors, Normals) {
    Inputs in(27);
    Lines lines;
    add_leaves(in, lines);
    add_facets(in, lines);
    add_turned(in, lines);
    add_tested(in, lines);
    check_vectors("normals",
                  {"Section 27.",
                   "leaf a block's object components x y z (16 each, times 2^6), to_viewer or",
                   "where the eye is (object words times 2^6), leaf i j -> N",
                   "facet three object places (times 2^6), to_viewer or the eye as above -> N",
                   "light right up back (Q2.30) N -> m",
                   "plane fraction_bits, quanta_a_texel or \"lamp\" reach focal, m, a pixel's",
                   "results X Y Z, twice the place -> slope_X slope_Y change, 0 without a plane",
                   "moved fraction_bits, the light, m and X Y Z as above, c -> the results, moved"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
