// An independent model of edge dequantizing: chains are stored, nodes are exact fractions, area
// is counted cell by cell. Slow, and shares nothing with shadow/filters/dequantize.cpp.
//
//   1. Every pixel in shadow has four directed sides, itself on the right hand; those shared by
//      two pixels cancel. The rest is linked to chains; where two sides leave one corner, the one
//      that stays with the same pixel is taken.
//   2. A pass replaces every free node by (previous + 2 node + next) / 4, all at once.
//   3. Sub-row r of a picture row counts the sixteenths of a pixel that lie to the right of the
//      chain at height (r + 1/2) / 16: a crossing is rounded half up to a sixteenth.
#pragma once

#include "fixed/rational.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace umbra78::shadow::test {

using fixed::Rational;

struct SlowNode {
    Rational x, y;
    bool pinned;
};
using SlowChain = std::vector<SlowNode>;
using PixelTest = std::function<bool(int x, int y)>;

// `shadow` and `background` are asked inside the frame only.
inline std::vector<SlowChain> slow_chains(int size, const PixelTest& shadow,
                                          const PixelTest& background) {
    const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < size && y < size; };
    const auto dark = [&](int x, int y) { return inside(x, y) && shadow(x, y); };
    const auto none = [&](int x, int y) { return !inside(x, y) || background(x, y); };
    struct Side {
        int x, y;       // its end
        int pixel;      // the pixel it belongs to
    };
    std::multimap<std::pair<int, int>, Side> from;  // by its start
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (!dark(x, y)) continue;
            const int pixel = y * size + x;
            if (!dark(x, y - 1)) from.insert({{x, y}, {x + 1, y, pixel}});
            if (!dark(x + 1, y)) from.insert({{x + 1, y}, {x + 1, y + 1, pixel}});
            if (!dark(x, y + 1)) from.insert({{x + 1, y + 1}, {x, y + 1, pixel}});
            if (!dark(x - 1, y)) from.insert({{x, y + 1}, {x, y, pixel}});
        }
    std::vector<SlowChain> chains;
    while (!from.empty()) {
        SlowChain chain;
        auto at = from.begin();
        const std::pair<int, int> start = at->first;
        while (true) {
            const auto [x, y] = at->first;
            chain.push_back({x, y, none(x - 1, y - 1) || none(x, y - 1) || none(x - 1, y) ||
                                       none(x, y)});
            const Side side = at->second;
            from.erase(at);
            const std::pair<int, int> corner{side.x, side.y};
            auto [first, last] = from.equal_range(corner);
            if (first == last) {
                if (corner != start) chain.clear();  // cannot be: sides always close
                break;
            }
            at = first;
            for (auto k = first; k != last; ++k)
                if (k->second.pixel == side.pixel) at = k;
            // Back at the start, from the pixel that the chain began with: closed.
            if (corner == start && at->second.pixel != side.pixel) break;
        }
        chains.push_back(chain);
    }
    return chains;
}

inline SlowChain slow_smooth(SlowChain chain, int passes) {
    const std::size_t n = chain.size();
    for (int pass = 0; pass < passes; ++pass) {
        const SlowChain old = chain;
        for (std::size_t k = 0; k < n; ++k) {
            if (old[k].pinned) continue;
            const SlowNode &a = old[(k + n - 1) % n], &b = old[k], &c = old[(k + 1) % n];
            chain[k].x = (a.x + b.x + b.x + c.x) / Rational(4);
            chain[k].y = (a.y + b.y + b.y + c.y) / Rational(4);
        }
    }
    return chain;
}

// The exact area to the right of a chain, in pixels: the shoelace formula (y runs down).
inline Rational slow_area(const SlowChain& chain) {
    Rational twice;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const SlowNode &a = chain[k], &b = chain[(k + 1) % chain.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / Rational(2);
}

// Coverage of each pixel in 256ths, clamped, before the background is taken out.
inline std::vector<int> slow_coverage(int size, const std::vector<SlowChain>& chains) {
    const auto cells = static_cast<std::size_t>(16 * size);
    // winding[r][c]: how often the sixteenth c of sub-row r is enclosed.
    std::vector<std::vector<int>> winding(cells, std::vector<int>(cells));
    for (const SlowChain& chain : chains)
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const SlowNode &a = chain[k], &b = chain[(k + 1) % chain.size()];
            if (a.y == b.y) continue;
            const bool up = b.y < a.y;
            const Rational top = up ? b.y : a.y, end = up ? a.y : b.y;
            std::int64_t first = 0;
            (top - Rational(1)).round_scaled(4, fixed::Rounding::floor, first);
            for (auto r = static_cast<std::size_t>(std::max<std::int64_t>(first, 0)); r < cells;
                 ++r) {
                const Rational middle(2 * static_cast<std::int64_t>(r) + 1, 32);
                if (middle < top) continue;
                if (middle >= end) break;
                std::int64_t x = 0;
                (a.x + (middle - a.y) * (b.x - a.x) / (b.y - a.y))
                    .round_scaled(4, fixed::Rounding::half_up, x);
                for (auto c = static_cast<std::size_t>(x); c < cells; ++c)
                    winding[r][c] += up ? 1 : -1;
            }
        }
    std::vector<int> out(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (std::size_t r = 0; r < cells; ++r)
        for (std::size_t c = 0; c < cells; ++c)
            out[r / 16 * static_cast<std::size_t>(size) + c / 16] += winding[r][c];
    for (int& area : out) area = std::clamp(area, 0, 256);
    return out;
}

}  // namespace umbra78::shadow::test
