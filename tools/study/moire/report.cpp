#include "tools/study/moire/report.hpp"

#include "tools/paper/bands.hpp"
#include "tools/study/report_sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

// With that many decimals; "" for an empty cell.
std::string figure(const Row& row, const char* column, int decimals) {
    const double value = row.number(column);
    return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, decimals);
}

bool is(const Row& row, std::string_view column, std::string_view value) {
    return row.text(column) == value;
}

void table_scene(std::span<const Row> rows, Report& report) {
    TableCells table{{"lookup", "dither", "its size, texels", "noise source", "false shadow",
                      "isolated pixels", "flatness", "windows", "verdict"}};
    for (const Row& row : rows)
        if (is(row, "ground", "scene"))
            table.push_back({row.text("lookup"), row.text("dither"), row.text("dither_size"),
                             row.text("noise"), percent(row.number("false_shadow")),
                             row.text("isolated_pixels"), figure(row, "flatness", 3),
                             row.text("windows"), verdict(row)});
    report.table(table, "The scene's surfaces. Flatness is the median spectral flatness of 32 x 32 "
                        "windows of the error over lit pixels: white noise has 0.5615, 0.57 to "
                        "0.59 where errors are few; a pattern tends to 0. 'Too few errors': fewer "
                        "than ten windows have the 16 errors that make a spectrum. Dither 'none' "
                        "is no dither.");
}

void table_plane(std::span<const Row> rows, Report& report) {
    TableCells table{{"lookup", "dither", "its size, texels", "noise source", "false shadow",
                      "peak over mean", "p", "anisotropy, dB", "flatness", "peak's period, px",
                      "predicted beat, px", "harmonic (k, l)", "verdict"}};
    for (const Row& row : rows)
        if (is(row, "ground", "plane"))
            table.push_back({row.text("lookup"), row.text("dither"), row.text("dither_size"),
                             row.text("noise"), percent(row.number("false_shadow")),
                             rounded(row.number("peak_over_mean")),
                             rounded(row.number("fisher_p"), 2), figure(row, "anisotropy_db", 1),
                             figure(row, "flatness", 3), figure(row, "peak_period_px", 3),
                             figure(row, "beat_period_px", 3),
                             row.text("harmonic_k").empty()
                                 ? "" : row.text("harmonic_k") + ", " + row.text("harmonic_l"),
                             verdict(row)});
    report.table(table,
        "The slanted plane, the middle quarter of the picture. White noise peaks at about "
        "ln(cells) times the mean, 11 for 256 x 256. p is the probability of so high a line in "
        "white noise (Fisher's g): a pattern has less than 0.001. Anisotropy is the maximum of any "
        "ring of the spectrum; the mean of white noise is -10 log10 K for K segments. The beat is "
        "that of the observer's pixels with the steeper axis of the light's texels; (k, l) is the "
        "harmonic of the two grids at the measured peak, 0, 0 if there is none up to order 5.");
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
            report.plot(plot, fmt::format(
                "The bias is figure 3's, half a texel. {} A missing point left too few errors for "
                "a spectrum.",
                log_y ? "White noise is at about 11."
                      : "White noise is at 0.56; below 0.48 the error is a pattern."));
    }
}

// The remedies of figure 4, each alone and both, drawn again for their pictures.
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
        const MoireFrame frame = draw_moire(moire_scene(request, c), c, truths);
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
                                   remedy.title, none ? " No pixel is wrong, so it is black."
                                                      : ""));
    }
    if (!radial.series.empty())
        report.plot(radial, "Power in rings around zero frequency, averaged over the window's "
                            "segments; white noise is at 1.");
}

// Cases that a sound measure must not take for noise.
void report_controls(std::span<const Row> rows, Report& report) {
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
    report.heading("Is the measure sound?");
    report.paragraph(fmt::format(
        "There are {} negative controls: a quarter texel of dither with nearest lookup, or a "
        "generator that restarts in every row. {} of them pass for noise, {} leave too few errors "
        "to measure. With bilinear lookup a narrow dither is not a control, because interpolation "
        "removes the pattern by itself. On the plane a pattern is a peak that white noise has "
        "once in 1000 windows (Fisher's g); in the scene it is a flatness of {} or less, and "
        "noise is {} or more.",
        json.size(), count("noise"), count("too few errors"), max_periodic_flatness,
        min_noise_flatness));
}

