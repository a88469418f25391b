#include "tools/captured/report.hpp"

#include "tools/bias/units.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbra78::tools::captured {
namespace {

using nlohmann::ordered_json;

// A bias of quanta in the constant parameters that count window depth or steps of the format.
struct Constant {
    std::string target, name;
    double value;
};
std::vector<Constant> constants_of(const Answer& a, double quanta) {
    const DepthFormat& format = a.capture.format;
    bias::Amount amount{};
    amount.world = quanta / static_cast<double>(far_code(format, a.frame.spec()));
    amount.texel = amount.range = amount.largest = amount.tangent = 1;
    amount.unorm_bits = format.own() ? a.frame.spec().z_bits : format.unorm_bits;
    amount.exponent = -1;  // of depths from 1/2 to 1
    amount.reversed = format.reversed;
    amount.map_px = a.frame.light_sides().width;
    std::vector<Constant> constants;
    for (const bias::Converted& c : bias::convert(amount, amount)) {
        const bias::Parameter& p = *c.parameter;
        const bool by_depth = p.unit == "r" || p.unit == "2^-n" || p.unit == "window depth";
        if (p.kind != bias::Kind::constant || !c.value || !by_depth) continue;
        constants.push_back({std::string(p.target), std::string(p.name), *c.value});
    }
    return constants;
}

double depth_of(const Answer& a, double quanta) {
    return quanta / static_cast<double>(far_code(a.capture.format, a.frame.spec()));
}

// --- JSON

ordered_json to_json(const NumberImage& image, const Codes& codes) {
    return {{"file", image.name},
            {"width", image.width},
            {"height", image.height},
            {"numbers", name_of(image.kind)},
            {"background_pixels", codes.background},
            {"largest_rounding_quanta", codes.largest_rounding}};
}

ordered_json to_json(const ShadowError& e) {
    return {{"lit_pixels", e.lit},
            {"shadowed_pixels", e.shadowed},
            {"false_shadow_pixels", e.false_shadow},
            {"false_light_pixels", e.false_light},
            {"false_shadow", e.false_shadow_rate()},
            {"false_light", e.false_light_rate()}};
}

ordered_json to_json(const Frequency& f) {
    return {{"u", f.u}, {"v", f.v}, {"period_px", f.period_px()}};
}

ordered_json to_json(const Judged& j) {
    ordered_json json{{"flatness", nullptr}, {"flatness_windows", j.flatness.windows},
                      {"window", nullptr}};
    if (j.flatness.windows > 0) json["flatness"] = j.flatness.median;
    if (!j.window) return json;
    const Window& w = *j.window;
    json["window"] = {{"left", w.left},
                      {"top", w.top},
                      {"side", w.side},
                      {"peak", to_json(w.peak.at)},
                      {"peak_over_mean", w.peak.over_mean},
                      {"chance", w.fisher.p},
                      {"predicted", nullptr}};
    if (w.beat) json["window"]["predicted"] = to_json(w.beat->predicted());
    return json;
}

ordered_json least_json(const Answer& a) {
    if (!a.least) return nullptr;
    ordered_json json{{"quanta", a.least->quanta},
                      {"depth", depth_of(a, a.least->quanta)},
                      {"error", to_json(a.least->error)}};
    for (const Constant& c : constants_of(a, a.least->quanta))
        json["units"].push_back({{"for", c.target}, {"parameter", c.name}, {"value", c.value}});
    return json;
}

ordered_json matrix_json(const hw::MatrixWords& m) {
    ordered_json rows = ordered_json::array();
    for (std::size_t r = 0; r < 4; ++r)
        rows.push_back({{"words", m.word[r]}, {"exponent", m.exponent[r]}});
    return {{"affine", m.affine}, {"rows", rows}};
}

// --- text

std::string line_of(const char* what, const NumberImage& image, const Codes& codes) {
    return fmt::format("{:<11} {}: {} x {} of {}, {} of the far plane; rounded by at most {:.3g} "
                       "quanta\n", what, image.name, image.width, image.height,
                       name_of(image.kind), codes.background, codes.largest_rounding);
}

std::string rates(const ShadowError& e) {
    return fmt::format("false shadow {:.2f} % of {} lit pixels, false light {:.2f} % of {} in "
                       "shadow", 100 * e.false_shadow_rate(), e.lit, 100 * e.false_light_rate(),
                       e.shadowed);
}

std::string place(const Frequency& f) {
    return fmt::format("({:.4f}, {:.4f}) cycles a pixel, {:.1f} pixels", f.u, f.v, f.period_px());
}

std::string spectrum_lines(const Judged& j) {
    std::string text;
    if (j.flatness.windows > 0)
        text += fmt::format("flatness    {:.3f} over {} windows with errors; white noise has 0.56, "
                            "a moire less\n", j.flatness.median, j.flatness.windows);
    if (!j.window) return text + "spectrum    n/a (no square of lit pixels has enough errors)\n";
    const Window& w = *j.window;
    text += fmt::format("spectrum    {0} x {0} pixels at ({1}, {2}): highest at {3}, {4:.0f} times "
                        "the mean, by chance {5:.2g}\n", w.side, w.left, w.top, place(w.peak.at),
                        w.peak.over_mean, w.fisher.p);
    if (w.beat)
        text += fmt::format("            the beat of the two grids on one plane there: {}\n",
                            place(w.beat->predicted()));
    return text;
}

std::string least_lines(const Answer& a) {
    if (!a.least) return "least bias  none up to an eighth of the depth range\n";
    std::string text = fmt::format("least bias  {} quanta, {:.4g} of the depth range\n",
                                   a.least->quanta, depth_of(a, a.least->quanta));
    text += fmt::format("            (under {:g} % away from edges; in the whole mask: {})\n",
                        100 * tolerated_false_shadow, rates(a.least->error));
    for (const Constant& c : constants_of(a, a.least->quanta))
        text += fmt::format("            {} {}: {:.6g}\n", c.target, c.name, c.value);
    if (a.capture.format.real)
        text += "            (a float's r is that of depths from 1/2 to 1, 2^-24)\n";
    return text;
}

}  // namespace

