// Worst errors of the lookup and the filters, by the production code.
#include "shadow/filters/composite.hpp"
#include "shadow/filters/dequantize.hpp"
#include "shadow/filters/low_pass.hpp"
#include "shadow/filters/ramp.hpp"
#include "shadow/light_place.hpp"
#include "shadow/window.hpp"
#include "tests/proofs/search.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::proofs {
namespace {

void low_passes(Words& words) {
    Worst worst("low_pass");
    constexpr int size = 16;
    std::array<hw::Depth16, size * size> depth{};
    std::array<std::uint8_t, size * size> mask{}, out{};
    const hw::ReadOnlyStore<hw::Depth16> store{4, depth};
    for (int k = 0; k < 300; ++k) {
        for (std::uint8_t& m : mask) m = static_cast<std::uint8_t>(words.number(0, 255));
        shadow::low_pass<hw::Depth16>(mask, store, 65535, out);
        for (int y = 1; y < size - 1; ++y)
            for (int x = 1; x < size - 1; ++x) {
                Given in;
                int sum = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int m = mask[std::size_t(size * (y + dy) + x + dx)];
                        sum += shadow::low_pass_weight(dx, dy) * m;
                        in.push_back(m);
                    }
                worst.add(ratio(out[std::size_t(size * y + x)] * 16 - sum, 16), in);
            }
    }
}

void composites() {
    Worst worst("composite");
    for (int share = 0; share < 256; share += 3)
        for (int mask = 0; mask < 256; ++mask)
            for (int density = 0; density <= 256; ++density) {
                const int out = shadow::composite(255, static_cast<std::uint8_t>(share),
                                                  static_cast<std::uint8_t>(mask), density);
                worst.add(ratio(out * 65280 - (255 * 65280 - share * mask * density), 65280),
                          {255, share, mask, density});
            }
}

void ramps() {
    for (int width = 2; width <= shadow::max_ramp_px; ++width) {
        Worst worst("ramp_" + std::to_string(width));
        for (int squares = 0; squares < width * width; ++squares) {
            const long double exact =
                255 * (1 - std::sqrt(static_cast<long double>(squares)) / width);
            worst.add(static_cast<double>(shadow::ramp_darkness(squares, width) - exact),
                      {squares});
        }
    }
}

void lookups(Words& words) {
    Worst share("percentage"), blend("bilinear");
    for (int side = 2; side <= 5; ++side)
        for (int count = 0; count <= side * side; ++count)
            share.add(ratio(shadow::share_of_dark(count, {side, false}) * side * side -
                                255 * count, side * side), {count, side});
    const hw::MachineSpec spec;
    for (int k = 0; k < 100'000; ++k) {
        const auto code = [&] { return static_cast<std::uint32_t>(words.number(0, 65535)); };
        const shadow::FourCodes z{code(), code(), code(), code()};
        const int fx = words.number(0, 127), fy = words.number(0, 127);
        const Wide exact = Wide{128 - fy} * ((128 - fx) * Wide{z[0]} + fx * Wide{z[1]}) +
                           Wide{fy} * ((128 - fx) * Wide{z[2]} + fx * Wide{z[3]});
        blend.add(ratio(shadow::blend_of(spec, fx, fy, z).z - exact, 1),
                  {fx, fy, z[0], z[1], z[2], z[3]});
    }
}

// --- edges: a shadow with a random left side, whose other side is straight -----------------------

constexpr int edge_bits = 5, edge_size = 1 << edge_bits;
constexpr int edge_top = 2, edge_end = 30, edge_right = 26;

struct Place {
    Wide x, y;
};

// Its nodes from (edge_right, edge_end) round by the left side, smoothed, in 2^-12 pixel.
std::vector<Place> smoothed_nodes(const std::array<int, edge_size>& left, int passes) {
    std::vector<Place> chain;
    for (int x = edge_right; x > left[edge_end - 1]; --x) chain.push_back({x, edge_end});
    for (int y = edge_end - 1; y >= edge_top; --y) {
        const int x = left[std::size_t(y)], next = y > edge_top ? left[std::size_t(y - 1)] : x;
        chain.push_back({x, y + 1});
        for (int at = x; at != next; at += at < next ? 1 : -1) chain.push_back({at, y});
    }
    for (int x = left[edge_top]; x < edge_right; ++x) chain.push_back({x, edge_top});
    for (int y = edge_top; y < edge_end; ++y) chain.push_back({edge_right, y});
    for (Place& p : chain) p = {p.x << 12, p.y << 12};
    for (int pass = 0; pass < passes; ++pass) {
        const std::vector<Place> was = chain;
        const std::size_t n = was.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Place &a = was[(k + n - 1) % n], &b = was[k], &c = was[(k + 1) % n];
            chain[k] = {(a.x + 2 * b.x + c.x) / 4, (a.y + 2 * b.y + c.y) / 4};
        }
    }
    return chain;
}

// Where the left side, which goes up, crosses the middle of a sub-row, in 1/16 pixel.
double exact_crossing(const std::vector<Place>& chain, int sub_row) {
    const Wide middle = sub_row * 256 + 128;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const Place &a = chain[k], &b = chain[(k + 1) % chain.size()];
        if (b.y <= middle && middle < a.y)
            return ratio(b.x * (a.y - b.y) + (middle - b.y) * (a.x - b.x), 256 * (a.y - b.y));
    }
    return 0;
}

// A line's coverage times its places is the sum of its crossings.
void edges(Words& words) {
    Worst crossing("edge_crossing"), level("edge_level");
    std::vector<hw::Depth16> depth(edge_size * edge_size);
    const hw::ReadOnlyStore<hw::Depth16> store{edge_bits, depth};
    std::vector<std::uint32_t> visited(shadow::edge_visited_words(edge_bits));
    std::vector<std::int16_t> coverage(shadow::edge_coverage_words(edge_bits));
    for (int k = 0; k < 4'000; ++k) {
        std::array<int, edge_size> left{};
        const int passes = words.number(3, 6);
        int x = words.number(8, 16);
        for (int y = edge_top; y < edge_end; ++y) {
            if (words.number(0, 3) == 0) x = std::clamp(x + words.number(-1, 1), 6, 18);
            left[std::size_t(y)] = x;
        }
        std::vector<std::uint8_t> mask(depth.size()), out(depth.size());
        for (int y = edge_top; y < edge_end; ++y)
            for (int at = left[std::size_t(y)]; at < edge_right; ++at)
                mask[std::size_t(edge_size * y + at)] = 255;
        shadow::dequantize<hw::Depth16>(mask, store, 65535, passes, {visited, coverage}, out);
        const std::vector<Place> chain = smoothed_nodes(left, passes);
        for (int y = edge_top + 8; y < edge_end - 8; ++y) {
            const std::int16_t* cell = coverage.data() + y * (edge_size + 2);
            double sum = 0;
            int area = 0;
            for (int at = 0; at < edge_size; ++at) {
                sum += at * cell[at];
                area += cell[at];
                level.add(ratio(out[std::size_t(edge_size * y + at)] * 256 - area * 255, 256),
                          {area});
            }
            sum += 16 * 16 * edge_right;
            for (int r = 0; r < 16; ++r) sum -= exact_crossing(chain, 16 * y + r);
            Given in{passes};
            for (int at = y - 6; at <= y + 6; ++at) in.push_back(left[std::size_t(at)]);
            crossing.add(sum / 16, in);
        }
    }
}

}  // namespace

void filter_errors() {
    Words words;
    low_passes(words);
    composites();
    ramps();
    lookups(words);
    edges(words);
}

}  // namespace umbra78::proofs
