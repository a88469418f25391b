// A contact sheet: gray pictures in a grid on a dark ground, a caption of a line or two under
// each. Units are pixels of the sheet; the font is stb_easy_font, ASCII, scaled by a whole number.
#pragma once

#include "tools/io/files.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace umbra78::tools {

// Rows from the top, width * height grays 0 .. 255.
struct Gray {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
};

// The first caption line is bright, the rest are dim. Text wider than the picture is cut with
// "..."; what is not printable ASCII shows as '?'.
struct SheetCell {
    int width = 0, height = 0;
    std::span<const std::uint8_t> pixels;
    std::vector<std::string> caption;
};

struct SheetLayout {
    int columns = 3;
    bool halved = false;  // each pixel the mean of 2 x 2, for sheets to glance at
    int text_scale = 2;   // largest; a sheet whose captions are too wide takes a smaller one
};

// Pictures may differ in size: every cell is as large as the largest. Two cells in two columns
// are a side-by-side comparison.
Gray compose_sheet(std::span<const SheetCell>, const SheetLayout& = {});
void write_sheet(const Path&, std::span<const SheetCell>, const SheetLayout& = {},
                 FileSet* set = nullptr);

}  // namespace umbra78::tools
