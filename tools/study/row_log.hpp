// The rows of an unfinished study or of a shard: JSON lines, a head and then a row a line, in the
// order in which the cases finished.
//
//   {"study":"error-time","inputs_hash":"fnv1a64:...","cases":84,"shard":[1,3],"inputs":{...}}
//   {"case":17,"row":{"case":17,"name":"lookup=nearest ...",...}}
//
// A row is one write of one line, so a run that is killed loses at most the line it was writing; a
// torn last line is left out when the file is read.
#pragma once

#include "tools/io/files.hpp"
#include "tools/study/inputs.hpp"

#include <map>

namespace umbra78::tools::study {

// Every n-th case, beginning with the i-th: 1 <= i <= n. 1/1 is all cases.
struct Shard {
    int i = 1, n = 1;
    bool holds(std::size_t index) const {
        return index % static_cast<std::size_t>(n) == static_cast<std::size_t>(i - 1);
    }
    bool operator==(const Shard&) const = default;
};

struct RowLog {
    std::string hash;
    std::size_t cases = 0;
    Shard shard;
    nlohmann::ordered_json inputs;
    std::string inputs_text;  // the end of the head, which holds the inputs
    std::map<std::size_t, Row> rows;
};

std::string head_line(const Asked&, Shard);
std::string row_line(std::size_t index, const Row&);
// Throws std::runtime_error. `known` is the first part of the same run, if there is one: inputs of
// the same text are not parsed again (`inputs` stays empty), because a study may have thousands of
// values and thousands of parts.
RowLog read_row_log(const Path&, const RowLog* known = nullptr);

// Appends rows to a log, and begins the log if there is none. A last line that a kill has torn is
// removed. No other program may append to the log meanwhile. Throws std::runtime_error.
class RowAppender {
public:
    RowAppender(const Path&, const Asked&, Shard);
    ~RowAppender();
    RowAppender(const RowAppender&) = delete;
    RowAppender& operator=(const RowAppender&) = delete;
    void append(std::size_t index, const Row&);

private:
    void write(const std::string& line);
    bool is_still_there() const;
    Path path_;
    int file_ = -1;
};

}  // namespace umbra78::tools::study
