#include "tools/band_study.hpp"

#include "tools/figure_set.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbra78::tools {
namespace {

using raster::Sampling;
using shadow::Registration;

constexpr int bins = 4;

const char* name(Sampling s) { return s == Sampling::centre ? "centre" : "leaf"; }
const char* name(Registration r) { return r == Registration::centre ? "centre" : "index"; }
const char* yes_or_no(bool fits) { return fits ? "yes" : "no"; }

std::array<double, bins> profile(const SceneTruth& truth, const RenderJob& job) {
    const std::vector<std::uint8_t> visible = job.visible();
    const MachineMask mask{job.bytes(Plane::mask), visible};
    std::array<ShadowError, bins> sum{};
    for (std::size_t sphere = 0; sphere < truth.scene.spheres.size(); ++sphere) {
        const auto one = limb_to_line_profile(truth.truth, mask, truth.scene,
                                              static_cast<int>(sphere), truth.observer,
                                              truth.light, bins);
        for (std::size_t k = 0; k < bins; ++k) {
            sum[k].lit += one[k].lit;
            sum[k].false_shadow += one[k].false_shadow;
        }
    }
    std::array<double, bins> rates{};
    for (std::size_t k = 0; k < bins; ++k) rates[k] = sum[k].false_shadow_rate();
    return rates;
}

}  // namespace

bool BandRow::greatest_at_line() const {
    return std::max_element(false_shadow.begin(), false_shadow.end()) == &false_shadow.back();
}

bool BandRow::band_at_limb() const {
    return false_shadow[0] >= least_band && false_shadow[0] > false_shadow[1];
}

std::vector<BandRow> study_bands() {
    std::vector<BandRow> rows;
    for (const int azimuth : {-100, -80, 80, 100}) {
        LoadedScene scene = figures_scene();
        scene.light = shadow::figure_view(azimuth * 65536);
        const SceneTruth truth = *trace(scene);
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
            shadow::Settings settings = shadow::figure_settings(3);
            settings.sampling = sampling;
            RenderJob job(scene.view(), settings);
            job.draw_light();
            job.draw_observer();
            for (const Registration registration : {Registration::centre, Registration::index}) {
                settings.registration = registration;
                job.use(settings);
                job.cast_shadows();
                rows.push_back({azimuth, sampling, registration, profile(truth, job)});
            }
        }
    }
    return rows;
}

std::string to_markdown(const std::vector<BandRow>& rows) {
    std::string text =
        "| light | sampling | registration | lit part of a disc | limb | middle | inner | line | "
        "line is the light's right edge | greatest at the line | band left of the line | band is "
        "the observer's right edge |\n"
        "|------:|----------|--------------|--------------------|-----:|-------:|------:|-----:|"
        "---|---|---|---|\n";
    for (const BandRow& row : rows) {
        const auto& fs = row.false_shadow;
        text += fmt::format(
            "| {:+d} | {} | {} | {} limb to {} of centre | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {} "
            "| {} | {} | {} |\n",
            row.azimuth, name(row.sampling), name(row.registration),
            row.right_edge_lit() ? "right" : "left",
            row.line_left_of_centre() ? "left" : "right", fs[0], fs[1], fs[2], fs[3],
            yes_or_no(row.line_is_lights_right_edge()), yes_or_no(row.greatest_at_line()),
            yes_or_no(row.band_left_of_line()), yes_or_no(row.band_is_observers_right_edge()));
    }
    return text + fmt::format(
        "\nFigure 3's settings; light: azimuth in degrees, positive to the observer's right. limb "
        ".. line: false-shadow rate in four\nequal steps of the normal's azimuth over the lit "
        "side of the spheres. Greatest at the line: no other step's rate is\nas high. A band: at "
        "the limb the rate is at least {} and higher than in the middle; left of the line if the "
        "left\nlimb is lit, the observer's right edge if the right limb is.\n",
        BandRow::least_band);
}

nlohmann::ordered_json to_json(const std::vector<BandRow>& rows) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const BandRow& row : rows)
        json.push_back({{"azimuth", row.azimuth},
                        {"sampling", name(row.sampling)},
                        {"registration", name(row.registration)},
                        {"right_edge_lit", row.right_edge_lit()},
                        {"line_left_of_centre", row.line_left_of_centre()},
                        {"false_shadow_limb_to_line", row.false_shadow},
                        {"line_is_lights_right_edge", row.line_is_lights_right_edge()},
                        {"greatest_at_line", row.greatest_at_line()},
                        {"band_left_of_line", row.band_left_of_line()},
                        {"band_is_observers_right_edge", row.band_is_observers_right_edge()}});
    return json;
}

}  // namespace umbra78::tools
