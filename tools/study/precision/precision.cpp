// study precision: the worst error of every fixed-point unit, against its bound.
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
    std::optional<shadow::Settings> settings(const Request&, const Case&) const override {
        return std::nullopt;
    }

    std::vector<Case> cases(const Request&) const override {
        std::vector<Case> all;
        for (const PrecisionUnit& unit : precision_units())
            all.push_back({std::string(unit.name), {}, {{"name", std::string(unit.name)}}});
        return all;
    }

    Row run(const Request& request, const Case& c) const override {
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
        std::vector<std::vector<std::string>> table{
            {"unit", "way", "cases", "worst, LSB", "bound", "worst / bound", "worst input", "why"}};
        Plot plot{"errors", "Errors of the units", "error over its bound", "share of the cases",
                  false, true, {}};
        double worst = 0;
        for (const Row& r : rows) {
            table.push_back({r.text("unit"), r.text("way"), r.text("cases"), r.text("worst_lsb"),
                             r.text("bound_lsb"), r.text("over_bound"), r.text("worst_input"),
                             r.text("bound_source")});
            Series series{r.text("unit"), {}, true, {}};
            for (int bin = 0; bin < error_bins; ++bin) {
                const double share = r.number(bin_column(bin)) / r.number("cases");
                if (share > 0) series.points.emplace_back((bin + 0.5) / error_bins, share);
            }
            plot.series.push_back(std::move(series));
            worst = std::max(worst, r.number("over_bound"));
        }
        report.summary()["greatest_over_bound"] = worst;
        report.paragraph(fmt::format("The greatest error over its bound is {}. A tie reaches 1: "
                                     "it is half an LSB off whichever way it goes.", worst));
        report.table(table, "The worst that was found, as words.");
        report.plot(plot, "How the errors are spread from 0 to the bound. Climbing makes the "
                          "drawn ones heavier at the bound than a frame's are.");
    }
};

}  // namespace

std::unique_ptr<Study> make_precision_study() { return std::make_unique<Precision>(); }

}  // namespace umbra78::tools::study
