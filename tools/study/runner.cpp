#include "tools/study/runner.hpp"

#include "tools/io/interruptible.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace umbra78::tools::study {
namespace {

using Clock = std::chrono::steady_clock;

// On a terminal: cases done, and the time left if the rest take as long as those before.
class Progress {
public:
    explicit Progress(std::size_t cases) : cases_(cases), shown_(isatty(STDERR_FILENO) != 0) {}
    ~Progress() {
        if (shown_) fmt::print(stderr, "\r\033[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void done(std::size_t finished) const {
        if (!shown_) return;
        const std::chrono::duration<double> s = Clock::now() - start_;
        const double left_s = s.count() / static_cast<double>(finished) *
                              static_cast<double>(cases_ - finished);
        fmt::print(stderr, "\r\033[Kcase {} of {}, {:.0f} s left", finished, cases_, left_s);
    }

private:
    std::size_t cases_;
    bool shown_;
    Clock::time_point start_ = Clock::now();
};

// The cases still to run, and where their rows go; shared by the threads.
class Work {
public:
    Work(const Asked& asked, std::vector<std::size_t> left, RowAppender& log,
         std::map<std::size_t, Row>& rows)
        : asked_(asked), left_(std::move(left)), log_(log), rows_(rows), progress_(left_.size()) {}

    // A thread's part: cases until none is left, or somebody failed or asked to stop.
    void run() {
        const auto go_on = [&] { return !Interruptible::asked() && !failed_; };
        for (std::size_t k = next_++; k < left_.size() && go_on(); k = next_++) {
            Row row = run_case(asked_, left_[k], asked_.cases[left_[k]]);
            const std::lock_guard lock(mutex_);
            try {
                log_.append(left_[k], row);
                rows_.insert_or_assign(left_[k], std::move(row));
                progress_.done(++finished_);
            } catch (...) {
                error_ = std::current_exception();
                failed_ = true;
            }
        }
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

private:
    const Asked& asked_;
    std::vector<std::size_t> left_;
    RowAppender& log_;
    std::map<std::size_t, Row>& rows_;
    Progress progress_;
    std::mutex mutex_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::size_t finished_ = 0;
    std::exception_ptr error_;
};

// Rows of an earlier run of the same command.
std::map<std::size_t, Row> rows_there(const Asked& asked, Shard shard, const Path& log) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(log, ignored)) return {};
    cut_torn_line(log);
    if (std::filesystem::file_size(log) == 0) return {};
    RowLog there = read_row_log(log);
    if (there.hash != asked.hash || there.shard != shard)
        throw std::runtime_error(fmt::format(
            "{}: it holds rows of other inputs (scene, settings, grid or version); remove it to "
            "begin anew, or give another folder with --out", log.string()));
    return std::move(there.rows);
}

}  // namespace

std::map<std::size_t, Row> run_cases(const Asked& asked, const RunOptions& options,
                                     const Path& log) {
    std::map<std::size_t, Row> rows = rows_there(asked, options.shard, log);
    std::vector<std::size_t> left;
    std::size_t all = 0;
    for (std::size_t k = 0; k < asked.cases.size(); ++k) {
        if (!options.shard.holds(k)) continue;
        ++all;
        if (!rows.contains(k)) left.push_back(k);
    }
    const Interruptible interruptible;
    RowAppender appender(log, asked, options.shard);
    {
        const auto cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
        const int wanted = options.jobs > 0 ? options.jobs : cores;
        Work work(asked, left, appender, rows);
        std::vector<std::jthread> threads;
        for (int k = 1; k < std::min(wanted, static_cast<int>(left.size())); ++k)
            threads.emplace_back([&work] { work.run(); });
        work.run();
        for (std::jthread& thread : threads) thread.join();
        work.rethrow();
    }
    if (rows.size() < all)
        throw std::runtime_error(fmt::format("interrupted: {} of {} cases are done and kept in {}; "
                                             "run the same command again to go on", rows.size(),
                                             all, log.string()));
    return rows;
}

}  // namespace umbra78::tools::study
