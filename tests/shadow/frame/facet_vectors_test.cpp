// Vectors of facets: triangles, polygons cut to the guard band, shading, dicing.
#include "raster/dice.hpp"
#include "raster/draw.hpp"
#include "tests/shadow/frame/vectors.hpp"

#include <algorithm>
#include <memory>

namespace umbra78::test {
namespace {

// A polygon's vertex: X Y Z W, its place, its normal.
Line& operator<<(Line& line, const raster::FacetVertex& v) {
    for (const std::int64_t n : v.screen) line << n;
    for (const std::int64_t n : v.world) line << n;
    for (const std::int64_t n : v.normal) line << n;
    return line;
}
Line& operator<<(Line& line, const raster::Corner& c) { return line << c.x << c.y << c.z; }

raster::Corner some_corner(Inputs& in, std::int64_t reach) {
    const auto word = [&](std::int64_t limit) {
        return static_cast<std::int32_t>(in.between(-limit, limit));
    };
    return {word(reach), word(reach), word(INT32_MAX / 4)};
}

void add_triangles(Inputs& in, Lines& lines) {
    const hw::MachineSpec spec{.xy_bits = 4};
    constexpr std::int32_t half = 1 << (raster::raster_fraction - 1);
    for (int k = 0; k < 40; ++k) {
        const std::int64_t reach = k % 4 == 3 ? raster::max_screen : 5 << 13;
        raster::Corner a = some_corner(in, reach), b = some_corner(in, reach);
        raster::Corner c = some_corner(in, reach);
        if (k % 4 == 1)  // corners on pixels' centres and between them
            for (std::int32_t* v : {&a.x, &a.y, &b.x, &b.y, &c.x, &c.y})
                *v = static_cast<std::int32_t>(fixed::floor_shift(std::int64_t{*v}, 12)) * half;
        if (k == 5) c = {2 * b.x - a.x, 2 * b.y - a.y, 0};
        if (k == 6 || k == 7) {  // a level side through pixels' centres, at the top or the bottom
            a = {-7 * half, (k == 6 ? -5 : 7) * half, a.z};
            b = {9 * half, a.y, b.z};
            c = {3 * half, (k == 6 ? 7 : -5) * half, c.z};
        }
        int count = 0;
        std::int64_t sum = 0;
        raster::Sample first{}, last{};
        raster::sample_triangle(a, b, c, spec, [&](const raster::Sample& s) {
            if (count++ == 0) first = s;
            last = s;
            sum += s.z;
        });
        Line line;
        line << "triangle" << a << b << c << "->" << count;
        if (count > 0)
            line << sum << first.px << first.py << first.z << last.px << last.py << last.z;
        lines.push_back(line.text());
    }
}

void add_polygons(Inputs& in, Lines& lines) {
    for (int k = 0; k < 40; ++k) {
        hw::MachineSpec spec;
        spec.xy_bits = static_cast<int>(in.between(4, 12));
        spec.z_bits = static_cast<int>(in.between(4, 24));
        const bool affine = k % 2 == 0;
        const raster::GuardBand band = raster::guard_band(spec, affine);
        raster::FacetPolygon p;
        p.count = 3;
        Line line;
        line << "polygon" << spec.xy_bits << spec.z_bits << (affine ? "affine" : "perspective");
        for (std::size_t v = 0; v < 3; ++v) {
            raster::FacetVertex& at = p.vertex[v];
            const std::int64_t w = affine || k >= 36 ? 1
                                                     : in.between(-1, 3) * in.between(1, 1 << 20);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int64_t limit = band[axis] * std::max<std::int64_t>(w, 1);
                at.screen[axis] = in.between(-2 * limit, 2 * limit);
                at.world[axis] = in.word(22);
                at.normal[axis] = in.between(-16384, 16384);
            }
            if (k >= 36) at.screen[v] = v == k % 3u ? band[v] * w : -band[v] * w;  // on a plane
            at.screen[3] = w;
            line << at;
        }
        bool cut = false;
        const bool left = p.clip(band, cut);
        line << "->" << (left ? p.count : 0);
        for (std::size_t v = 0; left && v < p.count; ++v) line << p.vertex[v];
        lines.push_back(line.text());
    }
}

void add_shades(Inputs& in, Lines& lines) {
    const auto direction = [&](bool to_point) {
        raster::WideVector d;
        for (std::int64_t& n : d) n = in.between(-16384, 16384);
        const raster::UnitVector unit = raster::unit_vector(d);
        for (std::int64_t& n : d) n *= 1 << 9;
        return raster::Toward{to_point, unit, d};
    };
    for (int k = 0; k < 40; ++k) {
        const bool flat = k % 4 == 0, to_point = k % 3 == 0;
        std::array<raster::FacetVertex, 3> v;
        std::array<raster::WideVector, 3> facet;
        raster::FacetTriangle t{{&v[0], &v[1], &v[2]}, {}};
        Line line;
        line << (flat ? "flat" : "smooth") << (to_point ? "points" : "directions");
        for (std::size_t c = 0; c < 3; ++c) {
            t.screen[c] = some_corner(in, k % 2 == 0 ? 5 << 13 : raster::max_screen);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                v[c].world[axis] = in.word(22);
                v[c].normal[axis] = in.between(-16384, 16384);
            }
            v[c].screen = {0, 0, 0, k % 5 == 0 ? 1 : in.between(1, std::int64_t{1} << 43)};
            if (k % 7 == 3 && c == 1) v[c].screen[3] = in.between(1, 1 << 20);
            facet[c] = v[c].world;
            line << t.screen[c] << v[c].screen[3];
            for (const std::int64_t n : v[c].world) line << n;
            for (const std::int64_t n : v[c].normal) line << n;
        }
        raster::ShadingSpec spec;
        spec.ambient_q8 = static_cast<std::int32_t>(in.between(0, 256));
        spec.sources[0].toward = direction(to_point);
        spec.viewer = direction(to_point);
        for (const raster::Toward& to : {spec.sources[0].toward, spec.viewer})
            for (std::size_t axis = 0; axis < 3; ++axis)
                line << (to_point ? to.point[axis] : std::int64_t{to.direction[axis]});
        const raster::Material material{static_cast<std::int32_t>(in.between(0, 255)),
                                        static_cast<std::int32_t>(in.between(0, 255)),
                                        static_cast<std::int32_t>(in.between(0, 8))};
        // The corners' mean lies in the triangle.
        raster::Sample s{};
        s.x = static_cast<std::int32_t>(
            (std::int64_t{t.screen[0].x} + t.screen[1].x + t.screen[2].x) / 3);
        s.y = static_cast<std::int32_t>(
            (std::int64_t{t.screen[0].y} + t.screen[1].y + t.screen[2].y) / 3);
        const raster::FacetShading shading(t, facet, flat, spec, material);
        const raster::Shade lit = shading.shade(s, 0)[0], dark = shading.shade(s, 1)[0];
        line << spec.ambient_q8 << material.diffuse[0] << material.specular[0] << material.shininess
             << s.x << s.y << "->" << lit.intensity << lit.direct[0]
             << dark.intensity << dark.direct[0];
        lines.push_back(line.text());
    }
}

