#include "tools/paper/figure_comparisons.hpp"

#include "tools/io/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

using shadow::figure_settings;

struct Square {
    int left, top, side;  // pixels
};

// A part of a picture, with every pixel twice as wide and high.
std::vector<std::uint8_t> enlarged(std::span<const std::uint8_t> picture, int size, Square part) {
    std::vector<std::uint8_t> large;
    for (int y = 0; y < 2 * part.side; ++y)
        for (int x = 0; x < 2 * part.side; ++x)
            large.push_back(picture[static_cast<std::size_t>(part.top + y / 2) * size +
                                    static_cast<std::size_t>(part.left + x / 2)]);
    return large;
}

// A square of half the picture's size around a sphere's centre, moved into the picture.
Square around(const raster::Sphere& sphere, const raster::View& view, int size) {
    const std::int64_t half = size / 2;
    const auto pixel = [&](std::int64_t word) { return half + word * half / view.extent; };
    const auto min = [&](std::int64_t centre) {
        return static_cast<int>(std::clamp<std::int64_t>(centre - half / 2, 0, half));
    };
    return {min(pixel(sphere.centre.x)), min(pixel(-std::int64_t{sphere.centre.y})),
            static_cast<int>(half)};
}

std::uint8_t brightest(std::span<const std::uint8_t> picture, std::span<const std::uint8_t> mask,
                       int size, Square part) {
    std::uint8_t level = 0;
    for (int y = part.top; y < part.top + part.side; ++y)
        for (int x = part.left; x < part.left + part.side; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
            if (mask[at] == 255) level = std::max(level, picture[at]);
        }
    return level;
}

}  // namespace

void write_highlights(const Path& path, FileSet* set) {
    // The upper left sphere is moved up by 0.45, so that its shadow covers the upper right one's
    // highlight.
    constexpr std::size_t moved = 0, shown = 1;
    LoadedScene scene = figures_scene();
    scene.spheres[moved].centre.y += 45 * 65536 / 100;
    for (std::size_t k = 0; k < scene.spheres.size(); ++k)
        raster::sphere_patches(scene.spheres[k],
                               std::span<raster::Patch, raster::patches_per_sphere>(
                                   scene.patches.data() + k * raster::patches_per_sphere,
                                   raster::patches_per_sphere));
    RenderJob job(scene.view(), scene.settings);
    job.render();
    const int size = scene.settings.machine.size_px();
    const Square part = around(scene.spheres[shown], scene.observer, size);
    const std::vector<std::uint8_t> shadow(job.bytes(Plane::mask).begin(),
                                           job.bytes(Plane::mask).end());
    const auto after = enlarged(job.bytes(Plane::picture), size, part);
    const int after_level = brightest(job.bytes(Plane::picture), shadow, size, part);

    shadow::Settings correct = scene.settings;
    correct.form = shadow::Form::correct;
    job.use(correct);
    job.draw_observer();
    job.cast_shadows();
    job.filter_and_composite();
    const auto before = enlarged(job.bytes(Plane::picture), size, part);
    const int before_level = brightest(job.bytes(Plane::picture), shadow, size, part);

    const char* change = "figure 6, upper left sphere 0.45 higher";
    const SheetCell cells[] = {
        {2 * part.side, 2 * part.side, after,
         {"post-process: highlight darkened", change,
          fmt::format("brightest level in shadow: {}", after_level)}},
        {2 * part.side, 2 * part.side, before,
         {"correct form: no highlight in shadow", change,
          fmt::format("brightest level in shadow: {}", before_level)}}};
    write_sheet(path, cells, {.columns = 2}, set);
}

void write_samplings(const Path& path, const FigureSet& set_of_figures, FileSet* set) {
    const LoadedScene& scene = set_of_figures.scene();
    const int size = set_of_figures.size_px();
    std::vector<SheetCell> cells;
    const auto add = [&](const char* title, std::span<const std::uint8_t> mask,
                         std::span<const std::uint8_t> visible) {
        const ShadowError error = shadow_error(set_of_figures.truth().truth, {mask, visible});
        cells.push_back({size, size, mask,
                         {title, fmt::format("false shadow {} %, false light {} %",
                                             percent(error.false_shadow_rate()),
                                             percent(error.false_light_rate()))}});
    };
    const auto& mask3 = set_of_figures.figures()[2].picture;
    add("Fig. 3: centre sampling and registration", mask3, set_of_figures.visible());
    add("centre sampling, index registration", set_of_figures.index_mask(),
        set_of_figures.visible());

    shadow::Settings leaf = figure_settings(3);
    leaf.sampling = raster::Sampling::leaf;
    RenderJob job(scene.view(), leaf);
    job.draw_light();
    job.draw_observer();
    job.cast_shadows();
    const auto visible = job.visible();
    const std::vector<std::uint8_t> centred(job.bytes(Plane::mask).begin(),
                                            job.bytes(Plane::mask).end());
    add("leaf sampling, centre registration", centred, visible);
    leaf.registration = shadow::Registration::index;
    job.use(leaf);
    job.cast_shadows();
    add("leaf sampling, index registration", job.bytes(Plane::mask), visible);
    write_sheet(path, cells, {.columns = 2}, set);
}

void write_ap120b_comparison(const Path& path, const FigureSet& figures, FileSet* set) {
    const int size = figures.size_px();
    const auto& fixed = figures.figures()[2].picture;
    const auto& array = figures.ap120b_mask(3);
    // A single pixel is hard to see: each that differs is drawn with its eight neighbours.
    std::vector<std::uint8_t> differ(fixed.size(), 0);
    int count = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * size + static_cast<std::size_t>(x);
            if (fixed[at] == array[at]) continue;
            ++count;
            for (int v = std::max(0, y - 1); v <= std::min(size - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(size - 1, x + 1); ++u)
                    differ[static_cast<std::size_t>(v) * size + static_cast<std::size_t>(u)] = 255;
        }
    const auto rates = [&](std::span<const std::uint8_t> mask) {
        const ShadowError e = shadow_error(figures.truth().truth, {mask, figures.visible()});
        return fmt::format("false shadow {} %, false light {} %", percent(e.false_shadow_rate()),
                           percent(e.false_light_rate()));
    };
    const SheetCell cells[] = {
        {size, size, fixed, {"Fig. 3: the fixed-point unit", rates(fixed)}},
        {size, size, array, {"Fig. 3: the AP-120B, 38-bit floats", rates(array)}},
        {size, size, differ, {fmt::format("{} pixels differ", count), "each drawn 3 x 3"}}};
    write_sheet(path, cells, {.columns = 3}, set);
}

}  // namespace umbra78::tools
