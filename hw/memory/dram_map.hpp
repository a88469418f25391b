// Where a pixel is in its store's chips: bank, row, column, and which chip of the word.
//
// A bit plane of 512 x 512 is 16 chips of 2^14 bits, addressed together: a *word* is 16 pixels, and
// pixel address y 2^n + x has its word in the high 14 bits, its chip in the low 4. A larger store
// has more chips, not more rows: its word is wider. Words run along the scan lines, 32 a line.
//
//   rows = lines:  row = word / 128, column = word mod 128     a page is 2048 pixels: four lines
//   rows = words:  row = word mod 128, column = word / 128     four lines visit all 128 rows
//
// Four banks hold 2 x 2 interleaved texels: bank 2 (y mod 2) + x mod 2 has a quarter of the chips
// and stores pixel (x/2, y/2) of a picture half as wide, so any 2 x 2 texels lie in four banks.
#pragma once

#include "fixed/rounding.hpp"
#include "hw/memory/dram_timing.hpp"

#include <cstdint>

namespace umbra78::hw {

struct DramPlace {
    int bank;
    std::int32_t row, column;
    std::int32_t chip;  // within the word
};

struct DramMap {
    int xy_bits = 9;
    int banks = 1;  // 1 or 4
    DramRows rows = DramRows::lines;

    static constexpr int word_address_bits = 14;
    static_assert(DramTiming::chip_rows * DramTiming::chip_columns == 1 << word_address_bits);

    // Pixels in a word of all banks together, as a power of two: 16, or more in a larger store.
    constexpr int word_bits() const {
        const int n = 2 * xy_bits - word_address_bits;
        return n > 4 ? n : 4;
    }
    constexpr int word_px() const { return 1 << word_bits(); }

    constexpr DramPlace place(int x, int y) const {
        const int half = banks == 4 ? 1 : 0;
        const std::int32_t address = (fixed::floor_shift(y, half) << (xy_bits - half)) +
                                     fixed::floor_shift(x, half);
        const int chip_bits = word_bits() - 2 * half;
        const std::int32_t word = fixed::floor_shift(address, chip_bits);
        const std::int32_t low = word % DramTiming::chip_columns;
        const std::int32_t high = word / DramTiming::chip_columns;
        const bool lines = rows == DramRows::lines;
        return {half != 0 ? 2 * (y & 1) + (x & 1) : 0, lines ? high : low, lines ? low : high,
                address & ((1 << chip_bits) - 1)};
    }
};

}  // namespace umbra78::hw
