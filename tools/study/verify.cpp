#include "tools/study/verify.hpp"

#include "tools/io/file_errors.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/study/csv.hpp"
#include "tools/study/runner.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

using nlohmann::ordered_json;

ordered_json read_summary(const Path& path) {
    if (const std::string why = why_not_read(path); !why.empty())
        throw std::runtime_error(fmt::format("cannot read '{}', which holds the scene: {}; keep it "
                                             "beside the CSV", path.string(), why));
    std::ifstream file(path, std::ios::binary);
    try {
        ordered_json json = parse_json(std::string(std::istreambuf_iterator<char>(file), {}));
        json.at("case_columns").at("extra");
        json.at("inputs");
        return json;
    } catch (const nlohmann::json::exception&) {
        throw std::runtime_error(fmt::format("{}: it is not a summary of a study; keep the one "
                                             "that umbra78 study wrote", path.string()));
    }
}

// The case that the row's own cells describe.
Case case_of(const Csv& csv, std::size_t row, const ordered_json& columns) {
    Case c;
    c.name = csv.at(row, "name").value_or("");
    for (const std::string key : columns.at("varied"))
        if (const auto value = csv.at(row, key); value && !value->empty())
            c.set.push_back(key + "=" + *value);
    for (const std::string key : columns.at("extra"))
        if (const auto value = csv.at(row, key); value && !value->empty())
            c.extra.emplace_back(key, *value);
    return c;
}

// All columns except host times, hashes first: if they agree, the rest is arithmetic on the same
// pixels.
std::vector<std::string> compared_columns(const Csv& csv) {
    std::vector<std::string> columns;
    for (const std::string& column : csv.columns)
        if (!is_of_host(column)) columns.push_back(column);
    std::stable_partition(columns.begin(), columns.end(), [](const std::string& column) {
        return column.find("hash") != std::string::npos;
    });
    return columns;
}

std::string cell(const Row& row, const std::string& column) {
    for (const auto& [name, value] : row.cells())
        if (name == column) return print(value);
    return "";
}

}  // namespace

Verified verify(const Path& path, std::size_t sample, Studies known) {
    const Csv csv = read_csv(path);
    const Path beside = Path(path).replace_extension(".json");
    const ordered_json summary = read_summary(beside);
    const Asked asked = ask_again(summary["inputs"], beside.string(), known);

    std::vector<std::size_t> rows(csv.rows.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    std::mt19937_64 engine(1978);
    for (std::size_t k = 0; k + 1 < rows.size(); ++k)
        std::swap(rows[k], rows[k + engine() % (rows.size() - k)]);
    rows.resize(std::min(sample, rows.size()));
    std::sort(rows.begin(), rows.end());

    Verified result{csv.rows.size(), rows.size(), {}};
    if (csv.rows.size() != asked.cases.size())
        result.differences.push_back(fmt::format("{}: {} rows, but the study has {} cases",
                                                 path.string(), csv.rows.size(),
                                                 asked.cases.size()));
    const std::vector<std::string> columns = compared_columns(csv);
    for (const std::size_t k : rows) {
        const Row again = run_case(asked, k, case_of(csv, k, summary["case_columns"]));
        for (const std::string& column : columns)
            if (const std::string there = *csv.at(k, column), here = cell(again, column);
                there != here)
                result.differences.push_back(fmt::format("{}: case {}: {} is {} in the file, {} "
                                                         "here", path.string(), k, column,
                                                         there.empty() ? "empty" : there,
                                                         here.empty() ? "empty" : here));
    }
    return result;
}

}  // namespace umbra78::tools::study
