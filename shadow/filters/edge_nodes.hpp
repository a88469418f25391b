// The nodes of a shadow's boundary on their way from the tracer to the area: a block of them at a
// time is smoothed, and what lies right of the smoothed edges is added to the coverage. No chain is
// ever stored whole.
#pragma once

#include "shadow/filters/dequantize.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

class EdgeNodes {
public:
    EdgeNodes(int passes, std::span<std::int16_t> coverage, int size_px)
        : passes_(passes), coverage_(coverage), pitch_(size_px + 2) {}

    // The next corner of the chain, in pixels. The first and the last `passes` fill the smoother.
    void add(int x, int y, bool pinned) {
        if (held_ == most) smooth_and_count();
        const auto k = static_cast<std::size_t>(held_++);
        x_[k] = static_cast<std::uint32_t>(x) << node_fraction;
        y_[k] = static_cast<std::uint32_t>(y) << node_fraction;
        kept_[k] = pinned ? ~0u : 0u;
    }
    void end() { smooth_and_count(); }

private:
    // Nodes are carried in 2^-12 pixel: two bits for each of six passes, so averages are exact.
    static constexpr int node_fraction = 2 * max_dequantize_passes;
    static constexpr int sub_rows = 16;
    static constexpr int sub_row = (1 << node_fraction) / sub_rows;
    static constexpr int most = 128;
    using Words = std::array<std::uint32_t, most>;

    // Each pass loses a node at either end. Returns where the result is.
    const Words& smooth(const Words& nodes, Words& a, Words& b) const {
        const Words* from = &nodes;
        for (int lost = 1; lost <= passes_; ++lost) {
            Words& to = lost % 2 == 0 ? a : b;
            average(*from, kept_, lost, held_ - lost, to);
            from = &to;
        }
        return *from;
    }
    static void average(const Words& from, const Words& kept, int first, int end, Words& to) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(end); ++k) {
            const std::uint32_t mean = (from[k - 1] + 2 * from[k] + from[k + 1]) >> 2;
            to[k] = (from[k] & kept[k]) | (mean & ~kept[k]);  // a pinned node stays
        }
    }

    // What the next block needs is kept: the last node that has all its passes, where the next edge
    // begins, and those that it depends on.
    void smooth_and_count() {
        const int needed = 2 * passes_ + 1;
        if (held_ <= needed) return;
        Words xs[2], ys[2];
        const Words &x = smooth(x_, xs[0], xs[1]), &y = smooth(y_, ys[0], ys[1]);
        const auto end = static_cast<std::size_t>(held_ - passes_);
        for (auto k = static_cast<std::size_t>(passes_); k + 1 < end; ++k)
            add_edge(static_cast<int>(x[k]), static_cast<int>(y[k]), static_cast<int>(x[k + 1]),
                     static_cast<int>(y[k + 1]));
        for (Words* words : {&x_, &y_, &kept_})
            std::copy(words->begin() + held_ - needed, words->begin() + held_, words->begin());
        held_ = needed;
    }

    // Coverage to the right of an edge, for the sub-rows whose middle it crosses. An edge begins as
    // one pixel long, and no pass makes it longer in either direction (tests/PROOFS.md,
    // edge_length_32).
    void add_edge(int ax, int ay, int bx, int by) {
        if (ay == by) return;
        const bool up = by < ay;  // northward: the shadow begins to the right
        const int top_x = up ? bx : ax, top_y = up ? by : ay;
        const int end_x = up ? ax : bx, end_y = up ? ay : by;
        int row = sub_row_after(top_y);
        const int last = sub_row_after(end_y);
        if (row >= last) return;
        const int down = end_y - top_y, across = end_x - top_x;
        const int along = row * sub_row + sub_row / 2 - top_y;  // less than `down`
        Quotient crossing = floor(along * across, down);
        const Quotient step = row + 1 < last ? floor(sub_row * across, down) : Quotient{};
        Crossed crossed;
        for (; row < last; ++row) {
            const int middle = top_x + crossing.value + sub_row / 2;
            const unsigned x = static_cast<unsigned>(middle) / sub_row;  // in sixteenths
            const int cell = row / sub_rows * pitch_ + static_cast<int>(x / sub_rows);
            if (cell != crossed.cell) {
                put(crossed, up);
                crossed = {cell};
            }
            crossed.rows += 1;
            crossed.sixteenths += static_cast<int>(x % sub_rows);
            crossing.value += step.value;
            crossing.rest += step.rest;
            if (crossing.rest >= down) {
                crossing.rest -= down;
                ++crossing.value;
            }
        }
        put(crossed, up);
    }
    static int sub_row_after(int y) {
        return static_cast<int>(static_cast<unsigned>(y + sub_row / 2 - 1) / sub_row);
    }
    struct Quotient {
        int value, rest;
    };
    // Of |v| up to a pixel times the divisor: what an edge goes across on a part of its way down.
    static Quotient floor(int v, int divisor) {
        constexpr int pixel = 1 << node_fraction;
        const auto from_left = static_cast<unsigned>(v + pixel * divisor);
        const auto value = static_cast<int>(from_left / static_cast<unsigned>(divisor));
        return {value - pixel, static_cast<int>(from_left) - value * divisor};
    }

    // Sub-rows that cross the same pixel: each covers it from so many sixteenths on, and what is to
    // its right.
    struct Crossed {
        int cell = 0, rows = 0, sixteenths = 0;
    };
    void put(const Crossed& crossed, bool up) {
        const int right = up ? crossed.sixteenths : -crossed.sixteenths;
        const int all = up ? sub_rows * crossed.rows : -sub_rows * crossed.rows;
        std::int16_t* cell = coverage_.data() + crossed.cell;
        cell[0] = static_cast<std::int16_t>(cell[0] + all - right);
        cell[1] = static_cast<std::int16_t>(cell[1] + right);
    }

    int passes_;
    std::span<std::int16_t> coverage_;
    int pitch_;
    int held_ = 0;
    Words x_, y_, kept_;
};

}  // namespace umbra78::shadow
