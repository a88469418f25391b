// Edge dequantizing as a stream: boundary tracer, cascade of averages, and area by sub-rows.
#include "shadow/filters/dequantize.hpp"

#include "fixed/rounding.hpp"
#include "shadow/filters/filter_check.hpp"

#include <algorithm>
#include <array>

namespace umbra78::shadow {
namespace {

// Nodes are carried in 2^-12 pixel: two bits for each of six passes.
constexpr int node_fraction = 2 * max_dequantize_passes;
constexpr int sub_rows = 16;
constexpr std::int32_t sub_row = (1 << node_fraction) / sub_rows;

struct Node {
    std::int32_t x, y;
    bool pinned;
};

// A cascade of 1-2-1 averages: a node goes in, the node `passes` steps before it comes out.
class Smoother {
public:
    explicit Smoother(int passes) : passes_(passes) {}

    Node operator()(Node n) {
        for (int p = 0; p < passes_; ++p) {
            Stage& s = stage_[static_cast<std::size_t>(p)];
            const Node a = s.older, b = s.newer;
            s.older = b;
            s.newer = n;
            n = b.pinned ? b : Node{mean(a.x, b.x, n.x), mean(a.y, b.y, n.y), false};
        }
        return n;
    }

private:
    struct Stage {
        Node older{}, newer{};
    };
    // Exact: a pass-p node has 2 p fraction bits of the 12.
    static std::int32_t mean(std::int32_t a, std::int32_t b, std::int32_t c) {
        return fixed::floor_shift(a + 2 * b + c, 2);
    }
    int passes_;
    std::array<Stage, max_dequantize_passes> stage_{};
};

// floor(v / divisor) of a v that grows by the same step from sub-row to sub-row. divisor > 0.
struct Crossing {
    std::int64_t value, rest, step, step_rest, divisor;

    Crossing(std::int64_t v, std::int64_t grows, std::int64_t by)
        : value(fixed::round_divide(v, by, fixed::Rounding::floor)), rest(v - value * by),
          step(fixed::round_divide(grows, by, fixed::Rounding::floor)),
          step_rest(grows - step * by), divisor(by) {}
    void next() {
        value += step;
        rest += step_rest;
        if (rest < divisor) return;
        rest -= divisor;
        ++value;
    }
};

template <class Depth>
class Tracer {
public:
    Tracer(std::span<const std::uint8_t> mask, const hw::ReadOnlyStore<Depth>& observer,
           Depth background, int passes, EdgeMemory memory, const LineSet& lines)
        : mask_(mask), depth_(observer.depth), background_(background),
          size_(observer.size_px()), passes_(passes), memory_(memory), lines_(lines) {}

    // Before the chains are followed.
    void clear(const hw::Band& band) {
        const auto line_bits = static_cast<std::size_t>(size_);
        for (int y = band.first; y < band.end; ++y) {
            if (!lines_.has(y)) continue;
            std::fill_n(memory_.coverage.data() + y * (size_ + 2), size_ + 2, std::int16_t{0});
            // A line of 16 pixels has half a word: the next line's bits are cleared, too.
            std::fill_n(memory_.visited.data() + at(0, y) / 32, (line_bits + 31) / 32, 0u);
        }
    }

    std::uint64_t trace_all() {
        std::uint64_t steps = 0;
        for (int y = 0; y < size_; ++y)
            for (int x = 0; lines_.has(y) && x < size_; x += 8)
                if (may_have_upper_edge(x, y)) steps += trace_from(x, y);
        return steps;
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
               static_cast<std::size_t>(x);
    }
    // Whether one of eight pixels is in shadow under a lit one: a shadow is the byte's highest bit.
    bool may_have_upper_edge(int x, int y) const {
        std::uint64_t here = 0, above = 0;
        __builtin_memcpy(&here, mask_.data() + at(x, y), sizeof here);
        if (y > 0) __builtin_memcpy(&above, mask_.data() + at(x, y - 1), sizeof above);
        return (here & ~above & 0x8080808080808080) != 0;
    }
    std::uint64_t trace_from(int first, int y) {
        std::uint64_t steps = 0;
        for (int x = first; x < first + 8; ++x)
            if (shadow(x, y) && !shadow(x, y - 1) && !visited(x, y)) steps += trace(x, y);
        return steps;
    }
    bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < size_ && y < size_; }
    bool shadow(int x, int y) const { return inside(x, y) && mask_[at(x, y)] >= 128; }
    bool background(int x, int y) const { return !inside(x, y) || depth_[at(x, y)] == background_; }

