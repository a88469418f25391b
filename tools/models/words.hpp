// The text of a model's file as words with their lines, and the numbers that they are.
//
// What is wrong is reported to a FirstError, in a line that begins "FILE:LINE: "; the value is then
// a harmless one, and the reader is at its end.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/model.hpp"

#include <string>
#include <string_view>

namespace umbra78::tools {

struct ModelWord {
    std::string_view text;
    int line = 0;
};

// Reports "NAME:LINE: what".
void report_at(FirstError&, const std::string& name, int line, const std::string& what);

// The word in quotes, cut and without unprintable characters: a file may hold anything.
std::string shown(std::string_view word);

// Words: what stands between blanks, ends of lines, commas where `commas`, and comments, which go
// from # to the end of the line. Lines end with LF or CR LF. A byte order mark is skipped.
class ModelWords {
public:
    // The text begins in `line` of the file.
    ModelWords(std::string_view text, const std::string& name, bool commas, FirstError& error,
               int line = 1);

    bool done() const { return next_.text.empty() || error_.any(); }
    const ModelWord& peek() const { return next_; }  // an empty text at the end
    ModelWord take();

    // A whole number min .. max. `called` is what errors call it: "the number of patches".
    int count(const std::string& called, int min, int max);
    // Three coordinates. `within` says in errors what the file ends in: "patch 2 of 28".
    ModelPoint point(const std::string& within);

    void report(int line, const std::string& what) { report_at(error_, name_, line, what); }
    // Reports that the file ends in something.
    void report_end(const std::string& within);
    FirstError& error() const { return error_; }

private:
    void advance();
    std::int64_t coordinate(const std::string& within);

    std::string_view rest_;
    const std::string& name_;
    bool commas_;
    FirstError& error_;
    ModelWord next_;
    int line_;
};

// The word of a coordinate, at most max_model, or a report. Beside what fixed::parse_decimal()
// reads it may be ".5" or "5.", but has no underscores.
std::int64_t read_coordinate(const ModelWord&, const std::string& name, FirstError&);

// A whole number min .. max, or `min` and a report.
int read_whole(const ModelWord&, const std::string& called, int min, int max,
               const std::string& name, FirstError&);

}  // namespace umbra78::tools
