// umbra78 study growth: how time and memory grow with the number of primitives and with their area.
//
// The landscape of tools/stream/hills.hpp is streamed: once cut into ever more patches, its area
// the same, and once laid out in ever more layers of the same number of patches in all.
#include "tools/study/growth/growth.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace umbra78::tools::study {
namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr std::uint64_t layered_patches = 4096;

Case case_of(const char* sweep, std::uint64_t patches, std::uint64_t layers) {
    return {fmt::format("{} patches, {} layers", patches, layers),
            {},
            {{"sweep", sweep},
             {"asked_patches", std::to_string(patches)},
             {"asked_layers", std::to_string(layers)}}};
}

std::uint64_t asked(const Case& c, std::string_view key) {
    std::uint64_t value = 0;
    for (const auto& [name, text] : c.extra)
        if (name == key) std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// A cost of a frame: its column, how it is called, its unit, what it is over in that unit.
struct Cost {
    const char *column, *words, *unit;
    double scale;
};
constexpr Cost costs[] = {
    {"frame_cycles", "the machine's cycles", "thousand cycles", 1e-3},
    {"frame_host_ms", "this computer's time", "microseconds", 1e3},
};

struct Sweep {
    const char *name, *title, *column, *x_label, *of_x, *meaning;
    double per;  // of the column: the slope is told for so many
};
constexpr Sweep sweeps[] = {
    {"number", "Growth with the number of patches, at equal area", "patches", "patches", "a patch",
     "The same hills, cut into ever more patches.", 1},
    {"area", "Growth with the area drawn, at an equal number of patches", "area_px",
     "pixels drawn in both views", "a thousand pixels",
     "4096 patches, laid out in 1 to 16 layers of hills.", 1000},
};

Points points_of(std::span<const Row> rows, const Sweep& sweep, const char* column) {
    Points points;
    for (const Row& row : rows)
        if (row.text("sweep") == sweep.name && row.text("status") == "ok" && row.has(column) &&
            std::isfinite(row.number(column)))
            points.emplace_back(row.number(sweep.column), row.number(column));
    return points;
}

class Growth final : public Study {
public:
    std::string_view name() const override { return "growth"; }
    std::string_view meaning() const override {
        return "Time and memory over the number and the area of primitives that are never held";
    }
    Takes takes() const override { return {false, false}; }
    std::optional<LoadedScene> scene(const Request&, const Case&) const override {
        return std::nullopt;  // a case makes its own
    }
    std::vector<Case> cases(const Request&) const override;
    Row run(const Request& request, const Case& c, const LoadedScene*) const override {
        return growth_row({.patches = asked(c, "asked_patches"),
                           .layers = asked(c, "asked_layers"),
                           .gap = 1 << raster::world_fraction},
                          request.host_times);
    }
    void report(const Request&, std::span<const Row>, Report&) const override;
    std::vector<ColumnMeaning> columns() const override;
};

std::vector<Case> Growth::cases(const Request& request) const {
    std::vector<Case> all;
    const int decades = request.quick ? 4 : 7;
    for (int decade = 2; decade <= decades; ++decade) {
        const auto ten = static_cast<std::uint64_t>(std::lround(std::pow(10, decade)));
        all.push_back(case_of("number", ten, 1));
        if (decade < decades) all.push_back(case_of("number", 3 * ten, 1));
    }
    for (const std::uint64_t layers : {1, 2, 4, 8, 16})
        all.push_back(case_of("area", layered_patches, layers));
    return all;
}

void plot(const Sweep& sweep, std::span<const Row> rows, Report& report) {
    Plot plot{fmt::format("growth-{}", sweep.name), sweep.title, sweep.x_label,
              "machine: seconds; this computer: milliseconds", true, true, {}};
    const std::pair<const char*, double> shown[] = {{"frame_cycles", 200e-9},
                                                    {"frame_host_ms", 1}};
    for (const auto& [column, scale] : shown) {
        Series series{column[6] == 'c' ? "machine, s" : "this computer, ms", {}, true, {}};
        for (const auto& [x, y] : points_of(rows, sweep, column))
            series.points.emplace_back(x, y * scale);
        plot.series.push_back(std::move(series));
    }
    report.plot(plot, sweep.meaning);
}

void plot_memory(std::span<const Row> rows, Report& report) {
    Plot plot{"memory", "Memory over the number of patches", "patches",
              "most memory of the program, MB", true, false, {}};
    Series series{"peak", points_of(rows, sweeps[0], "peak_host_mb"), true, {}};
    if (series.points.empty()) {
        report.paragraph("This computer does not tell the most memory of a program, so there is "
                         "no figure of it here.");
        return;
    }
    plot.series.push_back(std::move(series));
    report.plot(plot, "The program's peak while the frame is drawn, the program itself included.");
}

std::string memory_answer(std::span<const Row> rows) {
    const Points peaks = points_of(rows, sweeps[0], "peak_host_mb");
    if (peaks.empty()) return "";
    return fmt::format(" The program's memory is {:.1f} MB with {:.0f} patches and {:.1f} MB with "
                       "{:.0f}.", peaks.front().second, peaks.front().first, peaks.back().second,
                       peaks.back().first);
}

void Growth::report(const Request&, std::span<const Row> rows, Report& report) const {
    TableCells table{{"cost", "over", "slope", "fixed part", "greatest deviation"}};
    std::string answer = "Time grows as a line.";
    for (const Sweep& sweep : sweeps)
        for (const Cost& cost : costs) {
            const Points points = points_of(rows, sweep, cost.column);
            if (points.size() < 3) continue;
            const Line line = line_through(points);
            const bool machine = &cost == costs;
            const std::string slope = fmt::format(
                "{} {} {}", rounded(line.slope * cost.scale * sweep.per), cost.unit, sweep.of_x);
            table.push_back({cost.words, sweep.x_label, slope,
                             fmt::format("{} {}", rounded(line.fixed * (machine ? 1e-6 : 1)),
                                         machine ? "million cycles" : "ms"),
                             percent(line.worst)});
            report.summary()[sweep.name][cost.column] = {
                {"slope", line.slope}, {"fixed", line.fixed}, {"greatest_deviation", line.worst}};
            if (machine)
                answer += fmt::format(" The machine takes {}, and no frame's cycles are farther "
                                      "than {} from the line of the {}.", slope,
                                      percent(line.worst), sweep.name);
        }
    report.answer(answer + memory_answer(rows));
    for (const Sweep& sweep : sweeps) plot(sweep, rows, report);
    plot_memory(rows, report);
    report.heading("The lines");
    report.table(table, "Each line has the least sum of squares of deviations as shares, so that "
                        "small scenes count as much as large ones.");
}

std::vector<ColumnMeaning> Growth::columns() const {
    return {
        {"sweep", "number: ever more patches of the same hills; area: ever more layers"},
        {"asked_*", "what distinguishes the case: its patches in all, and its layers"},
        {"patches", "patches of the landscape"},
        {"layers", "landscapes below each other, which share the patches"},
        {"area_px", "pixels drawn in both views, with their overdraw"},
        {"picture_hash", "FNV-1a-64 of the picture"},
        {"*_cycles", "cycles of the machine, simulated: a view's, the transformation's, the "
                     "frame's, its units side by side"},
        {"frame_bytes", "memory of the frame's planes on this computer, bytes"},
        {"frame_host_ms", "this computer's time for the frame, the making of the patches included; "
                          "below 20 000 patches the least of five"},
        {"peak_host_mb", "the program's most memory while it drew the frame, MB of 2^20 bytes"},
    };
}

}  // namespace

std::unique_ptr<Study> make_growth_study() { return std::make_unique<Growth>(); }

}  // namespace umbra78::tools::study
