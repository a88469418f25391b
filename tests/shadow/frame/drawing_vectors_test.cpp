// Vectors of drawing: the transform unit, corrections, splits, the block rule, samples, shading.
#include "raster/draw.hpp"
#include "tests/shadow/frame/vectors.hpp"

namespace umbra78::test {
namespace {

using raster::Bounds;
using raster::Component;

std::array<std::int64_t, 16> some_controls(Inputs& in, int bits) {
    std::array<std::int64_t, 16> p;
    for (std::int64_t& v : p) v = in.word(bits);
    return p;
}
// A block about as large as those that are drawn, around `at`.
Component small_component(Inputs& in, std::int64_t at, int bits) {
    std::array<std::int64_t, 16> p;
    for (std::int64_t& v : p) v = at + in.word(bits);
    return raster::component_from_bezier(p);
}

Line& operator<<(Line& line, const Bounds& b) {
    return line << b.min << b.max << b.slope_u << b.slope_v << b.bend_u << b.bend_v;
}

TEST(Vectors, TransformUnit) {
    constexpr std::array<const char*, 3> statuses{"ok", "divisor_not_positive", "overflow"};
    constexpr std::array<const char*, 2> orders{"exact", "round_first"};
    constexpr std::array<const char*, 7> roundings{
        "floor", "ceiling", "to_zero", "half_up", "half_to_zero", "half_away", "half_even"};
    Inputs in(5);
    Lines lines;
    for (int k = 0; k < 72; ++k) {
        hw::MachineSpec s;
        s.xy_bits = static_cast<int>(in.between(4, 12));
        s.z_bits = static_cast<int>(in.between(4, 24));
        s.coefficient_bits = static_cast<int>(in.between(8, 32));
        s.fraction_bits = static_cast<int>(in.between(0, 12));
        s.max_accumulator_bits = k % 3 == 0 ? static_cast<int>(in.between(16, 40)) : 64;
        s.product_rounding = static_cast<fixed::Rounding>(in.between(0, 6));
        s.transform_rounding = static_cast<fixed::Rounding>(in.between(0, 6));
        s.divide_order = static_cast<hw::DivideOrder>(in.between(0, 1));
        hw::MatrixWords m;
        m.affine = k % 2 == 0;
        for (auto& row : m.word)
            for (std::int32_t& w : row) w = static_cast<std::int32_t>(in.word(s.coefficient_bits));
        for (int& e : m.exponent) e = static_cast<int>(in.between(-12, 6));
        if (m.affine) m.word[3] = {0, 0, 0, 1 << (s.coefficient_bits - 2)};
        if (m.affine) m.exponent[3] = 0;
        if (k % 4 == 1) m.word[3] = {1, -1, 1, (1 << (s.coefficient_bits - 2)) - 1};
        const auto word = [&] { return static_cast<std::int32_t>(in.word(s.word_bits())); };
        const hw::Words v{word(), word(), word()};
        const hw::Point p = hw::TransformUnit(s, m)(v);
        Line line;
        line << s.xy_bits << s.z_bits << s.coefficient_bits << s.fraction_bits
             << s.max_accumulator_bits << roundings[static_cast<std::size_t>(s.product_rounding)]
             << roundings[static_cast<std::size_t>(s.transform_rounding)]
             << orders[static_cast<std::size_t>(s.divide_order)] << (m.affine ? "affine" : "not");
        for (const auto& row : m.word)
            for (const std::int32_t w : row) line << w;
        for (const int e : m.exponent) line << e;
        line << v.x << v.y << v.z << "->" << statuses[static_cast<std::size_t>(p.status)];
        if (p.status == hw::DivideStatus::ok) line << p.x << p.y << p.z;
        lines.push_back(line.text());
    }
    check_vectors("transform_unit",
                  {"Section 5, for screen words. xy_bits z_bits coefficient_bits fraction_bits",
                   "accumulator_bits product_rounding transform_rounding divide_order, affine or",
                   "not, coefficients (16) exponents (4) x y z -> status X Y Z"},
                  lines);
}

TEST(Vectors, Blocks) {
    Inputs in(6);
    Lines corrections, splits;
    for (int k = 0; k < 24; ++k) {
        const auto p = some_controls(in, 40);
        Line line;
        for (const std::int64_t v : p) line << v;
        const Component c = raster::component_from_bezier(p);
        corrections.push_back((line << "->" << c << "bounds" << raster::bounds(c)).text());
        Component low, high;
        k % 2 == 0 ? raster::split_u(c, low, high) : raster::split_v(c, low, high);
        Line halves;
        halves << (k % 2 == 0 ? "u" : "v") << c;
        splits.push_back((halves << "->" << low << high).text());
    }
    check_vectors("corrections",
                  {"Section 6: 16 control values, (i, j) at 4 j + i -> f (4) gu (4) gv (4) guv (4)",
                   "and their bounds: min max slope_u slope_v bend_u bend_v"},
                  corrections);
    check_vectors("splits",
                  {"Section 6: the direction, f (4) gu (4) gv (4) guv (4)",
                   "-> lower half (16), upper half (16)"},
                  splits);
}

TEST(Vectors, BlockRule) {
    constexpr std::array<const char*, 4> actions{"outside", "u", "v", "draw"};
    Inputs in(7);
    Lines lines;
    hw::MachineSpec s;
    for (int k = 0; k < 60; ++k) {
        s.z_bits = k % 5 == 4 ? 24 : 16;
        raster::ScreenBounds b;
        std::array<Component, 3> c;
        const std::int64_t edge = 256 * 8192 + 128;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int bits = static_cast<int>(in.between(8, k % 3 == 0 ? 30 : 17));
            std::int64_t at = in.word(22);
            if (k % 6 == 1) at = (k % 4 == 1 ? 1 : -1) * (edge + in.between(-300, 300));
            c[axis] = k % 6 == 1 ? small_component(in, at, 7) : small_component(in, at, bits);
            b[axis] = raster::bounds(c[axis]);
        }
        Line line;
        line << "affine" << s.xy_bits << s.z_bits << c[0] << c[1] << c[2] << "->";
        const auto action = raster::block_action(b, s);
        lines.push_back((line << actions[static_cast<std::size_t>(action)]).text());
    }
    constexpr std::array<const char*, 3> visibilities{"bounds", "outside", "crosses"};
    for (int k = 0; k < 72; ++k) {
        s.z_bits = k % 5 == 4 ? 24 : 16;
        std::array<Component, 4> c;
        // W, how far it and X, Y, Z spread, and the pixel about which they do: behind or across
        // the eye's plane, small blocks, close to the eye, beside the frame, far out.
        const int mode = k % 6;
        const std::int64_t w =
            mode == 2 ? in.between(300, 1 << 16) : in.between(1 << 24, std::int64_t{1} << 34);
        const int w_bits = mode == 0 ? 35 : mode == 2 ? 5 : static_cast<int>(in.between(8, 26));
        const int bits = static_cast<int>(mode == 1 ? in.between(10, 30) : in.between(20, 42));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::int64_t px = in.between(-255, 255);
            if (mode == 3) px *= 8;
            if (mode >= 4 && axis == 0) px = in.between(3900, mode == 4 ? 5000 : 4200);
            c[axis] = small_component(in, px * w, mode == 5 ? 43 : bits);
        }
        c[3] = small_component(in, mode == 0 && k % 4 == 0 ? -w : w, w_bits);
        raster::ScreenBounds b;
        const auto seen = raster::projected_bounds(c, s, b);
        Line line;
        line << "perspective" << s.xy_bits << s.z_bits << c[0] << c[1] << c[2] << c[3] << "->"
             << visibilities[static_cast<std::size_t>(seen)];
        if (seen == raster::Visibility::bounded)
            line << b[0] << b[1] << b[2]
                 << actions[static_cast<std::size_t>(raster::block_action(b, s))]
                 << (raster::unbounded_both_ways(b) ? "huge" : "finite");
        lines.push_back(line.text());
    }
    check_vectors("block_rule",
                  {"Sections 6 and 14; a component is f (4) gu (4) gv (4) guv (4).",
                   "affine xy_bits z_bits X Y Z -> outside, u, v or draw",
                   "perspective xy_bits z_bits X Y Z W -> outside, or crosses, or bounds of X/W,",
                   "Y/W and Z/W (6 each), what section 6's rule makes of them, and huge if a",
                   "slope or bend is 2^58 or more in both directions"},
                  lines);
}

