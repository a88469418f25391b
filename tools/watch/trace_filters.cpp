// The filters' and the composite's words: what happens to a pixel's mask after the post-process.
#include "tools/watch/trace_units.hpp"

#include "shadow/filters/composite.hpp"
#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/frame/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace umbra78::tools {
namespace {

struct TracedPixel {
    const WatchedFrame& frame;
    int x, y;

    const hw::FrameStore<hw::Depth32>& store() const { return frame.observer(); }
    std::size_t address() const { return store().address(x, y); }
    std::uint32_t background() const { return frame.settings().machine.background(); }
};

void expect_equal(std::string_view what, int computed, int buffer) {
    if (computed != buffer)
        throw std::logic_error(fmt::format("{}: {} by the formula, {} in the frame's buffer", what,
                                           computed, buffer));
}

// The shadow's area in a pixel is a running sum along the row, so the filter is run again.
void trace_dequantize(TraceLog& log, const TracedPixel& at, const RenderJob& job) {
    const shadow::Settings& s = at.frame.settings();
    const int bits = s.machine.xy_bits, size = s.machine.size_px();
    std::vector<std::uint32_t> visited(shadow::edge_visited_words(bits));
    std::vector<std::int16_t> coverage(shadow::edge_coverage_words(bits));
    std::vector<std::uint8_t> out(job.bytes(Plane::mask).size());
    shadow::dequantize<hw::Depth32>(job.bytes(Plane::mask), at.store(), at.background(),
                                    s.dequantize_passes, {visited, coverage}, out);
    int sum = 0;
    for (int x = 0; x <= at.x; ++x)
        sum += coverage[static_cast<std::size_t>(at.y * (size + 2) + x)];
    log.word("coverage", signed_word(sum, 16, 8), "the running sum along the row");
    log.word("a", unsigned_word(std::clamp(sum, 0, 256), 9, 8), "the area in shadow: 0 .. 256");
    log.word("edges", unsigned_word(job.bytes(Plane::edges)[at.address()], 8),
             "(255 a + 128) >> 8");
    expect_equal("edges", out[at.address()], job.bytes(Plane::edges)[at.address()]);
}

// One pass at the pixel: nine words, their sum, the result.
void trace_low_pass(TraceLog& log, const TracedPixel& at, const std::vector<std::uint8_t>& in,
                    int out) {
    constexpr const char* names[3][3] = {{"nw", "n", "ne"}, {"w", "self", "e"}, {"sw", "s", "se"}};
    const int size = at.store().size_px();
    int sum = 8;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int x = at.x + dx, y = at.y + dy;
            const bool beyond = x < 0 || y < 0 || x >= size || y >= size;
            const bool none = beyond || at.store().depth[at.store().address(x, y)] ==
                                            at.background();
            const int value = in[none ? at.address() : at.store().address(x, y)];
            const int weight = shadow::low_pass_weight(dx, dy);
            log.word(names[dy + 1][dx + 1], unsigned_word(value, 8),
                     fmt::format("times {}{}", weight,
                                 beyond ? "; beyond the frame: the pixel's own"
                                 : none ? "; background: the pixel's own" : ""));
            sum += weight * value;
        }
    }
    log.word("sum", unsigned_word(sum, 13), "8 + the nine");
    log.word("filtered", unsigned_word(out, 8), "sum >> 4");
    expect_equal("low-pass", sum >> 4, out);
}

void trace_low_passes(TraceLog& log, const TracedPixel& at, const RenderJob& job) {
    const std::span<const std::uint8_t> edges = job.bytes(Plane::edges);
    std::vector<std::uint8_t> in(edges.begin(), edges.end()), out(in.size());
    const int passes = at.frame.settings().low_pass_passes;
    for (int pass = 1; pass <= passes; ++pass) {
        shadow::low_pass<hw::Depth32>(in, at.store(), at.background(), out);
        if (passes > 1) log.say(fmt::format("pass {} of {}", pass, passes));
        trace_low_pass(log, at, in, out[at.address()]);
        in.swap(out);
    }
    expect_equal("filtered", in[at.address()], job.bytes(Plane::filtered)[at.address()]);
}

void trace_composite(TraceLog& log, const TracedPixel& at, const RenderJob& job) {
    const int intensity = job.bytes(Plane::intensity)[at.address()];
    const int mask = job.bytes(Plane::filtered)[at.address()];
    const int density = at.frame.settings().density_q8;
    const bool whole = at.frame.settings().composite == shadow::Composite::whole;
    const int share = whole ? intensity : job.bytes(Plane::direct)[at.address()];
    const std::int64_t taken = std::int64_t{share} * mask * density;
    log.word("I", unsigned_word(intensity, 8), "the observer's intensity");
    log.word("P", unsigned_word(share, 8),
             whole ? "all of it is darkened" : "the light's direct share of it");
    log.word("m", unsigned_word(mask, 8), "the filtered mask");
    log.word("d", unsigned_word(density, 9, 8), "the shadow's density");
    log.word("P m d", unsigned_word(taken, 24), "what the shadow takes away, of 65280 I");
    const int picture = job.bytes(Plane::picture)[at.address()];
    log.word("picture", unsigned_word(picture, 8), "half_up of (65280 I - P m d) / 65280");
    expect_equal("picture",
                 shadow::composite(static_cast<std::uint8_t>(intensity),
                                   static_cast<std::uint8_t>(share),
                                   static_cast<std::uint8_t>(mask), density),
                 picture);
}

}  // namespace

void trace_filters(TraceLog& log, const WatchedFrame& frame, const RenderJob& job, int x, int y) {
    const TracedPixel at{frame, x, y};
    const bool none = frame.observer().depth[at.address()] == at.background();
    log.at("dequantize");
    if (none) {
        log.say("background stays 0 in every filter");
    } else if (frame.settings().dequantize_passes == 0) {
        log.say("left out: edges = mask");
    } else if (shadow::method_of(job.inputs()).darkness == shadow::Darkness::graded) {
        log.say("left out, for a graded mask has no edge to follow: edges = mask");
    } else {
        trace_dequantize(log, at, job);
    }
    if (!none) log.at("low-pass");
    if (!none && frame.settings().low_pass_passes == 0) log.say("left out: filtered = edges");
    if (!none) trace_low_passes(log, at, job);
    log.at("composite");
    trace_composite(log, at, job);
}

}  // namespace umbra78::tools
