// The sign of three lines without the case of 0, and where a row of pixels passes a corner.
//
// Three lines of the light's picture may pass through one point. Where polygons are concave and
// have holes, that makes contacts of many kinds. Instead of treating each, every line is moved: to
// each of its three numbers an infinitesimal is added, all of different orders (simulation of
// simplicity, Edelsbrunner & Muecke 1990). Then no three lines meet, and the sign of a determinant
// that is 0 is that of the first coefficient in the infinitesimals that is not 0. The last of them
// is 1, so there is always one. The orders hang on the lines' numbers alone, so all the signs are
// those of one picture, which is the true one but for infinitesimals. atherton.md says why no pixel
// sees the difference.
#pragma once

#include "shadow/rivals/light_lines.hpp"

#include <cstdint>

namespace umbra78::shadow::rivals {

struct MovedCounts {
    SignCounts signs;
    std::uint64_t ties = 0;  // of them, that were 0 before the lines were moved
};

// As LightLines::sign, of three different lines that are moved: 1 or -1.
int moved_sign(const LightLines& lines, LineId a, LineId b, LineId c, MovedCounts& counts);

// A row of pixels, as the light sees it on one facet, and how it moves as the row goes down.
struct SeenRow {
    LightLine at, growth;
};
SeenRow seen_row(const LightLines& lines, std::uint32_t on, int row);

// On which side of a row lines a and b, which are moved, meet: 1 or -1, times the signs of their
// insides. The row is moved down by an infinitesimal that is greater than all those of lines.
int row_sign(const LightLines& lines, LineId a, LineId b, const SeenRow& row);

}  // namespace umbra78::shadow::rivals
