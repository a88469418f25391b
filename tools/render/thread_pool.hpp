// Threads for a frame: an executor of the core (shadow/executor.hpp), which has none itself.
//
// The threads are made once and wait between the stages. Who calls run() works with them, as worker
// 0, so that a pool of one has no thread of its own.
#pragma once

#include "shadow/executor.hpp"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace umbra78::tools {

// How many workers `--threads N` asks for: N, or for 0 one for each of the processors, at most
// max_workers.
std::size_t workers_for(int threads);

class ThreadPool {
public:
    explicit ThreadPool(std::size_t workers);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    shadow::Executor executor() { return {run, this, threads_.size() + 1}; }

private:
    struct Work {
        std::size_t parts = 0;
        shadow::Executor::Task task = nullptr;
        void* work = nullptr;
    };
    static void run(void* self, std::size_t parts, shadow::Executor::Task task, void* work);
    void work_through(std::size_t worker, const Work& work);
    void wait_for_work(std::size_t worker);

    std::mutex mutex_;
    std::condition_variable begins_, ended_;
    Work work_;
    std::atomic<std::size_t> next_{0};  // part
    std::size_t run_ = 0;               // counted
    std::size_t at_work_ = 0;           // threads that have not ended this run
    bool over_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace umbra78::tools
