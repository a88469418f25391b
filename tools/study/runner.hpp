// Runs the cases of a study on all cores, and keeps each row as soon as it is there.
//
// Rows come in the order of work and are handed on in the order of the cases. SIGINT and SIGTERM
// let the cases at hand be finished; what is done stays in the log, and the next run goes on.
#pragma once

#include "tools/study/row_log.hpp"

namespace umbra78::tools::study {

struct RunOptions {
    int jobs = 0;  // 0: as many as there are cores
    Shard shard;
};

// The whole row of a case: what tells it from others, every setting, status, its figures.
Row run_case(const Asked&, std::size_t index, const Case&);

// The shard's rows, with those that `log` has already. Throws std::runtime_error if interrupted.
std::map<std::size_t, Row> run_cases(const Asked&, const RunOptions&, const Path& log);

}  // namespace umbra78::tools::study
