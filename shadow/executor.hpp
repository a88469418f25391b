// Who does a frame's work: the caller's threads, which the core has none of.
//
// A stage divides its work into parts and hands them to an Executor. Parts write different words
// and read none that another writes, so they may run in any order and at the same time; what they
// count is added up in the order of their numbers. So a frame has the same bits and the same
// counts with any number of workers.
#pragma once

#include "hw/band.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace umbra78::shadow {

inline constexpr std::size_t max_workers = 64;
inline constexpr std::size_t max_parts = 4 * max_workers;

struct Executor {
    using Task = void (*)(void* work, std::size_t part, std::size_t worker);

    // Calls task(work, p, w) once for each p < parts, and returns when all calls have returned.
    // Calls that overlap in time have different w < workers. What a call has written is seen by
    // whoever runs after run() has returned. Null: the parts are done one after the other.
    void (*run)(void* context, std::size_t parts, Task task, void* work) = nullptr;
    void* context = nullptr;
    std::size_t workers = 1;

    bool shares() const { return run != nullptr && workers > 1; }

    // part(p, worker) for each p < parts.
    template <class Part>
    void operator()(std::size_t parts, Part&& part) const {
        if (run == nullptr || parts < 2) {
            for (std::size_t p = 0; p < parts; ++p) part(p, std::size_t{0});
            return;
        }
        using Called = std::remove_reference_t<Part>;
        run(
            context, parts,
            [](void* work, std::size_t p, std::size_t worker) {
                (*static_cast<Called*>(work))(p, worker);
            },
            const_cast<void*>(static_cast<const void*>(&part)));
    }
};

// Parts of `count` things, at least `least` to a part and as many parts as let workers that are
// quick take more of them.
inline std::size_t parts_of(const Executor& executor, std::size_t count, std::size_t least) {
    if (!executor.shares()) return 1;
    return std::clamp<std::size_t>(count / least, 1, std::min(4 * executor.workers, max_parts));
}

// Calls work(band, worker) for bands of about as many lines each, and returns the sum of what they
// count.
template <class Counts, class Work>
Counts count_bands(const Executor& executor, int lines, Work&& work) {
    const std::size_t parts = parts_of(executor, static_cast<std::size_t>(lines), 16);
    std::array<Counts, max_parts> counted{};
    const auto limit = [&](std::size_t p) {
        return static_cast<int>(static_cast<std::size_t>(lines) * p / parts);
    };
    executor(parts, [&](std::size_t p, std::size_t worker) {
        counted[p] = work(hw::Band{limit(p), limit(p + 1)}, worker);
    });
    Counts sum{};
    for (std::size_t p = 0; p < parts; ++p) sum += counted[p];
    return sum;
}

// The same of work that counts nothing.
template <class Work>
void for_bands(const Executor& executor, int lines, Work&& work) {
    count_bands<int>(executor, lines, [&](hw::Band band, std::size_t worker) {
        work(band, worker);
        return 0;
    });
}

}  // namespace umbra78::shadow
