#include "tools/study/row.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

// What CSV and JSON can hold: neither NaN nor infinity.
Value storable(Value value) {
    const double* real = std::get_if<double>(&value);
    if (real == nullptr || std::isfinite(*real)) return value;
    if (std::isnan(*real)) return std::monostate{};
    return std::string(*real > 0 ? "inf" : "-inf");
}

}  // namespace

void Row::set(std::string_view column, Value value) {
    const auto is_it = [&](const auto& cell) { return cell.first == column; };
    const auto found = std::find_if(cells_.begin(), cells_.end(), is_it);
    if (found != cells_.end()) {
        found->second = storable(std::move(value));
    } else {
        cells_.emplace_back(column, storable(std::move(value)));
    }
}

const Value* Row::find(std::string_view column) const {
    for (const auto& [name, value] : cells_)
        if (name == column) return &value;
    return nullptr;
}

bool Row::has(std::string_view column) const { return find(column) != nullptr; }

const Value& Row::at(std::string_view column) const {
    if (const Value* value = find(column)) return *value;
    throw std::out_of_range(fmt::format("a study's row has no column '{}'", column));
}

double Row::number(std::string_view column) const {
    const Value& value = at(column);
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    const auto* word = std::get_if<std::string>(&value);
    const double infinite = std::numeric_limits<double>::infinity();
    if (word != nullptr && *word == "inf") return infinite;
    if (word != nullptr && *word == "-inf") return -infinite;
    return std::numeric_limits<double>::quiet_NaN();
}

std::string Row::text(std::string_view column) const { return print(at(column)); }

bool is_of_host(std::string_view column) {
    return column.ends_with("_host_ms") || column.ends_with("_host_mb");
}

std::string print(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
    if (const auto* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? *text : "";
}

nlohmann::ordered_json to_json(const Row& row) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const auto& [column, value] : row.cells()) {
        nlohmann::ordered_json& cell = json[column];  // null
        if (const auto* whole = std::get_if<std::int64_t>(&value)) cell = *whole;
        if (const auto* real = std::get_if<double>(&value)) cell = *real;
        if (const auto* text = std::get_if<std::string>(&value)) cell = *text;
    }
    return json;
}

Row row_of(const nlohmann::ordered_json& json) {
    Row row;
    for (const auto& [column, cell] : json.items()) {
        if (cell.is_number_integer()) {
            row.set(column, cell.get<std::int64_t>());
        } else if (cell.is_number()) {
            row.set(column, cell.get<double>());
        } else if (cell.is_string()) {
            row.set(column, cell.get<std::string>());
        } else {
            row.set(column, std::monostate{});
        }
    }
    return row;
}

std::vector<Row> aligned(std::span<const Row> rows) {
    // A column that no earlier row has had is inserted after the one that it follows in its row.
    std::vector<std::string> columns;
    for (const Row& row : rows) {
        std::ptrdiff_t next = 0;
        for (const auto& [column, value] : row.cells()) {
            auto found = std::find(columns.begin(), columns.end(), column);
            if (found == columns.end()) found = columns.insert(columns.begin() + next, column);
            next = found - columns.begin() + 1;
        }
    }
    std::vector<Row> result;
    for (const Row& row : rows) {
        Row& whole = result.emplace_back();
        for (const std::string& column : columns) whole.set(column, std::monostate{});
        for (const auto& [column, value] : row.cells()) whole.set(column, value);
    }
    return result;
}

}  // namespace umbra78::tools::study
