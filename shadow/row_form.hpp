// The forms of a scan line of the post-process: one meaning, once for each instruction set.
//
// `plain` is C++ without more (shadow/row_plain.cpp) and is there on every machine. On
// x86-64 shadow/row_forms.cpp adds the processor's lanes: SSE2, AVX2 and AVX-512, all three
// compiled from one text, shadow/row_body.hpp, over a few named operations of each set. The program
// asks the processor once a frame and takes the last form that it has. Tests run every form that
// the machine has and compare it bit for bit with post_process(), the definition.
#pragma once

#include "shadow/post_process.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace umbra78::shadow {

// What does not change along a scan line of one row of the matrix, split at the binary point
// (shadow/post_process_rows.cpp), and c_z.
struct RowShare {
    std::int32_t high, low;
    std::int16_t z_coefficient;
    int shift;
};

// A scan line's work, as far as it lies in a strip of at most widest_row columns. Plain members
// only: the lanes' text names no template, whose copy for one instruction set the linker could take
// for all.
struct RowLine {
    // of the frame
    const ShadowTest* test;
    const LightMap<hw::Depth16>* light;
    const hw::Depth16* texels;
    int size, xy_bits, fraction_bits;  // of the map and the frame
    int z_up;             // z words are (code - offset) 2^z_up
    std::int32_t offset;  // the code of Z = 0
    std::int32_t background;
    bool whole;  // the shares' high parts are 0, their low ones modulo 2^32
    bool bilinear;
    int window_side;  // texels; 0: no window
    bool percentage;  // a window's darkness is a share of its texels:
    int share_scale, share_offset;  // floor((count share_scale + share_offset) / 2^20)
    int uniforms;  // bytes in a dither word, 0: none
    std::int32_t amplitude;
    // of the strip
    int first, width;  // its columns
    int* noise_line;   // whose words all are in the memory's noise_bits
    static constexpr int no_line = -2;  // nor is it the line before the first
    // of the line
    fixed::NoiseRegister noise{1};  // at the strip's first pixel
    int y;
    const hw::Depth16* depth;
    std::uint8_t* mask;
    RowShare share[3];
};

struct RowCounts {
    std::uint32_t visible, shadowed;
};

struct RowForm {
    std::string_view name;
    bool (*supported)();  // by this processor
    // Fills the line's mask, and reads the columns' shares of `memory`.
    RowCounts (*run)(const RowLine& line, RowMemory& memory);
    // Of 64 codes a word: bit k of a word says whether its code k is another than `none`.
    void (*find_drawn)(const hw::Depth16* codes, std::size_t words, hw::Depth16 none,
                       std::uint64_t* drawn);
};

// All that are compiled in, `plain` first, the fastest last.
std::span<const RowForm> row_forms();
// The last one that is supported.
const RowForm& fastest_row_form();

PostProcessCounts post_process_rows(const DepthMaps<hw::Depth16>& maps,
                                    const hw::MatrixWords& matrix, const ShadowTest& test,
                                    RowMemory& memory, std::span<std::uint8_t> mask,
                                    const RowForm& form, hw::Band band = {});

// Whether the lanes cover what the plain form covers: not a fall back to the nearest texel, and no
// dither word of more than 16 bits. The plain form does the rest.
bool lanes_cover(const ShadowTest& test);

// The definition, for lanes at the map's edge: results of the transform unit, dithered.
std::uint8_t row_pixel_darkness(const RowLine& line, std::int32_t x, std::int32_t y,
                                std::int32_t z);
// The line's first 32 words of noise, of 32 bits.
void start_row_noise(const RowLine& line, std::uint32_t* words);

RowCounts plain_row(const RowLine& line, RowMemory& memory);
void plain_drawn(const hw::Depth16* codes, std::size_t words, hw::Depth16 none,
                 std::uint64_t* drawn);

}  // namespace umbra78::shadow
