// A study's rows as text: a cell of a CSV, a line of JSON.
#pragma once

#include "tools/study/study.hpp"

#include <nlohmann/json_fwd.hpp>

namespace umbra78::tools::study {

// Shortest text that reads back as the same number; "" for no value.
std::string print(const Value&);

nlohmann::ordered_json to_json(const Row&);  // column: value, in the row's order
Row row_of(const nlohmann::ordered_json&);

// The rows with the same columns each: a case that failed has none of its figures.
std::vector<Row> aligned(std::span<const Row>);

}  // namespace umbra78::tools::study
