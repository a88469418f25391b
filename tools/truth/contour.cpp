#include "tools/truth/contour.hpp"

#include "tools/truth/image_walk.hpp"

#include <array>
#include <cmath>

namespace umbra78::tools {
namespace {

constexpr std::int32_t none = -1;

// A side between two neighbouring pixels: twice the index of its upper or left pixel, and one more
// if it is vertical.
std::array<std::size_t, 2> pixels_of(std::int32_t side, int size) {
    const auto at = static_cast<std::size_t>(side / 2);
    return {at, at + (side % 2 ? static_cast<std::size_t>(size) : 1)};
}

// For each side the line's next side, or none. Once clockwise round a cell, a line begins at a side
// that leaves the inside and ends at the side before it that enters: the inside, on the right hand,
// is what lies between the two.
std::vector<std::int32_t> next_sides(int size, std::span<const std::uint8_t> inside,
                                     std::span<const std::uint8_t> cells) {
    std::vector<std::int32_t> next(2 * inside.size(), none);
    for (int row = 0; row + 1 < size; ++row) {
        for (int column = 0; column + 1 < size; ++column) {
            const int at = row * size + column;
            if (!cells[at]) continue;
            const std::array corners{inside[at], inside[at + 1], inside[at + size + 1],
                                     inside[at + size]};
            if (corners[0] == corners[1] && corners[1] == corners[2] && corners[2] == corners[3])
                continue;
            const std::array sides{2 * at, 2 * (at + 1) + 1, 2 * (at + size), 2 * at + 1};
            for (int leaves = 0; leaves < 4; ++leaves) {
                if (!corners[leaves] || corners[(leaves + 1) % 4]) continue;
                int enters = leaves;
                do enters = (enters + 3) % 4;
                while (corners[enters] || !corners[(enters + 1) % 4]);
                next[sides[leaves]] = sides[enters];
            }
        }
    }
    return next;
}

}  // namespace

ImagePoint pixel_centre(std::size_t at, int size) {
    const auto width = static_cast<std::size_t>(size);
    return {static_cast<double>(at % width) + 0.5, static_cast<double>(at / width) + 0.5};
}

ImagePoint between(const ImagePoint& from, const ImagePoint& to, double part) {
    return {from.column + part * (to.column - from.column), from.row + part * (to.row - from.row)};
}

double pixels_between(const ImagePoint& a, const ImagePoint& b) {
    return std::hypot(a.column - b.column, a.row - b.row);
}

double length(const Contour& line) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k) sum += pixels_between(line[k - 1], line[k]);
    return sum;
}

std::vector<Contour> contours(int size, std::span<const std::uint8_t> inside,
                              std::span<const std::uint8_t> cells, const CrossingPlace& place) {
    expect_image(inside.size(), size);
    expect_image(cells.size(), size);
    std::vector<std::int32_t> next = next_sides(size, inside, cells);
    std::vector<std::uint8_t> is_next(next.size());
    for (const std::int32_t side : next)
        if (side != none) is_next[side] = 1;

    std::vector<Contour> lines;
    const auto point = [&](std::int32_t side) {
        const auto [a, b] = pixels_of(side, size);
        return inside[a] ? place(a, b) : place(b, a);
    };
    const auto follow = [&](std::int32_t start) {
        Contour line{point(start)};
        for (std::int32_t side = start; next[side] != none;) {
            const std::int32_t to = next[side];
            next[side] = none;
            line.push_back(to == start ? line.front() : point(to));
            side = to;
        }
        lines.push_back(std::move(line));
    };
    const auto sides = static_cast<std::int32_t>(next.size());
    for (std::int32_t side = 0; side < sides; ++side)
        if (next[side] != none && !is_next[side]) follow(side);
    for (std::int32_t side = 0; side < sides; ++side)
        if (next[side] != none) follow(side);  // what is left is closed
    return lines;
}

std::vector<Contour> mask_contours(int size, std::span<const std::uint8_t> mask,
                                   std::span<const std::uint8_t> cells) {
    std::vector<std::uint8_t> inside(mask.size());
    for (std::size_t at = 0; at < mask.size(); ++at) inside[at] = mask[at] >= 128;
    return contours(size, inside, cells, [&](std::size_t in, std::size_t out) {
        const ImagePoint from = pixel_centre(in, size), to = pixel_centre(out, size);
        const double part = (mask[in] - 127.5) / (mask[in] - mask[out]);
        return between(from, to, part);
    });
}

}  // namespace umbra78::tools