std::string print(const Answer& a) {
    const hw::MachineSpec& m = a.frame.spec();
    const Outcomes& o = a.outcomes;
    std::string text = line_of("observer", a.capture.observer, a.frame.observer()) +
                       line_of("light", a.capture.light, a.frame.light());
    text += fmt::format("machine     {0} x {0} pixels, {1} bits of Z, matrix words of {2}; bias "
                        "{3:.6g} quanta\n", m.size_px(), m.z_bits, m.coefficient_bits,
                        std::ldexp(static_cast<double>(a.frame.settings().bias_q16), -16));
    text += fmt::format("pixels      {} compared, {} in shadow; lit without comparison: {} outside "
                        "the light's buffer, {} without a quotient\n", o.compared, o.shadowed,
                        o.outside, o.no_quotient);
    text += fmt::format("mask        {}\n",
                        hash_of(a.frame.buffer("mask", std::span<const std::uint8_t>(a.mask))));
    text += fmt::format("error       {}; {} isolated pixels\n", rates(a.judged.error),
                        a.judged.isolated_pixels);
    if (a.judged.estimated)
        text += fmt::format("            against an estimate: what is in shadow when each pixel is "
                            "compared at its own plane, bias {}\n", estimate_bias(m));
    text += spectrum_lines(a.judged);
    if (a.searched) text += least_lines(a);
    if (a.trace)
        text += fmt::format("\npixel ({}, {}): {}\n\n{}", a.trace->pixel.x, a.trace->pixel.y,
                            summary(*a.trace), to_text(a.trace->lines));
    return text;
}

ordered_json to_json(const Answer& a) {
    const CapturedFrame& f = a.frame;
    const Outcomes& o = a.outcomes;
    ordered_json json;
    json["observer"] = to_json(a.capture.observer, f.observer());
    json["light"] = to_json(a.capture.light, f.light());
    json["depth_format"] = a.capture.format.name;
    json["matrix"] = matrix_json(f.words(f.settings().bias_q16));
    json["pixels"] = {{"background", o.background}, {"no_quotient", o.no_quotient},
                      {"outside", o.outside},       {"compared", o.compared},
                      {"in_shadow", o.shadowed}};
    json["hashes"] = {
        {"observer_z", hash_of(f.buffer("observer_z", f.observer()))},
        {"light_z", hash_of(f.buffer("light_z", f.light()))},
        {"mask", hash_of(f.buffer("mask", std::span<const std::uint8_t>(a.mask)))}};
    json["error"] = to_json(a.judged.error);
    json["error"]["isolated_pixels"] = a.judged.isolated_pixels;
    json["error"]["estimated"] = a.judged.estimated;
    json["spectrum"] = to_json(a.judged);
    if (a.searched) json["least_bias"] = least_json(a);
    if (a.trace) json["trace"] = tools::to_json(*a.trace);
    json["settings"] = settings_json(f.settings());
    json["warnings"] = a.warnings;
    return json;
}

}  // namespace umbra78::tools::captured
