// Places: a view sampled where it is asked to be, and not at its pixels' centres
// (shadow/rivals/scan_out.md, the alias-free map in the machine's words).
//
// In: places within the frame, each for a pixel of another frame. Out: for each triangle of a leaf
// or of a facet that covers a place its depth there, by the rule that samples a pixel's centre
// (sampling.hpp, triangle.hpp), and the other frame's pixel as the sample's. The places lie in
// lists, one a pixel, in the caller's memory.
#pragma once

#include "hw/frame_store.hpp"
#include "raster/footprint.hpp"
#include "raster/sampling.hpp"
#include "raster/triangle.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace umbra78::raster {

struct Place {
    std::int32_t x, y;       // raster units from the middle of the frame
    std::uint16_t px, py;    // whose it is
    std::uint32_t next;      // of its list
};

struct PlaceCounts {
    std::uint64_t places = 0;
    std::uint64_t texels = 0;   // whose lists were read
    std::uint64_t visits = 0;   // of a place in such a list
};

class Places {
public:
    // `heads`: as many as the frame has pixels. `room`: as many as are added.
    Places(const hw::MachineSpec& spec, std::span<Place> room, std::span<std::uint32_t> heads)
        : room_(room), heads_(heads), half_(spec.half_px()) {
        const auto size = static_cast<std::size_t>(spec.size_px());
        fixed::require(heads.size() == size * size, "places: a list a pixel");
        std::fill(heads.begin(), heads.end(), none);
    }

    // Traps if there is no room, or the place is outside the frame.
    void add(std::int32_t x, std::int32_t y, int px, int py) {
        const auto at = static_cast<std::size_t>(counts_.places);
        fixed::require(at < room_.size(), "places: more than there is room for");
        const std::int32_t column = pixel_of(x), row = pixel_of(y), size = 2 * half_;
        fixed::require(column >= 0 && row >= 0 && column < size && row < size,
                       "places: outside the frame");
        std::uint32_t& head = heads_[list(column, row)];
        room_[at] = {x, y, static_cast<std::uint16_t>(px), static_cast<std::uint16_t>(py), head};
        head = static_cast<std::uint32_t>(at);
        ++counts_.places;
    }
    const PlaceCounts& counts() const { return counts_; }

    // Those in a box, its borders included. `visit` gets each, and returns nothing.
    template <class Visit>
    void in_box(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1, Visit&& visit) {
        const std::int64_t last = std::int64_t{half_} * pixel_units;  // a pixel beyond the frame
        const auto pixel = [&](std::int64_t v) {
            return pixel_of(static_cast<std::int32_t>(std::clamp(v, -last, last - 1)));
        };
        if (x1 < -last || x0 >= last || y1 < -last || y0 >= last) return;
        for (std::int32_t row = pixel(y0); row <= pixel(y1); ++row) {
            for (std::int32_t column = pixel(x0); column <= pixel(x1); ++column) {
                ++counts_.texels;
                for (std::uint32_t i = heads_[list(column, row)]; i != none; i = room_[i].next) {
                    const Place& p = room_[i];
                    ++counts_.visits;
                    if (p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1) visit(p);
                }
            }
        }
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    std::int32_t pixel_of(std::int32_t v) const {
        return fixed::floor_shift(v, raster_fraction) + half_;
    }
    std::size_t list(std::int32_t column, std::int32_t row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(2 * half_) +
               static_cast<std::size_t>(column);
    }

    std::span<Place> room_;
    std::span<std::uint32_t> heads_;
    PlaceCounts counts_;
    std::int32_t half_;
};

// Hands every sample of a block at the places to `emit`, as sample_centres does at the pixels'
// centres. Returns how many places lay in a leaf's box.
template <class Emit>
std::uint64_t sample_block_places(const Corners& g, Places& places, Emit&& emit) {
    std::uint64_t tested = 0;
    for (int j = 0; j < leaves; ++j) {
        for (int i = 0; i < leaves; ++i) {
            const Corner c00 = corner_at(g, i, j), c10 = corner_at(g, i + 1, j);
            const Corner c01 = corner_at(g, i, j + 1), c11 = corner_at(g, i + 1, j + 1);
            const auto [x0, x1] = std::minmax({c00.x, c10.x, c01.x, c11.x});
            const auto [y0, y1] = std::minmax({c00.y, c10.y, c01.y, c11.y});
            places.in_box(std::int64_t{x0} - slack, std::int64_t{x1} + slack,
                          std::int64_t{y0} - slack, std::int64_t{y1} + slack, [&](const Place& p) {
                ++tested;
                std::int64_t z = 0;
                if (triangle_depth(c00, c10, c11, p.x, p.y, z))
                    emit(Sample{p.px, p.py, p.x, p.y, z, i, j});
                if (triangle_depth(c00, c11, c01, p.x, p.y, z))
                    emit(Sample{p.px, p.py, p.x, p.y, z, i, j, true});
            });
        }
    }
    return tested;
}

// Hands every sample of a facet's triangle at the places to `emit`, as sample_triangle does at the
// pixels' centres. Returns how many places lay in its box.
template <class Emit>
std::uint64_t sample_triangle_places(Corner a, Corner b, Corner c, Places& places, Emit&& emit) {
    std::uint64_t tested = 0;
    std::int64_t area = detail::turn(a, b, c.x, c.y);
    if (area == 0) return 0;
    if (area < 0) {
        std::swap(b, c);
        area = -area;
    }
    detail::DepthPlane plane(a, b, c, area);
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    places.in_box(x0, x1, y0, y1, [&](const Place& p) {
        ++tested;
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
            if (detail::EdgeValue(from, to, p.x, p.y).value < 0) return;
        plane.start(p.x, p.y, false);
        emit(Sample{p.px, p.py, p.x, p.y, plane.z(), 0, 0});
    });
    return tested;
}

// A sink that has places samples its view there, and not at its pixels' centres.
template <class T>
concept HasPlaces = requires(T& sink) { sink.places; };

// The least code at each place, kept at the pixel whose it is.
template <class Depth>
struct PlaceSink {
    static constexpr bool shades = false;
    hw::FrameStore<Depth>& store;  // of the other frame
    Places& places;

    bool hidden(const Footprint&) const { return false; }
    void sample(const Sample& s, std::uint32_t code, const void*) {
        Depth& z = store.depth[store.address(s.px, s.py)];
        if (code < z) z = static_cast<Depth>(code);
    }
};

}  // namespace umbra78::raster
