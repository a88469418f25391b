#include "tools/study/moire/report.hpp"

#include "tools/paper/bands.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

std::string figure(const Row& row, const char* column, const char* form) {
    const double value = row.number(column);
    return std::isnan(value) ? "" : fmt::format(fmt::runtime(form), value);
}

bool is(const Row& row, std::string_view column, std::string_view value) {
    return row.text(column) == value;
}

void table_scene(std::span<const Row> rows, Report& report) {
    std::vector<std::vector<std::string>> table{{"lookup", "dither", "texels", "noise",
        "false shadow", "isolated pixels", "flatness", "windows", "verdict"}};
    for (const Row& row : rows)
        if (is(row, "ground", "scene"))
            table.push_back({row.text("lookup"), row.text("dither"), row.text("dither_size"),
                             row.text("noise"), figure(row, "false_shadow", "{:.4f}"),
                             row.text("isolated_pixels"), figure(row, "flatness", "{:.3f}"),
                             row.text("windows"), verdict(row)});
    report.table(table, "The scene's surfaces: the median flatness of 32 x 32 windows of the error "
                        "over lit pixels. White noise has 0.5615 (0.57 to 0.59 where errors are "
                        "few), a pattern goes to 0. 'no errors': fewer than ten windows have the "
                        "16 errors that make a spectrum.");
}

void table_plane(std::span<const Row> rows, Report& report) {
    std::vector<std::vector<std::string>> table{{"lookup", "dither", "texels", "noise",
        "false shadow", "peak over mean", "Fisher's g", "p", "anisotropy, dB", "flatness",
        "peak's period, px", "predicted beat, px", "harmonic (k, l)", "verdict"}};
    for (const Row& row : rows)
        if (is(row, "ground", "plane"))
            table.push_back({row.text("lookup"), row.text("dither"), row.text("dither_size"),
                             row.text("noise"), figure(row, "false_shadow", "{:.4f}"),
                             figure(row, "peak_over_mean", "{:.1f}"),
                             figure(row, "fisher_g", "{:.5f}"), figure(row, "fisher_p", "{:.2g}"),
                             figure(row, "anisotropy_db", "{:.1f}"),
                             figure(row, "flatness", "{:.3f}"),
                             figure(row, "peak_period_px", "{:.3f}"),
                             figure(row, "beat_period_px", "{:.3f}"),
                             row.text("harmonic_k") + ", " + row.text("harmonic_l"),
                             verdict(row)});
    report.table(table, "A slanted plane, the middle quarter of the picture. White noise peaks at "
                        "about ln(cells), 11 for 256 x 256; p is the chance of so high a line in "
                        "noise; anisotropy is the greatest of any ring, white noise's mean -10 "
                        "log10 K of K segments. The beat is that of the observer's pixels with "
                        "the steeper axis of the light's texels; (k, l) is the harmonic of the "
                        "two grids that the measured peak stands on, 0, 0 for none up to order "
                        "5.");
}

void plot_sizes(std::span<const Row> rows, const char* ground, const char* column,
                const char* label, bool log_y, Report& report) {
    for (const char* lookup : {"nearest", "bilinear"}) {
        Plot plot;
        plot.name = fmt::format("{}-{}-{}", column, ground, lookup);
        plot.title = fmt::format("{} over the dither's size: {}, {} lookup", label, ground, lookup);
        plot.x_label = "dither, peak to peak (texels)";
        plot.y_label = label;
        plot.log_y = log_y;
        for (const char* shape : {"uniform", "triangular", "normal4", "normal"}) {
            Series series;
            series.title = shape;
            for (const Row& row : rows)
                if (is(row, "ground", ground) && is(row, "lookup", lookup) &&
                    is(row, "dither", shape) && is(row, "noise", "machine") &&
                    row.number(column) > 0)
                    series.points.emplace_back(row.number("dither_size"), row.number(column));
            std::sort(series.points.begin(), series.points.end());
            if (!series.points.empty()) plot.series.push_back(std::move(series));
        }
        if (!plot.series.empty())
            report.plot(plot, "At figure 3's bias, half a texel. What is missing left too few "
                              "errors to have a spectrum.");
    }
}

