// The post-process (Williams 1978): every visible pixel, moved into the light's view and tested.
//
//   observer's (x, y, Z) --transform unit, bias in its Z row--> light's (X, Y, Z)
//     --dither X, Y--> look up --> compare --> mask (255 in shadow, 0 lit or background; by
//                                              percentage lookup anything between, too)
//
// Its cost depends on the resolution alone: one transform a visible pixel, whatever was drawn.
// `post_process` is the definition, one pixel at a time. `post_process_rows` runs the same
// arithmetic one scan line at a time, in the lanes of the processor (shadow/row_form.hpp); it
// covers codes of up to 16 bits and every lookup but jittered windows, affine or in perspective
// (rows_cover). Tests hold the two equal bit for bit.
// Both read the depth maps (DepthMaps), write every byte of the mask, and trap if the maps or the
// mask have other sizes than the machine.
#pragma once

#include "hw/band.hpp"
#include "shadow/compare.hpp"
#include "shadow/depth_maps.hpp"
#include "shadow/kept_normal.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

// A pixel's words as they enter the transform unit.
constexpr hw::Words pixel_words(int px, int py, std::uint32_t code, const ShadowTest& s) {
    const hw::MachineSpec& m = s.machine;
    const int half_word = m.input_fraction() - 1;
    const int centre = s.registration == Registration::centre ? 1 : 0;
    const auto word = [&](int p) { return (2 * (p - m.half_px()) + centre) * (1 << half_word); };
    const std::int64_t z = (std::int64_t{code} - m.depth_offset()) *
                           (std::int64_t{1} << (m.input_fraction() - m.depth_fraction()));
    return {word(px), word(py), static_cast<std::int32_t>(z)};
}

// Work that changes no bit and is done only to show that, and what it costs; and whether noise is
// drawn. Without its noise a dithered frame has other bits.
struct PostProcessWork {
    hw::UnitWork unit{};
    bool background = false;  // transforms pixels where nothing was drawn, too; they stay lit
    bool noise = true;        // draws noise, of amplitude 0 where dither is off
    bool empty_lines = false;  // goes through scan lines with no visible pixel, too
    constexpr bool operator==(const PostProcessWork&) const = default;
};
constexpr PostProcessWork needed_work(const ShadowTest& s) {
    return {{}, false, !hw::silent(s.dither, s.machine), false};
}

// The noise that is drawn for a frame: where dither is off, uniform noise of amplitude 0.
constexpr hw::Dither drawn_dither(const ShadowTest& s) {
    if (s.dither.shape != hw::DitherShape::none) return s.dither;
    return {hw::DitherShape::uniform, 0, s.dither.seed};
}

struct PostProcessCounts {
    std::uint64_t visible = 0;  // pixels transformed
    std::uint64_t shadowed = 0;  // those whose darkness is not 0
    std::uint64_t lines = 0;    // scan lines with a visible pixel; the AP-120B's form counts them

    PostProcessCounts& operator+=(const PostProcessCounts& more) {
        visible += more.visible;
        shadowed += more.shadowed;
        lines += more.lines;
        return *this;
    }
};

// What a light's test reads of its view to follow a receiver's surface: the most that its plane
// changes a depth, in quanta (shadow/receiver.hpp), its measures (shadow/normal_offset.hpp) and its
// axes (shadow/kept_normal.hpp).
struct ReceiverWords {
    std::int64_t limit = INT64_MAX;
    LightScale scale{};
    LightAxes axes{};
};

// `band`: of the frame's lines these alone are tested and written.
template <class Depth>
PostProcessCounts post_process(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                               const ShadowTest& test, const PostProcessWork& work,
                               std::span<std::uint8_t> mask, const ReceiverWords& receiver = {},
                               hw::Band band = {});
template <class Depth>
PostProcessCounts post_process(const DepthMaps<Depth>& maps, const hw::MatrixWords& matrix,
                               const ShadowTest& test, std::span<std::uint8_t> mask) {
    return post_process(maps, matrix, test, needed_work(test), mask);
}

inline constexpr int widest_row = 512;

// Scratch of the row forms: the columns' share of each result, split at the binary point; what the
// plain form keeps between its loops; and the noise of a scan line.
struct RowMemory {
    static constexpr int noise_words = widest_row * 2 * fixed::max_uniforms / 4;
    alignas(64) std::int32_t column_high[3][widest_row];
    alignas(64) std::int32_t column_low[3][widest_row];
    alignas(64) std::int64_t column_wide[4][widest_row];  // of result_form.hpp
    union {  // what the plain form keeps between its loops, or the sums of the lanes' noise
        alignas(64) std::int32_t result[3][widest_row];
        alignas(64) std::uint16_t noise_sums[2 * widest_row];
    };
    alignas(64) std::int32_t address[widest_row];
    alignas(64) std::int16_t noise[2 * widest_row];  // X and Y of each pixel
    alignas(64) std::uint32_t noise_bits[noise_words];
};

// Whether the row form covers these settings and this matrix.
bool rows_cover(const ShadowTest& test, const hw::MatrixWords& matrix);

// Requires rows_cover, which it checks.
PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& test,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    hw::Band band = {});

}  // namespace umbra78::shadow
