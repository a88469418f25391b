#include "tools/study/report_sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace umbra78::tools::study {
namespace {

// Passes everything on to the whole report, with the combination's words in titles and captions
// and its number in files' names.
class Section final : public Report {
public:
    Section(Report& whole, std::string words, int number)
        : whole_(whole), words_(std::move(words)), number_(number) {}

    void answer(std::string_view text) override {
        whole_.answer(fmt::format("With {}: {}", words_, text));
    }
    void heading(std::string_view text) override {
        whole_.heading(fmt::format("{} (with {})", text, words_));
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
    void table(const TableCells& cells, std::string_view caption) override {
        whole_.table(cells, fmt::format("With {}: {}", words_, caption));
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

void write_sections(const Request& request, std::span<const std::string_view> own,
                    std::span<const Row> rows, Report& report, const WriteSection& write) {
    std::vector<std::string> keys;
    for (const auto& [key, values] : request.vary)
        if (values.size() > 1 && std::find(own.begin(), own.end(), key) == own.end())
            keys.push_back(key);
    if (keys.empty()) return write(rows, report);

    std::vector<std::pair<std::string, std::vector<Row>>> sections;  // in the order of the rows
    std::map<std::string, std::size_t> place;
    for (const Row& row : rows) {
        std::string words;
        for (const std::string& key : keys)
            words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", key, row.text(key));
        const auto [found, is_new] = place.emplace(words, sections.size());
        if (is_new) sections.emplace_back(words, std::vector<Row>());
        sections[found->second].second.push_back(row);
    }
    int number = 0;
    for (const auto& [words, some] : sections) {
        Section section(report, words, ++number);
        write(some, section);
    }
}

}  // namespace umbra78::tools::study
