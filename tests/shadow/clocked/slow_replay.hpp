// An independent model of the memory replay: registers filled and emptied clock by clock, and
// memory nanosecond by nanosecond (tests/hw/memory/slow_dram.hpp). Places in the chips and texels
// are found here again, from hw/MACHINE.md, section 17.
#pragma once

#include "shadow/clocked/memory_replay.hpp"
#include "shadow/frame/settings.hpp"
#include "tests/hw/memory/slow_dram.hpp"
#include "tests/shadow/slow_lookup.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace umbra78::shadow::test {

struct SlowToken {
    int x, y;
    bool visible;
    std::vector<SlowRead> reads;  // of texels, in order
};

// Pixels of a word of all chips: P in section 17.
inline int slow_word_px(int xy_bits) { return std::max(16, (1 << xy_bits << xy_bits) / 16384); }

// A pixel's bank, row and column, in a store of one bank or of four that are interleaved.
inline hw::DramPlace slow_place(const hw::Timing& timing, int xy_bits, int banks, int x, int y) {
    const int part = banks == 4 ? 2 : 1;
    const int address = y / part * ((1 << xy_bits) / part) + x / part;
    const int px = slow_word_px(xy_bits) / banks, word = address / px;
    const bool lines = timing.dram.rows == hw::DramRows::lines;
    return {banks == 4 ? 2 * (y % 2) + x % 2 : 0, lines ? word / 128 : word % 128,
            lines ? word % 128 : word / 128, address % px};
}

class SlowReplay {
public:
    SlowReplay(const Settings& s, std::uint64_t issue_cycles, std::vector<SlowToken> tokens)
        : observer(s.timing.dram, pixel_map(s), s.timing.dram.video != hw::Video::off),
          light(s.timing.dram, light_map(s), s.timing.dram.video == hw::Video::all),
          mask(s.timing.dram, pixel_map(s), s.timing.dram.video == hw::Video::all), s_(s),
          issue_(issue_cycles), tokens_(std::move(tokens)) {}

    // The frame's time.
    std::uint64_t run() {
        const auto clock = static_cast<std::uint64_t>(s_.timing.clock_ns);
        std::size_t next = 0, finished = 0;
        std::uint64_t now = 0;
        for (;; now += clock) {
            // From the last stage to the first, so that what is emptied at this edge can be filled.
            for (std::size_t k = 4; k-- > 0;) {
                Register& r = registers_[k];
                if (r.full && now >= r.until && (k == 3 || !registers_[k + 1].full)) {
                    r.full = false;
                    if (k == 3) ++finished;
                    else enter(k + 1, r.token, now);
                }
                if (k == 0 && !r.full && next < tokens_.size()) enter(0, next++, now);
            }
            if (finished == tokens_.size()) return now;
        }
    }

    hw::test::SlowDram observer, light, mask;

private:
    struct Register {
        bool full = false;
        std::size_t token = 0;
        std::uint64_t until = 0;
    };

    static hw::DramMap pixel_map(const Settings& s) {
        return {s.machine.xy_bits, 1, s.timing.dram.rows};
    }
    static hw::DramMap light_map(const Settings& s) {
        return {s.machine.xy_bits, s.timing.light_banks, s.timing.dram.rows};
    }

    std::uint64_t memory(hw::test::SlowDram& dram, const SlowToken& t, std::uint64_t now) {
        const hw::DramPlace p = slow_place(s_.timing, s_.machine.xy_bits, 1, t.x, t.y);
        return dram.access({&p, 1}, now);
    }

    void enter(std::size_t stage, std::size_t index, std::uint64_t now) {
        const SlowToken& t = tokens_[index];
        const int px = slow_word_px(s_.machine.xy_bits);
        std::uint64_t clocks = 1, done = now;
        if (stage == 0 && t.x % px == 0) done = memory(observer, t, now);
        if (stage == 1 && t.visible) clocks = issue_;
        if (stage == 2) done = look_up(t.reads, now);
        if (stage == 3 && (t.x + 1) % px == 0) done = memory(mask, t, now);
        // run() looks at clock edges only: that is the rounding up.
        const auto clock = static_cast<std::uint64_t>(s_.timing.clock_ns);
        registers_[stage] = {true, index, std::max(done, now + clocks * clock)};
    }

    std::uint64_t look_up(const std::vector<SlowRead>& reads, std::uint64_t now) {
        std::uint64_t address = now;  // the register of addresses takes a clock for each request
        std::vector<hw::DramPlace> request;
        for (std::size_t k = 0; k < reads.size(); ++k) {
            const auto& [x, y] = reads[k].texel;
            request.push_back(
                slow_place(s_.timing, s_.machine.xy_bits, s_.timing.light_banks, x, y));
            if (k + 1 < reads.size() && reads[k + 1].request == reads[k].request) continue;
            now = light.access(request, std::max(now, address));
            address += static_cast<std::uint64_t>(s_.timing.clock_ns);
            request.clear();
        }
        return now;
    }

    Settings s_;
    std::uint64_t issue_;
    std::vector<SlowToken> tokens_;
    std::array<Register, 4> registers_{};
};

// The recurrence of section 17 as a table, with stores that serve a request in a clock:
//   leave(k, i) = max( leave(k-1, i) + service(k, i),  leave(k+1, i-1) )
// Each entry carries its services by stage; of two equal terms the first is taken.
inline PathTime slow_ideal_path(const Settings& s, std::uint64_t issue_cycles,
                                const std::vector<SlowToken>& tokens) {
    using Entry = std::array<std::uint64_t, 4>;  // clocks, by stage
    const auto sum = [](const Entry& e) { return e[0] + e[1] + e[2] + e[3]; };
    // Of the token before and of this one: stages 1..4, and 0 and 5 beside them.
    std::array<Entry, 6> before{}, leave{};
    for (const SlowToken& t : tokens) {
        std::set<int> requests;
        for (const SlowRead& read : t.reads) requests.insert(read.request);
        const Entry service{1, t.visible ? issue_cycles : 1,
                            std::max<std::uint64_t>(1, requests.size()), 1};
        leave[0] = before[1];
        for (std::size_t k = 1; k <= 4; ++k) {
            Entry own = leave[k - 1];
            own[k - 1] += service[k - 1];
            leave[k] = sum(before[k + 1]) > sum(own) ? before[k + 1] : own;
        }
        before = leave;
    }
    const auto ns = [&](std::size_t k) {
        return leave[4][k] * static_cast<std::uint64_t>(s.timing.clock_ns);
    };
    return {ns(0), ns(1), ns(2), ns(3)};
}

}  // namespace umbra78::shadow::test
