#include "hw/memory/dram.hpp"

#include "fixed/trap.hpp"

#include <algorithm>

namespace umbra78::hw {
namespace {

constexpr std::uint64_t never = UINT64_MAX;
constexpr std::uint64_t refresh_interval_ns = DramTiming::refresh_ns / DramTiming::chip_rows;

std::uint64_t ns(int n) { return static_cast<std::uint64_t>(n); }

}  // namespace

Dram::Dram(const DramTiming& timing, const DramMap& map, bool shown)
    : timing_(timing), map_(map), video_due_ns_(shown ? video_due_ns(map, 0) : never),
      refresh_due_ns_(shown && video_refreshes(map) ? never : refresh_interval_ns) {
    fixed::require(map.banks >= 1 && ns(map.banks) <= max_banks, "dram: too many banks");
}

// Whether an access that starts at start_ns finds its row open, for not too long, and may start a
// column.
bool Dram::hits(const Bank& bank, std::int32_t row, std::uint64_t start_ns) const {
    return bank.row == row && start_ns >= bank.ready_ns + ns(timing_.column_recovery_ns()) &&
           start_ns + ns(timing_.column_ns) <= bank.opened_ns + ns(DramTiming::longest_open_ns);
}

// When all banks of a request can start: a hit waits for the column, all else for the bank only.
std::uint64_t Dram::ready_ns(std::span<const DramPlace> places, std::uint64_t at_ns) const {
    std::uint64_t start = at_ns;
    for (const DramPlace& p : places) {
        const Bank& bank = banks_[static_cast<std::size_t>(p.bank)];
        const std::uint64_t column =
            std::max(at_ns, bank.ready_ns + ns(timing_.column_recovery_ns()));
        start = std::max(start, hits(bank, p.row, column) ? column : bank.ready_ns);
    }
    return start;
}

std::uint64_t Dram::due_ns() const { return std::min(video_due_ns_, refresh_due_ns_); }

// Serves the cycle that fell due first, in all banks, and adds its part after `at_ns` to the waits.
void Dram::steal(std::uint64_t at_ns, std::uint64_t& video_ns, std::uint64_t& refresh_ns) {
    const bool video = video_due_ns_ <= refresh_due_ns_;
    std::uint64_t begin = due_ns();
    bool open = false;
    for (const Bank& b : banks_) {
        begin = std::max(begin, b.ready_ns);
        open = open || b.row != closed;
    }
    const std::uint64_t end =
        begin + ns(timing_.whole_cycle_ns() + (open ? timing_.recovery_ns() : 0));
    for (Bank& b : banks_) b = {closed, 0, end};
    if (end > at_ns) (video ? video_ns : refresh_ns) += end - std::max(begin, at_ns);
    if (video) {
        video_due_ns_ = hw::video_due_ns(map_, ++counts_.video_cycles);
    } else {
        ++counts_.refresh_cycles;
        refresh_due_ns_ += refresh_interval_ns;
    }
}

// One bank's part of a request that starts at start_ns; returns when its data is there.
std::uint64_t Dram::serve(Bank& bank, std::int32_t row, std::uint64_t start_ns) {
    ++counts_.accesses;
    const bool open = bank.row != closed;
    if (hits(bank, row, start_ns)) {
        ++counts_.page_hits;
        return bank.ready_ns = start_ns + ns(timing_.column_ns);
    }
    ++counts_.row_misses;
    if (open) ++counts_.row_changes;
    const std::uint64_t opened = start_ns + (open ? ns(timing_.recovery_ns()) : 0);
    const std::uint64_t done = opened + ns(timing_.access_ns);
    if (timing_.page_mode()) {
        bank = {row, opened, done};
    } else {
        bank = {closed, 0, opened + ns(timing_.whole_cycle_ns())};
    }
    return done;
}

std::uint64_t Dram::access(std::span<const DramPlace> places, std::uint64_t at_ns) {
    std::uint64_t video_ns = 0, refresh_ns = 0;
    std::uint64_t start = ready_ns(places, at_ns);
    while (due_ns() <= start) {
        steal(at_ns, video_ns, refresh_ns);
        start = ready_ns(places, at_ns);
    }
    const std::uint64_t bank_ns = start - at_ns - video_ns - refresh_ns;
    std::uint64_t done = start;
    for (const DramPlace& p : places)
        done = std::max(done, serve(banks_[static_cast<std::size_t>(p.bank)], p.row, start));

    ++counts_.requests;
    counts_.video_waits += video_ns != 0;
    counts_.refresh_waits += refresh_ns != 0;
    counts_.bank_waits += bank_ns != 0;
    counts_.video_wait_ns += video_ns;
    counts_.refresh_wait_ns += refresh_ns;
    counts_.bank_wait_ns += bank_ns;
    counts_.busy_ns += done - start;
    return done;
}

}  // namespace umbra78::hw
