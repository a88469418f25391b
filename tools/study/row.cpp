#include "tools/study/row_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace umbra78::tools::study {
namespace {

// What a file can hold: JSON and CSV know neither NaN nor infinity.
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

const Value& Row::at(std::string_view column) const {
    for (const auto& [name, value] : cells_)
        if (name == column) return value;
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
    Row all;
    for (const Row& row : rows)
        for (const auto& [column, value] : row.cells()) all.set(column, std::monostate{});
    std::vector<Row> result;
    for (const Row& row : rows) {
        result.push_back(all);
        for (const auto& [column, value] : row.cells()) result.back().set(column, value);
    }
    return result;
}

}  // namespace umbra78::tools::study
