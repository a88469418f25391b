#include "tools/render/thread_pool.hpp"

#include <algorithm>

namespace umbra78::tools {

std::size_t workers_for(int threads) {
    const auto asked = static_cast<std::size_t>(
        threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(asked, 1, shadow::max_workers);
}

ThreadPool::ThreadPool(std::size_t workers) {
    for (std::size_t w = 1; w < workers; ++w)
        threads_.emplace_back([this, w] { wait_for_work(w); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    begins_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(void* self, std::size_t parts, shadow::Executor::Task task, void* work) {
    ThreadPool& pool = *static_cast<ThreadPool*>(self);
    const Work all{parts, task, work};
    {
        const std::lock_guard lock(pool.mutex_);
        pool.work_ = all;
        pool.next_ = 0;
        pool.at_work_ = pool.threads_.size();
        ++pool.run_;
    }
    pool.begins_.notify_all();
    pool.work_through(0, all);
    std::unique_lock lock(pool.mutex_);
    pool.ended_.wait(lock, [&] { return pool.at_work_ == 0; });
}

void ThreadPool::work_through(std::size_t worker, const Work& work) {
    for (std::size_t p = next_++; p < work.parts; p = next_++) work.task(work.work, p, worker);
}

void ThreadPool::wait_for_work(std::size_t worker) {
    std::unique_lock lock(mutex_);
    for (std::size_t done = 0;;) {
        begins_.wait(lock, [&] { return over_ || run_ != done; });
        if (over_) return;
        done = run_;
        const Work work = work_;
        lock.unlock();
        work_through(worker, work);
        lock.lock();
        if (--at_work_ == 0) ended_.notify_one();
    }
}

}  // namespace umbra78::tools