// The remedies of figure 4, one and both, drawn once more for their pictures.
struct Remedy {
    const char *name, *title, *lookup, *dither;
};
constexpr Remedy remedies[] = {{"nearest", "nearest lookup", "nearest", "none"},
                               {"dither", "nearest lookup, normal dither", "nearest", "normal"},
                               {"bilinear", "bilinear lookup", "bilinear", "none"},
                               {"both", "bilinear lookup, normal dither", "bilinear", "normal"},
                               {"uniform", "nearest lookup, uniform dither", "nearest", "uniform"}};

void picture_spectra(const Request& request, const char* ground, Report& report) {
    const TruthCache truths;
    Plot radial;
    radial.name = fmt::format("radial-{}", ground);
    radial.title = "Radially averaged power of the error: the plane";
    radial.x_label = "frequency (cycles a pixel)";
    radial.y_label = "power (1 is the mean)";
    radial.log_y = true;
    for (const Remedy& remedy : remedies) {
        const Case c{"", {"bias_unit=texels", "bias=0.5", "dequantize=0", "low_pass=0",
                          fmt::format("lookup={}", remedy.lookup),
                          fmt::format("dither={}", remedy.dither), "dither_size=1"},
                     {{"ground", ground}, {"noise", "machine"}}};
        const MoireFrame frame = draw_moire(request, c, truths);
        const SceneTruth& truth = frame.traced->truth;
        int n = frame.window_px;
        std::vector<double> power;
        if (n > 0) {
            const ErrorSpectrum s = error_spectrum(truth, frame.shown(), n);
            power = s.power;
            Series series{remedy.title, {}, true, {}};
            for (std::size_t k = 0; k < s.radial.power.size(); ++k)
                if (s.radial.power[k] > 0)
                    series.points.emplace_back(s.radial.frequency[k], s.radial.power[k]);
            if (!series.points.empty()) radial.series.push_back(std::move(series));
        } else {
            n = 64;
            power = periodogram(busiest_window(truth, frame.shown(), n), n);
        }
        const bool none = std::all_of(power.begin(), power.end(), [](double p) { return p == 0; });
        report.picture(fmt::format("spectrum-{}-{}", ground, remedy.name), n, n,
                       spectrum_picture(power, n),
                       fmt::format("Spectrum of the error of {}, {}; zero frequency is in the "
                                   "middle, white the highest bin, black four decades below.{}",
                                   frame.window_px > 0 ? "the plane"
                                                       : "the lit window with the most errors",
                                   remedy.title, none ? " No pixel of it is wrong: it is black."
                                                      : ""));
    }
    if (!radial.series.empty())
        report.plot(radial, "Power in rings round zero frequency, of the mean of the window's "
                            "segments; white noise lies at 1.");
}

// Controls first: a measure that passes them is none.
void tell_controls(std::span<const Row> rows, Report& report) {
    auto& json = report.summary()["controls"];
    for (const Row& row : rows) {
        const bool restarted = is(row, "noise", "restarted rows");
        const bool narrow = row.number("dither_size") == 0.25 && !is(row, "dither", "none") &&
                            is(row, "lookup", "nearest");
        if (!restarted && !narrow) continue;
        json.push_back({{"ground", row.text("ground")}, {"lookup", row.text("lookup")},
                        {"dither", row.text("dither")},
                        {"control", restarted ? "restarted rows" : "a quarter texel"},
                        {"verdict", verdict(row)}});
    }
    const auto count = [&](std::string_view verdict) {
        return std::count_if(json.begin(), json.end(), [&](const auto& control) {
            return control["verdict"] == verdict;
        });
    };
    report.paragraph(fmt::format(
        "Negative controls: {} cases of a quarter texel of dither with nearest lookup, or of a "
        "generator started anew in every row; {} of them pass for noise, {} leave no error to "
        "measure. With bilinear lookup a narrow dither is no control: interpolation has taken the "
        "pattern away by itself. A pattern is, on the plane, a peak that white noise has once in "
        "1000 windows (Fisher's g); in the scene, a flatness of {} or less, and noise {} or more.",
        json.size(), count("noise"), count("no errors"), max_periodic_flatness,
        min_noise_flatness));
}

