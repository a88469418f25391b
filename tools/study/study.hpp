// A study: a question put to the machine as a table of cases, each drawn and measured.
//
//   scene + grid --cases()--> cases --run(), any order, any core, any computer--> rows
//     --CSV, one row a case--> plots, pictures, index.html
//
// A case is made of nothing but its settings, so a row of the CSV can be run again alone, and a
// study can be cut into shards, interrupted and resumed. Rows hold the same values on every
// computer, except host times and memory, whose columns end in "_host_ms" and "_host_mb" and can be
// left out.
//
// A new study is a folder tools/study/NAME/, its room in CMakeLists.txt, and its two lines in
// tools/cli/study_list.hpp and study_list.cpp.
#pragma once

#include "tools/study/report.hpp"
#include "tools/study/request.hpp"
#include "tools/study/row.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// What a column of the CSV means, with its unit. A name that begins or ends in '*' is of all
// columns that end or begin with the rest of it: "bias_*" is bias_quanta and bias_texels.
struct ColumnMeaning {
    std::string_view name, meaning;
};

class Study {
public:
    virtual ~Study() = default;
    virtual std::string_view name() const = 0;
    virtual std::string_view meaning() const = 0;  // one line for --help

    // What the user may ask for. `scene`: a scene file and --vary; false for a study whose cases
    // are its own. `automatic`: --auto.
    struct Takes {
        bool scene = true, automatic = false, only = false;
    };
    virtual Takes takes() const { return {}; }

    // In full or quick; as a rule a grid() of the keys that the study varies. Throws SceneError.
    virtual std::vector<Case> cases(const Request&) const = 0;

    // The scene that the case draws, parsed once: its settings go into the row, and run() gets it.
    // Nothing where the case draws no frame. Throws SceneError, whose text becomes the status.
    virtual std::optional<LoadedScene> scene(const Request&, const Case&) const;

    // The figures of a case. `scene` is what scene() returned, null for nothing. The framework
    // puts the case's name, its extra columns, every setting and "status" before the figures; the
    // status is "ok" or the text of what run() threw. Called from several threads at once.
    virtual Row run(const Request&, const Case&, const LoadedScene* scene) const = 0;

    // Writes the answers, plots, pictures and tables that follow from all rows.
    virtual void report(const Request&, std::span<const Row>, Report&) const = 0;

    // What the figures' columns mean. Settings and the framework's own columns are not among them.
    virtual std::vector<ColumnMeaning> columns() const = 0;
};

// The studies of a program (tools/cli/study_list.hpp), for those who find one by its name.
using Studies = std::span<const std::unique_ptr<Study>>;

}  // namespace umbra78::tools::study
