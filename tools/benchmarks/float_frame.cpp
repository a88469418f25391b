#include "tools/benchmarks/float_frame.hpp"

#include "shadow/frame/paper_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbra78::tools {
namespace {

constexpr float pixels_a_unit = 128, codes_a_unit = 128 * 128, middle = 256, bias = 400;

template <class Vector>
float dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<std::array<float, 3>, 3> axes_of(std::int32_t azimuth_q16) {
    const raster::View view = shadow::figure_view(azimuth_q16);
    const auto floats = [](const raster::Axis& a) {
        const auto one = [](std::int32_t v) { return std::ldexp(static_cast<float>(v), -30); };
        return std::array{one(a[0]), one(a[1]), one(a[2])};
    };
    return {floats(view.axes.right), floats(view.axes.up), floats(view.axes.back)};
}

}  // namespace

SphereMesh::SphereMesh(int rings) {
    const int slices = 2 * rings;
    for (const raster::Sphere& s : shadow::figure_spheres) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (int i = 0; i <= rings; ++i) {
            for (int j = 0; j < slices; ++j) {
                const double a = std::numbers::pi * i / rings;
                const double b = 2 * std::numbers::pi * j / slices;
                const std::array n{std::sin(a) * std::sin(b), std::cos(a),
                                   std::sin(a) * std::cos(b)};
                const auto at = [&](std::int32_t centre, double k) {
                    return centre + static_cast<std::int32_t>(std::lround(s.radius * k));
                };
                const auto q14 = [](double v) {
                    return static_cast<std::int32_t>(std::lround(16384 * v));
                };
                vertices.push_back(
                    {at(s.centre.x, n[0]), at(s.centre.y, n[1]), at(s.centre.z, n[2])});
                normals.push_back({q14(n[0]), q14(n[1]), q14(n[2])});
            }
        }
        const auto vertex = [&](int i, int j) {
            return first + static_cast<std::uint32_t>(i * slices + j % slices);
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            raster::Facet f;
            f.vertex = f.normal = {a, b, c};  // counter-clockwise from outside
            facets.push_back(f);
        };
        for (int i = 0; i < rings; ++i) {
            for (int j = 0; j < slices; ++j) {
                if (i > 0) add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
                if (i + 1 < rings)
                    add(vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1));
            }
        }
    }
}

FloatFrame::FloatFrame(const SphereMesh& mesh)
    : screen_(mesh.vertices.size()), light_(mesh.vertices.size()), depth_(size * size),
      lambert_(size * size), observer_(size * size), map_(size * size), mask_(size * size),
      picture_(size * size), observer_axes_(axes_of(0)),
      light_axes_(axes_of(shadow::figure_azimuth_q16)) {
    for (const raster::World& p : mesh.vertices)
        points_.push_back({static_cast<float>(p.x) / 65536, static_cast<float>(p.y) / 65536,
                           static_cast<float>(p.z) / 65536});
    for (std::size_t k = 0; k < mesh.normals.size(); ++k) {
        const auto& n = mesh.normals[k];
        normals_.push_back({static_cast<float>(n[0]) / 16384, static_cast<float>(n[1]) / 16384,
                            static_cast<float>(n[2]) / 16384});
        light_[k] = dot(normals_[k], light_axes_[2]);
    }
    for (const raster::Facet& f : mesh.facets) triangles_.push_back(f.vertex);
    // A pixel's place in the world, by the observer's axes, and from there to the light's map.
    const float to_pixel[3] = {pixels_a_unit, -pixels_a_unit, -codes_a_unit};
    const float origin[3] = {middle, middle, 32768};
    for (std::size_t r = 0; r < 3; ++r) {
        to_light_.m[r][3] = origin[r] - (r == 2 ? bias : 0);
        for (std::size_t c = 0; c < 3; ++c) {
            to_light_.m[r][c] = to_pixel[r] / to_pixel[c] * dot(light_axes_[r], observer_axes_[c]);
            to_light_.m[r][3] -= to_light_.m[r][c] * origin[c];
        }
    }
    to_light_.m[3] = {0, 0, 0, 1};
}