TEST(Vectors, Samples) {
    Inputs in(8);
    Lines lines;
    for (int k = 0; k < 16; ++k) {
        const Component c = small_component(in, in.word(22), 16);
        std::array<raster::CornerGrid<std::int32_t>, 1> grid;
        raster::expand<std::int32_t, 1>(std::array{c}, grid);
        Line line;
        line << "corners" << c << "->";
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {0, 1}, {7, 3}, {8, 8}, {15, 9},
                                  {16, 15}, {16, 16}})
            line << grid[0][static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
        lines.push_back(line.text());
    }
    for (int k = 0; k < 96; ++k) {
        const auto corner = [&] {
            const auto v = [&](int bits) { return static_cast<std::int32_t>(in.word(bits)); };
            return raster::Corner{v(13), v(13), v(20)};
        };
        const raster::Corner a = corner(), b = corner(), c = k % 12 == 0 ? a : corner();
        const auto place = [&](std::int32_t p, std::int32_t q) {
            return (p + q) / 2 + static_cast<std::int32_t>(in.between(-260, 260));
        };
        const std::int32_t x = place(a.x, b.x), y = place(a.y, b.y);
        std::int64_t z = 0;
        Line line;
        line << "triangle";
        for (const raster::Corner& p : {a, b, c}) line << p.x << p.y << p.z;
        line << x << y << "->";
        if (raster::triangle_depth(a, b, c, x, y, z)) {
            line << z;
        } else {
            line << "none";
        }
        lines.push_back(line.text());
    }
    for (int k = 0; k < 32; ++k) {
        hw::MachineSpec s;
        s.z_bits = static_cast<int>(in.between(4, 24));
        const std::int64_t half = s.depth_offset() << raster::depth_guard(s);
        const std::int64_t at = k % 3 == 0 ? half : k % 3 == 1 ? -half : in.word(20);
        std::int64_t z = at + in.between(-200, 200);
        if (k % 6 == 0) z = half - (std::int64_t{1} << raster::depth_guard(s));  // the background's
        std::uint32_t code = 0;
        Line line;
        line << "code" << s.xy_bits << s.z_bits << z << "->";
        if (raster::depth_code(z, s, code)) {
            line << code;
        } else {
            line << "none";
        }
        lines.push_back(line.text());
    }
    check_vectors("samples",
                  {"Section 7.",
                   "corners f (4) gu (4) gv (4) guv (4) -> leaf corners (0,0) (1,0) (0,1) (7,3) "
                   "(8,8) (15,9) (16,15) (16,16)",
                   "triangle a (x y z) b c, place x y -> depth, or none",
                   "code xy_bits z_bits depth -> Z code, or none"},
                  lines);
}

