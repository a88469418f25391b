// A study's CSV: a line of column names, then a row a case (RFC 4180; lines end in a newline).
//
// Lines that end in a carriage return and a newline, as Python's csv writes them, are read, too,
// and so is a byte order mark before the first name.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/row.hpp"

#include <optional>

namespace umbra78::tools::study {

std::string to_csv(std::span<const Row>);  // of aligned() rows

// Cells as text. Every row has as many as there are columns.
struct Csv {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    // Nothing if there is no such column.
    std::optional<std::string> at(std::size_t row, std::string_view column) const;
};
Csv read_csv(const Path&);  // throws std::runtime_error, which names the line

}  // namespace umbra78::tools::study
