// Runs the cases of a study on all cores, and keeps each row as soon as it is measured.
//
// Cases finish in any order; their rows are returned in the order of the cases. SIGINT and SIGTERM
// let the cases that are running finish: their rows stay in the log, and the next run of the same
// command goes on from there.
#pragma once

#include "tools/study/row_log.hpp"

#include <map>

namespace umbra78::tools::study {

struct RunOptions {
    int jobs = 0;  // cases at a time; 0: as many as there are cores
    Shard shard;
    bool replace = false;  // the finished files of other inputs in the folder
};

// The whole row of a case: its number and name, its overrides, every setting, "status", figures.
// A case that throws has no figures, and the exception's text as its status.
Row run_case(const Asked&, std::size_t index, const Case&);

// The rows of the shard's cases, with those that `log` already has. Throws std::runtime_error if
// it is interrupted, if the log is of other inputs, or if it cannot be written.
std::map<std::size_t, Row> run_cases(const Asked&, const RunOptions&, const Path& log);

}  // namespace umbra78::tools::study
