// The post-process (Williams 1978): every visible pixel, moved into the light's view and tested.
//
//   observer's (x, y, Z) --transform unit, bias in its Z row--> light's (X, Y, Z)
//     --dither X, Y--> look up --> compare --> mask (255 in shadow, 0 lit or background)
//
// Its cost depends on the resolution alone: one transform a visible pixel, whatever was drawn.
// `post_process` is the definition, a pixel at a time; `post_process_rows` runs the same
// arithmetic a scan line at a time, in lanes the compiler vectorizes, wherever the words are
// 1978's and both views affine. Tests hold the two equal bit for bit.
#pragma once

#include "shadow/compare.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

inline constexpr std::uint8_t mask_lit = 0;
inline constexpr std::uint8_t mask_shadow = 255;

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

// What the plain form does of what can change nothing, and whether it draws the noise.
struct PostProcessWork {
    hw::UnitWork unit{};
    bool background = false;  // pixels where nothing was drawn are transformed, and lit
    bool noise = true;        // where dither is off, words of amplitude 0
    constexpr bool operator==(const PostProcessWork&) const = default;
};
constexpr PostProcessWork needed_work(const ShadowTest& s) {
    return {{}, false, !hw::silent(s.dither, s.machine)};
}

// The noise of a frame; where dither is off it is drawn, if it is, with amplitude 0.
constexpr hw::Dither drawn_dither(const ShadowTest& s) {
    if (s.dither.shape != hw::DitherShape::none) return s.dither;
    return {hw::DitherShape::uniform, 0, s.dither.seed};
}

struct PostProcessCounts {
    std::uint64_t visible = 0;  // pixels transformed
    std::uint64_t shadowed = 0;
    std::uint64_t lines = 0;    // scan lines with a visible pixel; the AP-120B's form counts them
};

PostProcessCounts post_process(const hw::FrameStore<const hw::Depth16>& observer,
                               const hw::FrameStore<const hw::Depth16>& light,
                               const hw::MatrixWords& matrix, const ShadowTest& settings,
                               const PostProcessWork& work, std::span<std::uint8_t> mask);
PostProcessCounts post_process(const hw::FrameStore<const hw::Depth32>& observer,
                               const hw::FrameStore<const hw::Depth32>& light,
                               const hw::MatrixWords& matrix, const ShadowTest& settings,
                               const PostProcessWork& work, std::span<std::uint8_t> mask);
// The work that the settings need.
inline PostProcessCounts post_process(const hw::FrameStore<const hw::Depth16>& observer,
                                      const hw::FrameStore<const hw::Depth16>& light,
                                      const hw::MatrixWords& matrix, const ShadowTest& settings,
                                      std::span<std::uint8_t> mask) {
    return post_process(observer, light, matrix, settings, needed_work(settings), mask);
}
inline PostProcessCounts post_process(const hw::FrameStore<const hw::Depth32>& observer,
                                      const hw::FrameStore<const hw::Depth32>& light,
                                      const hw::MatrixWords& matrix, const ShadowTest& settings,
                                      std::span<std::uint8_t> mask) {
    return post_process(observer, light, matrix, settings, needed_work(settings), mask);
}

inline constexpr int widest_row = 512;

// Scratch of the row form: the columns' share of each result, split at the binary point.
struct RowMemory {
    using Lanes = std::array<std::int32_t, widest_row>;
    std::array<Lanes, 3> column_high, column_low;
    std::array<Lanes, 3> result;
    Lanes address;
};

// Whether the row form covers these settings and this matrix.
bool rows_cover(const ShadowTest& settings, const hw::MatrixWords& matrix);

// Requires rows_cover.
PostProcessCounts post_process_rows(const hw::FrameStore<const hw::Depth16>& observer,
                                    const hw::FrameStore<const hw::Depth16>& light,
                                    const hw::MatrixWords& matrix, const ShadowTest& settings,
                                    RowMemory& memory, std::span<std::uint8_t> mask);

}  // namespace umbra78::shadow
