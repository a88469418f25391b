// umbra78 study precision: the maximum error of every fixed-point unit, against its bound.
#include "tools/study/precision/precision.hpp"
#include "tools/study/study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

std::string bin_column(int bin) {
    return bin == error_bins ? "above_bound" : fmt::format("bin_{}", bin);
}

std::string words_of(const PrecisionUnit& unit, const Input& in) {
    std::string text;
    for (int w = 0; w < unit.words; ++w)
        text += fmt::format("{}{}", w == 0 ? "" : " ", in[static_cast<std::size_t>(w)]);
    return text;
}

Row row_of(const PrecisionUnit& unit, const PrecisionResult& r, bool quick) {
    Row row;
    row.set("unit", std::string(unit.name));
    row.set("bound_source", std::string(unit.bound_source));
    const char* way = !unit.exhaustive ? "drawn, climbed" : quick ? "every 61st word" : "all words";
    row.set("way", std::string(way));
    row.set("cases", static_cast<std::int64_t>(r.cases));
    row.set("worst_lsb", r.worst);
    row.set("bound_lsb", unit.bound);
    row.set("over_bound", r.worst / unit.bound);
    row.set("mean_lsb", r.mean);
    row.set("worst_input", words_of(unit, r.at));
    for (int bin = 0; bin <= error_bins; ++bin)
        row.set(bin_column(bin),
                static_cast<std::int64_t>(r.histogram[static_cast<std::size_t>(bin)]));
    row.set("holds", std::string(r.worst <= unit.bound && r.cases > 0 ? "yes" : "no"));
    return row;
}

class Precision : public Study {
public:
    std::string_view name() const override { return "precision"; }
    std::string_view meaning() const override {
        return "The worst error of each fixed-point unit, against its bound";
    }
    Takes takes() const override { return {false, false}; }
    std::optional<LoadedScene> scene(const Request&, const Case&) const override {
        return std::nullopt;  // a case is a unit, not a frame
    }

    std::vector<Case> cases(const Request&) const override {
        std::vector<Case> all;
        for (const PrecisionUnit& unit : precision_units())
            all.push_back({std::string(unit.name), {}, {{"name", std::string(unit.name)}}});
        return all;
    }

    Row run(const Request& request, const Case& c, const LoadedScene*) const override {
        const auto start = std::chrono::steady_clock::now();
        for (const PrecisionUnit& unit : precision_units()) {
            if (unit.name != c.name) continue;
            Row row = row_of(unit, measure(unit, request.quick), request.quick);
            const std::chrono::duration<double, std::milli> spent =
                std::chrono::steady_clock::now() - start;
            if (request.host_times) row.set("case_host_ms", spent.count());
            return row;
        }
        throw std::invalid_argument(fmt::format("study precision has no unit '{}'", c.name));
    }

    void report(const Request&, std::span<const Row> rows, Report& report) const override {
        TableCells table{{"unit", "inputs", "cases", "maximum error, LSB", "bound, LSB",
                          "error over bound", "input of the maximum", "why this bound"}};
        Plot plot{"errors", "Errors of the units", "error over its bound", "share of the cases",
                  false, true, {}};
        double worst = 0;
        std::string beyond;
        for (const Row& r : rows) {
            table.push_back({r.text("unit"), r.text("way"), r.text("cases"),
                             rounded(r.number("worst_lsb")), rounded(r.number("bound_lsb")),
                             rounded(r.number("over_bound")), r.text("worst_input"),
                             r.text("bound_source")});
            Series series{r.text("unit"), {}, true, {}};
            for (int bin = 0; bin < error_bins; ++bin) {
                const double share = r.number(bin_column(bin)) / r.number("cases");
                if (share > 0) series.points.emplace_back((bin + 0.5) / error_bins, share);
            }
            plot.series.push_back(std::move(series));
            worst = std::max(worst, r.number("over_bound"));
            if (r.text("holds") != "yes")
                beyond += fmt::format("{}{}", beyond.empty() ? "" : ", ", r.text("unit"));
        }
        report.summary()["greatest_over_bound"] = worst;
        report.answer(
            beyond.empty()
                ? fmt::format("All {} units are as exact as they promise: no error that was found "
                              "exceeds its bound. The greatest is {:.3f} times its bound. At 1 "
                              "it is a tie, half an LSB off whichever way it is rounded.",
                              rows.size(), worst)
                : fmt::format("NOT within their bounds: {}. The greatest error is {} times its "
                              "bound.", beyond, rounded(worst)));
        report.plot(plot, "The distribution of the errors from 0 to the bound. Where inputs are "
                          "searched and not all tried, the search makes errors near the bound more "
                          "frequent than they are in a frame.");
        report.heading("Every unit");
        report.table(table, "'All words' means that every input was tried; 'drawn, climbed' means "
                            "random inputs, each changed a bit or a unit at a time as long as the "
                            "error grows. The input of the maximum is given as words.");
    }

    std::vector<ColumnMeaning> columns() const override {
        return {
            {"unit", "the unit; the name of the case"},
            {"bound_source", "why the bound is what it is"},
            {"way", "all words; or drawn, climbed: random inputs, and a climb from each to greater "
                    "errors; --quick tries fewer"},
            {"cases", "how many inputs were tried"},
            {"worst_lsb", "the maximum error that was found, in LSB of the unit's result"},
            {"bound_lsb", "the bound that it must not exceed, LSB"},
            {"over_bound", "worst_lsb over bound_lsb"},
            {"mean_lsb", "the mean error of all inputs tried, LSB"},
            {"worst_input", "the input words of the maximum error"},
            {"bin_*", "how many errors are in this sixteenth of the range from 0 to the bound"},
            {"above_bound", "how many errors are above the bound"},
            {"holds", "yes if no error is above the bound"},
            {"case_host_ms", "this computer's time for the case, ms"},
        };
    }
};

}  // namespace

std::unique_ptr<Study> make_precision_study() { return std::make_unique<Precision>(); }

}  // namespace umbra78::tools::study
