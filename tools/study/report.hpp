// What a study says of its rows: text, tables, plots and pictures, in the order of the page.
//
// A page leads with the answer, then shows the plot that proves it, then the rest under headings.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbra78::tools::study {

struct Series {
    std::string title;
    std::vector<std::pair<double, double>> points;
    bool line = true;                 // joined by a line; false: points only
    std::vector<std::string> labels;  // beside the points; empty for none
};

struct Plot {
    std::string name;                     // the file's name without its ending
    std::string title, x_label, y_label;  // labels with units
    bool log_x = false, log_y = false;
    std::vector<Series> series;
};

struct HeatMap {
    std::string name, title, x_label, y_label, value_label;
    std::vector<std::string> x_ticks, y_ticks;
    std::vector<double> values;  // row by row, y slowest; NaN is a hole
};

// The cells of a table, row by row; the first row is the head.
using TableCells = std::vector<std::vector<std::string>>;

class Report {
public:
    virtual ~Report() = default;

    // A paragraph of the answer to the study's question. Answers come before anything else.
    virtual void answer(std::string_view text) = 0;
    virtual void heading(std::string_view text) = 0;  // opens a section
    virtual void paragraph(std::string_view text) = 0;
    // A caption is one paragraph that says what is seen.
    virtual void plot(const Plot&, std::string_view caption) = 0;  // SVG and PNG, by gnuplot
    virtual void heat_map(const HeatMap&, std::string_view caption) = 0;
    // Gray, width * height values, row 0 at the top.
    virtual void picture(std::string_view name, int width, int height,
                         std::span<const std::uint8_t> gray, std::string_view caption) = 0;
    virtual void table(const TableCells&, std::string_view caption) = 0;
    virtual nlohmann::ordered_json& summary() = 0;  // the answers with all digits, for NAME.json
};

// A number as a page shows it: `digits` significant digits, but all digits of its whole part; an
// exponent below 10^-4; "inf", "-inf"; "" for NaN. The CSV and NAME.json keep the exact value.
std::string rounded(double value, int digits = 3);

// A rate 0 .. 1 in percent, with one decimal or two significant digits: "23.9 %", "0.053 %", "0 %";
// "" for NaN.
std::string percent(double rate);

}  // namespace umbra78::tools::study
