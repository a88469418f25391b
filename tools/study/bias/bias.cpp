// umbra78 study bias: which bias, and in which unit?
//
// Two kinds of case. A sweep is one bias, and both rates of error at it. A search bisects whole
// quanta for the least bias with under 0.1 % false shadow, overall and outside the edge band (one
// light texel mapped back to the observer): false shadow never rises with the bias, since every
// pixel's depth only falls. Searches at other widths say in which unit that bias stands still.
#include "tools/study/bias/report.hpp"
#include "tools/study/bias/search.hpp"

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
    Row run(const Request&, const Case&) const override;
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

std::vector<Case> sweeps(std::vector<Case> cases) {
    for (Case& c : cases) c.extra.emplace_back("find", "rates");
    return cases;
}

// The values without the scene's own.
std::vector<std::string> other(const std::string& values, int own) {
    std::vector<std::string> kept;
    std::istringstream words(values);
    for (std::string word; words >> word;)
        if (word != std::to_string(own)) kept.push_back(word);
    return kept;
}

// --vary without a key that the search finds by itself.
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

    // Beside the scene's own widths, which are above.
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
    return all;
}

Row BiasStudy::run(const Request& request, const Case& c) const {
    const LoadedScene scene = scene_of(request, c);
    const auto traced = truths_.needed(scene);
    const LightUnits units = light_units(scene);
    BiasedFrames frames(scene, *traced);
    const bool search = c.extra.at(0).second == "least";
    const double nan = std::nan("");
    const LeastBias min = search ? min_bias(frames) : LeastBias{nan, nan};
    // A search's rates are those at the least bias outside the band, or where it gave up.
    const double found =
        std::isnan(min.outside) ? max_bias_quanta(scene.settings.machine) : min.outside;
    const double bias = search ? found : frames.bias_quanta();

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
    return row;
}

}  // namespace

std::unique_ptr<Study> make_bias_study() { return std::make_unique<BiasStudy>(); }

}  // namespace umbra78::tools::study
