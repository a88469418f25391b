// umbra78 study bias: which bias, and in which unit?
//
// There are several kinds of case. One is a bias, and both rates of error with it. The other is a
// search by bisection, in whole quanta, for the least bias with under 0.1 % false shadow, over all
// pixels and outside the edge band (one light texel mapped back to the observer). Bisection is
// sound because false shadow never rises with the bias: every pixel's depth only falls. Searches
// at other widths show in which unit the least bias stays the same. A third kind searches for the
// least constant bias that is needed beside each form of bias that follows the surface. A fourth
// has depth maps of today beside the scene's own: both.
#include "tools/study/bias/maps.hpp"
#include "tools/study/bias/report.hpp"
#include "tools/study/bias/search.hpp"
#include "tools/study/grid.hpp"
#include "tools/truth/spectrum.hpp"

#include <array>
#include <cmath>
#include <sstream>

namespace umbra78::tools::study {
namespace {

const GridKey unit{"bias_unit", {"quanta"}};

class BiasStudy : public Study {
public:
    std::string_view name() const override { return "bias"; }
    std::string_view meaning() const override {
        return "Which bias, in which unit: both errors over bias, and the least that suffices";
    }
    Takes takes() const override { return {true, true}; }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows,
                Report& report) const override {
        report_bias(request, rows, report);
    }

private:
    TruthCache truths_;
};

std::vector<Case> searches(std::vector<Case> cases) {
    for (Case& c : cases) {
        c.name = "least bias " + c.name;
        c.extra.emplace_back("find", "least");
    }
    return cases;
}

// The least constant bias beside each form, and beside none.
std::vector<Case> forms(const Request& search, bool quick) {
    const std::vector<std::vector<GridKey>> all{
        {{"map_depth", {"first", "back", "midpoint"}}},
        {{"bias_slope", {"0.5", "1"}}},
        {{"bias_slope", {"1"}}, {"bias_clamp", {"512"}}},
        {{"receiver", {"plane"}}, {"slope_source", {"depths", "normals"}}},
        {{"receiver", {"plane"}}, {"bias_clamp", {"512"}}, {"slope_source", {"depths", "normals"}}},
        {{"receiver", {"normal"}},
         {"normal_offset", {"0.5", "0.75", "1", "2"}},
         {"slope_source", {"depths", "normals"}}}};
    std::vector<Case> cases;
    for (std::vector<GridKey> form : all) {
        std::vector<GridKey> axes{{"lookup", {"nearest", "bilinear"}},
                                  {"dither", {"none", "normal"}},
                                  unit};
        if (quick) axes[0].second = {"nearest"}, axes[1].second = {"none"};
        axes.insert(axes.end(), form.begin(), form.end());
        cases = joined(std::move(cases), grid(search, axes));
    }
    for (Case& c : cases) {
        c.name = "least bias beside its form, " + c.name;
        c.extra.emplace_back("find", "form");
    }
    return cases;
}

std::vector<Case> sweeps(std::vector<Case> cases) {
    for (Case& c : cases) c.extra.emplace_back("find", "rates");
    return cases;
}

// The values, separated by spaces, without the scene's own.
std::vector<std::string> other(const std::string& values, int own) {
    std::vector<std::string> kept;
    std::istringstream words(values);
    for (std::string word; words >> word;)
        if (word != std::to_string(own)) kept.push_back(word);
    return kept;
}

// --vary without the bias, which the search finds by itself.
Request without_bias(Request request) {
    std::erase_if(request.vary, [](const GridKey& axis) { return axis.first == "bias"; });
    return request;
}

std::vector<Case> BiasStudy::cases(const Request& request) const {
    constexpr std::array<std::string_view, 2> swept{"xy_bits", "z_bits"};
    if (request.automatic) return searches(grid(without_bias(request), {unit}));
    const Request sweep = for_sweep(request, swept, {}), search = without_bias(sweep);
    std::vector<GridKey> axes{{"sampling", {"centre", "leaf"}},
                           {"lookup", {"nearest", "bilinear"}},
                           {"dither", {"none", "uniform", "triangular", "normal4", "normal"}},
                           unit};
    std::vector<std::string> biases{"0",  "1",  "2",  "4",   "8",   "16",  "24",  "32",  "48",
                                    "64", "96", "128", "192", "256", "384", "512", "768", "1024"};
    if (request.quick) {
        axes[0].second = {"centre"};
        axes[2].second = {"none", "normal"};
        biases = {"0", "64", "256", "1024"};
    }
    std::vector<Case> all = joined({}, searches(grid(search, axes)));
    axes.push_back({"bias", biases});
    all = joined(std::move(all), sweeps(grid(sweep, axes)));

    // Other widths than the scene's own, which are above.
    const hw::MachineSpec& own = request.scene.settings.machine;
    const auto add_width = [&](std::string_view key, const char* values, int its_own) {
        Request only = without_bias(for_sweep(request, swept, std::array{key}));
        for (auto& [varied, asked] : only.vary)
            if (varied == key) std::erase(asked, std::to_string(its_own));
        std::erase_if(only.vary, [](const GridKey& axis) { return axis.second.empty(); });
        const std::vector<GridKey> axes_of_width{{"lookup", {"nearest", "bilinear"}},
                                              {"dither", {"none"}},
                                              unit,
                                              {std::string(key), other(values, its_own)}};
        all = joined(std::move(all), searches(grid(only, axes_of_width)));
    };
    add_width("xy_bits", request.quick ? "8" : "7 8 10", own.xy_bits);
    add_width("z_bits", request.quick ? "12" : "12 14 20", own.z_bits);
    all = joined(std::move(all), forms(search, request.quick));
    if (request.vary.empty()) all = joined(std::move(all), map_cases(request));
    return all;
}

// How far the error is from noise.
void set_flatness(Row& row, const SceneTruth& truth, const MachineMask& mask) {
    const auto flatness =
        median_local_flatness(error_image(truth.truth, mask), truth.truth.size,
                              lit_pixels(truth.truth, mask));
    row.set("flatness", flatness.windows > 0 ? Value(flatness.median) : Value());
}

Row BiasStudy::run(const Request&, const Case& c, const LoadedScene* drawn) const {
    const LoadedScene& scene = *drawn;
    const auto traced = truths_.needed(scene);
    const LightUnits units = light_units(scene);
    BiasedFrames frames(scene, *traced);
    const bool map = c.extra.at(0).second == "map";
    const bool search = c.extra.at(0).second != "rates";
    const double nan = std::nan("");
    const LeastBias min = search ? min_bias(frames) : LeastBias{nan, nan};
    // A search's rates are those at the least bias outside the band, or where it gave up.
    const double found =
        std::isnan(min.outside) ? max_bias_quanta(scene.settings.machine) : min.outside;
    const double bias = search && !map ? found : frames.bias_quanta();

    Row row;
    set_in_three_units(row, "bias", units, bias);
    const MachineMask mask = frames.draw(bias);
    set_rates(row, frames.errors(mask));
    set_in_three_units(row, "gap", units,
                       detachment_gap(*traced, mask) * units.quanta_per_world);
    set_in_three_units(row, "least", units, min.overall);
    set_in_three_units(row, "least_outside", units, min.outside);
    set_in_three_units(row, "bound", units, frames.bound({}));
    set_in_three_units(row, "bound_outside", units, frames.bound(traced->band));
    row.set("beyond_bound", std::int64_t{frames.beyond_bound(mask, bias)});
    if (map) set_flatness(row, traced->truth, mask);
    return row;
}

std::vector<ColumnMeaning> BiasStudy::columns() const {
    std::vector<ColumnMeaning> all(std::begin(rate_columns), std::end(rate_columns));
    for (const ColumnMeaning& own : std::initializer_list<ColumnMeaning>{
             {"find", "rates: both errors at one bias; least: a search for the least bias; form: "
                      "the same beside a bias that follows the surface; map: both for a depth map"},
             {"map", "of a row of kind map: the scene's own depth map, or a profile of today's"},
             {"range", "and how many times as deep the light's range is as the scene has it"},
             {"flatness", "and the median spectral flatness of 32 x 32 windows of the error: white "
                          "noise 0.56, a pattern towards 0; empty without 16 errors in a window"},
             {"bias_*", "the bias in quanta of the light's Z, light texels, world units; of a "
                        "search the one that its rates are of: the least outside the edge band"},
             {"gap_*", "the distance from its caster at which a shadow begins, in the same units"},
             {"least_outside_*", "the least bias with under 0.1 % false shadow outside the edge "
                                 "band; empty if an eighth of the depth range is not enough"},
             {"least_*", "the least bias with under 0.1 % false shadow over all pixels"},
             {"bound_outside_*", "the analytic bound that 99.9 % of the lit pixels outside the "
                                 "edge band keep"},
             {"bound_*", "the analytic bound that 99.9 % of all lit pixels keep"},
             {"beyond_bound", "pixels outside the edge band in false shadow although the bias is "
                              "at least their own bound"}})
        all.push_back(own);
    return all;
}

}  // namespace

std::unique_ptr<Study> make_bias_study() { return std::make_unique<BiasStudy>(); }

}  // namespace umbra78::tools::study
