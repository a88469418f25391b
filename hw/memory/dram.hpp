// The times of a frame store's dynamic memory: banks with an open row, and the cycles that refresh
// and video read-out take. No bit depends on them; they say only when an access is done.
//
//   row open, and not for too long:   column_ns            (a page hit)
//   row closed:                       access_ns            (a row miss)
//   another row open:                 recovery, access_ns  (a row miss that first closes a row)
//   without page mode: access_ns, and the bank is ready a whole cycle after the start
//
// A request is for one place, or for one in each of several banks, which start together. It starts
// when its banks are ready (for a page hit: a page cycle after the last column) and no refresh or
// video cycle is due. One that is due at the same time goes first; several go in the order in which
// they fell due, at a tie the video before the refresh. Such a cycle waits for accesses that have
// begun, takes all banks, closes all rows (a recovery, if one is open) and lasts a whole cycle.
// In and out: nanoseconds from the frame's start. What is published and what is assumed:
// hw/MACHINE.md, section 17.
// Not emulated: set-up and hold times, the video's own buffer, vertical blanking.
#pragma once

#include "hw/memory/dram_map.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::hw {

struct DramCounts {
    std::uint64_t requests = 0, accesses = 0;        // a request is for up to four accesses
    std::uint64_t page_hits = 0, row_misses = 0;     // their sum is `accesses`
    std::uint64_t row_changes = 0;                   // misses that first closed a row
    std::uint64_t refresh_cycles = 0, video_cycles = 0;
    std::uint64_t refresh_waits = 0, video_waits = 0, bank_waits = 0;  // requests that waited
    std::uint64_t refresh_wait_ns = 0, video_wait_ns = 0, bank_wait_ns = 0;
    std::uint64_t busy_ns = 0;  // from the start of requests to their data

    // From asking to data, over all requests.
    std::uint64_t latency_ns() const {
        return busy_ns + refresh_wait_ns + video_wait_ns + bank_wait_ns;
    }
};

// When the video of a shown store asks for its words: at equal distances within each line.
constexpr std::uint64_t video_words_a_line(const DramMap& map) {
    return map.xy_bits > map.word_bits() ? std::uint64_t{1} << (map.xy_bits - map.word_bits()) : 1;
}
constexpr std::uint64_t video_due_ns(const DramMap& map, std::uint64_t word) {
    const std::uint64_t a_line = video_words_a_line(map);
    return word / a_line * DramTiming::line_ns + word % a_line * DramTiming::active_ns / a_line;
}
// Whether reading out visits every row in time, so that nothing else need refresh them.
constexpr bool video_refreshes(const DramMap& map) {
    const std::uint64_t lines = DramTiming::chip_rows / video_words_a_line(map);
    return map.rows == DramRows::words && lines * DramTiming::line_ns <= DramTiming::refresh_ns;
}

class Dram {
public:
    static constexpr std::size_t max_banks = 4;

    Dram(const DramTiming& timing, const DramMap& map, bool shown);

    // When the data of a request that is made at `at_ns` is there. A request is made after the one
    // before it is done, never earlier.
    std::uint64_t access(std::span<const DramPlace> places, std::uint64_t at_ns);

    const DramCounts& counts() const { return counts_; }

private:
    struct Bank {
        std::int32_t row = closed;
        std::uint64_t opened_ns = 0, ready_ns = 0;
    };
    static constexpr std::int32_t closed = -1;

    bool hits(const Bank& bank, std::int32_t row, std::uint64_t start_ns) const;
    std::uint64_t ready_ns(std::span<const DramPlace> places, std::uint64_t at_ns) const;
    std::uint64_t due_ns() const;
    void steal(std::uint64_t at_ns, std::uint64_t& video_ns, std::uint64_t& refresh_ns);
    std::uint64_t serve(Bank& bank, std::int32_t row, std::uint64_t start_ns);

    DramTiming timing_;
    DramMap map_;
    std::array<Bank, max_banks> banks_{};
    std::uint64_t video_due_ns_, refresh_due_ns_;
    DramCounts counts_;
};

}  // namespace umbra78::hw
