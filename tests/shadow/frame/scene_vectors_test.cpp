// Vectors of the scene's words: decimals, sines, patches, views and loaded matrices.
#include "fixed/decimal.hpp"
#include "fixed/sine.hpp"
#include "raster/blob.hpp"
#include "raster/planar.hpp"
#include "raster/projection.hpp"
#include "raster/view.hpp"
#include "shadow/bias.hpp"
#include "tests/shadow/frame/vectors.hpp"

namespace umbra78::test {
namespace {

TEST(Vectors, Decimals) {
    Lines lines;
    for (const char* number : {"0", "1", "-1", "0.1", "-0.1", "0.72", "-1.05", "100", "1e-5",
                               "32766.999", "0.0000076293945312", "0.00000762939453125",
                               "0.0000076293945313", "0.00002288818359375", "-0.00000762939453125",
                               "-0.00002288818359375", "0.02", "359.99999"})
        for (const int fraction : {8, 16})
            lines.push_back((Line() << number << fraction << "->"
                                    << fixed::parse_decimal(number, fraction, 48).value).text());
    check_vectors("decimals", {"Section 3: a decimal, fraction bits -> the word."}, lines);
}

TEST(Vectors, Sines) {
    Inputs in(1);
    Lines lines;
    const auto add = [&](std::int64_t angle) {
        const fixed::SineCosine s = fixed::sine_cosine(static_cast<std::int32_t>(angle));
        lines.push_back((Line() << angle << "->" << s.sine << s.cosine).text());
    };
    for (int degrees = -360; degrees <= 360; degrees += 45) add(degrees * 65536);
    for (const int degrees : {30, 60, 1, 89, 100}) add(degrees * 65536);
    for (int k = 0; k < 20; ++k) add(in.between(-360 * 65536, 360 * 65536));
    check_vectors("sines", {"Section 3: an angle, Q15.16 degrees -> sine and cosine, Q2.30."},
                  lines);
}

TEST(Vectors, Patches) {
    Inputs in(2);
    Lines lines;
    const auto coordinate = [&] { return static_cast<std::int32_t>(in.word(24)); };
    for (int k = 0; k < 24; ++k) {
        const raster::Sphere s{{coordinate(), coordinate(), coordinate()},
                               static_cast<std::int32_t>(in.between(1, 1 << 20)), 0};
        std::array<raster::Patch, raster::patches_per_sphere> patches;
        raster::sphere_patches(s, patches);
        const auto patch = in.between(0, 31), point = in.between(0, 15);
        const raster::World& p =
            patches[static_cast<std::size_t>(patch)].control[static_cast<std::size_t>(point)];
        lines.push_back((Line() << "sphere" << s.centre.x << s.centre.y << s.centre.z << s.radius
                                << patch << point << "->" << p.x << p.y << p.z).text());
    }
    for (int k = 0; k < 12; ++k) {
        const raster::Plane s{{coordinate(), coordinate(), coordinate()},
                              {coordinate(), coordinate(), coordinate()},
                              {coordinate(), coordinate(), coordinate()}, 0};
        const auto point = in.between(0, 15);
        const raster::World p = raster::plane_patch(s).control[static_cast<std::size_t>(point)];
        Line line;
        line << "plane";
        for (const raster::World* w : {&s.origin, &s.u, &s.v}) line << w->x << w->y << w->z;
        lines.push_back((line << point << "->" << p.x << p.y << p.z).text());
    }
    for (int k = 0; k < 24; ++k) {
        raster::Patch patch{};
        const std::array<std::int32_t, 4> near{65534, 65535, 131068, 131069};  // where it changes
        const auto largest = k < 4 ? near[static_cast<std::size_t>(k)]
                                   : static_cast<std::int32_t>(std::abs(in.word(31)) % 2147352576);
        patch.control[5] = {-largest, largest / 3, -largest / 5};
        const hw::WordFormat f = raster::object_format(std::span(&patch, 1));
        const hw::Words w = raster::to_object_words(patch, f)[5];
        lines.push_back((Line() << "object" << patch.control[5].x << patch.control[5].y
                                << patch.control[5].z << "->" << f.fraction << w.x << w.y << w.z)
                            .text());
    }
    check_vectors("patches",
                  {"Section 3, world words Q15.16.",
                   "sphere centre (3) radius patch point -> x y z",
                   "plane origin (3) u (3) v (3) point -> x y z",
                   "object x y z, the scene's only point -> object_fraction x y z"},
                  lines);
}

// --- views ----------------------------------------------------------------------------------

Line& operator<<(Line& line, const raster::View& v) {
    for (const raster::Axis& a : {v.axes.right, v.axes.up, v.axes.back})
        for (const std::int32_t c : a) line << c;
    return line << v.target.x << v.target.y << v.target.z << v.extent << v.distance
                << v.near_depth << v.far_depth;
}

raster::View some_view(Inputs& in) {
    raster::View v;
    v.projection = in.between(0, 1) == 0 ? raster::Projection::orthographic
                                         : raster::Projection::perspective;
    // One after the other: the order of a call's arguments is the compiler's.
    const auto elevation = static_cast<std::int32_t>(in.between(-90, 90) * 65536);
    const auto azimuth = static_cast<std::int32_t>(in.word(25));
    v.axes = raster::axes_from_angles(azimuth, elevation);
    const auto coordinate = [&] { return static_cast<std::int32_t>(in.word(19)); };
    v.target = {coordinate(), coordinate(), coordinate()};
    v.extent = static_cast<std::int32_t>(in.between(1000, 1 << 20));
    const bool eye = v.projection == raster::Projection::perspective;
    if (eye) v.distance = static_cast<std::int32_t>(in.between(1000, 1 << 20));
    v.near_depth = eye ? in.between(100, 1 << 16) : in.between(-1 << 20, 1 << 16);
    v.far_depth = v.near_depth + in.between(1000, 1 << 21);
    return v;
}

Line& operator<<(Line& line, const hw::MatrixWords& m) {
    for (const auto& row : m.word)
        for (const std::int32_t w : row) line << w;
    for (const int e : m.exponent) line << e;
    return line;
}

TEST(Vectors, Views) {
    Inputs in(3);
    Lines lines;
    const auto axes = [](Line& line, const raster::ViewAxes& a) {
        line << "->";
        for (const raster::Axis& axis : {a.right, a.up, a.back})
            for (const std::int32_t c : axis) line << c;
        return line.text();
    };
    for (int k = 0; k < 16; ++k) {
        const auto a = static_cast<std::int32_t>(in.word(25));
        const auto e = static_cast<std::int32_t>(in.between(-90 * 65536, 90 * 65536));
        Line line;
        lines.push_back(axes(line << "angles" << a << e, raster::axes_from_angles(a, e)));
    }
    for (int k = 0; k < 16; ++k) {
        const auto coordinate = [&] { return static_cast<std::int32_t>(in.word(31)); };
        raster::World p{coordinate(), coordinate(), coordinate()};
        raster::World t{coordinate(), coordinate(), coordinate()};
        if (k < 2) t = {p.x, k == 0 ? p.y + 5 : p.y - 70000, p.z};  // straight up and down
        raster::ViewAxes a;
        if (!raster::axes_from_points(p, t, a)) continue;
        Line line;
        lines.push_back(axes(line << "points" << p.x << p.y << p.z << t.x << t.y << t.z, a));
    }
    for (int k = 0; k < 24; ++k) {
        raster::View v = some_view(in);
        raster::Patch patch{};
        Line line;
        line << "fit" << v;
        for (raster::World& p : patch.control) p = v.target;
        for (const std::size_t at : {0u, 15u}) {
            const auto near = [&](std::int32_t t) {
                return t + static_cast<std::int32_t>(in.word(k < 12 ? 18 : 22));
            };
            raster::World& p = patch.control[at];
            p = {near(v.target.x), near(v.target.y), near(v.target.z)};
            line << p.x << p.y << p.z;
        }
        raster::fit_depth(v, raster::depth_range(v, std::span(&patch, 1)));
        lines.push_back((line << "->" << v.near_depth << v.far_depth).text());
    }
    check_vectors("views",
                  {"Section 4. A view is right (3) up (3) back (3) target (3) extent distance near",
                   "far; distance 0 is orthographic.",
                   "angles azimuth elevation -> right up back",
                   "points from (3) to (3) -> right up back",
                   "fit view, two points (6); the other 14 of the patch are the target -> near "
                   "far"},
                  lines);
}

TEST(Vectors, Matrices) {
    Inputs in(4);
    Lines lines;
    for (int k = 0; k < 40; ++k) {
        hw::MachineSpec spec;
        spec.xy_bits = static_cast<int>(in.between(4, 12));
        spec.z_bits = static_cast<int>(in.between(4, 24));
        spec.coefficient_bits = static_cast<int>(in.between(8, 32));
        const raster::View a = some_view(in), b = some_view(in);
        const std::int64_t bias = in.word(26);
        const int fraction = static_cast<int>(in.between(0, 14));
        hw::MatrixWords m;
        const auto result = [&](Line& line, hw::LoadStatus status) {
            line << "->";
            if (status == hw::LoadStatus::ok) {
                line << m;
            } else {
                line << "refused";
            }
            return line.text();
        };
        Line line;
        if (k % 2 == 0) {
            const hw::WordFormat object{16, fraction};
            line << "screen" << spec.xy_bits << spec.z_bits << spec.coefficient_bits << fraction
                 << a;
            lines.push_back(
                result(line, hw::load_matrix(raster::world_to_screen(a, spec), spec, object, m)));
        } else {
            line << "shadow" << spec.xy_bits << spec.z_bits << spec.coefficient_bits << bias << a
                 << b;
            lines.push_back(result(
                line, hw::load_matrix(raster::observer_to_light(a, b, spec, bias), spec,
                                      hw::screen_words(spec), m)));
        }
    }
    for (int k = 0; k < 12; ++k) {
        const raster::View light = some_view(in);
        const std::int64_t bias = in.word(20);
        const hw::MachineSpec spec;
        const auto unit = k % 2 == 0 ? shadow::BiasUnit::texels : shadow::BiasUnit::world;
        std::int64_t quanta = 0;
        ASSERT_TRUE(
            shadow::bias_in_quanta(bias, unit, shadow::bias_units(light, spec), quanta));
        Line line;
        line << "bias" << bias << (k % 2 == 0 ? "texels" : "world") << light;
        lines.push_back((line << "->" << quanta).text());
    }
    check_vectors("matrices",
                  {"Sections 4 and 5. A view is as in views.txt; a matrix is 16 coefficients, row",
                   "by row, and 4 exponents.",
                   "screen xy_bits z_bits coefficient_bits object_fraction view -> matrix",
                   "shadow xy_bits z_bits coefficient_bits bias (quanta, Q.16) observer light -> "
                   "matrix",
                   "bias word (Q.16) unit light -> quanta, Q.16 (1978's widths)"},
                  lines);
}

// --- the ground -----------------------------------------------------------------------------

Line& operator<<(Line& line, const raster::World& p) { return line << p.x << p.y << p.z; }

TEST(Vectors, Ground) {
    Inputs in(26);
    Lines lines;
    const auto place = [&](int bits) -> raster::World {
        const auto word = [&] { return static_cast<std::int32_t>(in.word(bits)); };
        return {word(), word(), word()};
    };
    for (int k = 0; k < 40; ++k) {
        hw::MachineSpec spec;
        spec.xy_bits = static_cast<int>(in.between(4, 12));
        spec.z_bits = static_cast<int>(in.between(4, 24));
        spec.coefficient_bits = static_cast<int>(in.between(8, 32));
        const raster::View observer = some_view(in), light = some_view(in);
        const raster::World o = place(19), u = place(19), v = place(19), p = place(20);
        std::array<raster::Patch, 2> patches{raster::plane_patch({o, u, v, 0})};
        patches[1].control.fill(p);
        const hw::WordFormat object{16, static_cast<int>(in.between(0, 14))};
        hw::RationalMatrix exact;
        hw::MatrixWords m;
        ASSERT_TRUE(raster::planar_shadow(observer, light, patches, 0, spec, exact));
        Line line;
        line << "flat" << spec.xy_bits << spec.z_bits << spec.coefficient_bits << object.fraction
             << o << u << v << p << observer << light << "->";
        if (hw::load_matrix(exact, spec, object, m) == hw::LoadStatus::ok)
            line << m;
        else
            line << "refused";
        lines.push_back(line.text());
    }
    for (int k = 0; k < 24; ++k) {
        const raster::World o = place(19), u = place(19), v = place(19);
        raster::EllipseFit fit(raster::plane_patch({o, u, v, 0}));
        Line line;
        line << "blob" << k % 8 << o << u << v;
        for (int point = 0; point < 3; ++point) {
            const raster::World p = place(19);
            fit.add(p);
            line << p;
        }
        raster::Ellipse e;
        if (!fit.fit(e)) continue;
        std::array<raster::Patch, raster::patches_per_ellipse> patches;
        raster::ellipse_patches(e, patches);
        line << "->" << e.centre << e.a << e.b;
        for (const raster::World& p : patches[static_cast<std::size_t>(k % 8)].control) line << p;
        lines.push_back(line.text());
    }
    check_vectors("ground",
                  {"Section 26. A view is as in views.txt, a matrix as in matrices.txt; the ground",
                   "is a plane by origin (3) u (3) v (3).",
                   "flat xy_bits z_bits coefficient_bits object_fraction ground, the only point of",
                   "what casts (3), observer light -> the shadow matrix",
                   "blob patch ground, an object's three points (9) -> centre a b, and that patch",
                   "of the eight"},
                  lines);
}

}  // namespace
}  // namespace umbra78::test
