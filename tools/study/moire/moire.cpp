// umbra78 study moire: is the error a pattern, and which remedy makes it noise?
//
// The error is measured on two grounds. On the scene's own surfaces the moire changes its pitch
// from place to place; there the flatness of small windows distinguishes pattern from noise. On a
// slanted plane the moire has one pitch, which is predicted from the two grids; there the highest
// line of the spectrum decides. The bias is figure 3's, half a texel. Dithers that are too narrow,
// and a generator that restarts in every row, are negative controls: a measure that takes them for
// noise measures nothing.
#include "tools/study/grid.hpp"
#include "tools/study/moire/frame.hpp"
#include "tools/study/moire/report.hpp"

#include <cmath>

namespace umbra78::tools::study {
namespace {

class MoireStudy : public Study {
public:
    std::string_view name() const override { return "moire"; }
    std::string_view meaning() const override {
        return "Is the error a pattern: its spectrum before and after each remedy";
    }
    std::vector<Case> cases(const Request&) const override;
    std::optional<LoadedScene> scene(const Request& request, const Case& c) const override {
        return moire_scene(request, c);
    }
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows,
                Report& report) const override {
        report_moire(request, rows, report);
    }

private:
    TruthCache truths_;
};

std::vector<Case> MoireStudy::cases(const Request& request) const {
    const std::vector<GridKey> shared{{"bias_unit", {"texels"}}, {"bias", {"0.5"}},
                                   {"dequantize", {"0"}},     {"low_pass", {"0"}},
                                   {"lookup", {"nearest", "bilinear"}}};
    std::vector<Case> all;
    const auto add = [&](const char* ground, const char* noise, std::vector<GridKey> axes) {
        axes.insert(axes.begin(), shared.begin(), shared.end());
        std::vector<Case> cases = grid(request, std::move(axes));
        for (Case& c : cases) {
            c.extra = {{"ground", ground}, {"noise", noise}};
            c.name = std::string(ground) + " " + noise + " " + c.name;
        }
        all = joined(std::move(all), cases);
    };
    GridKey shapes{"dither", {"uniform", "triangular", "normal4", "normal"}};
    GridKey sizes{"dither_size", {"0", "0.25", "0.5", "0.75", "1", "1.5", "2"}};
    if (request.quick) {
        shapes.second = {"uniform", "normal"};
        sizes.second = {"0.25", "1"};
    }
    for (const char* ground : {"scene", "plane"}) {
        add(ground, "machine", {{"dither", {"none"}}, {"dither_size", {"1"}}});
        add(ground, "machine", {shapes, sizes});
        add(ground, "restarted rows",
            {{"dither", {"uniform", "normal"}}, {"dither_size", {"1"}}});
    }
    return all;
}

Row MoireStudy::run(const Request&, const Case& c, const LoadedScene* scene) const {
    const MoireFrame frame = draw_moire(*scene, c, truths_);
    const ErrorSpectrum s = error_spectrum(frame.traced->truth, frame.shown(), frame.window_px);
    Row row;
    set_rates(row, frame.report);
    set_in_three_units(row, "bias", light_units(*scene), frame.bias_quanta);
    row.set("flatness", s.flatness.windows > 0 ? Value(s.flatness.median) : Value());
    row.set("windows", std::int64_t{s.flatness.windows});

    const bool plane = frame.window_px > 0, errors = plane && s.peak.over_mean > 0;
    const auto set = [&](const char* column, double value) {
        row.set(column, errors ? Value(value) : Value());
    };
    set("peak_over_mean", s.peak.over_mean);
    set("fisher_g", s.fisher.g);
    set("fisher_p", s.fisher.p);
    set("anisotropy_db", s.radial.max_anisotropy_db);
    set("white_anisotropy_db", -10 * std::log10(std::max(s.segments, 1)));
    set("peak_u", s.peak.at.u);
    set("peak_v", s.peak.at.v);
    set("peak_period_px", s.peak.at.period_px());
    const GridBeat beat = plane ? grid_beat(frame.traced->truth) : GridBeat{};
    set("beat_u", beat.predicted().u);
    set("beat_v", beat.predicted().v);
    set("beat_period_px", beat.predicted().period_px());
    const Harmonic h = harmonic_at(beat, s.peak.at, plane ? 1.0 / frame.window_px : 0);
    row.set("harmonic_k", errors ? Value(std::int64_t{h.k}) : Value());
    row.set("harmonic_l", errors ? Value(std::int64_t{h.l}) : Value());
    return row;
}

std::vector<ColumnMeaning> MoireStudy::columns() const {
    std::vector<ColumnMeaning> all(std::begin(rate_columns), std::end(rate_columns));
    for (const ColumnMeaning& own : std::initializer_list<ColumnMeaning>{
             {"ground", "what is seen: the scene's own surfaces, or the slanted plane"},
             {"noise", "machine: the machine's noise source; restarted rows: a generator that "
                       "restarts in every row, a negative control"},
             {"bias_*", "the bias in quanta of the light's Z, light texels, world units"},
             {"flatness", "median spectral flatness of 32 x 32 windows of the error: white noise "
                          "0.56, a pattern towards 0; empty without a window of 16 errors"},
             {"windows", "how many windows have the 16 errors that make a spectrum"},
             {"peak_over_mean", "the highest line of the plane's spectrum over the mean line"},
             {"fisher_g", "Fisher's g: that line's share of the whole power"},
             {"fisher_p", "the probability of so high a line in white noise"},
             {"anisotropy_db", "the maximum anisotropy of any ring of the spectrum, dB"},
             {"white_anisotropy_db", "the mean of it for white noise, dB"},
             {"peak_u", "frequency of that line along X, cycles a pixel"},
             {"peak_v", "frequency of that line along Y, cycles a pixel"},
             {"peak_period_px", "its period, pixels"},
             {"beat_*", "frequency (u, v) and period of the predicted beat of the two grids"},
             {"harmonic_*", "the harmonic (k, l) of the two grids at the measured line; 0, 0 if "
                            "there is none up to order 5"}})
        all.push_back(own);
    return all;
}

bool has(const Case& c, std::string_view column, std::string_view value) {
    for (const auto& [name, held] : c.extra)
        if (name == column) return held == value;
    return false;
}

}  // namespace

LoadedScene moire_scene(const Request& request, const Case& c) {
    return has(c, "ground", "plane") ? parse_scene(slanted_plane, "the slanted plane", c.set)
                                     : scene_of(request, c);
}

MoireFrame draw_moire(const LoadedScene& scene, const Case& c, const TruthCache& truths) {
    MoireFrame frame;
    frame.traced = truths.needed(scene);
    frame.window_px = has(c, "ground", "plane") ? scene.settings.machine.size_px() / 2 : 0;
    RenderJob job(scene.view(), scene.settings);
    draw_mask(job);
    frame.visible = job.visible();
    if (has(c, "noise", "restarted rows")) {
        frame.mask = mask_with_restarted_rows(job);
    } else {
        const auto mask = job.bytes(Plane::mask);
        frame.mask.assign(mask.begin(), mask.end());
    }
    const std::int64_t bias_q16 = job.matrices().lights[0].bias_quanta_q16;
    frame.bias_quanta = std::ldexp(static_cast<double>(bias_q16), -16);
    const Buffer depths = job.buffer(Plane::observer_z);
    frame.report = report(frame.traced->truth, frame.shown(), frame.traced->band, &depths);
    return frame;
}

std::unique_ptr<Study> make_moire_study() { return std::make_unique<MoireStudy>(); }

}  // namespace umbra78::tools::study
