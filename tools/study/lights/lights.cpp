// umbra78 study lights: how large a light's map must be, from where it may shine, and how near.
//
// The paper names what makes quantization worse: lateral resolution, severe perspective, a light
// close to the scene. Here each is varied alone: the map's texel beside the observer's pixel; the
// angle between a light at infinity and the observer, and a lamp's, up to both facing each other;
// and the height of a lamp over a floor that it grazes more and more. Each case is measured at a
// bias of 1.5 texels of its own map, which is figure 4's, and its least bias is searched for.
#include "tools/study/lights/lights.hpp"

#include "tools/study/bias/search.hpp"
#include "tools/study/grid.hpp"
#include "tools/study/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace umbra78::tools::study {
namespace {

std::string_view extra(const Case& c, std::string_view column) {
    for (const auto& [name, value] : c.extra)
        if (name == column) return value;
    return {};
}

double at_of(const Case& c) {
    return std::strtod(std::string(extra(c, "asked_at")).c_str(), nullptr);
}

class Lights final : public Study {
public:
    std::string_view name() const override { return "lights"; }
    std::string_view meaning() const override {
        return "Errors over the map's size, the angle between the views, and a lamp's height";
    }
    std::vector<Case> cases(const Request&) const override;
    std::optional<LoadedScene> scene(const Request& request, const Case& c) const override {
        return lights_scene(request, c);
    }
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override;

private:
    TruthCache truths_;
};

// The keys that a question sets itself; it is asked for once, whatever --vary gives them.
std::vector<std::string_view> own_keys(Question q) {
    if (q == Question::size)
        return {"light.extent", "light.near", "light.far", "observer.extent", "observer.near",
                "observer.far", "xy_bits"};
    if (q == Question::angle) return {"light.azimuth"};
    return {};
}

// --vary for a question: without several values of its own keys; on a ground of the study's
// settings alone.
Request for_question(const Request& request, Question q) {
    Request asked = for_sweep(request, own_keys(q), {});
    if (q == Question::opposed_lamp || q == Question::low_lamp)
        std::erase_if(asked.vary, [](const GridKey& axis) {
            return axis.first.find('.') != std::string::npos;
        });
    return asked;
}

std::vector<Case> settings_of(const Request& request) {
    const std::vector<GridKey> shared{{"bias_unit", {"texels"}},
                                      {"bias", {"1.5"}},
                                      {"dequantize", {"0"}},
                                      {"low_pass", {"0"}}};
    const auto with = [&](const char* lookup, const char* dither) {
        std::vector<GridKey> axes{{"lookup", {lookup}}, {"dither", {dither}}};
        axes.insert(axes.end(), shared.begin(), shared.end());
        return grid(request, axes);
    };
    std::vector<Case> all = joined({}, with("nearest", "none"));
    if (!request.quick) all = joined(std::move(all), with("bilinear", "none"));
    return joined(std::move(all), with("bilinear", "normal"));
}

// What is tried of each question: texels a pixel, degrees, world units.
std::vector<const char*> places(Question q, bool quick) {
    switch (q) {
    case Question::size:
        return quick ? std::vector{"0.5", "1", "2"}
                     : std::vector{"0.25", "0.5", "1", "2", "4", "8"};
    case Question::low_lamp:
        return quick ? std::vector{"4", "1", "0.25"}
                     : std::vector{"8", "4", "2", "1", "0.5", "0.25", "0.125"};
    default:
        return quick ? std::vector{"0", "90", "180"}
                     : std::vector{"0", "15", "30", "45", "60", "75", "90", "105", "120", "135",
                                   "150", "165", "180"};
    }
}

std::vector<std::string> overrides(const LoadedScene& scene, Question q, double at) {
    if (q == Question::size) return size_overrides(scene, at);
    if (q == Question::angle) return {angle_override(scene, at)};
    return {};
}

std::vector<Case> Lights::cases(const Request& request) const {
    const bool lamp = request.scene.light().projection == raster::Projection::perspective;
    std::vector<Case> all;
    for (const Question q :
         {Question::size, Question::angle, Question::opposed_lamp, Question::low_lamp}) {
        if (q == Question::angle && lamp) continue;  // a lamp has a position, and no azimuth
        const std::string name(question_names[static_cast<std::size_t>(q)]);
        for (const char* at : places(q, request.quick))
            for (const Case& settings : settings_of(for_question(request, q))) {
                Case c = settings;
                c.extra = {{"question", name}, {"asked_at", at}};
                c.name = fmt::format("{} {}, {}", name, at, c.name);
                if (q == Question::size || q == Question::angle)
                    for (std::string& set :
                         overrides(scene_of(request, settings), q, at_of(c)))
                        c.set.push_back(std::move(set));
                all.push_back(std::move(c));
            }
    }
    return all;
}

Row Lights::run(const Request&, const Case& c, const LoadedScene* drawn) const {
    const LoadedScene& scene = *drawn;
    const auto traced = truths_.needed(scene);
    const LightUnits units = light_units(scene);
    BiasedFrames frames(scene, *traced);
    const LeastBias least = min_bias(frames);
    const bool found = !std::isnan(least.outside);
    Row row;
    row.set("at", at_of(c));
    const auto pixel = static_cast<std::size_t>(scene.settings.machine.size_px());
    row.set("map_mb", std::ldexp(static_cast<double>(pixel * pixel) *
                                     scene.settings.machine.z_bits / 8, -20));
    const TexelSides sides = texel_sides(traced->truth);
    row.set("texel_px_median", sides.median);
    row.set("texel_px_95", sides.most);
    set_in_three_units(row, "least_outside", units, least.outside);
    set_in_three_units(row, "least", units, least.overall);
    // Both errors where the least bias is used.
    const ShadowReport at_least =
        frames.errors(frames.draw(found ? std::optional(least.outside) : std::nullopt));
    const double nan = std::nan("");
    row.set("false_light_at_least", found ? at_least.all.false_light_rate() : nan);
    row.set("false_light_outside_at_least",
            found ? at_least.outside_band.false_light_rate() : nan);
    const ShadowReport own = frames.errors(frames.draw());
    set_rates(row, own);
    row.set("lit_px", std::int64_t{own.all.lit});
    row.set("shadowed_px", std::int64_t{own.all.shadowed});
    row.set("band_share", own.all.lit + own.all.shadowed == 0
                              ? nan
                              : 1 - static_cast<double>(own.outside_band.lit +
                                                        own.outside_band.shadowed) /
                                        (own.all.lit + own.all.shadowed));
    const shadow::FrameLedger ledger = frames.job().ledger();
    const auto cycles = [&](const char* column, std::uint64_t count) {
        row.set(column, static_cast<std::int64_t>(count));
    };
    cycles("light_cycles", shadow::FrameLedger::cycles(ledger.light, true));
    cycles("observer_cycles", shadow::FrameLedger::cycles(ledger.observer, true));
    cycles("transformation_cycles", ledger.transformation(true));
    cycles("frame_cycles", ledger.total(true));
    return row;
}

std::vector<ColumnMeaning> Lights::columns() const {
    std::vector<ColumnMeaning> all(std::begin(rate_columns), std::end(rate_columns));
    for (const ColumnMeaning& own : std::initializer_list<ColumnMeaning>{
             {"question", "what is varied: the size of the scene's map; the angle between its "
                          "light and its observer; the same of a lamp over balls; a lamp's height"},
             {"at", "texels of the map a pixel of the observer, relative to the scene's own "
                    "(size); degrees from the observer (angle, opposed lamp); world units over the "
                    "floor (low lamp)"},
             {"asked_at", "the same, which distinguishes the case"},
             {"map_mb", "memory of the light's map, MB of 2^20 bytes"},
             {"texel_px_*", "pixels that the side of a texel covers, over the lit pixels: the "
                            "middle value, and what 95 % of them do not exceed"},
             {"least_outside_*", "the least bias with under 0.1 % false shadow outside the edge "
                                 "band; empty if an eighth of the depth range is not enough"},
             {"least_*", "the least bias with under 0.1 % false shadow over all pixels"},
             {"false_light_at_least", "false_light at the least bias outside the edge band"},
             {"false_light_outside_at_least", "the same without the edge band"},
             {"lit_px", "compared pixels that are lit in truth"},
             {"shadowed_px", "compared pixels that are in shadow in truth"},
             {"band_share", "share of the compared pixels that lie in the edge band"},
             {"*_cycles", "cycles of the machine, simulated: of drawing a view, of the "
                          "transformation, of the frame, its units side by side"}})
        all.push_back(own);
    return all;
}

void Lights::report(const Request& request, std::span<const Row> rows, Report& to) const {
    constexpr std::array<std::string_view, 13> own{
        "lookup", "dither", "bias", "bias_unit", "dequantize", "low_pass", "light.extent",
        "light.near", "light.far", "light.azimuth", "observer.extent", "observer.near",
        "observer.far"};
    write_sections(request, own, rows, to, [&](std::span<const Row> some, Report& section) {
        report_lights(request, some, section);
    });
}

}  // namespace

Question question_of(const Case& c) {
    const auto found = std::ranges::find(question_names, extra(c, "question"));
    return static_cast<Question>(found - std::begin(question_names));
}

LoadedScene lights_scene(const Request& request, const Case& c) {
    const Question q = question_of(c);
    if (q == Question::opposed_lamp)
        return parse_scene(opposed_lamp_scene(at_of(c)), "the opposed lamp", c.set);
    if (q == Question::low_lamp)
        return parse_scene(low_lamp_scene(at_of(c)), "the low lamp", c.set);
    return scene_of(request, c);
}

std::unique_ptr<Study> make_lights_study() { return std::make_unique<Lights>(); }

}  // namespace umbra78::tools::study