TEST(Vectors, Triangles) {
    Inputs in(21);
    Lines lines;
    add_triangles(in, lines);
    add_polygons(in, lines);
    add_shades(in, lines);
    check_vectors("triangles",
                  {"Section 21. xy_bits is 4 for triangles.",
                   "triangle a (x y z) b c -> number of samples, then the sum of their Z, and px "
                   "py Z of the first and of the last, line by line from the top",
                   "polygon xy_bits z_bits affine|perspective, three vertices: X Y Z W, object "
                   "place x 2^6, normal -> number of vertices left in the guard band, and these",
                   "flat|smooth directions|points, three corners: x y z W, object place x 2^6, "
                   "normal; to_light, to_viewer, or where light and eye are (in places' words); "
                   "ambient diffuse specular shininess, a covered place x y -> intensity and "
                   "direct share lit, and in shadow"},
                  lines);
}

// A patch whose points are their bilinear mean and some words more; the edges of some are points.
raster::Patch some_patch(Inputs& in, int k) {
    raster::Patch p;
    const std::int64_t reach =
        k % 5 == 4 ? raster::max_world : std::int64_t{1} << in.between(8, 22);
    const std::int64_t bend =
        k % 5 == 4 ? reach
                   : std::max<std::int64_t>(reach / (std::int64_t{1} << in.between(0, 9)), 1);
    std::array<raster::World, 4> corner;
    const auto word = [&](std::int64_t limit) {
        return static_cast<std::int32_t>(in.between(-limit, limit));
    };
    for (raster::World& w : corner) w = {word(reach / 2), word(reach / 2), word(reach / 2)};
    for (std::int32_t j = 0; j < 4; ++j) {
        for (std::int32_t i = 0; i < 4; ++i) {
            const auto mean = [&](std::int32_t raster::World::*axis) {
                return ((3 - j) * ((3 - i) * (corner[0].*axis / 9) + i * (corner[1].*axis / 9)) +
                        j * ((3 - i) * (corner[2].*axis / 9) + i * (corner[3].*axis / 9))) +
                       word(bend / 2);
            };
            p.control[static_cast<std::size_t>(4 * j + i)] = {
                mean(&raster::World::x), mean(&raster::World::y), mean(&raster::World::z)};
        }
    }
    const auto collapse = [&](std::size_t from, std::size_t step) {
        for (std::size_t n = 1; n < 4; ++n) p.control[from + n * step] = p.control[from];
    };
    if (k % 7 == 1) collapse(0, 1);
    if (k % 7 == 2) collapse(12, 1);
    if (k % 7 == 3) collapse(0, 4);
    if (k % 7 == 4) collapse(3, 4);
    if (k % 21 == 8) collapse(4, 1);  // and the next row: the replacement is zero, too, at k = 1
    return p;
}

