// Contours: lines between the inside and the outside of an image, at fractions of a pixel.
//
// A cell's corners are the centres of four neighbouring pixels. The line crosses a side of the
// cell whose two ends differ, and is straight within a cell (marching squares: Lorensen and Cline,
// "Marching Cubes", SIGGRAPH 87, in two dimensions). It has the inside on its right hand. Two
// inside pixels that touch at a corner only are kept apart, as the edge dequantizer keeps them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace umbra78::tools {

// In pixels: the centre of the pixel in row y and column x is (x + 1/2, y + 1/2).
struct ImagePoint {
    double column, row;
};

ImagePoint pixel_centre(std::size_t at, int size);
ImagePoint between(const ImagePoint& from, const ImagePoint& to, double part);
double pixels_between(const ImagePoint&, const ImagePoint&);

// A line of at least two points; closed if the last is the first.
using Contour = std::vector<ImagePoint>;

double length(const Contour&);

// Where the line passes between two neighbouring pixels, the first of them inside.
using CrossingPlace = std::function<ImagePoint(std::size_t inside, std::size_t outside)>;

// `inside` has size * size values, 0 or 1. A cell is crossed only where `cells` is 1 at its upper
// left pixel; the last row and column of `cells` are not read. Lines end where the cells do.
std::vector<Contour> contours(int size, std::span<const std::uint8_t> inside,
                              std::span<const std::uint8_t> cells, const CrossingPlace&);

// Those of a mask of 0..255 at 127.5, between pixels by linear interpolation.
std::vector<Contour> mask_contours(int size, std::span<const std::uint8_t> mask,
                                   std::span<const std::uint8_t> cells);

}  // namespace umbra78::tools
