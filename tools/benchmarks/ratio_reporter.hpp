// The table of a benchmark's run: medians as ratios to one row of it.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace umbra78::tools {

// Collects the medians and prints them beside their ratio to the baseline; as CSV, where asked.
class RatioReporter : public benchmark::BenchmarkReporter {
public:
    // `names` in the order of the table.
    RatioReporter(const std::vector<std::string>& names, std::string baseline, std::string csv)
        : names_(names), baseline_(std::move(baseline)), csv_(std::move(csv)) {}

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median") continue;
            const auto cycles = run.counters.find("cycles");
            rows_.push_back({run.run_name.function_name, run.GetAdjustedCPUTime(),
                             cycles == run.counters.end() ? 0.0 : cycles->second.value});
        }
    }
    void Finalize() override {
        const auto place = [&](const Row& r) {
            return std::find(names_.begin(), names_.end(), r.name);
        };
        std::sort(rows_.begin(), rows_.end(),
                  [&](const Row& a, const Row& b) { return place(a) < place(b); });
        const auto base = std::find_if(rows_.begin(), rows_.end(),
                                       [&](const Row& r) { return r.name == baseline_; });
        fmt::print("{:<44} {:>10} {:>8}\n", "stage", "median ms", "ratio");
        std::string csv = "stage,median_ms,ratio,cycles_a_second\n";
        for (const Row& r : rows_) {
            const std::string ratio =
                base == rows_.end() ? "" : fmt::format("{:.2f}", r.ms / base->ms);
            const std::string speed =
                r.cycles == 0 ? "" : fmt::format("  {:.1f} million cycles/s", r.cycles * 1e-6);
            fmt::print("{:<44} {:>10.3f} {:>8}{}\n", r.name, r.ms, ratio, speed);
            csv += fmt::format("\"{}\",{:.4f},{},{:.0f}\n", r.name, r.ms, ratio, r.cycles);
        }
        fmt::print("ratio: to the affine float baseline, medians of one interleaved run\n");
        if (!csv_.empty()) std::ofstream(csv_) << csv;
    }

private:
    struct Row {
        std::string name;
        double ms, cycles;
    };
    const std::vector<std::string>& names_;
    std::string baseline_, csv_;
    std::vector<Row> rows_;
};

}  // namespace umbra78::tools
