// Edge dequantizing: the boundary's tracer, and what its area makes of a line. What becomes of the
// traced nodes is in edge_nodes.hpp.
#include "shadow/filters/dequantize.hpp"

#include "fixed/rounding.hpp"
#include "shadow/filters/edge_nodes.hpp"
#include "shadow/filters/filter_check.hpp"

#include <algorithm>
#include <array>

namespace umbra78::shadow {
namespace {

// Where a chain goes on that comes to a corner in a direction, 0 east, 1 south, 2 west, 3 north: by
// the direction, and by which of the corner's pixels are in shadow. The shadow stays on the right;
// where two shadows touch at the corner alone, it stays with the same pixel.
constexpr std::array<std::array<std::uint8_t, 16>, 4> turns = [] {
    // North-west, north-east, south-west, south-east: the bit of the pixel ahead on either hand.
    constexpr std::array<unsigned, 4> right{8, 4, 1, 2}, left{2, 8, 4, 1};
    std::array<std::array<std::uint8_t, 16>, 4> all{};
    for (unsigned direction = 0; direction < 4; ++direction)
        for (unsigned shadows = 0; shadows < 16; ++shadows) {
            unsigned next = direction;
            if ((shadows & right[direction]) == 0)
                next = direction + 1;  // round the pixel on the right
            else if ((shadows & left[direction]) != 0)
                next = direction + 3;
            all[direction][shadows] = static_cast<std::uint8_t>(next & 3);
        }
    return all;
}();

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
        for (int y = 0; y < size_; ++y) {
            if (!lines_.has(y)) continue;
            const std::uint8_t* line = mask_.data() + at(0, y);
            const std::uint8_t* above = y > 0 ? line - size_ : line;
            const std::uint64_t lit = y > 0 ? 0 : ~std::uint64_t{0};  // above the frame
            const int block = std::min(size_, 64);
            for (int first = 0; first < size_; first += block) {
                if (!has_upper_edge(line + first, above + first, lit, block)) continue;
                for (int x = first; x < first + block; x += 8)
                    if (has_upper_edge(line + x, above + x, lit, 8)) steps += trace_from(x, y);
            }
        }
        return steps;
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
               static_cast<std::size_t>(x);
    }
    // Whether one of `count` pixels, a multiple of eight, is in shadow under a lit one: a shadow is
    // the byte's highest bit.
    static bool has_upper_edge(const std::uint8_t* line, const std::uint8_t* above,
                               std::uint64_t lit, int count) {
        std::uint64_t any = 0;
        for (int x = 0; x < count; x += 8) {
            std::uint64_t here = 0, upper = 0;
            __builtin_memcpy(&here, line + x, sizeof here);
            __builtin_memcpy(&upper, above + x, sizeof upper);
            any |= here & (~upper | lit);
        }
        return (any & 0x8080808080808080) != 0;
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

    // The four pixels that meet at a corner: which are in shadow, a bit each in the order
    // north-west, north-east, south-west, south-east, and whether one is background.
    struct Corner {
        unsigned shadows;
        bool pinned;
    };
    // `place` is the corner's south-eastern pixel in the frame, if it is in it.
    Corner corner(int x, int y, std::ptrdiff_t place) const {
        if (x > 0 && y > 0 && x < size_ && y < size_) {
            const std::uint8_t* m = mask_.data() + place;
            const Depth* z = depth_.data() + place;
            const auto bit = [](std::uint8_t value, int k) { return (value >> 7 & 1u) << k; };
            return {bit(m[-size_ - 1], 0) | bit(m[-size_], 1) | bit(m[-1], 2) | bit(m[0], 3),
                    ((z[-size_ - 1] == background_) | (z[-size_] == background_) |
                     (z[-1] == background_) | (z[0] == background_)) != 0};
        }
        return {(shadow(x - 1, y - 1) ? 1u : 0u) | (shadow(x, y - 1) ? 2u : 0u) |
                    (shadow(x - 1, y) ? 4u : 0u) | (shadow(x, y) ? 8u : 0u),
                background(x - 1, y - 1) || background(x, y - 1) || background(x - 1, y) ||
                    background(x, y)};
    }

    // Follows one chain once round, and `passes` nodes more at either end to fill the smoother.
    std::uint64_t trace(const int first_x, const int first_y) {
        constexpr std::array<int, 4> dx{1, 0, -1, 0}, dy{0, 1, 0, -1};
        const std::array<std::ptrdiff_t, 4> next{1, size_, -1, -size_};
        EdgeNodes nodes(passes_, memory_.coverage, size_);
        int x = first_x, y = first_y;
        auto place = static_cast<std::ptrdiff_t>(at(x, y));
        unsigned direction = 0;
        bool pinned = corner(x, y, place).pinned;
        std::int64_t length = -1;
        for (std::int64_t fed = 0; length < 0 || fed <= length + 2 * passes_;) {
            nodes.add(x, y, pinned);
            ++fed;
            if (direction == 0) visit(x, y);
            x += dx[direction];
            y += dy[direction];
            place += next[direction];
            const Corner here = corner(x, y, place);
            pinned = here.pinned;
            direction = turns[direction][here.shadows];
            if (length < 0 && x == first_x && y == first_y && direction == 0) length = fed;
        }
        nodes.end();
        return static_cast<std::uint64_t>(length);
    }

    std::span<const std::uint8_t> mask_;
    std::span<const Depth> depth_;
    Depth background_;
    int size_, passes_;
    EdgeMemory memory_;
    const LineSet& lines_;
};

// A line's coverage, summed from the left, as darkness. Eight pixels whose coverage does not
// change are of one darkness. What is background is taken out in a loop of its own, which lanes do.
template <class Depth>
void fill_line(const std::int16_t* __restrict coverage, const Depth* __restrict depth,
               Depth background, int size, std::uint8_t* __restrict out) {
    int area = 0;  // of 256
    std::uint8_t dark = 0;
    for (int x = 0; x < size; x += 8) {
        std::uint64_t changes[2];
        __builtin_memcpy(changes, coverage + x, sizeof changes);
        if ((changes[0] | changes[1]) == 0) {
            const std::uint64_t all = dark * std::uint64_t{0x0101010101010101};
            __builtin_memcpy(out + x, &all, sizeof all);
            continue;
        }
        for (int k = x; k < x + 8; ++k) {
            area += coverage[k];
            const int covered = std::clamp(area, 0, 256);
            dark = static_cast<std::uint8_t>(fixed::floor_shift(covered * 255 + 128, 8));
            out[k] = dark;
        }
    }
    for (int x = 0; x < size; ++x)
        out[x] = static_cast<std::uint8_t>(out[x] & (depth[x] == background ? 0 : 255));
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
