// umbra78 study widths: which width buys what?
//
// One width or rounding is varied at a time from the scene's values, which are 1978's in the
// paper's scene, and X/Y against Z on a grid. The bias is half a texel of the scene's own light
// map, as in figure 3, kept in world units: every machine then has the same gap, and a coarser map
// shows all of its error. Where X and Y vary the bias is also kept in texels, which grow with them.
#include "tools/study/grid.hpp"
#include "tools/study/measures.hpp"
#include "tools/study/report_sections.hpp"
#include "tools/study/widths/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using Values = std::vector<std::string>;

// The keys that are varied one at a time, each in a sweep of its own.
constexpr std::array<std::string_view, 9> swept_keys{
    "xy_bits",          "z_bits",           "coefficient_bits",   "accumulator_bits",
    "fraction_bits",    "coefficient_rounding", "product_rounding", "transform_rounding",
    "depth_rounding"};
// The keys that the report distinguishes.
constexpr std::array<std::string_view, 11> report_keys{
    "xy_bits",          "z_bits",           "coefficient_bits",   "accumulator_bits",
    "fraction_bits",    "coefficient_rounding", "product_rounding", "transform_rounding",
    "depth_rounding",   "lookup",           "bias_unit"};

class WidthsStudy : public Study {
public:
    std::string_view name() const override { return "widths"; }
    std::string_view meaning() const override {
        return "Which width buys what: X, Y, Z, matrix, accumulator, fraction; and each rounding";
    }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> all, Report& to) const override {
        write_sections(request, report_keys, all, to, [&](std::span<const Row> rows, Report& some) {
            report_widths(request, rows, some);
        });
    }

private:
    TruthCache truths_;
};

// Half a texel at the scene's own widths, as a decimal that the bias holds exactly.
std::string half_texel_in_world(const LoadedScene& scene) {
    const double world = 0.5 / light_units(scene).texels_per_world;
    return fmt::format("{:.16f}", std::ldexp(std::round(std::ldexp(world, 16)), -16));
}

const Values roundings{"floor",        "ceiling",   "to_zero",  "half_up",
                       "half_to_zero", "half_away", "half_even"};

std::vector<GridKey> widths(bool quick) {
    if (quick)
        return {{"z_bits", {"12", "16"}}, {"fraction_bits", {"2", "7"}},
                {"depth_rounding", {"floor", "half_up"}}};
    return {{"z_bits", {"8", "10", "11", "12", "13", "14", "15", "16", "18", "20"}},
            {"coefficient_bits", {"8", "10", "11", "12", "13", "14", "16", "20", "24"}},
            {"accumulator_bits", {"16", "17", "18", "19", "20", "21", "22", "23", "24", "26", "28",
                                  "35"}},
            {"fraction_bits", {"0", "1", "2", "3", "4", "5", "6", "7", "8", "10"}},
            {"coefficient_rounding", roundings},
            {"product_rounding", roundings},
            {"transform_rounding", roundings},
            {"depth_rounding", roundings}};
}

