#include "raster/scene.hpp"

#include "fixed/rounding.hpp"
#include "raster/arc.hpp"

namespace umbra78::raster {
namespace {

using fixed::Rounding;

// radius a b: a b is rounded to Q2.30, then the product to Q15.16.
constexpr std::int32_t scaled(std::int32_t radius, std::int32_t a, std::int32_t b) {
    return axis_product(radius, axis_product(a, b));
}

// a + b i / 3, for i from 0 to 3.
constexpr std::int32_t third(std::int64_t a, std::int64_t b, int i) {
    return static_cast<std::int32_t>(
        a + fixed::round_divide(b * i, 3, Rounding::half_even));
}

}  // namespace

void sphere_patches(const Sphere& s, std::span<Patch, patches_per_sphere> out) {
    for (int n = 0; n < patches_per_sphere; ++n) {
        const int meridian = n % 8, parallel = n / 8 - 2;  // azimuth from +z to +x; -90..90 up
        Patch& patch = out[static_cast<std::size_t>(n)];
        patch.material = s.material;
        for (int j = 0; j < 4; ++j) {
            const fixed::SineCosine v = arc_point(parallel, j);
            for (int i = 0; i < 4; ++i) {
                const fixed::SineCosine u = arc_point(meridian, i);
                patch.control[static_cast<std::size_t>(4 * j + i)] = {
                    s.centre.x + scaled(s.radius, u.sine, v.cosine),
                    s.centre.y + scaled(s.radius, axis_one, v.sine),
                    s.centre.z + scaled(s.radius, u.cosine, v.cosine)};
            }
        }
    }
}

Patch plane_patch(const Plane& p) {
    Patch patch;
    patch.material = p.material;
    const auto at = [](std::int32_t o, std::int32_t u, std::int32_t v, int i, int j) {
        return third(third(o, u, i), v, j);
    };
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            patch.control[static_cast<std::size_t>(4 * j + i)] = {
                at(p.origin.x, p.u.x, p.v.x, i, j), at(p.origin.y, p.u.y, p.v.y, i, j),
                at(p.origin.z, p.u.z, p.v.z, i, j)};
        }
    }
    return patch;
}

}  // namespace umbra78::raster
