// A small scene as an engine would draw it, in double precision: a floor and a box, seen in
// perspective, lit by a spot light in perspective or by the sun; D3D's conventions, z 0 .. 1.
#pragma once

#include "tools/captured/capture.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace umbra78::tools::captured::test {

using Real4 = std::array<double, 4>;
using Matrix = std::array<Real4, 4>;

inline Matrix product(const Matrix& a, const Matrix& b) {
    Matrix m{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
}
inline Real4 product(const Matrix& a, const Real4& p) {
    Real4 r{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) r[i] += a[i][k] * p[k];
    return r;
}

inline Matrix inverse(Matrix a) {
    Matrix b{};
    for (std::size_t i = 0; i < 4; ++i) b[i][i] = 1;
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < 4; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = 0; i < 4; ++i) {
            const double part = i == k ? 1 - 1 / a[k][k] : a[i][k] / a[k][k];
            for (std::size_t j = 0; j < 4; ++j) b[i][j] -= part * b[k][j];
            for (std::size_t j = 4; j-- > 0;)
                if (j != k) a[i][j] -= part * a[k][j];
            a[i][k] = i == k ? 1 : 0;
        }
    }
    return b;
}

// World to the eye's axes: x right, y up, z ahead.
inline Matrix look_at(const std::array<double, 3>& eye, const std::array<double, 3>& at) {
    const auto unit = [](std::array<double, 3> v) {
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        for (double& c : v) c /= length;
        return v;
    };
    const auto z = unit({at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]});
    const auto x = unit({z[2], 0, -z[0]});
    const std::array y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2],
                       z[0] * x[1] - z[1] * x[0]};
    const auto row = [&](const std::array<double, 3>& v) {
        return Real4{v[0], v[1], v[2], -(v[0] * eye[0] + v[1] * eye[1] + v[2] * eye[2])};
    };
    return {row(x), row(y), row(z), Real4{0, 0, 0, 1}};
}

inline Matrix perspective(double focal_x, double focal_y, double near, double far) {
    return {Real4{focal_x, 0, 0, 0}, Real4{0, focal_y, 0, 0},
            Real4{0, 0, far / (far - near), -near * far / (far - near)}, Real4{0, 0, 1, 0}};
}
inline Matrix orthographic(double half, double near, double far) {
    return {Real4{1 / half, 0, 0, 0}, Real4{0, 1 / half, 0, 0},
            Real4{0, 0, 1 / (far - near), -near / (far - near)}, Real4{0, 0, 0, 1}};
}

struct Camera {
    Matrix view_projection;
    Sides sides;
};

// The floor y = 0 within +-4, and a box from -1 .. 1, 0 .. 1.5, -1 .. 1. The least t of a ray
// within low .. high that meets one of them; infinite if none does.
inline double first_hit(const std::array<double, 3>& o, const std::array<double, 3>& d, double low,
                        double high) {
    double best = std::numeric_limits<double>::infinity();
    const auto offer = [&](double t) {
        if (t > low && t < high && t < best) best = t;
    };
    const double floor = -o[1] / d[1];
    if (std::abs(o[0] + floor * d[0]) < 4 && std::abs(o[2] + floor * d[2]) < 4) offer(floor);
    constexpr std::array least{-1.0, 0.0, -1.0}, most{1.0, 1.5, 1.0};
    double in = -std::numeric_limits<double>::infinity(), out = -in;
    for (std::size_t k = 0; k < 3; ++k) {
        const double a = (least[k] - o[k]) / d[k], b = (most[k] - o[k]) / d[k];
        in = std::max(in, std::min(a, b));
        out = std::min(out, std::max(a, b));
    }
    if (in < out) {
        offer(in);
        offer(out);
    }
    return best;
}

struct Drawn {
    NumberImage depth;                               // 32-bit floats
    std::vector<std::array<double, 3>> points;       // seen, in the world; NaN where nothing is
};

// Through each pixel's centre.
inline Drawn draw(const Camera& camera) {
    const Matrix back = inverse(camera.view_projection);
    const auto world = [&](double x, double y, double z) {
        const Real4 p = product(back, Real4{x, y, z, 1});
        return std::array{p[0] / p[3], p[1] / p[3], p[2] / p[3]};
    };
    Drawn drawn;
    drawn.depth.name = "drawn";
    drawn.depth.width = camera.sides.width;
    drawn.depth.height = camera.sides.height;
    for (int j = 0; j < camera.sides.height; ++j)
        for (int i = 0; i < camera.sides.width; ++i) {
            const double x = (2 * i + 1.0) / camera.sides.width - 1;
            const double y = 1 - (2 * j + 1.0) / camera.sides.height;
            const auto from = world(x, y, 0), to = world(x, y, 1);
            const std::array d{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
            const double t = first_hit(from, d, 0, 1);
            double depth = 1;
            std::array<double, 3> point{};
            for (std::size_t k = 0; k < 3; ++k) point[k] = from[k] + t * d[k];
            if (t < 1) {
                const Real4 p = product(camera.view_projection,
                                        Real4{point[0], point[1], point[2], 1});
                depth = p[2] / p[3];
            }
            drawn.depth.values.push_back(static_cast<double>(static_cast<float>(depth)));
            drawn.points.push_back(point);
        }
    return drawn;
}

inline Capture capture_of(const Camera& observer, const Camera& light) {
    Capture capture;
    capture.observer = draw(observer).depth;
    capture.light = draw(light).depth;
    const Matrix m = product(light.view_projection, inverse(observer.view_projection));
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) capture.matrix[4 * i + j] = m[i][j];
    capture.convention = *find_convention("d3d");
    capture.format = *find_depth_format("d32f");
    return capture;
}

inline const std::array<double, 3> spot_at{3, 5, -2}, sun_from{6, 8, -3};
inline Camera eye() {
    return {product(perspective(1.2, 1.6, 0.5, 40), look_at({-3, 4, -6}, {0, 0.5, 0})), {320, 240}};
}
inline Camera spot() {
    return {product(perspective(1.1, 1.1, 1, 15), look_at(spot_at, {0, 0, 0})), {256, 256}};
}
inline Camera sun() {
    return {product(orthographic(5, 1, 20), look_at(sun_from, {0, 0, 0})), {256, 200}};
}

}  // namespace umbra78::tools::captured::test
