// The page of the study of rivals: how a method's cycles grow.
#include "tools/study/rivals/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbra78::tools::study {
namespace {

struct Growth {
    std::string_view question, over;
    double (*x)(const Row&);
};
constexpr Growth growths[] = {
    {question::dicing, "facets", [](const Row& row) { return row.number("facets"); }},
    {question::objects, "boxes", [](const Row& row) { return std::pow(at_of(row), 2); }},
    {question::resolution, "pixels", pixels_of},
    {question::lights, "lights", [](const Row& row) { return at_of(row); }},
};

PowerLaw law_of(std::span<const Row> all, const Growth& growth, std::string_view method) {
    Points points;
    for (const Row* row : rows_of(all, growth.question, method))
        points.emplace_back(growth.x(*row), row->number("shadow_cycles"));
    return power_law(points);
}

}  // namespace

void report_growth(std::span<const Row> all, Report& report) {
    TableCells table{{"method"}};
    std::string ranges;
    for (const Growth& growth : growths) {
        table[0].push_back(fmt::format("over {}", growth.over));
        const std::vector<std::string> methods = methods_in(all);
        const PowerLaw law = law_of(all, growth, methods.empty() ? "" : methods.back());
        if (law.from < law.to)
            ranges += fmt::format("{}{:.0f} to {:.0f} {}", ranges.empty() ? "" : ", ", law.from,
                                  law.to, growth.over);
    }
    for (const std::string& method : methods_in(all)) {
        table.push_back({method});
        for (const Growth& growth : growths) {
            const PowerLaw law = law_of(all, growth, method);
            table.back().push_back(rounded(law.exponent, 2));
            report.summary()["methods"][method][fmt::format("exponent_of_{}", growth.over)] =
                law.exponent;
        }
        const Row* row = finest(all, method);
        if (row != nullptr)
            report.summary()["methods"][method]["frame_cycles"] = row->number("shadow_cycles");
    }
    report.heading("How the cycles grow");
    report.table(table, fmt::format("Exponents of a power law, fitted by least squares to the "
                                    "logarithms of cycles of a frame's shadow over {}. Boxes "
                                    "become smaller as they become more, so that they cover the "
                                    "same pixels.", ranges));
    Plot plot{"rivals-objects", "Cycles of a frame's shadow over boxes on a floor", "boxes",
              "million cycles, map and test", true, true, {}};
    for (const std::string& method : methods_in(all)) {
        Points points;
        for (const Row* row : rows_of(all, question::objects, method))
            points.emplace_back(std::pow(at_of(*row), 2),
                                row->number("shadow_cycles") / 1e6);
        if (!points.empty()) plot.series.push_back({method, points, true, {}});
    }
    if (!plot.series.empty())
        report.plot(plot, "Boxes of twelve facets each on a floor, all casting shadows.");
}

}  // namespace umbra78::tools::study
