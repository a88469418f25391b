// An independent model of the memory replay: registers filled and emptied clock by clock, and
// memory nanosecond by nanosecond (tests/hw/memory/slow_dram.hpp).
#pragma once

#include "shadow/light_place.hpp"
#include "shadow/frame/settings.hpp"
#include "tests/hw/memory/slow_dram.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace umbra78::shadow::test {

struct SlowToken {
    int x, y;
    bool visible;
    Texels texels;
};

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
        const hw::DramPlace p = pixel_map(s_).place(t.x, t.y);
        return dram.access({&p, 1}, now);
    }

    void enter(std::size_t stage, std::size_t index, std::uint64_t now) {
        const SlowToken& t = tokens_[index];
        const int px = pixel_map(s_).word_px();
        std::uint64_t clocks = 1, done = now;
        if (stage == 0 && t.x % px == 0) done = memory(observer, t, now);
        if (stage == 1 && t.visible) clocks = issue_;
        if (stage == 2) done = look_up(t.texels, now);
        if (stage == 3 && (t.x + 1) % px == 0) done = memory(mask, t, now);
        // run() looks at clock edges only: that is the rounding up.
        const auto clock = static_cast<std::uint64_t>(s_.timing.clock_ns);
        registers_[stage] = {true, index, std::max(done, now + clocks * clock)};
    }

    std::uint64_t look_up(const Texels& texels, std::uint64_t now) {
        std::vector<hw::DramPlace> places;
        for (std::size_t k = 0; k < texels.count; ++k)
            places.push_back(light_map(s_).place(texels.at[k].x, texels.at[k].y));
        if (places.empty()) return now;
        if (places.size() > 1 && s_.timing.light_banks == 4) return light.access(places, now);
        std::uint64_t address = now;  // the register of addresses takes a clock for each
        for (const hw::DramPlace& p : places) {
            now = light.access({&p, 1}, std::max(now, address));
            address += static_cast<std::uint64_t>(s_.timing.clock_ns);
        }
        return now;
    }

    Settings s_;
    std::uint64_t issue_;
    std::vector<SlowToken> tokens_;
    std::array<Register, 4> registers_{};
};

}  // namespace umbra78::shadow::test
