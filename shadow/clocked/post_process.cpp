// The clocked post-process's stages, and its schedule from one scan of the observer's Z: what lets
// a frame's cycles be known without ticking it.
#include "shadow/clocked/post_process_impl.hpp"
#include "shadow/lines.hpp"
#include "shadow/row_form.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace umbra78::shadow {

PostProcessPipeline::PostProcessPipeline(const TimedTest& s, const hw::MatrixWords& matrix)
    : transform(checked(s).machine, s.timing, matrix), divide(s.machine, s.timing, matrix),
      lookup(s), divides(!matrix.affine), dithers(s.dither.shape != hw::DitherShape::none) {
    read_cycles = dithers ? hw::ClockedNoise::cycles_per_pixel(s.dither, s.timing) : 1;
    read_cycles = std::max(read_cycles, tap_noise_cycles(lookup.window, s.timing));
    const int between = lookup.blends ? lookup.interpolate_cycles()
                        : lookup.sums() ? lookup.fetch_cycles()
                                        : 0;
    slot_cycles = std::max({transform.cycles(), divides ? divide.cycles() : 1,
                            lookup.fetch_cycles(), between, 1});  // comparing takes no longer
    latency = transform.latency() + (divides ? divide.latency() : 0) + lookup.fetch_cycles() +
              between + lookup.compare_cycles() + 2;  // place, write
}

namespace {

// Of words of 64 codes, which of them are visible: by lanes where there are some.
template <class Depth>
void find_drawn(std::span<const Depth> depth, Depth none, std::span<std::uint64_t> drawn) {
    if constexpr (hw::built(hw::Feature::rows) && sizeof(Depth) == sizeof(hw::Depth16)) {
        fastest_row_form().find_drawn(depth.data(), drawn.size(), none, drawn.data());
    } else {
        for (std::size_t w = 0; w < drawn.size(); ++w)
            drawn[w] = drawn_of_64<Depth>(depth.subspan(64 * w, 64), none);
    }
}

// Reads the scan's pixels by runs.
class ScheduleRuns {
public:
    ScheduleRuns(int read_cycles, int slot_cycles)
        : read_(static_cast<std::uint64_t>(read_cycles)),
          slot_(std::max(static_cast<std::uint64_t>(slot_cycles), read_)) {}

    void skip(int run) { gap_ += static_cast<std::uint64_t>(run); }
    void let_go(int run) {
        const std::uint64_t reading = read_ * (gap_ + 1);
        s_.last_issue += s_.visible == 0 ? reading - 1 : std::max(slot_, reading);
        s_.last_issue += slot_ * static_cast<std::uint64_t>(run - 1);
        s_.visible += static_cast<std::uint64_t>(run);
        gap_ = 0;
    }
    // Of `count` pixels, which of them are visible.
    void read(std::uint64_t drawn, int count) {
        for (int at = 0; at < count;) {
            const std::uint64_t rest = drawn >> at;
            const int none = std::min(std::countr_zero(rest), count - at);
            skip(none);
            at += none;
            if (at == count) return;
            const int run = std::countr_one(drawn >> at);
            let_go(run);
            at += run;
        }
    }
    Schedule result() {
        s_.trailing = read_ * gap_;
        return s_;
    }

private:
    std::uint64_t read_, slot_, gap_ = 0;  // background pixels after the one let go last
    Schedule s_;
};

}  // namespace

template <class Depth>
Schedule schedule(std::span<const Depth> depth, std::uint32_t background, int read_cycles,
                  int slot_cycles) {
    fixed::require(read_cycles > 0 && slot_cycles > 0,
                   "schedule: a pixel takes a cycle or more");
    const auto none = static_cast<Depth>(background);
    ScheduleRuns runs(read_cycles, slot_cycles);
    std::array<std::uint64_t, 64> drawn;
    const std::size_t whole = depth.size() / 64;
    for (std::size_t k = 0; k < whole; k += drawn.size()) {
        const std::span words = std::span(drawn).first(std::min(drawn.size(), whole - k));
        find_drawn<Depth>(depth.subspan(64 * k), none, words);
        for (const std::uint64_t word : words) runs.read(word, 64);
    }
    const std::span last = depth.subspan(64 * whole);
    runs.read(drawn_of_64<Depth>(last, none), static_cast<int>(last.size()));
    Schedule s = runs.result();
    s.pixels = depth.size();
    return s;
}

#define UMBRA78_CLOCKED(Depth)                                                                \
    template Schedule schedule(std::span<const Depth>, std::uint32_t, int, int);              \
    template class ClockedPostProcess<Depth>;
UMBRA78_CLOCKED(hw::Depth16)
UMBRA78_CLOCKED(hw::Depth32)
#undef UMBRA78_CLOCKED

}  // namespace umbra78::shadow