void tell_beat(std::span<const Row> rows, Report& report) {
    for (const Row& row : rows) {
        if (!is(row, "ground", "plane") || !is(row, "lookup", "nearest") ||
            !is(row, "dither", "none") || std::isnan(row.number("peak_period_px")))
            continue;
        report.paragraph(fmt::format(
            "The moire of a slanted plane, the study's own: predicted from the two grids, a beat "
            "of {} px at ({}, {}) cycles a "
            "pixel; measured, a peak of {} times the mean, {} px at ({}, {}), harmonic ({}, {}).",
            figure(row, "beat_period_px", "{:.3f}"), figure(row, "beat_u", "{:.4f}"),
            figure(row, "beat_v", "{:.4f}"), figure(row, "peak_over_mean", "{:.0f}"),
            figure(row, "peak_period_px", "{:.3f}"), figure(row, "peak_u", "{:.4f}"),
            figure(row, "peak_v", "{:.4f}"), row.text("harmonic_k"), row.text("harmonic_l")));
        report.summary()["beat_px"] = {{"predicted", row.number("beat_period_px")},
                                       {"measured", row.number("peak_period_px")}};
        return;
    }
}

// Williams 1978, p. 273, on figure 3: the reading of tools/paper/bands.hpp.
void tell_bands(Report& report) {
    const auto rows = measure_bands(64);
    std::vector<std::vector<std::string>> table{{"light", "sampling", "registration", "limb",
        "middle", "inner", "line", "line is the light's right edge", "greatest at the line",
        "band left of the line", "observer's right edge dark"}};
    std::size_t max = 0;
    for (const BandRow& row : rows) {
        const std::array<bool, 4> fits{row.line_is_lights_right_edge(), row.max_at_line(),
                                       row.band_left_of_line(), row.observers_right_edge_dark()};
        max = std::max(max, static_cast<std::size_t>(std::count(fits.begin(), fits.end(), true)));
        std::vector<std::string> line{
            fmt::format("{:+d}", row.azimuth),
            row.sampling == raster::Sampling::centre ? "centre" : "leaf",
            row.registration == shadow::Registration::centre ? "centre" : "index"};
        for (const double rate : row.false_shadow) line.push_back(fmt::format("{:.3f}", rate));
        for (const bool fit : fits) line.emplace_back(fit ? "yes" : "no");
        table.push_back(std::move(line));
    }
    report.table(table, "The paper's sentence on figure 3's two bands, part by part, for each side "
                        "of the light, sampling and registration; the figures' scene, 64 quanta.");
    report.paragraph(fmt::format("The paper's sentence on the two bands: of its four parts no "
                                 "reading fits more than {}.", max));
    report.summary()["bands"] = to_json(rows);
}

}  // namespace

std::string verdict(const Row& row) {
    if (is(row, "ground", "plane")) {
        const double p = row.number("fisher_p");
        if (std::isnan(p)) return "no errors";
        return p < 1e-3 ? "pattern" : "noise";
    }
    const double flatness = row.number("flatness");
    if (std::isnan(flatness) || row.number("windows") < min_windows) return "no errors";
    if (flatness <= max_periodic_flatness) return "pattern";
    return flatness >= min_noise_flatness ? "noise" : "between";
}

void report_moire(const Request& request, std::span<const Row> all, Report& report) {
    std::vector<Row> rows;
    for (const Row& row : all)
        if (is(row, "status", "ok")) rows.push_back(row);
    constexpr std::array<std::string_view, 3> told{"lookup", "dither", "dither_size"};
    for_combinations(request, told, rows, report, [](std::span<const Row> some, Report& to) {
        tell_beat(some, to);
        tell_controls(some, to);
        table_scene(some, to);
        table_plane(some, to);
        plot_sizes(some, "scene", "flatness", "flatness", false, to);
        plot_sizes(some, "plane", "peak_over_mean", "peak over mean", true, to);
    });
    picture_spectra(request, "plane", report);
    if (request.quick) return;
    picture_spectra(request, "scene", report);
    tell_bands(report);
}

}  // namespace umbra78::tools::study
