// The page of the study of rivals: what the first class owes to its sectors, to which edges it
// projects, and to stopping when all is dark.
#include "tools/study/rivals/tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

std::string million(const Row& row, const char* column) {
    return rounded(row.number(column) / 1e6);
}

void report_sectors(const Rows& rows, Report& report) {
    TableCells table{{"sectors", "boxes compared, million", "links", "a frame, million cycles"}};
    const Row *best = nullptr, *most = nullptr;
    for (const Row* row : rows) {
        table.push_back({rounded(std::pow(at_of(*row), 2), 9), million(*row, "link_tests"),
                         rounded(row->number("links"), 9), million(*row, "shadow_cycles")});
        if (best == nullptr || row->number("shadow_cycles") < best->number("shadow_cycles"))
            best = row;
        if (most == nullptr || at_of(*row) < at_of(*most)) most = row;
    }
    if (best == nullptr) return;
    report.table(table, fmt::format("The light's picture cut into sectors, {:.0f} facets. The "
                                    "links are the same; {:.0f} sectors are best here, and more "
                                    "of them hold each facet several times.",
                                    best->number("facets"), std::pow(at_of(*best), 2)));
    report.summary()["best_sectors"] = std::pow(at_of(*best), 2);
    report.summary()["cycles_without_sectors_over_best"] =
        most->number("shadow_cycles") / best->number("shadow_cycles");
}

void report_edges(std::span<const Row> all, Report& report) {
    TableCells table{{"projected", "facets", "edges projected", "a frame, million cycles"}};
    std::string laws;
    for (const char* method : {"every edge", "contours alone"}) {
        const Rows rows = rows_of(all, question::edges, method);
        for (const Row* row : rows)
            table.push_back({method, rounded(row->number("facets"), 9),
                             rounded(row->number("edges_projected"), 9),
                             million(*row, "shadow_cycles")});
        const PowerLaw law = power_law(points_of(rows, "facets", "edges_projected"));
        laws += fmt::format("{}{} to the power {}", laws.empty() ? "" : ", ", method,
                            rounded(law.exponent, 2));
        report.summary()["edges_exponent"][method] = law.exponent;
    }
    if (table.size() > 1)
        report.table(table, fmt::format("Which edges the second scan projects. They grow with "
                                        "facets: {}.", laws));
}

void report_layers(std::span<const Row> all, Report& report) {
    TableCells table{{"sheets", "stopped when dark, million cycles", "not stopped"}};
    const Rows stopped = rows_of(all, question::layers, "stopped when dark"),
               full = rows_of(all, question::layers, "not stopped");
    for (std::size_t k = 0; k < std::min(stopped.size(), full.size()); ++k)
        table.push_back({stopped[k]->text("at"), million(*stopped[k], "shadow_cycles"),
                         million(*full[k], "shadow_cycles")});
    if (table.size() > 1)
        report.table(table, "Sheets between the light and a floor: a run that is wholly dark need "
                            "not ask the other sheets.");
}

}  // namespace

void report_scan_out(std::span<const Row> all, Report& report) {
    report.heading("Into the first class");
    report_sectors(rows_of(all, question::sectors), report);
    report_edges(all, report);
    report_layers(all, report);
}

}  // namespace umbra78::tools::study
