// What the tests of traces, waterfalls and waveforms share: words of a trace by
// name, and random machines.
#pragma once

#include "tests/shadow/clocked/clocked_frames.hpp"
#include "tools/watch/pixel_trace.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace umbra78::tools::test {

using shadow::test::pick;
using shadow::test::Random;

// The last word of that name in that part; a failure and 0 where there is none.
inline std::int64_t word_of(const PixelTrace& trace, std::string_view part,
                            std::string_view name) {
    for (auto line = trace.lines.rbegin(); line != trace.lines.rend(); ++line)
        if (line->part == part && line->name == name && line->word) return line->word->value;
    ADD_FAILURE() << "no word " << name << " in " << part << "\n" << to_text(trace.lines);
    return 0;
}

inline bool has_word(const PixelTrace& trace, std::string_view part, std::string_view name) {
    for (const TraceLine& line : trace.lines)
        if (line.part == part && line.name == name) return true;
    return false;
}

// Any widths, lookup, dither and parts; a small frame.
inline shadow::Settings random_machine(Random& random) {
    shadow::Settings s = shadow::test::random_settings(random, false);
    s.machine.xy_bits = 4;
    s.machine.multipliers = pick(random, {1, 4, 16});
    s.machine.divide_order =
        pick(random, {hw::DivideOrder::exact, hw::DivideOrder::round_first});
    hw::Timing& t = s.timing;
    t.divider = pick(random, {hw::Divider::serial, hw::Divider::pipelined});
    t.light_banks = pick(random, {1, 4});
    t.noise_bits = pick(random, {1, 7, 24, 64, 192, 1024});
    t.clock_ns = pick(random, {100, 150, 200, 1000});
    t.multiply_ns = pick(random, {1, 160, 400});
    t.add_ns = pick(random, {1, 60, 150});
    return s;
}

inline std::unique_ptr<WatchedFrame> random_frame(Random& random, const shadow::Settings& s) {
    std::vector<hw::Depth32> observer(std::size_t{1} << (2 * s.machine.xy_bits));
    std::vector<hw::Depth32> light(observer.size());
    shadow::test::fill_depth(random, s.machine, observer);
    shadow::test::fill_depth(random, s.machine, light);
    const auto matrix = shadow::test::random_matrix(random, s.machine, random.bits() % 2 == 0);
    return std::make_unique<WatchedFrame>(s, matrix, std::move(observer), std::move(light));
}

}  // namespace umbra78::tools::test
