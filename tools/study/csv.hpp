// A study's CSV (RFC 4180, but lines end in a newline alone): a head, then one row a case.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/study.hpp"

namespace umbra78::tools::study {

std::string to_csv(std::span<const Row>);  // of aligned rows

// Cells as text; all rows have as many as the head.
struct Csv {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    // The row's cell; nothing where there is no such column.
    std::optional<std::string> at(std::size_t row, std::string_view column) const;
};
Csv read_csv(const Path&);  // throws std::runtime_error with the line

}  // namespace umbra78::tools::study
