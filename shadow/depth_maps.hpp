// The two depth maps that a pass of the shadow test reads, by name; and what a pass requires.
//
// The observer's and the light's store have one type, so two parameters could be swapped unseen.
// DepthMaps is filled by name only:
//   DepthMaps<Depth16>{.observer = a, .light = b}     compiles
//   DepthMaps<Depth16>{a, b}, {.light = b, .observer = a}     do not
//
// A pass checks its inputs once, at its entry; a broken requirement ends in fixed::trap, which says
// which one it was.
#pragma once

#include "fixed/trap.hpp"
#include "hw/frame_store.hpp"
#include "hw/machine_spec.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

template <class Depth>
struct DepthMaps {
    // A first member that no store converts to.
    struct Named {
        explicit Named() = default;
    };
    [[no_unique_address]] Named by_name = Named();

    hw::FrameStore<const Depth> observer;  // what the observer sees first
    hw::FrameStore<const Depth> light;     // what the light sees first: the light map
};

inline void check_machine(const hw::MachineSpec& spec) {
    fixed::require(hw::check(spec) == hw::SpecStatus::ok,
                   "shadow test: a width of the machine is out of its range");
}

template <class Depth>
void check_observer(const hw::FrameStore<const Depth>& observer, const hw::MachineSpec& spec) {
    fixed::require(observer.fits(spec),
                   "shadow test: the observer's store has other widths than the machine");
}
template <class Depth>
void check_light(const hw::FrameStore<const Depth>& light, const hw::MachineSpec& spec) {
    fixed::require(light.fits(spec),
                   "shadow test: the light's store has other widths than the machine");
}
inline void check_mask(std::span<const std::uint8_t> mask, const hw::MachineSpec& spec) {
    fixed::require(mask.size() == std::size_t{1} << (2 * spec.xy_bits),
                   "shadow test: the mask has not one byte for each pixel");
}

// What every pass over a frame requires.
template <class Depth>
void check(const DepthMaps<Depth>& maps, const hw::MachineSpec& spec,
           std::span<const std::uint8_t> mask) {
    check_machine(spec);
    check_observer(maps.observer, spec);
    check_light(maps.light, spec);
    check_mask(mask, spec);
}

}  // namespace umbra78::shadow
