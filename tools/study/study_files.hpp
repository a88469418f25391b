// A study run, and what it leaves: NAME.csv, NAME.json, plots, pictures, index.html; or, of a
// shard, NAME.part-i-of-n.jsonl alone. All files appear together.
#pragma once

#include "tools/study/runner.hpp"

#include <nlohmann/json.hpp>

namespace umbra78::tools::study {

struct StudyDone {
    nlohmann::ordered_json summary;       // NAME.json
    std::vector<std::string> paragraphs;
    std::vector<std::string> files;
    std::size_t rows = 0, failed = 0;
    std::string first_failure;
    bool plots_missing = false;           // there is no gnuplot
};

// `as_part`: of a shard, even if it is the only one. Throws std::runtime_error.
StudyDone run_study(const Asked&, const RunOptions&, const Path& folder, bool as_part);

// The parts of a sharded run, which become the files of a whole one. Throws std::runtime_error if
// one is missing, twice there, unfinished, or of other inputs.
StudyDone merge_parts(std::span<const std::string> parts, const Path& folder, Studies);

}  // namespace umbra78::tools::study