// What each lookup's error on the scene's surfaces is, without dither and with a texel of it.
void answer_remedies(std::span<const Row> rows, Report& report) {
    for (const char* lookup : {"nearest", "bilinear"}) {
        std::string words;
        for (const Row& row : rows) {
            const bool undithered = is(row, "dither", "none");
            if (!is(row, "ground", "scene") || !is(row, "lookup", lookup) ||
                !is(row, "noise", "machine") || (row.number("dither_size") != 1 && !undithered))
                continue;
            words += fmt::format("{}{}: {}", words.empty() ? "" : "; ",
                                 undithered ? "no dither" : row.text("dither"), verdict(row));
            if (verdict(row) != "too few errors")
                words += fmt::format(" ({})", figure(row, "flatness", 3));
        }
        if (!words.empty())
            report.answer(fmt::format("The error on the scene's surfaces with {} lookup and a "
                                      "dither of one texel (in brackets the flatness, 0.56 for "
                                      "white noise): {}.", lookup, words));
    }
}

void answer_beat(std::span<const Row> rows, Report& report) {
    for (const Row& row : rows) {
        if (!is(row, "ground", "plane") || !is(row, "lookup", "nearest") ||
            !is(row, "dither", "none") || std::isnan(row.number("peak_period_px")))
            continue;
        report.answer(fmt::format(
            "The moire of the study's slanted plane is where the two grids put it. Predicted is a "
            "beat of {} px at ({}, {}) cycles a pixel; measured is a peak of {} times the mean, {} "
            "px at ({}, {}), harmonic ({}, {}).",
            figure(row, "beat_period_px", 3), figure(row, "beat_u", 4), figure(row, "beat_v", 4),
            figure(row, "peak_over_mean", 0), figure(row, "peak_period_px", 3),
            figure(row, "peak_u", 4), figure(row, "peak_v", 4), row.text("harmonic_k"),
            row.text("harmonic_l")));
        report.summary()["beat_px"] = {{"predicted", row.number("beat_period_px")},
                                       {"measured", row.number("peak_period_px")}};
        return;
    }
}

// Williams 1978, p. 273, on figure 3: the reading of tools/paper/bands.hpp.
void report_bands(Report& report) {
    const auto rows = measure_bands(64);
    TableCells table{{"light's azimuth", "sampling", "registration", "false shadow: limb",
                      "middle", "inner", "line", "line is the light's right edge",
                      "maximum at the line", "band left of the line",
                      "observer's right edge dark"}};
    std::size_t max = 0;
    for (const BandRow& row : rows) {
        const std::array<bool, 4> fits{row.line_is_lights_right_edge(), row.max_at_line(),
                                       row.band_left_of_line(), row.observers_right_edge_dark()};
        max = std::max(max, static_cast<std::size_t>(std::count(fits.begin(), fits.end(), true)));
        std::vector<std::string> line{
            fmt::format("{:+d}", row.azimuth),
            row.sampling == raster::Sampling::centre ? "centre" : "leaf",
            row.registration == shadow::Registration::centre ? "centre" : "index"};
        for (const double rate : row.false_shadow) line.push_back(percent(rate));
        for (const bool fit : fits) line.emplace_back(fit ? "yes" : "no");
        table.push_back(std::move(line));
    }
    report.heading("The paper's two bands");
    report.paragraph(fmt::format("The paper describes two bands on figure 3 in a sentence of four "
                                 "parts. No reading of it fits more than {} of them.", max));
    report.table(table, "The sentence part by part, for each side of the light, sampling and "
                        "registration, in the figures' scene with 64 quanta of bias. The limb is "
                        "the sphere's visible edge, the line that where its shadow begins.");
    report.summary()["bands"] = to_json(rows);
}

}  // namespace

std::string verdict(const Row& row) {
    if (is(row, "ground", "plane")) {
        const double p = row.number("fisher_p");
        if (std::isnan(p)) return "too few errors";
        return p < 1e-3 ? "pattern" : "noise";
    }
    const double flatness = row.number("flatness");
    if (std::isnan(flatness) || row.number("windows") < min_windows) return "too few errors";
    if (flatness <= max_periodic_flatness) return "pattern";
    return flatness >= min_noise_flatness ? "noise" : "between";
}

void report_moire(const Request& request, std::span<const Row> all, Report& report) {
    std::vector<Row> rows;
    for (const Row& row : all)
        if (is(row, "status", "ok")) rows.push_back(row);
    constexpr std::array<std::string_view, 3> keys{"lookup", "dither", "dither_size"};
    write_sections(request, keys, rows, report, [](std::span<const Row> some, Report& to) {
        answer_remedies(some, to);
        answer_beat(some, to);
        plot_sizes(some, "scene", "flatness", "flatness", false, to);
        to.heading("On the slanted plane");
        plot_sizes(some, "plane", "peak_over_mean", "peak over mean", true, to);
        to.heading("Every case");
        table_scene(some, to);
        table_plane(some, to);
        report_controls(some, to);
    });
    report.heading("Spectra");
    picture_spectra(request, "plane", report);
    if (request.quick) return;
    picture_spectra(request, "scene", report);
    report_bands(report);
}

}  // namespace umbra78::tools::study
