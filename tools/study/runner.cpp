#include "tools/study/runner.hpp"

#include "tools/io/console.hpp"
#include "tools/io/interruptible.hpp"
#include "tools/scene/settings_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

namespace umbra78::tools::study {
namespace {

using Clock = std::chrono::steady_clock;

// The case's overrides that are not settings: a profile, observer.KEY, light.KEY.
void set_overrides(Row& row, const Case& c) {
    for (const std::string& set : c.set) {
        const std::size_t equals = set.find('=');
        const std::string key = set.substr(0, equals);
        if (shadow::find_setting(key) == nullptr) row.set(key, set.substr(equals + 1));
    }
}

// Every setting; empty cells for a case that draws no frame. A whole number is stored as one.
void set_settings(Row& row, const std::optional<LoadedScene>& scene) {
    const Row settings = row_of(settings_json(scene ? scene->settings : shadow::Settings{}));
    for (const auto& [key, value] : settings.cells()) {
        const auto* real = std::get_if<double>(&value);
        const bool whole = real != nullptr && *real == static_cast<double>(std::int64_t(*real));
        row.set(key, !scene ? Value() : whole ? Value(std::int64_t(*real)) : value);
    }
}

// The number of cases done, and the time left if the remaining cases take as long as those before
// them: on a terminal after each case, elsewhere, as in a batch system's log, a line a minute.
class Progress {
public:
    explicit Progress(std::size_t cases) : cases_(cases), terminal_(isatty(STDERR_FILENO) != 0) {}
    ~Progress() {
        if (terminal_) print_progress("\r\033[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void done(std::size_t finished) {
        const Clock::time_point now = Clock::now();
        if (!terminal_ && now - printed_ < std::chrono::minutes(1)) return;
        printed_ = now;
        const std::chrono::duration<double> s = now - start_;
        const double left_s = s.count() / static_cast<double>(finished) *
                              static_cast<double>(cases_ - finished);
        const std::string text = fmt::format("case {} of {}, {:.0f} s left", finished, cases_,
                                             left_s);
        print_progress(terminal_ ? "\r\033[K" + text : "umbra78: " + text + "\n");
    }

private:
    std::size_t cases_;
    bool terminal_;
    Clock::time_point start_ = Clock::now(), printed_ = start_;
};

// The cases still to run, and where their rows go. The threads share it.
class Work {
public:
    Work(const Asked& asked, std::vector<std::size_t> left, RowAppender& log,
         std::map<std::size_t, Row>& rows)
        : asked_(asked), left_(std::move(left)), log_(log), rows_(rows), progress_(left_.size()) {}

    // What each thread does: takes cases until none is left, a write fails or an interrupt is asked
    // for.
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

// The rows of an earlier run of the same command. The log has its head.
std::map<std::size_t, Row> rows_there(const Asked& asked, Shard shard, const Path& log) {
    RowLog there = read_row_log(log);
    if (there.hash != asked.hash || there.shard != shard)
        throw std::runtime_error(fmt::format(
            "{}: it holds rows of other inputs (scene, settings, grid or version); remove it to "
            "begin anew, or give another folder with --out", log.string()));
    return std::move(there.rows);
}

}  // namespace

Row run_case(const Asked& asked, std::size_t index, const Case& c) {
    Row row;
    row.set("case", static_cast<std::int64_t>(index));
    row.set("name", c.name);
    set_overrides(row, c);
    for (const auto& [column, value] : c.extra) row.set(column, value);
    try {
        const std::optional<LoadedScene> scene = asked.study->scene(asked.request, c);
        set_settings(row, scene);
        row.set("status", std::string("ok"));
        const Row figures = asked.study->run(asked.request, c, scene ? &*scene : nullptr);
        for (const auto& [column, value] : figures.cells())
            if (asked.request.host_times || !is_of_host(column)) row.set(column, value);
    } catch (const std::bad_alloc&) {
        row.set("status", std::string("not enough memory"));
    } catch (const std::exception& error) {
        row.set("status", std::string(error.what()));
    }
    return row;
}

std::map<std::size_t, Row> run_cases(const Asked& asked, const RunOptions& options,
                                     const Path& log) {
    const Interruptible interruptible;
    RowAppender appender(log, asked, options.shard);
    std::map<std::size_t, Row> rows = rows_there(asked, options.shard, log);
    std::vector<std::size_t> left;
    std::size_t all = 0;
    for (std::size_t k = 0; k < asked.cases.size(); ++k) {
        if (!options.shard.holds(k)) continue;
        ++all;
        if (!rows.contains(k)) left.push_back(k);
    }
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
