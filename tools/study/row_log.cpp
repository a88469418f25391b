#include "tools/study/row_log.hpp"

#include "tools/io/file_errors.hpp"
#include "tools/io/text_formats.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace umbra78::tools::study {
namespace {

using nlohmann::ordered_json;

[[noreturn]] void fail_to_read(const Path& path, std::string_view wrong) {
    throw std::runtime_error(fmt::format(
        "{}: {}; give a file that umbra78 study wrote, or run that part again", path.string(),
        wrong));
}

RowLog read_head(const Path& path, const std::string& line, const RowLog* known) {
    RowLog log;
    const std::size_t inputs = std::min(line.find(",\"inputs\":"), line.size());
    log.inputs_text = line.substr(inputs);
    const bool is_known = known != nullptr && known->inputs_text == log.inputs_text;
    const ordered_json json = parse_json(is_known ? line.substr(0, inputs) + "}" : line);
    log.hash = json.at("inputs_hash");
    log.cases = json.at("cases");
    log.shard = {json.at("shard").at(0), json.at("shard").at(1)};
    if (!is_known) log.inputs = json.at("inputs");
    if (log.shard.n < 1 || log.shard.i < 1 || log.shard.i > log.shard.n)
        fail_to_read(path, "line 1 names no shard");
    return log;
}

void read_row(const Path& path, RowLog& log, const std::string& line, int number) {
    const ordered_json json = parse_json(line);
    const std::size_t index = json.at("case");
    if (index >= log.cases || !log.shard.holds(index))
        fail_to_read(path, fmt::format("line {} is of case {}, which is not of this file", number,
                                       index));
    log.rows.insert_or_assign(index, row_of(json.at("row")));
}

// So that what is appended begins a line.
void cut_torn_line(const Path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t whole = text.rfind('\n') + 1;  // 0 where there is none
    if (whole != text.size()) std::filesystem::resize_file(path, whole);
}

}  // namespace

std::string head_line(const Asked& asked, Shard shard) {
    return print_line({{"study", asked.study->name()},
                       {"inputs_hash", asked.hash},
                       {"cases", asked.cases.size()},
                       {"shard", {shard.i, shard.n}},
                       {"inputs", asked.inputs}});
}

std::string row_line(std::size_t index, const Row& row) {
    return print_line({{"case", index}, {"row", to_json(row)}});
}

RowLog read_row_log(const Path& path, const RowLog* known) {
    if (const std::string why = why_not_read(path); !why.empty()) fail_to_read(path, why);
    std::ifstream file(path, std::ios::binary);
    RowLog log;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (file.eof()) break;  // torn
        try {
            number == 1 ? void(log = read_head(path, line, known))
                        : read_row(path, log, line, number);
        } catch (const nlohmann::json::exception&) {
            fail_to_read(path, fmt::format("line {} is not one of a study's", number));
        }
    }
    if (log.hash.empty()) fail_to_read(path, "it has no head");
    return log;
}

RowAppender::RowAppender(const Path& path, const Asked& asked, Shard shard) : path_(path) {
    destination_of(path);  // for its errors
    do {  // a program that ends removes its log, perhaps between these two calls
        if (file_ >= 0) ::close(file_);
        file_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
        if (file_ < 0)
            throw std::runtime_error(fmt::format(
                "cannot write '{}': {}; name a place that can be written to with --out",
                path.string(), std::generic_category().message(errno)));
        if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(file_);
            throw std::runtime_error(fmt::format(
                "{}: another umbra78 is writing to it; wait until it ends, or give another folder "
                "with --out", path.string()));
        }
    } while (!is_still_there());
    cut_torn_line(path);
    if (std::filesystem::file_size(path) == 0) write(head_line(asked, shard));
}

bool RowAppender::is_still_there() const {
    struct stat there {}, opened {};
    return ::stat(path_.c_str(), &there) == 0 && ::fstat(file_, &opened) == 0 &&
           there.st_dev == opened.st_dev && there.st_ino == opened.st_ino;
}

RowAppender::~RowAppender() { ::close(file_); }

void RowAppender::append(std::size_t index, const Row& row) { write(row_line(index, row)); }

void RowAppender::write(const std::string& line) {
    const char* from = line.data();
    for (std::size_t left = line.size(); left > 0;) {
        const ssize_t written = ::write(file_, from, left);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0)
            throw std::runtime_error(fmt::format(
                "cannot write '{}': {}; free some space there, then run the same command again",
                path_.string(), std::generic_category().message(errno)));
        from += written;
        left -= static_cast<std::size_t>(written);
    }
}

}  // namespace umbra78::tools::study