Line& operator<<(Line& line, const raster::World& w) { return line << w.x << w.y << w.z; }

// The sum that decides the patch's level, as section 22 has it, for a tolerance at its very limit.
std::int64_t limit_of(const raster::Patch& p, int level) {
    std::int64_t low = 0, high = std::int64_t{1} << 40;  // the least tolerance that is enough
    while (low < high) {
        const std::int64_t middle = low + (high - low) / 2;
        if (raster::dice_levels(p, level + 1, middle).patch <= level)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

TEST(Vectors, Dicing) {
    Inputs in(22);
    Lines lines;
    const auto memory = std::make_unique<raster::DiceMemory>();
    for (int k = 0; k < 84; ++k) {
        const raster::Patch p = some_patch(in, k);
        const auto most = static_cast<int>(in.between(0, 5));
        std::int64_t tolerance = std::int64_t{1} << in.between(0, 16);
        if (k % 2 == 0) tolerance = limit_of(p, k % 4) - (k % 3 == 0 ? 1 : 0);
        const raster::DiceLevels levels = raster::dice_levels(p, most, tolerance);
        Line line;
        line << "levels" << most << tolerance;
        for (const raster::World& w : p.control) line << w;
        line << "->" << levels.patch;
        for (const int edge : levels.edge) line << edge;
        lines.push_back(line.text());
        const raster::Mesh mesh = raster::dice(p, levels, true, *memory);
        const std::int64_t cells = std::int64_t{1} << levels.patch;
        const std::int64_t i = k % 3 == 0 ? 0 : in.between(0, cells), j = in.between(0, cells);
        const auto at = static_cast<std::size_t>(j * (cells + 1) + i);
        Line vertex;
        vertex << "vertex" << levels.patch << i << j;
        for (const raster::World& w : p.control) vertex << w;
        vertex << "->" << mesh.vertices[at];
        for (const std::int32_t c : mesh.normals[at]) vertex << c;
        lines.push_back(vertex.text());
    }
    check_vectors("dicing",
                  {"Section 22.",
                   "levels dice_levels tolerance, 16 points in world words -> the patch's level, "
                   "and those of its edges j = 0, j = k, i = 0, i = k",
                   "vertex level i j, 16 points -> place in world words, normal"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
