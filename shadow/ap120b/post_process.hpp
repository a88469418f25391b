// The post-process on an FPS AP-120B, in its floating point: what the paper says NYIT meant to use
// (Williams 1978).
//
//   host: (px, py, code) of a scan line's visible pixels, 16-bit integers, floated
//     --4 x 4, bias in it--> (X, Y, K, W) --divide, where W is not 1--> dither X, Y
//     --fix--> texel (host fetches its code: the map is larger than the processor's memory)
//     --interpolate--> compare K --> mask
//
// X and Y come out in texels from the map's corner, K in its Z codes: the matrix holds the pixel's
// centre, the frame's centre, the scale of Z and the bias, so no element needs another addition.
// The rules outside the light's volume are the fixed-point unit's; hw/MACHINE.md, section 18.
// This code computes one pixel at a time; the processor's vector routines, which take a scan line
// at a time, would give the same bits. Codes have at most 16 bits, as the host sends them: more
// trap, and so do maps or a mask of other sizes than the machine.
#pragma once

#include "hw/ap120b/transform.hpp"
#include "shadow/post_process.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

// From exact rationals, each entry rounded once. `exact` is observer to light with the bias.
hw::ap120b::Matrix array_matrix(const hw::RationalMatrix& exact, const ShadowTest& settings);

// A pixel's four words as the host's transfer leaves them; the code is sent less half its range.
constexpr hw::ap120b::Vector array_words(int px, int py, std::uint32_t code,
                                         const hw::MachineSpec& spec) {
    using fixed::Float38;
    const auto host = [](std::int64_t v) {
        return Float38::from_host(static_cast<std::int16_t>(v)).normalised();
    };
    return {host(px), host(py), host(std::int64_t{code} - spec.depth_offset()), host(1)};
}

// `affine`: W is 1 and not divided by.
template <class Depth>
bool array_in_shadow(const LightMap<Depth>& map, hw::ap120b::Vector p, bool affine,
                     const hw::DitherWords& d);

// `band`: of the frame's lines these alone are tested and written.
template <class Depth>
PostProcessCounts array_post_process(const DepthMaps<Depth>& maps,
                                     const hw::ap120b::Matrix& matrix, bool affine,
                                     const ShadowTest& test, std::span<std::uint8_t> mask,
                                     hw::Band band = {});

// The processor's memory while it works on a scan line of n pixels: word addresses.
struct ArrayMemoryMap {
    std::uint32_t constants, points, dither, texels, fractions, codes, mask, end;
};
constexpr ArrayMemoryMap array_memory_map(int pixels) {
    const auto n = static_cast<std::uint32_t>(pixels);
    ArrayMemoryMap m{};
    m.constants = 0;             // the matrix, bounds, powers of two
    m.points = 64;               // X Y K W, transformed in place
    m.dither = m.points + 4 * n;
    m.texels = m.dither + 2 * n;
    m.fractions = m.texels + 2 * n;
    m.codes = m.fractions + 2 * n;
    m.mask = m.codes + 4 * n;
    m.end = m.mask + n;
    return m;
}
static_assert(array_memory_map(512).end == 7744, "a line of 1978's frame: an eighth of the memory");
static_assert(array_memory_map(4096).end <= hw::ap120b::memory_words, "the widest line fits");

}  // namespace umbra78::shadow
