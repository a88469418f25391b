#include "tools/paper/bands.hpp"

#include "tools/io/text_formats.hpp"
#include "tools/paper/figure_set.hpp"

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

bool BandRow::max_at_line() const {
    return std::max_element(false_shadow.begin(), false_shadow.end()) == false_shadow.end() - 1;
}

bool BandRow::band_left_of_line() const {
    bool band = false;
    for (std::size_t k = 0; k + 1 < false_shadow.size(); ++k)
        band |= false_shadow[k] >= false_shadow[k + 1] + min_dark;
    return band && !right_edge_lit();
}

std::vector<BandRow> measure_bands(int bias_quanta) {
    std::vector<BandRow> rows;
    for (const int azimuth : {-100, -80, 80, 100}) {
        LoadedScene scene = figures_scene();
        scene.light() = shadow::figure_view(azimuth * 65536);
        const SceneTruth truth = *trace(scene);
        for (const Sampling sampling : {Sampling::centre, Sampling::leaf}) {
            shadow::Settings settings = shadow::figure_settings(3);
            settings.sampling = sampling;
            settings.bias_q16 = std::int64_t{bias_quanta} << 16;
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

std::string to_markdown(const std::vector<BandRow>& rows, int bias_quanta) {
    std::vector<std::vector<std::string>> table{
        {"light", "sampling", "registration", "lit part of a disc", "limb", "middle", "inner",
         "line", "(1)", "(2)", "(3)", "(4)"}};
    for (const BandRow& row : rows) {
        std::vector<std::string> cells{
            fmt::format("{:+d}", row.azimuth), name(row.sampling), name(row.registration),
            fmt::format("{} limb to {} of centre", row.right_edge_lit() ? "right" : "left",
                        row.line_left_of_centre() ? "left" : "right")};
        for (const double rate : row.false_shadow) cells.push_back(fmt::format("{:.3f}", rate));
        for (const bool fits : {row.line_is_lights_right_edge(), row.max_at_line(),
                                row.band_left_of_line(), row.observers_right_edge_dark()})
            cells.emplace_back(fits ? "yes" : "no");
        table.push_back(std::move(cells));
    }
    return markdown_table(table) +
           fmt::format(
               "\nFigure 3's settings, bias {1} quanta. light: azimuth in degrees, positive to "
               "the observer's right.\nlimb .. line: false-shadow rate in four equal steps of the "
               "normal's azimuth over the lit side of the\nfour spheres. The parts of the "
               "sentence:\n\n"
               "1. the shadow line is the right edge of the spheres in the light's view\n"
               "2. the error is greatest at the line\n"
               "3. there is a dark band to the left of the line: a step darker by {0} than its "
               "neighbour toward the line\n"
               "4. the observer's right edge of the spheres is lit in truth, and dark: at the "
               "limb the rate is at least {0}\n",
               BandRow::min_dark, bias_quanta);
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
                        {"greatest_at_line", row.max_at_line()},
                        {"band_left_of_line", row.band_left_of_line()},
                        {"observers_right_edge_dark", row.observers_right_edge_dark()}});
    return json;
}

}  // namespace umbra78::tools
