// Executors for tests: threads, and one that shows whether parts depend on their order.
#pragma once

#include "shadow/executor.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

namespace umbra78::test {

// A thread for each worker, made anew for each run, with parts of its own: nothing orders what two
// of them do, so that ThreadSanitizer sees every word that they share.
class Threads {
public:
    explicit Threads(std::size_t workers) : workers_(workers) {}
    shadow::Executor executor() { return {run, this, workers_}; }

private:
    static void run(void* self, std::size_t parts, shadow::Executor::Task task, void* work) {
        const std::size_t workers = static_cast<Threads*>(self)->workers_;
        const auto take = [&](std::size_t worker) {
            for (std::size_t p = worker; p < parts; p += workers) task(work, p, worker);
        };
        std::vector<std::jthread> threads;
        for (std::size_t w = 1; w < workers; ++w) threads.emplace_back(take, w);
        take(0);
    }
    std::size_t workers_;
};

// One thread that does the parts in any order, each as any of the workers.
class Shuffled {
public:
    explicit Shuffled(std::size_t workers) : workers_(workers) {}
    shadow::Executor executor() { return {run, this, workers_}; }
    std::size_t parts() const { return parts_; }  // done so far

private:
    static void run(void* self, std::size_t parts, shadow::Executor::Task task, void* work) {
        Shuffled& s = *static_cast<Shuffled*>(self);
        std::vector<std::size_t> order(parts);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), s.random_);
        for (const std::size_t p : order) task(work, p, s.random_() % s.workers_);
        s.parts_ += parts;
    }
    std::size_t workers_, parts_ = 0;
    std::mt19937 random_{78};
};

}  // namespace umbra78::test
