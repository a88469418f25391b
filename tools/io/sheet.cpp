#include "tools/io/sheet.hpp"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <stdexcept>

namespace umbra78::tools {
namespace {

constexpr std::uint8_t ground = 22, frame = 58, bright = 226, dim = 148;
constexpr int margin = 24;       // round the sheet and between cells
constexpr int caption_gap = 10;  // picture to caption, and caption to the next row
constexpr int line_height = 12;  // of the font at scale 1; its capitals are 7 high

std::string printable(std::string text) {
    for (char& letter : text)
        if (letter < ' ' || letter > '~') letter = '?';
    return text;
}

int text_width(std::string text, int scale) { return scale * stb_easy_font_width(text.data()); }

std::string cut(std::string text, int width, int scale) {
    if (text_width(text, scale) <= width) return text;
    while (!text.empty() && text_width(text + "...", scale) > width) text.pop_back();
    return text + "...";
}

void fill(Gray& sheet, int left, int top, int width, int height, std::uint8_t gray) {
    const int right = std::min(left + width, sheet.width);
    const int bottom = std::min(top + height, sheet.height);
    for (int y = std::max(top, 0); y < bottom; ++y)
        for (int x = std::max(left, 0); x < right; ++x) sheet.pixels[y * sheet.width + x] = gray;
}

// stb_easy_font answers with axis-parallel quads on whole units: x, y, z and a colour a corner.
void draw_text(Gray& sheet, int left, int top, std::string text, int scale, std::uint8_t gray) {
    struct Corner {
        float x, y, z;
        std::uint8_t colour[4];
    };
    std::vector<Corner> corners(text.size() * 4 * 24 + 4);  // at most 24 quads a letter
    const int quads =
        stb_easy_font_print(0, 0, text.data(), nullptr, corners.data(),
                            static_cast<int>(corners.size() * sizeof(Corner)));
    for (int quad = 0; quad < quads; ++quad) {
        const Corner &from = corners[4 * quad], &to = corners[4 * quad + 2];
        fill(sheet, left + scale * int(from.x), top + scale * int(from.y),
             scale * int(to.x - from.x), scale * int(to.y - from.y), gray);
    }
}

// The cell's picture at the sheet's scale.
Gray shown(const SheetCell& cell, bool halved) {
    if (cell.pixels.size() != static_cast<std::size_t>(cell.width) * cell.height)
        throw std::invalid_argument("a sheet cell does not hold width * height pixels");
    if (!halved) return {cell.width, cell.height, {cell.pixels.begin(), cell.pixels.end()}};
    Gray small{cell.width / 2, cell.height / 2, {}};
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const std::uint8_t* at = &cell.pixels[2 * y * cell.width + 2 * x];
            const int sum = at[0] + at[1] + at[cell.width] + at[cell.width + 1];
            small.pixels.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    return small;
}

void place(Gray& sheet, int left, int top, const Gray& picture) {
    fill(sheet, left - 1, top - 1, picture.width + 2, picture.height + 2, frame);
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(&picture.pixels[y * picture.width], picture.width,
                    &sheet.pixels[(top + y) * sheet.width + left]);
}

}  // namespace

Gray compose_sheet(std::span<const SheetCell> cells, const SheetLayout& layout) {
    int width = 1, height = 0, lines = 0, widest_text = 0;
    std::vector<Gray> pictures;
    for (const SheetCell& cell : cells) {
        pictures.push_back(shown(cell, layout.halved));
        width = std::max(width, pictures.back().width);
        height = std::max(height, pictures.back().height);
        lines = std::max(lines, static_cast<int>(cell.caption.size()));
        for (const std::string& line : cell.caption)
            widest_text = std::max(widest_text, text_width(printable(line), 1));
    }
    const int fitting = width / std::max(widest_text, 1);
    const int scale = std::clamp(fitting, 1, std::max(layout.text_scale, 1));
    const int across = width + margin;
    const int down = height + (lines ? caption_gap + lines * line_height * scale : 0) + margin;
    const int count = static_cast<int>(cells.size());
    const int columns = std::max(std::min(layout.columns, count), 1);
    const int rows = (count + columns - 1) / columns;

    Gray sheet{columns * across + margin, rows * down + margin, {}};
    sheet.pixels.assign(static_cast<std::size_t>(sheet.width) * sheet.height, ground);
    for (int i = 0; i < count; ++i) {
        const int left = margin + i % columns * across, top = margin + i / columns * down;
        place(sheet, left, top, pictures[i]);
        int text_top = top + height + caption_gap;
        for (const std::string& line : cells[i].caption) {
            draw_text(sheet, left, text_top, cut(printable(line), width, scale), scale,
                      text_top == top + height + caption_gap ? bright : dim);
            text_top += line_height * scale;
        }
    }
    return sheet;
}

void write_sheet(const Path& path, std::span<const SheetCell> cells, const SheetLayout& layout,
                 FileSet* set) {
    const Gray sheet = compose_sheet(cells, layout);
    write_png_gray(path, sheet.width, sheet.height, sheet.pixels, set);
}

}  // namespace umbra78::tools
