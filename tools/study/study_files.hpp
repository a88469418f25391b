// Runs a study and writes its files: NAME.csv, NAME.json, plots, pictures and index.html; for a
// shard only NAME.part-i-of-n.jsonl. All files appear together.
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

// `as_part`: write a shard's file, even if the shard is the only one. Throws std::runtime_error,
// for instance if the folder holds this study of other inputs and that is not to be replaced.
StudyDone run_study(const Asked&, const RunOptions&, const Path& folder, bool as_part);

// Makes the files of a study from the parts of a sharded run. Throws std::runtime_error if a part
// is missing, given twice, unfinished, or of other inputs.
StudyDone merge_parts(std::span<const std::string> parts, const Path& folder, Studies,
                      bool replace = false);

}  // namespace umbra78::tools::study
