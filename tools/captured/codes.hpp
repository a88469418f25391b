// A captured depth buffer in the machine's words: codes of z_bits, in the upper left corner of its
// frame.
//
// With d the stored depth, from 0 at the near plane to 1 at the far one (one minus it where the
// format is reversed), a code is half_up(d far_code), exactly, whatever the host computes in; at
// most the deepest drawn. A stored depth of the far plane itself is what a buffer was cleared to,
// and becomes background, as does the frame beyond the buffer.
#pragma once

#include "hw/frame_store.hpp"
#include "tools/captured/conventions.hpp"
#include "tools/io/number_images.hpp"

#include <cstddef>
#include <vector>

namespace umbra78::tools::captured {

struct Codes {
    std::vector<hw::Depth32> depth;    // the frame's
    std::vector<hw::Depth16> narrow;   // the same, where 16 bits hold it
    std::size_t background = 0;        // of the buffer's pixels
    double largest_rounding = 0;       // of a depth, in quanta
};

// Throws SceneError: one line that names the file, the place and the remedy, of a number that is no
// depth of the format.
Codes codes_of(const NumberImage&, const DepthFormat&, bool first_row_on_top,
               const hw::MachineSpec&);

// Bits of Z that hold every code of the format; of a float as many as the machine has.
int z_bits_of(const DepthFormat&, const NumberImage&);
// Bits of X and Y of a frame that both buffers fit in. Throws SceneError if one is too large.
int xy_bits_of(const NumberImage& observer, const NumberImage& light);

// A mask or a truth as darkness in the frame: 255 in shadow. What is half of the greatest value or
// more is bright.
std::vector<std::uint8_t> darkness_of(const NumberImage&, bool bright_is_lit,
                                      bool first_row_on_top, const hw::MachineSpec&);

}  // namespace umbra78::tools::captured