    // A chain is known by the upper edges it runs along, eastward.
    bool visited(int x, int y) const {
        return (memory_.visited[at(x, y) / 32] >> (at(x, y) % 32) & 1u) != 0;
    }
    void visit(int x, int y) { memory_.visited[at(x, y) / 32] |= 1u << (at(x, y) % 32); }

    Node node(int x, int y) const {
        const bool pinned = background(x - 1, y - 1) || background(x, y - 1) ||
                            background(x - 1, y) || background(x, y);
        return {x << node_fraction, y << node_fraction, pinned};
    }

    struct Step {
        int x, y, direction;  // at corner (x, y), about to go 0 east, 1 south, 2 west, 3 north
    };

    // The pixels ahead on either hand of a step that starts at corner (x, y).
    bool ahead(const Step& s, bool right) const {
        constexpr std::array<std::array<int, 2>, 4> right_px{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
        constexpr std::array<std::array<int, 2>, 4> left_px{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
        const auto& d = (right ? right_px : left_px)[static_cast<std::size_t>(s.direction)];
        return shadow(s.x + d[0], s.y + d[1]);
    }

    Step advance(Step s) {
        constexpr std::array<int, 4> dx{1, 0, -1, 0}, dy{0, 1, 0, -1};
        if (s.direction == 0) visit(s.x, s.y);
        s.x += dx[static_cast<std::size_t>(s.direction)];
        s.y += dy[static_cast<std::size_t>(s.direction)];
        if (!ahead(s, true)) {
            s.direction = (s.direction + 1) & 3;  // round the pixel on the right
        } else if (ahead(s, false)) {
            s.direction = (s.direction + 3) & 3;
        }
        return s;
    }

    // Follows one chain once round, and `passes` nodes more at either end to fill the smoother.
    std::uint64_t trace(int x, int y) {
        const Step start{x, y, 0};
        Smoother smooth(passes_);
        Step s = start;
        std::int64_t length = -1, fed = 0;
        Node last{};
        while (length < 0 || fed <= length + 2 * passes_) {
            const Node n = smooth(node(s.x, s.y));
            if (fed > 2 * passes_) add_edge(last, n);
            last = n;
            ++fed;
            s = advance(s);
            if (length < 0 && s.x == start.x && s.y == start.y && s.direction == start.direction)
                length = fed;
        }
        return static_cast<std::uint64_t>(length);
    }

    // Coverage to the right of an edge, for the sub-rows whose middle it crosses.
    void add_edge(const Node& a, const Node& b) {
        if (a.y == b.y) return;
        const bool up = b.y < a.y;  // northward: the shadow begins to the right
        const Node& top = up ? b : a;
        const Node& end = up ? a : b;
        const std::int32_t first = (top.y + sub_row / 2 - 1) / sub_row;
        const std::int32_t last = (end.y + sub_row / 2 - 1) / sub_row;
        if (first >= last) return;
        const auto sign = static_cast<std::int16_t>(up ? 1 : -1);
        const std::int64_t along = first * sub_row + sub_row / 2 - top.y;
        Crossing crossing(along * (end.x - top.x), std::int64_t{sub_row} * (end.x - top.x),
                          end.y - top.y);
        for (std::int32_t r = first; r < last; ++r, crossing.next()) {
            const std::int64_t x = top.x + crossing.value;
            const std::int64_t step = (x + sub_row / 2) / sub_row;  // 1/16 pixel
            const auto part = static_cast<std::int16_t>(step % sub_rows);
            std::int16_t* cell = memory_.coverage.data() +
                                 (r / sub_rows) * (size_ + 2) + step / sub_rows;
            cell[0] = static_cast<std::int16_t>(cell[0] + sign * (sub_rows - part));
            cell[1] = static_cast<std::int16_t>(cell[1] + sign * part);
        }
    }

    std::span<const std::uint8_t> mask_;
    std::span<const Depth> depth_;
    Depth background_;
    int size_, passes_;
    EdgeMemory memory_;
    const LineSet& lines_;
};

// A line's coverage, summed from the left, as darkness. Eight pixels whose coverage does not
// change are of one darkness.
template <class Depth>
void fill_line(const std::int16_t* coverage, const Depth* depth, Depth background, int size,
               std::uint8_t* out) {
    int area = 0;  // of 256
    const auto darkness = [&] {
        const int covered = std::clamp(area, 0, 256);
        return static_cast<std::uint8_t>(fixed::floor_shift(covered * 255 + 128, 8));
    };
    const auto put = [&](int x, std::uint8_t dark) {
        out[x] = static_cast<std::uint8_t>(depth[x] == background ? 0 : dark);
    };
    for (int x = 0; x < size; x += 8) {
        std::uint64_t changes[2];
        __builtin_memcpy(changes, coverage + x, sizeof changes);
        if ((changes[0] | changes[1]) == 0) {
            const std::uint8_t dark = darkness();
            for (int k = 0; k < 8; ++k) put(x + k, dark);
            continue;
        }
        for (int k = 0; k < 8; ++k) {
            area += coverage[x + k];
            put(x + k, darkness());
        }
    }
}

}  // namespace

template <class Depth>
std::uint64_t dequantize(std::span<const std::uint8_t> mask,
                         const hw::ReadOnlyStore<Depth>& observer, Depth background, int passes,
                         EdgeMemory memory, std::span<std::uint8_t> out, const LineSet& lines,
                         const Executor& executor) {
    check_filter(mask, observer, out, lines);
    fixed::require(passes >= 0 && passes <= max_dequantize_passes, "dequantize: 0 to 6 passes");
    const std::size_t visited = edge_visited_words(observer.xy_bits);
    const std::size_t coverage = edge_coverage_words(observer.xy_bits);
    fixed::require(memory.visited.size() >= visited && memory.coverage.size() >= coverage,
                   "dequantize: its memory is too small for the frame");
    memory = {memory.visited.first(visited), memory.coverage.first(coverage)};
    Tracer<Depth> tracer(mask, observer, background, passes, memory, lines);
    const int size = observer.size_px();
    for_bands(executor, size, [&](hw::Band band, std::size_t) { tracer.clear(band); });
    const std::uint64_t steps = tracer.trace_all();
    for_bands(executor, size, [&](hw::Band band, std::size_t) {
        for (int y = band.first; y < band.end; ++y) {
            if (!lines.has(y)) continue;
            const std::size_t a = observer.address(0, y);
            fill_line(memory.coverage.data() + y * (size + 2), observer.depth.data() + a,
                      background, size, out.data() + a);
        }
    });
    return steps;
}

template std::uint64_t dequantize(std::span<const std::uint8_t>,
                                  const hw::ReadOnlyStore<hw::Depth16>&, hw::Depth16, int,
                                  EdgeMemory, std::span<std::uint8_t>, const LineSet&,
                                  const Executor&);
template std::uint64_t dequantize(std::span<const std::uint8_t>,
                                  const hw::ReadOnlyStore<hw::Depth32>&, hw::Depth32, int,
                                  EdgeMemory, std::span<std::uint8_t>, const LineSet&,
                                  const Executor&);

}  // namespace umbra78::shadow
