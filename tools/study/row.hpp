// A row of a study: its columns by name, and how they are written as text and as JSON.
//
// A value is nothing, a whole number, a real number or a text. A number is printed so that it
// reads back as the same number. CSV and JSON hold neither NaN nor infinity: NaN is stored as
// nothing, and an infinity as the text "inf" or "-inf".
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace umbra78::tools::study {

using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

std::string print(const Value&);  // "" for no value

// Whether a column holds what this computer took, which differs from run to run: a time
// ("_host_ms") or its memory ("_host_mb").
bool is_of_host(std::string_view column);

// Columns in the order in which they were first set.
class Row {
public:
    void set(std::string_view column, Value value);  // replaces the value of an earlier set
    bool has(std::string_view column) const;
    const Value& at(std::string_view column) const;  // throws std::out_of_range if it is missing
    // Of a whole or real number, "inf" or "-inf"; NaN of any other text and of no value.
    double number(std::string_view column) const;
    std::string text(std::string_view column) const;
    std::span<const std::pair<std::string, Value>> cells() const { return cells_; }

private:
    const Value* find(std::string_view column) const;
    std::vector<std::pair<std::string, Value>> cells_;
};

nlohmann::ordered_json to_json(const Row&);  // column: value, in the row's order
Row row_of(const nlohmann::ordered_json&);   // the inverse

// The rows, all with the same columns: a case that failed has none of its figures, and gets empty
// cells there.
std::vector<Row> aligned(std::span<const Row>);

}  // namespace umbra78::tools::study
