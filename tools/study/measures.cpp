#include "tools/study/measures.hpp"

#include "shadow/bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

// Z as the machine's word, before it is rounded: 0 at the near plane, 2^bits at the far one.
double exact_code(const LoadedScene& scene, double depth) {
    const raster::View& view = scene.observer;
    const double near = std::ldexp(static_cast<double>(view.near_depth), -16);
    const double far = std::ldexp(static_cast<double>(view.far_depth), -16);
    const double in_range = (depth - near) / (far - near);
    const bool perspective = view.projection == raster::Projection::perspective;
    return std::ldexp(perspective ? in_range * far / depth : in_range,
                      scene.settings.machine.z_bits);
}

// Whether the pixel lies inside its surface's image, away from every silhouette.
bool inside(const Truth& truth, std::size_t at) {
    const auto size = static_cast<std::size_t>(truth.size);
    const std::size_t x = at % size, y = at / size;
    if (!truth.visible[at] || x == 0 || y == 0 || x + 1 == size || y + 1 == size) return false;
    for (const std::size_t beside : {at - 1, at + 1, at - size, at + size})
        if (truth.surface[beside] != truth.surface[at]) return false;
    return true;
}

}  // namespace

void draw_mask(RenderJob& job) {
    job.draw_light();
    job.draw_observer();
    job.cast_shadows();
}

DepthError depth_error(const LoadedScene& scene, const Truth& truth, const Buffer& observer_z) {
    DepthError error;
    double sum = 0, squares = 0;
    for (std::size_t at = 0; at < truth.visible.size(); ++at) {
        const std::uint32_t code = observer_z.at(at);
        if (code == observer_z.maxval || !inside(truth, at)) continue;
        const double off = code - exact_code(scene, truth.depth[at]);
        error.min = error.pixels ? std::min(error.min, off) : off;
        error.max = error.pixels ? std::max(error.max, off) : off;
        sum += off;
        squares += off * off;
        ++error.pixels;
    }
    if (error.pixels == 0) return error;
    const auto pixels = static_cast<double>(error.pixels);
    error.mean = sum / pixels;
    error.rms = std::sqrt(squares / pixels);
    return error;
}

double detachment_gap(const Traced& traced, const MachineMask& mask) {
    const Truth& truth = traced.truth.truth;
    std::vector<std::pair<double, bool>> shadowed;  // distance, and whether it is lit
    for (std::size_t at = 0; at < truth.visible.size(); ++at)
        if (truth.visible[at] && !truth.lit[at] && mask.drawn(at) && !traced.truth.unlit_side[at])
            shadowed.emplace_back(truth.behind[at], !mask.in_shadow(at));
    std::sort(shadowed.begin(), shadowed.end());
    std::int64_t more_lit = 0, max = 0;
    double gap = 0;
    for (const auto& [distance, lit] : shadowed) {
        more_lit += lit ? 1 : -1;
        if (more_lit <= max) continue;
        max = more_lit;
        gap = distance;
    }
    return gap;
}

void set_rates(Row& row, const ShadowReport& errors) {
    row.set("false_shadow", errors.all.false_shadow_rate());
    row.set("false_light", errors.all.false_light_rate());
    row.set("false_shadow_outside", errors.outside_band.false_shadow_rate());
    row.set("false_light_outside", errors.outside_band.false_light_rate());
    row.set("isolated_pixels", std::int64_t{errors.isolated_pixels});
    set_coverage(row, errors.coverage.value());
}

void set_coverage(Row& row, const Coverage& c) {
    row.set("missing_pixels", std::int64_t{c.missing});
    row.set("extra_pixels", std::int64_t{c.extra});
    row.set("misplaced_pixels", std::int64_t{c.misplaced});
}

std::string words_of_coverage(std::span<const Row> rows) {
    std::size_t lacking = 0;
    const Row* worst = nullptr;
    double most = 0;
    for (const Row& row : rows) {
        double lost = 0;
        for (const ColumnMeaning& column : coverage_columns)
            if (row.has(column.name) && !std::isnan(row.number(column.name)))
                lost += row.number(column.name);
        lacking += lost > 0;
        if (lost <= most) continue;
        most = lost;
        worst = &row;
    }
    if (worst == nullptr) return "";
    return fmt::format("{} of {} frames are not what exact truth sees, and the rates do not count "
                       "their missing, extra and misplaced pixels: at most {} in case {}. Draw the "
                       "scene with umbra78 render, whose warnings name the reason.",
                       lacking, rows.size(), static_cast<std::int64_t>(most), worst->text("case"));
}

std::vector<std::uint8_t> error_picture(const SceneTruth& s, const MachineMask& mask) {
    const Truth& t = s.truth;
    std::vector<std::uint8_t> gray(t.visible.size(), 235);
    for (std::size_t at = 0; at < gray.size(); ++at) {
        if (!t.visible[at] || !mask.drawn(at) || s.unlit_side[at]) continue;
        if (t.lit[at]) gray[at] = mask.in_shadow(at) ? 0 : 200;
        else gray[at] = mask.in_shadow(at) ? 110 : 255;
    }
    return gray;
}

LightUnits light_units(const LoadedScene& scene) {
    const auto real = [](const hw::Rational& exact) {
        std::int64_t q32 = 0;
        exact.round_scaled(32, fixed::Rounding::half_even, q32);
        return std::ldexp(static_cast<double>(q32), -32);
    };
    const auto units = shadow::bias_units(scene.light(), scene.settings.machine);
    return {real(units.quanta_per_world), real(units.texels_per_world)};
}

void set_in_three_units(Row& row, const std::string& column, const LightUnits& units,
                        double quanta) {
    row.set(column + "_quanta", quanta);
    row.set(column + "_texels", units.texels(quanta));
    row.set(column + "_world", units.world(quanta));
}

}  // namespace umbra78::tools::study
