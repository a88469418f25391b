// A report once for each combination of what the user varies and the study does not.
#include "tools/study/study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbra78::tools::study {
namespace {

// Everything it is told goes on, named after the combination.
class ReportOfCombination final : public Report {
public:
    ReportOfCombination(Report& whole, std::string words, int number)
        : whole_(whole), words_(std::move(words)), number_(number) {
        whole_.paragraph(fmt::format("With {}:", words_));
    }

    void paragraph(std::string_view text) override { whole_.paragraph(text); }
    void plot(const Plot& plot, std::string_view caption) override {
        Plot named = plot;
        named.name = file(plot.name);
        named.title += fmt::format(" ({})", words_);
        whole_.plot(named, caption);
    }
    void heat_map(const HeatMap& map, std::string_view caption) override {
        HeatMap named = map;
        named.name = file(map.name);
        named.title += fmt::format(" ({})", words_);
        whole_.heat_map(named, caption);
    }
    void picture(std::string_view name, int width, int height, std::span<const std::uint8_t> gray,
                 std::string_view caption) override {
        whole_.picture(file(name), width, height, gray,
                       fmt::format("With {}: {}", words_, caption));
    }
    void table(const std::vector<std::vector<std::string>>& rows,
               std::string_view caption) override {
        whole_.table(rows, fmt::format("With {}: {}", words_, caption));
    }
    nlohmann::ordered_json& summary() override {
        return whole_.summary()["combinations"][words_];
    }

private:
    std::string file(std::string_view name) const { return fmt::format("{}-{}", name, number_); }

    Report& whole_;
    std::string words_;
    int number_;
};

}  // namespace

void for_combinations(const Request& request, std::span<const std::string_view> own,
                      std::span<const Row> rows, Report& report, const Tell& tell) {
    std::vector<std::pair<std::string, std::vector<Row>>> groups;
    for (const Row& row : rows) {
        std::string words;
        for (const auto& [key, values] : request.vary)
            if (values.size() > 1 && std::find(own.begin(), own.end(), key) == own.end())
                words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", key, row.text(key));
        auto group = std::find_if(groups.begin(), groups.end(),
                                  [&](const auto& g) { return g.first == words; });
        if (group == groups.end()) group = groups.insert(groups.end(), {words, {}});
        group->second.push_back(row);
    }
    int number = 0;
    for (const auto& [words, some] : groups) {
        if (words.empty()) {
            tell(some, report);
            continue;
        }
        ReportOfCombination of_some(report, words, ++number);
        tell(some, of_some);
    }
}

}  // namespace umbra78::tools::study
