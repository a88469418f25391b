#include "tools/benchmarks/workers.hpp"

#include "shadow/frame/frame.hpp"
#include "tools/benchmarks/drawn_frame.hpp"
#include "tools/render/thread_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

namespace umbra78::tools {
namespace {

double processor_ms() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double wall_ms() {
    return std::chrono::duration<double, std::milli>(
               std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Does the parts one after the other, and adds up how long they would have taken side by side.
class LaidOut {
public:
    explicit LaidOut(std::size_t workers) : workers_(workers) {}
    shadow::Executor executor() { return {run, this, workers_}; }
    // Since the last call: how much less than one after the other.
    double saved() { return std::exchange(saved_, 0.0); }

private:
    static void run(void* self, std::size_t parts, shadow::Executor::Task task, void* work) {
        LaidOut& l = *static_cast<LaidOut*>(self);
        std::vector<double> ready(l.workers_, 0.0);
        const double start = processor_ms();
        double before = start;
        for (std::size_t p = 0; p < parts; ++p) {
            const auto first = std::ranges::min_element(ready);
            task(work, p, static_cast<std::size_t>(first - ready.begin()));
            const double now = processor_ms();
            *first += now - before;
            before = now;
        }
        l.saved_ += before - start - *std::ranges::max_element(ready);
    }
    std::size_t workers_;
    double saved_ = 0;
};

struct Stage {
    const char* name;
    void (*run)(DrawnFrame&);
};
constexpr Stage stages[] = {
    {"light's view", [](DrawnFrame& f) {
         shadow::draw_light(f.inputs(), f.plan, f.frame, f.counts);
     }},
    {"observer's view", [](DrawnFrame& f) {
         shadow::draw_observer(f.inputs(), f.plan, f.frame, f.counts);
     }},
    {"post-process", [](DrawnFrame& f) {
         shadow::cast_shadows(f.inputs(), f.plan, f.frame, f.counts);
     }},
    {"filters and composite", [](DrawnFrame& f) {
         shadow::filter_and_composite(f.inputs(), f.plan, f.frame, f.counts);
     }},
    {"all of them", [](DrawnFrame& f) {
         shadow::draw_frame(f.inputs(), f.plan, f.frame, f.counts);
     }},
};

// The least of many rounds of each way of doing the stage.
struct Least {
    double one_processor = 1e9, laid_out = 1e9, one_wall = 1e9, many_wall = 1e9;
};

}  // namespace

int compare_workers(int threads, int rounds) {
    const std::size_t workers = workers_for(threads);
    ThreadPool pool(workers);
    LaidOut laid_out(workers);
    fmt::print("{:<24} {:<22} {:>8} {:>10} {:>9} {:>9}\n", "frame", "stage", "one, ms",
               "laid out", "by parts", "by wall");
    for (auto& frame : benchmark_frames(workers)) {
        auto& made = frame.second;  // clang++ 14 captures no structured binding
        for (const Stage& stage : stages) {
            Least least;
            for (int round = 0; round < rounds; ++round) {
                const auto run = [&](const shadow::Executor& executor) {
                    made->frame.executor = executor;
                    const double processor = processor_ms(), wall = wall_ms();
                    stage.run(*made);
                    return std::pair(processor_ms() - processor, wall_ms() - wall);
                };
                const auto [one, one_wall] = run({});
                least.one_processor = std::min(least.one_processor, one);
                least.one_wall = std::min(least.one_wall, one_wall);
                const double serial = run(laid_out.executor()).first;
                least.laid_out = std::min(least.laid_out, serial - laid_out.saved());
                least.many_wall = std::min(least.many_wall, run(pool.executor()).second);
            }
            fmt::print("{:<24} {:<22} {:>8.3f} {:>10.3f} {:>9.2f} {:>9.2f}\n", frame.first,
                       stage.name,
                       least.one_processor, least.laid_out, least.one_processor / least.laid_out,
                       least.one_wall / least.many_wall);
        }
    }
    return 0;
}

}  // namespace umbra78::tools