std::vector<Case> WidthsStudy::cases(const Request& request) const {
    const auto of = [&](std::string_view varies, std::vector<GridKey> axes) {
        if (varies == "product_rounding")  // an accumulator that cuts, or there is nothing to round
            axes.push_back({"accumulator_bits", {"22"}});
        for (const GridKey& shared : std::vector<GridKey>{
                 {"dither", {"none"}}, {"dequantize", {"0"}}, {"low_pass", {"0"}}})
            axes.push_back(shared);
        const auto keys = varies == "xy_bits and z_bits"
                              ? std::vector<std::string_view>{"xy_bits", "z_bits"}
                              : std::vector<std::string_view>{varies};
        std::vector<Case> cases = grid(for_sweep(request, swept_keys, keys), std::move(axes));
        for (Case& c : cases) c.extra.emplace_back("varies", varies);
        return cases;
    };
    const GridKey lookups{"lookup", {"nearest", "bilinear"}};
    const std::vector<GridKey> in_world{{"bias_unit", {"world"}},
                                     {"bias", {half_texel_in_world(request.scene)}}};
    const std::vector<GridKey> in_texels{{"bias_unit", {"texels"}}, {"bias", {"0.5"}}};
    const GridKey sizes{"xy_bits", request.quick ? Values{"7", "8"}
                                              : Values{"6", "7", "8", "9", "10", "11"}};
    const GridKey grid_sizes{"xy_bits", request.quick ? Values{"7", "8"}
                                                   : Values{"6", "7", "8", "9", "10"}};
    const GridKey depths{"z_bits", request.quick ? Values{"12", "16"}
                                              : Values{"8", "10", "12", "14", "16", "18", "20"}};

    std::vector<Case> all;
    for (const auto& bias : {in_world, in_texels})
        all = joined(std::move(all), of("xy_bits", {lookups, bias[0], bias[1], sizes}));
    std::vector<GridKey> one_by_one = widths(request.quick);
    for (const GridKey& asked : request.vary) {
        const auto is_it = [&](const auto& key) { return key == asked.first; };
        const auto swept = [&](const GridKey& axis) { return axis.first == asked.first; };
        if (asked.first != "xy_bits" && std::any_of(swept_keys.begin(), swept_keys.end(), is_it) &&
            std::none_of(one_by_one.begin(), one_by_one.end(), swept))
            one_by_one.push_back(asked);
    }
    for (const GridKey& width : one_by_one)
        all = joined(std::move(all), of(width.first, {lookups, in_world[0], in_world[1], width}));
    for (const auto& bias : {in_world, in_texels})
        all = joined(std::move(all), of("xy_bits and z_bits", {{"lookup", {"nearest"}}, bias[0],
                                                               bias[1], grid_sizes, depths}));
    return all;
}

Row WidthsStudy::run(const Request&, const Case&, const LoadedScene* drawn) const {
    const LoadedScene& scene = *drawn;
    const auto traced = truths_.needed(scene);
    RenderJob job(scene.view(), scene.settings);
    draw_mask(job);
    const auto visible = job.visible();
    const Buffer depths = job.buffer(Plane::observer_z);
    const ShadowReport errors =
        tools::report(traced->truth, {job.bytes(Plane::mask), visible}, traced->band, &depths);
    const shadow::FrameLedger ledger = job.ledger();
    const hw::MachineSpec& machine = scene.settings.machine;
    const auto whole = [](auto n) { return static_cast<std::int64_t>(n); };

    Row row;
    set_rates(row, errors);
    const std::int64_t bias_q16 = job.matrices().lights[0].bias_quanta_q16;
    set_in_three_units(row, "bias", light_units(scene),
                       std::ldexp(static_cast<double>(bias_q16), -16));
    row.set("word_bits", whole(machine.word_bits()));
    row.set("built_accumulator_bits", whole(machine.built_bits()));
    row.set("light_map_bytes",
            (std::int64_t{machine.z_bits} << (2 * machine.xy_bits)) / 8);
    row.set("drawing_cycles", whole(shadow::FrameLedger::cycles(ledger.light, true) +
                                    shadow::FrameLedger::cycles(ledger.observer, true)));
    row.set("transformation_cycles", whole(ledger.transformation(true)));
    row.set("frame_host_ms", job.times().total_ms());
    return row;
}

std::vector<ColumnMeaning> WidthsStudy::columns() const {
    std::vector<ColumnMeaning> all(std::begin(rate_columns), std::end(rate_columns));
    for (const ColumnMeaning& own : std::initializer_list<ColumnMeaning>{
             {"varies", "the key that the case's sweep varies"},
             {"bias_*", "the bias in quanta of the light's Z, light texels, world units"},
             {"word_bits", "width of a coordinate's word"},
             {"built_accumulator_bits", "width of the accumulator that the other widths give"},
             {"light_map_bytes", "memory of the light's Z, z_bits a texel"},
             {"drawing_cycles", "cycles of drawing both views, simulated"},
             {"transformation_cycles", "cycles of the post-process's transformation, simulated"},
             {"frame_host_ms", "this computer's time for the frame, ms"}})
        all.push_back(own);
    return all;
}

}  // namespace

std::unique_ptr<Study> make_widths_study() { return std::make_unique<WidthsStudy>(); }

}  // namespace umbra78::tools::study
