#include "tools/study/csv.hpp"

#include "tools/io/file_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

std::string cell_text(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + '"';
}

[[noreturn]] void fail(const Path& path, int line, std::string_view wrong) {
    throw std::runtime_error(fmt::format("{}:{}: {}; give a CSV that umbra78 study wrote",
                                         path.string(), line, wrong));
}

// The next record, which may hold line ends in its quotes. Counts lines.
std::optional<std::vector<std::string>> next_record(std::istream& in, const Path& path,
                                                    int& line) {
    if (in.peek() == std::istream::traits_type::eof()) return {};
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (char letter; in.get(letter);) {
        line += letter == '\n';
        if (quoted) {
            if (letter != '"') {
                cells.back() += letter;
            } else if (in.peek() == '"') {
                cells.back() += static_cast<char>(in.get());
            } else {
                quoted = false;
            }
        } else if (letter == '"') {
            quoted = true;
        } else if (letter == ',') {
            cells.emplace_back();
        } else if (letter == '\r' && in.peek() == '\n') {
            continue;  // of a line end; inside quotes it belongs to the cell
        } else if (letter == '\n') {
            return cells;
        } else {
            cells.back() += letter;
        }
    }
    fail(path, line, "the file ends in the middle of a row");
}

}  // namespace

std::string to_csv(std::span<const Row> rows) {
    std::string text;
    const auto add_line = [&](const Row& row, auto cell_of) {
        std::string_view comma = "";
        for (const auto& cell : row.cells()) {
            text += comma;
            text += cell_text(cell_of(cell));
            comma = ",";
        }
        text += '\n';
    };
    if (!rows.empty()) add_line(rows.front(), [](const auto& cell) { return cell.first; });
    for (const Row& row : rows) add_line(row, [](const auto& cell) { return print(cell.second); });
    return text;
}

std::optional<std::string> Csv::at(std::size_t row, std::string_view column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) return {};
    return rows.at(row)[static_cast<std::size_t>(found - columns.begin())];
}

Csv read_csv(const Path& path) {
    if (const std::string why = why_not_read(path); !why.empty())
        throw std::runtime_error(fmt::format("cannot read '{}': {}; give a CSV that umbra78 study "
                                             "wrote", path.string(), why));
    std::ifstream file(path, std::ios::binary);
    for (const char mark : {'\xEF', '\xBB', '\xBF'})  // UTF-8's, as spreadsheets write it
        if (file.peek() == static_cast<unsigned char>(mark)) file.get();
    Csv csv;
    int line = 1;
    if (auto head = next_record(file, path, line)) csv.columns = std::move(*head);
    for (int at = line; auto record = next_record(file, path, line); at = line) {
        if (record->size() != csv.columns.size())
            fail(path, at, fmt::format("{} cells under {} columns", record->size(),
                                       csv.columns.size()));
        csv.rows.push_back(std::move(*record));
    }
    return csv;
}

}  // namespace umbra78::tools::study
