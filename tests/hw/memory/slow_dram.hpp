// An independent model of the memory: one nanosecond after the other, and nothing else.
//
// In each nanosecond the model serves what is due: read-out and refresh in the order in which they
// fell due, and the request only if neither is. Nothing is computed ahead; waits are counted one by
// one.
#pragma once

#include "hw/memory/dram.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>

namespace umbra78::hw::test {

class SlowDram {
public:
    SlowDram(const DramTiming& timing, const DramMap& map, bool shown)
        : t_(timing), map_(map), shown_(shown) {}

    std::uint64_t access(std::span<const DramPlace> places, std::uint64_t at_ns) {
        bool video = false, refresh = false, bank = false, started = false;
        std::uint64_t done = 0;
        for (; !started; ++now_) {
            fall_due();
            if (now_ >= busy_until_) thief_ = Thief::none;
            if (!due_.empty()) {
                if (idle_everywhere()) steal();
            } else if (now_ >= at_ns && idle(places)) {
                done = start(places);
                started = true;
                continue;
            }
            if (now_ < at_ns) continue;
            counts.video_wait_ns += thief_ == Thief::video;
            counts.refresh_wait_ns += thief_ == Thief::refresh;
            counts.bank_wait_ns += thief_ == Thief::none;
            video = video || thief_ == Thief::video;
            refresh = refresh || thief_ == Thief::refresh;
            bank = bank || thief_ == Thief::none;
        }
        --now_;
        counts.video_waits += video;
        counts.refresh_waits += refresh;
        counts.bank_waits += bank;
        return done;
    }

    DramCounts counts;

private:
    enum class Thief { none, video, refresh };
    struct Bank {
        std::int32_t row = -1;
        std::uint64_t low_since = 0, busy_until = 0;
    };

    void fall_due() {
        if (looked_ == now_ + 1) return;  // this nanosecond has been looked at
        looked_ = now_ + 1;
        // The picture's lines, 63.5 us each; within 52 of them its words at even distances.
        const std::uint64_t words = std::max(1, (1 << map_.xy_bits) / map_.word_px());
        const std::uint64_t in_line = now_ % 63500;
        const bool word = in_line < 52000 && in_line % (52000 / words) == 0;
        if (shown_ && word) due_.push_back(Thief::video);
        const bool seen = shown_ && map_.rows == DramRows::words && 128 / words * 63500 <= 2000000;
        if (!seen && now_ != 0 && now_ % 15625 == 0) due_.push_back(Thief::refresh);
    }
    bool idle_everywhere() const {
        return std::all_of(std::begin(banks_), std::end(banks_),
                           [&](const Bank& b) { return b.busy_until <= now_; });
    }
    bool idle(std::span<const DramPlace> places) const {
        return std::all_of(places.begin(), places.end(), [&](const DramPlace& p) {
            const Bank& b = banks_[p.bank];
            return b.busy_until <= now_ && !waits_for_column(b, p.row);
        });
    }
    std::uint64_t column_ready(const Bank& b) const {
        return b.busy_until + static_cast<std::uint64_t>(std::max(t_.page_ns - t_.column_ns, 0));
    }
    bool in_time(const Bank& b, std::uint64_t column) const {
        return column + static_cast<std::uint64_t>(t_.column_ns) <= b.low_since + 10000;
    }
    // In the open row, the next column is worth a wait if it comes before the row must be closed.
    bool waits_for_column(const Bank& b, std::int32_t row) const {
        return b.row == row && now_ < column_ready(b) && in_time(b, column_ready(b));
    }
    std::uint64_t recovery() const {
        return static_cast<std::uint64_t>(std::max(t_.cycle_ns - t_.access_ns, 0));
    }
    std::uint64_t open() const { return static_cast<std::uint64_t>(t_.access_ns); }

    void steal() {
        std::uint64_t end = now_ + open() + recovery();
        if (std::any_of(std::begin(banks_), std::end(banks_), [](auto& b) { return b.row >= 0; }))
            end += recovery();
        for (Bank& b : banks_) b = {-1, 0, end};
        thief_ = due_.front();
        busy_until_ = end;
        ++(thief_ == Thief::video ? counts.video_cycles : counts.refresh_cycles);
        due_.pop_front();
    }
    std::uint64_t start(std::span<const DramPlace> places) {
        std::uint64_t last = now_;
        for (const DramPlace& p : places) {
            Bank& b = banks_[p.bank];
            std::uint64_t data = 0;
            if (b.row == p.row && now_ >= column_ready(b) && in_time(b, now_)) {
                ++counts.page_hits;
                data = now_ + static_cast<std::uint64_t>(t_.column_ns);
            } else {
                ++counts.row_misses;
                counts.row_changes += b.row >= 0;
                b.low_since = now_ + (b.row >= 0 ? recovery() : 0);
                b.row = p.row;
                data = b.low_since + open();
            }
            b.busy_until = data;
            if (t_.page_ns == 0) {
                b.row = -1;
                b.busy_until += recovery();
            }
            last = std::max(last, data);
            ++counts.accesses;
        }
        ++counts.requests;
        counts.busy_ns += last - now_;
        return last;
    }

    DramTiming t_;
    DramMap map_;
    bool shown_;
    Bank banks_[4];
    std::deque<Thief> due_;
    Thief thief_ = Thief::none;
    std::uint64_t now_ = 0, looked_ = 0, busy_until_ = 0;
};

}  // namespace umbra78::hw::test