void FloatFrame::draw() {
    draw_view(light_axes_, false, map_);
    draw_view(observer_axes_, true, observer_);
    float_post_process(observer_, map_, size, to_light_, true, mask_);
    for (std::size_t k = 0; k < picture_.size(); ++k) {
        const float direct = mask_[k] != 0 ? 0 : 0.7f * std::max(lambert_[k], 0.0f);
        picture_[k] = observer_[k] == 65535
                          ? std::uint8_t{0}
                          : static_cast<std::uint8_t>(255 * (0.3f + direct) + 0.5f);
    }
}

void FloatFrame::draw_view(const std::array<Vector, 3>& axes, bool shades,
                           std::vector<std::uint16_t>& codes) {
    std::fill(depth_.begin(), depth_.end(), 65535.0f);
    for (std::size_t k = 0; k < points_.size(); ++k)
        screen_[k] = {middle + pixels_a_unit * dot(axes[0], points_[k]),
                      middle - pixels_a_unit * dot(axes[1], points_[k]),
                      32768 - codes_a_unit * dot(axes[2], points_[k])};
    for (const auto& triangle : triangles_) draw_triangle(triangle, shades);
    for (std::size_t k = 0; k < codes.size(); ++k)
        codes[k] = static_cast<std::uint16_t>(depth_[k] + 0.5f);
}

// Barycentric weights at the pixels of the triangle's box, by steps along its lines.
void FloatFrame::draw_triangle(const std::array<std::uint32_t, 3>& vertex, bool shades) {
    const Vector &a = screen_[vertex[0]], &b = screen_[vertex[1]], &c = screen_[vertex[2]];
    const float area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (area >= 0) return;  // seen from behind: Y runs down
    const auto first = [](float v) { return std::max(static_cast<int>(std::ceil(v - 0.5f)), 0); };
    const auto last = [](float v) {
        return std::min(static_cast<int>(std::floor(v - 0.5f)), size - 1);
    };
    const int x0 = first(std::min({a[0], b[0], c[0]})), x1 = last(std::max({a[0], b[0], c[0]}));
    const int y0 = first(std::min({a[1], b[1], c[1]})), y1 = last(std::max({a[1], b[1], c[1]}));
    const float over = 1 / area;
    const float of_b_x = (c[1] - a[1]) * over, of_b_y = (a[0] - c[0]) * over;
    const float of_c_x = (a[1] - b[1]) * over, of_c_y = (b[0] - a[0]) * over;
    const float la = light_[vertex[0]], lb = light_[vertex[1]] - la, lc = light_[vertex[2]] - la;
    for (int y = y0; y <= y1; ++y) {
        const float dx = static_cast<float>(x0) + 0.5f - a[0];
        const float dy = static_cast<float>(y) + 0.5f - a[1];
        float of_b = dx * of_b_x + dy * of_b_y, of_c = dx * of_c_x + dy * of_c_y;
        const auto line = static_cast<std::size_t>(y) * size;
        for (int x = x0; x <= x1; ++x, of_b += of_b_x, of_c += of_c_x) {
            if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
            const float z = a[2] + of_b * (b[2] - a[2]) + of_c * (c[2] - a[2]);
            float& kept = depth_[line + static_cast<std::size_t>(x)];
            if (z >= kept) continue;
            kept = z;
            if (shades) lambert_[line + static_cast<std::size_t>(x)] = la + of_b * lb + of_c * lc;
        }
    }
}

int FloatFrame::visible() const {
    return static_cast<int>(std::count_if(observer_.begin(), observer_.end(),
                                          [](std::uint16_t z) { return z != 65535; }));
}

int FloatFrame::shadowed() const {
    return static_cast<int>(std::count(mask_.begin(), mask_.end(), 255));
}

}  // namespace umbra78::tools
