// A study: a question put to the machine as a table of cases, run, measured, plotted and told.
//
//   scene + grid --cases()--> cases --run(), any order, any core, any machine--> rows
//     --CSV, one row a case--> plots, pictures, index.html
//
// A case is made of nothing but its settings, so a row of the CSV can be run again alone, and a
// study can be cut into shards, interrupted and resumed. Rows hold the same values on every
// computer, but for host times, whose columns end in "_host_ms" and can be left out.
#pragma once

#include "tools/scene/scene_file.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace umbra78::tools::study {

// A value of a row. Numbers print so that they read back as the same number; NaN is empty, and an
// infinity is the text "inf" or "-inf".
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

// Columns in the order they are added; every row of a study has the same.
class Row {
public:
    void set(std::string_view column, Value value);
    const Value& at(std::string_view column) const;  // throws where there is none
    double number(std::string_view column) const;    // of an integer or a real; NaN where empty
    std::string text(std::string_view column) const;
    std::span<const std::pair<std::string, Value>> cells() const { return cells_; }

private:
    std::vector<std::pair<std::string, Value>> cells_;
};

// One point of the grid: key=value overrides of the scene, in the order of the keys, and what
// else tells the case from others (a unit's name, a named extreme).
struct Case {
    std::string name;
    std::vector<std::string> set;                            // as --set takes them
    std::vector<std::pair<std::string, std::string>> extra;  // columns of the study's own
};

// What the user asked for.
struct Request {
    std::string scene_file;          // as it was written; "" for the paper's scene
    LoadedScene scene;               // with the settings of the file
    std::string scene_text;          // what cases are read from; "" for the paper's scene
    // --vary: in the order given; replaces the study's default values of that key.
    std::vector<std::pair<std::string, std::vector<std::string>>> vary;
    bool quick = false;              // a small grid for tests: seconds
    bool automatic = false;          // --auto: print the answer for the scene
    bool host_times = true;
};

// A picture or plot and the paragraph that says what is seen in it.
struct Exhibit {
    std::string file;     // in the study's folder: .svg and .png for plots, .png for pictures
    std::string caption;  // one paragraph
};

// Where a report writes: everything goes through a FileSet, all files or none.
class Report;

class Study {
public:
    virtual ~Study() = default;
    virtual std::string_view name() const = 0;
    virtual std::string_view meaning() const = 0;  // one line for --help
    // What may be asked of it: another scene or other settings, unless its cases are its own; the
    // answer alone.
    struct Takes {
        bool scene = true, automatic = false;
    };
    virtual Takes takes() const { return {}; }
    // Full or quick; a grid() of the keys the study varies by itself, as a rule.
    virtual std::vector<Case> cases(const Request&) const = 0;
    // What the case is drawn with; nothing where it is no frame.
    virtual std::optional<shadow::Settings> settings(const Request&, const Case&) const;
    // The figures of a case. The framework puts the case's name, its extra columns, every setting
    // and "status" before them: "ok", or what was thrown, which is part of the row. Called from
    // several threads at once.
    virtual Row run(const Request&, const Case&) const = 0;
    // Plots, pictures and paragraphs from all rows; and the answers, for the JSON summary.
    virtual void report(const Request&, std::span<const Row>, Report&) const = 0;
};

// The studies a program has (tools/cli/study_list.hpp), handed to who must find one by its name.
using Studies = std::span<const std::unique_ptr<Study>>;

// The grid of all combinations, the first key slowest; --vary's values in place of the defaults,
// and its other keys after them, crossed with all.
using GridKey = std::pair<std::string, std::vector<std::string>>;
std::vector<Case> grid(const Request&, std::vector<GridKey> defaults);
// The cases of the first grid, then those of `more` that are not among them.
std::vector<Case> joined(std::vector<Case> first, const std::vector<Case>& more);

// The request for a sweep of `keys`, of a study that sweeps `own`: a key of its own that is given
// several values has them in its own sweep, and is not crossed with the others.
Request for_sweep(Request, std::span<const std::string_view> own,
                  std::span<const std::string_view> keys);
// Calls tell(rows, report) for each combination of the keys of --vary that are not `own`: what is
// told, plotted and summed up of one combination is not mixed with another's, and says which.
using Tell = std::function<void(std::span<const Row>, Report&)>;
void for_combinations(const Request&, std::span<const std::string_view> own, std::span<const Row>,
                      Report&, const Tell& tell);

// The scene with a case's overrides. Throws SceneError.
LoadedScene scene_of(const Request&, const Case&);

// --- reports ---------------------------------------------------------------------------------

struct Series {
    std::string title;
    std::vector<std::pair<double, double>> points;
    bool line = true;      // else points
    std::vector<std::string> labels;  // beside the points, where there are any
};
struct Plot {
    std::string name;      // file name without its ending
    std::string title, x_label, y_label;  // labels with units
    bool log_x = false, log_y = false;
    std::vector<Series> series;
};
struct HeatMap {
    std::string name, title, x_label, y_label, value_label;
    std::vector<std::string> x_ticks, y_ticks;
    std::vector<double> values;  // row by row, y slowest; NaN is a hole
};

class Report {
public:
    virtual ~Report() = default;
    virtual void paragraph(std::string_view text) = 0;
    virtual void plot(const Plot&, std::string_view caption) = 0;      // SVG and PNG by gnuplot
    virtual void heat_map(const HeatMap&, std::string_view caption) = 0;
    // Gray, width * height values.
    virtual void picture(std::string_view name, int width, int height,
                         std::span<const std::uint8_t> gray, std::string_view caption) = 0;
    virtual void table(const std::vector<std::vector<std::string>>& rows,
                       std::string_view caption) = 0;  // the first row is the head
    virtual nlohmann::ordered_json& summary() = 0;     // answers, for NAME.json
};

}  // namespace umbra78::tools::study
