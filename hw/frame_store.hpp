// The frame store: a Z plane, an intensity plane and a plane of the light's direct share, of
// 2^xy_bits x 2^xy_bits words each. A coloured store has an intensity plane for each channel, and
// a store of several lights a direct plane for each light in each channel, one after the other.
// A store may also keep its surfaces' normals (hw/MACHINE.md, section 27), in three planes.
//
// Row 0 is the top of the picture; word y 2^xy_bits + x holds pixel (x, y). The Z code is
// unsigned, 0 at the near plane; all ones is the background, and the code of what is drawn is
// clamped to one less. Nearer replaces (Catmull 1974, p. 32). A tie in Z goes to the smaller
// intensity, the smaller direct share and the smaller normal, so the result depends on what is
// drawn and never on the order it is drawn in. A sample replaces all planes or none: its words are
// one record.
//
// The planes are the caller's memory. FrameStore<Depth16> can be written; FrameStore<const Depth16>
// is what a stage takes that only reads, and each converts to it by itself.
// Not emulated here: access times, refresh and video read-out (hw/memory/dram.hpp replays those).
#pragma once

#include "hw/machine_spec.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace umbra78::hw {

// Z codes of up to 16 bits are two ganged 8-bit planes, as NYIT could have them; wider ones are
// for study.
using Depth16 = std::uint16_t;
using Depth32 = std::uint32_t;

// A normal's components are words of 16 bits with an offset; three middle ones are no normal.
using NormalWord = std::uint16_t;
inline constexpr NormalWord no_normal = 1 << 15;

template <class Depth>
struct FrameStore {
    static constexpr bool read_only = std::is_const_v<Depth>;
    using Intensity = std::conditional_t<read_only, const std::uint8_t, std::uint8_t>;
    using Normal = std::conditional_t<read_only, const NormalWord, NormalWord>;

    int xy_bits = 0;
    std::span<Depth> depth;            // size_px^2 words
    std::span<Intensity> intensity{};  // a plane a channel, or empty in the light's view
    std::span<Intensity> direct{};     // how much of it each light gives: its planes by channel
    std::span<Normal> normal{};        // three planes, or empty

    int size_px() const { return 1 << xy_bits; }
    std::size_t address(int x, int y) const {
        return (static_cast<std::size_t>(y) << xy_bits) + static_cast<std::size_t>(x);
    }

    // Whether this is a store of the machine's size that holds its Z codes.
    constexpr bool fits(const MachineSpec& spec) const {
        const auto words = std::size_t{1} << (2 * spec.xy_bits);
        return xy_bits == spec.xy_bits && spec.z_bits <= 8 * static_cast<int>(sizeof(Depth)) &&
               depth.size() == words && intensity.size() % words == 0 &&
               direct.size() % words == 0 && (normal.empty() || normal.size() == 3 * words);
    }
    constexpr bool keeps_normals() const { return !normal.empty(); }
    // A component, at most 2^14.
    constexpr std::int32_t normal_at(std::size_t address, std::size_t axis) const {
        return std::int32_t{normal[axis * depth.size() + address]} - no_normal;
    }
    // Whether it can keep what a shaded sample has.
    constexpr bool shades() const {
        return !depth.empty() && !intensity.empty() && intensity.size() % depth.size() == 0 &&
               !direct.empty() && direct.size() % intensity.size() == 0;
    }

    void clear(const MachineSpec& spec)
        requires(!read_only)
    {
        std::fill(depth.begin(), depth.end(), static_cast<Depth>(spec.background()));
        std::fill(intensity.begin(), intensity.end(), std::uint8_t{0});
        std::fill(direct.begin(), direct.end(), std::uint8_t{0});
        std::fill(normal.begin(), normal.end(), no_normal);
    }

    template <class Read>
        requires(!read_only && std::same_as<Read, const Depth>)
    constexpr operator FrameStore<Read>() const {
        return {xy_bits, depth, intensity, direct, normal};
    }
};

// A parameter of a template that deduces Depth from another argument.
template <class Depth>
using ReadOnlyStore = FrameStore<const std::type_identity_t<Depth>>;

}  // namespace umbra78::hw
