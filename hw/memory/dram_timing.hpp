// The times of the frame stores' memory chips: 16384 x 1-bit dynamic RAMs of the MK4116 class.
//
// Access and cycle are those of the 200 ns grade (Mostek's MK4116-3, as later texts give them), and
// so are 128 rows to be refreshed within 2 ms. The page mode's 135 and 225 ns, the 10 us for which
// a row may stay open and the visible part of a line are ASSUMPTIONS (hw/MACHINE.md, section 17).
#pragma once

#include <cstdint>

namespace umbra78::hw {

// Which bits of a word's address are the chips' row. The high ones: a page is some whole scan
// lines. The low ones: the video visits every row within a few lines.
enum class DramRows : std::uint8_t { lines, words };

// Which stores are read out to a monitor while the post-process runs.
enum class Video : std::uint8_t { off, observer, all };

struct DramTiming {
    int access_ns = 200;  // from a closed row to its data
    int cycle_ns = 375;   // from one opening of a row to the next
    int column_ns = 135;  // from a column of the open row to its data
    int page_ns = 225;    // from one column to the next; 0: every access closes its row
    DramRows rows = DramRows::lines;
    Video video = Video::observer;

    static constexpr int chip_rows = 128, chip_columns = 128;
    static constexpr int refresh_ns = 2'000'000;
    static constexpr int longest_open_ns = 10'000;
    static constexpr int line_ns = 63'500;    // a television line at 15.75 kHz,
    static constexpr int active_ns = 52'000;  // and its visible part

    // From the end of an access until another row can be opened (a cycle shorter than the access
    // counts as one as long).
    constexpr int recovery_ns() const { return cycle_ns > access_ns ? cycle_ns - access_ns : 0; }
    constexpr int whole_cycle_ns() const { return access_ns + recovery_ns(); }
    // From the end of a column's access until another column can be read.
    constexpr int column_recovery_ns() const {
        return page_ns > column_ns ? page_ns - column_ns : 0;
    }
    constexpr bool page_mode() const { return page_ns > 0; }
};

}  // namespace umbra78::hw