// With zero tangents in u: those of the corners 0 and 2, whose normals then need the chord of their
// own edge (case 0) or, where the edge 0..1 is a point, of the opposite one (case 1); all four, so
// that there is no normal (case 2). With coinciding control points these are the corrections.
void let_points_coincide(Component& c, int which) {
    const std::int64_t a = c.gu[0], b = c.gu[2];
    c.f[1] = which == 0 ? c.f[0] + 4 * a : c.f[0];
    c.f[3] = which == 2 ? c.f[2] : c.f[2] + 4 * b;
    c.gu = {which == 0 ? a : 0, which == 0 ? a : 0, which == 2 ? 0 : b, which == 2 ? 0 : b};
}

Component with_u_and_v_exchanged(const Component& c) {
    const auto corners = [](const auto& q) {
        return std::array<std::int64_t, 4>{q[0], q[2], q[1], q[3]};
    };
    return {corners(c.f), corners(c.gv), corners(c.gu), corners(c.guv)};
}

TEST(Vectors, Shading) {
    Inputs in(9);
    Lines lines;
    for (int k = 0; k < 76; ++k) {
        std::array<Component, 3> place;
        for (Component& c : place) c = small_component(in, in.word(21), k % 16 == 3 ? 1 : 19);
        if (k % 8 == 5)  // an edge that is a point
            for (Component& c : place) {
                c.f[1] = c.f[0];
                c.gu[0] = c.gu[1] = 0;
            }
        for (Component& c : place) {
            if (k >= 64) let_points_coincide(c, k % 3);
            if (k >= 64 && k % 2 == 1) c = with_u_and_v_exchanged(c);
        }
        raster::ShadingSpec spec;
        raster::Toward& light = spec.sources[0].toward;
        spec.ambient_q8 = static_cast<std::int32_t>(in.between(0, 256));
        const auto direction = [&] {
            raster::UnitVector u;
            raster::WideVector v{in.word(20), in.word(20), in.word(20) + 1};
            return u = raster::unit_vector(v);
        };
        light.direction = direction();
        spec.viewer.direction = direction();
        light.to_point = k % 4 == 1;
        for (std::int64_t& c : light.point) c = in.word(24);
        const auto level = [&](std::int64_t max) {
            return static_cast<std::int32_t>(in.between(0, max));
        };
        const raster::Material material{level(255), level(255), level(8)};
        const int i = static_cast<int>(in.between(0, 15)), j = static_cast<int>(in.between(0, 15));
        const bool in_shadow = k % 8 == 7;
        Line line;
        line << place[0] << place[1] << place[2] << (light.to_point ? "point" : "direction");
        for (std::size_t c = 0; c < 3; ++c) {
            if (light.to_point) {
                line << light.point[c];
            } else {
                line << light.direction[c];
            }
        }
        for (const std::int32_t c : spec.viewer.direction) line << c;
        line << spec.ambient_q8 << material.diffuse[0] << material.specular[0]
             << material.shininess << i << j << (in_shadow ? "shadow" : "open") << "->";
        const raster::Shade s =
            raster::BlockShading(place, spec, material).shade(i, j, in_shadow)[0];
        lines.push_back((line << int{s.intensity} << int{s.direct[0]}).text());
    }
    check_vectors("shading",
                  {"Section 9: a block's object components x y z (16 each, times 2^6), the light",
                   "as a direction (Q1.14) or as a point (object words times 2^6), to_viewer,",
                   "ambient, diffuse, specular, shininess, leaf i j, shadow or open",
                   "-> intensity direct"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
