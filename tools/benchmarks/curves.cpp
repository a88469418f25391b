#include "tools/benchmarks/curves.hpp"

#include "shadow/frame/paper_figures.hpp"
#include "tools/benchmarks/float_frame.hpp"
#include "tools/render/render_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <vector>

namespace umbra78::tools {
namespace {

struct Point {
    double x, ms;
};

double spent_ms() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

// The least of some rounds; one that takes long is done less often.
double frame_ms(const shadow::Scene& scene, const shadow::Settings& settings) {
    RenderJob job(scene, settings);
    double least = 1e12, all = 0;
    for (int round = 0; round < 7 && (round < 2 || all < 600); ++round) {
        const double start = spent_ms();
        job.use(settings);  // matrices and plan
        job.render();
        const double took = spent_ms() - start;
        least = std::min(least, took);
        all += took;
    }
    return least;
}

// Of the straight line through the last points' logarithms: where constant shares are small.
double slope(const std::vector<Point>& points) {
    const std::size_t from = points.size() > 4 ? points.size() - 4 : 0;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = from; k < points.size(); ++k) {
        const double a = std::log(points[k].x), b = std::log(points[k].ms);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

shadow::Scene scene_of(std::span<const raster::Patch> patches) {
    return {patches,
            {&shadow::figure_material, 1},
            shadow::figure_view(0),
            {{shadow::figure_view(shadow::figure_azimuth_q16)}}};
}

std::vector<Point> over_pixels() {
    const shadow::FigurePatches patches = shadow::figure_patches();
    std::vector<Point> points;
    for (int xy_bits = 6; xy_bits <= 12; ++xy_bits) {
        shadow::Settings s = shadow::figure_settings(6);
        s.machine.xy_bits = xy_bits;
        points.push_back({std::exp2(2 * xy_bits), frame_ms(scene_of(patches), s)});
    }
    return points;
}

Point with_facets(const SphereMesh& mesh, const shadow::Settings& settings) {
    shadow::Scene scene = scene_of({});
    scene.mesh = mesh.mesh();
    return {static_cast<double>(mesh.facets.size()), frame_ms(scene, settings)};
}

std::vector<Point> over_facets(int power) {
    std::vector<Point> points;
    for (double count = 100; count <= 1.01 * std::pow(10, power); count *= std::sqrt(10.0)) {
        const int rings = std::max(3, static_cast<int>(std::lround(std::sqrt(count / 16) + 0.5)));
        points.push_back(with_facets(SphereMesh(rings), shadow::figure_settings(3)));
    }
    return points;
}

// Squares that fill the picture, one behind the other, the hindmost first in the list.
std::vector<Point> over_depth() {
    std::vector<Point> points;
    for (int count = 1; count <= 256; count *= 2) {
        std::vector<raster::Patch> patches;
        for (int k = 0; k < count; ++k)
            patches.push_back(raster::plane_patch(
                {{-110000, -110000, -60000 + k * 120000 / count}, {220000, 0, 0}, {0, 220000, 0},
                 0}));
        shadow::Scene scene = scene_of(patches);
        scene.lights[0] = shadow::figure_view(-30 * 65536);
        points.push_back({static_cast<double>(count),
                          frame_ms(scene, shadow::figure_settings(3))});
    }
    return points;
}

std::vector<Point> over_lights() {
    const shadow::FigurePatches patches = shadow::figure_patches();
    std::vector<Point> points;
    for (std::size_t lights = 1; lights <= raster::max_sources; lights *= 2) {
        shadow::Scene scene = scene_of(patches);
        scene.light_count = lights;
        for (std::size_t l = 0; l < lights; ++l)
            scene.lights[l] = shadow::figure_view(static_cast<int>(l * 37 + 30) * -65536);
        points.push_back({static_cast<double>(lights),
                          frame_ms(scene, shadow::figure_settings(4))});
    }
    return points;
}

// At 64 x 64 pixels, so that the facets are what counts.
std::vector<Point> of_rival(shadow::Form form) {
    std::vector<Point> points;
    for (const int rings : {3, 4, 6, 8, 12}) {
        shadow::Settings s = shadow::figure_settings(3);
        s.machine.xy_bits = 6;
        s.form = form;
        points.push_back(with_facets(SphereMesh(rings), s));
        if (points.back().ms > 3000) break;
    }
    return points;
}

}  // namespace

int measure_curves(int power, const std::string& csv) {
    std::string rows = "curve,x,ms\n";
    const auto add = [&](const std::string& name, const std::vector<Point>& points) {
        for (const Point& p : points) rows += fmt::format("{},{:.0f},{:.4f}\n", name, p.x, p.ms);
        fmt::print("{:<26} {:>10.0f} to {:>10.0f} {:>10.3f} to {:>10.3f} ms  slope {:.2f}\n", name,
                   points.front().x, points.back().x, points.front().ms, points.back().ms,
                   slope(points));
        std::fflush(stdout);
    };
    add("pixels", over_pixels());
    add("facets", over_facets(power));
    add("surfaces behind another", over_depth());
    add("lights", over_lights());
    for (const shadow::Method& method : shadow::methods())
        if (shadow::is_rival(method.form))
            add(fmt::format("facets of {}", method.name), of_rival(method.form));
    if (!csv.empty()) std::ofstream(csv) << rows;
    return 0;
}

}  // namespace umbra78::tools
