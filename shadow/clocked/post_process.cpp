// The clocked post-process's stages, and its schedule from one scan of the observer's Z: what lets
// a frame's cycles be known without ticking it.
#include "shadow/clocked/post_process_impl.hpp"

#include <algorithm>

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

// A chunk of the scan: how many pixels are visible, and how often that changes from one to the
// next. In 16-bit words, which the compiler has lanes for.
struct Chunk {
    std::uint16_t visible = 0, changes = 0;
};
template <class Depth>
Chunk look(std::span<const Depth> piece, Depth none) {
    Chunk c;
    for (const Depth code : piece)
        c.visible = static_cast<std::uint16_t>(c.visible + (code != none));
    if (c.visible == 0 || c.visible == piece.size()) return c;
    for (std::size_t k = 1; k < piece.size(); ++k)
        c.changes = static_cast<std::uint16_t>(
            c.changes + ((piece[k] != none) != (piece[k - 1] != none)));
    return c;
}

}  // namespace

// A chunk that holds one run of visible or background pixels, or two, is counted as a whole; any
// other chunk is counted pixel by pixel.
template <class Depth>
Schedule schedule(std::span<const Depth> depth, std::uint32_t background, int read_cycles,
                  int slot_cycles) {
    fixed::require(read_cycles > 0 && slot_cycles > 0,
                   "schedule: a pixel takes a cycle or more");
    Schedule s;
    s.pixels = depth.size();
    const auto p = static_cast<std::uint64_t>(read_cycles);
    const std::uint64_t slot = std::max(static_cast<std::uint64_t>(slot_cycles), p);
    const auto none = static_cast<Depth>(background);
    std::uint64_t gap = 0;  // background pixels after the one let go last
    const auto let_go = [&](std::uint64_t run) {
        if (run == 0) return;
        const std::uint64_t reading = p * (gap + 1);
        s.last_issue += s.visible == 0 ? reading - 1 : std::max(slot, reading);
        s.last_issue += slot * (run - 1);
        s.visible += run;
        gap = 0;
    };
    constexpr std::size_t size = 64;
    for (std::size_t k = 0; k < depth.size(); k += size) {
        const std::span piece = depth.subspan(k, std::min(size, depth.size() - k));
        const Chunk c = look<Depth>(piece, none);
        if (c.changes > 1) {
            for (const Depth code : piece) code != none ? let_go(1) : void(++gap);
        } else if (piece[0] != none) {
            let_go(c.visible);
            gap += piece.size() - c.visible;
        } else {
            gap += piece.size() - c.visible;
            let_go(c.visible);
        }
    }
    s.trailing = p * gap;
    return s;
}

#define UMBRA78_CLOCKED(Depth)                                                                \
    template Schedule schedule(std::span<const Depth>, std::uint32_t, int, int);              \
    template class ClockedPostProcess<Depth>;
UMBRA78_CLOCKED(hw::Depth16)
UMBRA78_CLOCKED(hw::Depth32)
#undef UMBRA78_CLOCKED

}  // namespace umbra78::shadow
