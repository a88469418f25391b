// Rival space: the integers in which the rivals of the depth map are computed.
//
// The axes are those of the observer's view before it is projected: X right, Y down, Z away, from
// the view's target. A word is the exact coordinate in units of 2^-f pixel (at the target, for a
// view in perspective), rounded half even, once for each vertex. So the words are the polygons,
// and everything after them is exact: a rival without a wrong pixel can exist.
//
//   word = round_half_even(axis . (p - target) half_px 2^f / extent)     |word| <= 2^22
//
// f is the largest of 1 .. 22 - n (n bits of X and Y) with which every vertex, the eye and the
// lights at a place fit. So a distant lamp or a wide floor lowers f and is not refused, until half
// a pixel is too fine; then the status says so. From f = 1 on a pixel's centre is a word.
//
// The eye and each light are centres of projection: a place (w = 1), or, infinitely far, the
// direction toward it (w = 0), a unit vector in Q1.21.
#pragma once

#include "raster/view.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

inline constexpr int word_bits = 22;
inline constexpr std::int32_t max_word = std::int32_t{1} << word_bits;
inline constexpr int direction_fraction = 21;

struct Point {
    std::int32_t x, y, z;
    constexpr bool operator==(const Point&) const = default;
    friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

// (x, y, z) at a place where w = 1; the direction toward it where w = 0.
struct Centre {
    std::int32_t x, y, z, w;
    constexpr bool operator==(const Centre&) const = default;
};

enum class SpaceStatus : std::uint8_t {
    ok,
    too_wide,  // a vertex, the eye or a light's place lies too far from the target
};

// What the rivals see: the eye, a light, and the frame's pixels.
class Space {
public:
    constexpr Space() = default;
    // For tests: an eye and words as they are.
    constexpr Space(int xy_bits, int fraction, const Centre& eye)
        : xy_bits_(xy_bits), fraction_(fraction), eye_(eye) {}

    constexpr int fraction() const { return fraction_; }
    constexpr int xy_bits() const { return xy_bits_; }
    constexpr int size_px() const { return 1 << xy_bits_; }
    constexpr std::size_t pixels() const { return std::size_t{1} << (2 * xy_bits_); }
    constexpr const Centre& eye() const { return eye_; }

    // The centre of column or row i, a word.
    constexpr std::int32_t centre(int i) const { return (2 * i + 1 - size_px()) * half_pixel(); }
    // The first column or row whose centre is not below v; it may lie outside the frame.
    constexpr std::int64_t first_not_below(std::int64_t v) const {
        const std::int64_t odd = fixed::round_divide(v, half_pixel(), fixed::Rounding::ceiling);
        return fixed::floor_shift(odd + size_px(), 1);
    }

private:
    constexpr std::int32_t half_pixel() const { return std::int32_t{1} << (fraction_ - 1); }

    int xy_bits_ = 0, fraction_ = 1;
    Centre eye_{};
};

// A view's words, at any f.
class ToWords {
public:
    ToWords(const raster::View& observer, int xy_bits, int fraction);

    // False if a word is beyond max_word; then `out` is not to be used.
    bool point(const raster::World& p, Point& out) const;
    // A light as the machine has it: a view in perspective stands at its eye, another shines along
    // its axis.
    bool light(const raster::View& light, Centre& out) const;
    // False if the eye is too far.
    bool space(Space& out) const;

private:
    bool word(std::int64_t along, std::int32_t& out) const;
    bool words(const raster::WideVector& from_target, Point& out) const;

    raster::View observer_;
    int xy_bits_, fraction_;
};

// The f of a scene; `lights` are those that are used.
SpaceStatus fit_fraction(const raster::View& observer, int xy_bits,
                         const raster::Surfaces& surfaces, std::span<const raster::View> lights,
                         int& fraction);

}  // namespace umbra78::shadow::rivals
