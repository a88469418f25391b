// How dark a pixel of the observer's frame is, by the receiver that is set: its own point, its
// plane (shadow/receiver.hpp) or its point moved along its normal (shadow/normal_offset.hpp),
// either by its neighbours or by the normal that is kept of it (shadow/kept_normal.hpp).
//
// Both forms of the post-process call this (shadow/post_process.cpp, shadow/sectors.cpp), each with
// its own unit, which takes words to results.
#pragma once

#include "shadow/kept_normal.hpp"
#include "shadow/pixel_walk.hpp"

#include <cstdint>
#include <optional>

namespace umbra78::shadow {

// The results of the neighbours of which a pixel's surface is taken, and how they follow one
// another (moved_along_normal()).
struct Neighbours {
    hw::Point beside, below;
    int turn;
};

template <class Depth, class Transform>
std::optional<Neighbours> neighbours_of(const hw::FrameStore<const Depth>& observer,
                                        const Transform& transform, const ShadowTest& test,
                                        const WalkedPixel& pixel) {
    int beside_x = 0, beside_y = 0, below_x = 0, below_y = 0;
    const std::uint32_t none = test.machine.background();
    if (!nearer_neighbour(observer, none, pixel.x, pixel.y, 1, 0, beside_x, beside_y) ||
        !nearer_neighbour(observer, none, pixel.x, pixel.y, 0, 1, below_x, below_y))
        return {};
    const auto result = [&](int px, int py) {
        return transform(pixel_words(px, py, observer.depth[observer.address(px, py)], test));
    };
    return Neighbours{result(beside_x, beside_y), result(below_x, below_y),
                      (beside_x - pixel.x) * (below_y - pixel.y)};
}

template <class Depth>
void check_normals(const hw::FrameStore<const Depth>& observer, const ShadowTest& test) {
    fixed::require(!reads_normals(test) || observer.keeps_normals(),
                   "shadow test: the observer's store keeps no normals");
}

// Of a pixel whose results are `p`, with the normal that is kept of it.
template <class Depth>
std::uint8_t darkness_by_normal(const LightMap<Depth>& map,
                                const hw::FrameStore<const Depth>& observer, const ShadowTest& test,
                                const WalkedPixel& at, const hw::Point& p,
                                const ReceiverWords& receiver) {
    const LightNormal m = kept_normal(observer, at.address, receiver.axes);
    const int fraction = test.machine.fraction_bits;
    if (test.receiver == Receiver::normal)
        return darkness(map,
                        moved_along(p, m, test.normal_offset_q8, receiver.scale.at(p, fraction),
                                    fraction),
                        at.dither, at.taps);
    const ReceiverPlane plane =
        plane_of_normal(p, m, receiver.scale, fraction, receiver.limit);
    return darkness(map, p, at.dither, at.taps, &plane);
}

// Of a pixel whose results are `p`. One that is not visible has no surface.
template <class Depth, class Transform>
std::uint8_t pixel_darkness(const LightMap<Depth>& map, const hw::FrameStore<const Depth>& observer,
                            const Transform& transform, const ShadowTest& test,
                            const WalkedPixel& at, const hw::Point& p,
                            const ReceiverWords& receiver) {
    if (!hw::built(hw::Feature::surface_bias) || test.receiver == Receiver::point || !at.visible)
        return darkness(map, p, at.dither, at.taps);
    if (reads_normals(test)) return darkness_by_normal(map, observer, test, at, p, receiver);
    const std::optional<Neighbours> by = neighbours_of(observer, transform, test, at);
    if (test.receiver == Receiver::normal) {
        const hw::Point moved =
            by ? moved_along_normal(p, by->beside, by->below, by->turn, test.normal_offset_q8,
                                    receiver.scale, test.machine.fraction_bits)
               : p;
        return darkness(map, moved, at.dither, at.taps);
    }
    const ReceiverPlane plane = by ? receiver_plane(p, by->beside, by->below, receiver.limit)
                                   : ReceiverPlane{p, 0, 0, receiver.limit};
    return darkness(map, p, at.dither, at.taps, &plane);
}

}  // namespace umbra78::shadow
