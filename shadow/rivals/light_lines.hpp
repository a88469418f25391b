// Lines of the light's picture, and the one sign that class 2 needs: of three of them.
//
// Each line by which a surface is cut into lit and dark is a plane through the light: that of an
// edge (what it parts is the shadow's border), or that of the line where the planes of two facets
// A and F meet (where one of them comes out of the other),
//
//   lambda = (A . L) F - (F . L) A          lambda . L = 0
//
// Seen from the light such planes are lines, on whatever surface they fall, and the point where two
// of them meet on a surface is before or behind a third whatever the surface. So a polygon of class
// 2 is a list of lines; it has no coordinates, none are rounded, and the sign
//
//   det(a, b, c)   of c at the meeting of a and b
//
// has the words of the scene in it and nothing constructed from constructed things. The three
// numbers of a line are, for a light at a place, the plane's normal (a point of the picture is a
// direction from the light); for a direction L whose component d is the largest, those of the
// normal but n[d], and the offset (a point of the picture is P moved along L to where P[d] = 0).
//
// Bits (planes.hpp). A number of an edge's line has normal_bits or offset_bits; of a meeting line
// the numbers have as many more as F . L has. Products are as wide as they can be.
#pragma once

#include "shadow/rivals/light_grid.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace umbra78::shadow::rivals {

// A line and its inside: the side where its value has the sign `inside`.
class LineId {
public:
    constexpr LineId() = default;
    static constexpr LineId edge(std::uint32_t index, int inside) {
        return LineId(index << 1 | (inside < 0 ? 1u : 0u));
    }
    static constexpr LineId meeting(std::uint32_t index, int inside) {
        return LineId(meeting_bit | index << 1 | (inside < 0 ? 1u : 0u));
    }
    constexpr bool is_meeting() const { return (word_ & meeting_bit) != 0; }
    constexpr std::uint32_t index() const { return (word_ & ~meeting_bit) >> 1; }
    constexpr int inside() const { return (word_ & 1) != 0 ? -1 : 1; }
    constexpr LineId turned() const { return LineId(word_ ^ 1u); }
    // Whichever side is inside.
    constexpr bool is_along(LineId o) const { return (word_ ^ o.word_) < 2; }
    constexpr std::uint32_t number() const { return word_ >> 1; }  // of the line, without its side
    constexpr bool operator==(const LineId&) const = default;

private:
    static constexpr std::uint32_t meeting_bit = std::uint32_t{1} << 31;
    constexpr explicit LineId(std::uint32_t word) : word_(word) {}
    std::uint32_t word_ = 0;
};

// The three numbers' leading bits: floor(v / 2^s) with one s for a line, at most 2^20 in magnitude.
// They decide the sign of most triples in one word. Of a direction the third number is an offset,
// which is longer than the others by the bits of a place in the picture: its s is more by as many.
// That is the same for all lines of a picture, so it leaves the sign of their determinant.
using LeadingBits = std::array<std::int32_t, 3>;
inline constexpr int leading_bits = 20;
inline constexpr int offset_is_longer = offset_bits - normal_bits;

struct LightLine {
    constexpr LightLine() = default;
    // `longer` is 0 or offset_is_longer.
    constexpr explicit LightLine(const std::array<Sum, 3>& numbers, int longer = 0) : v(numbers) {
        const std::array<int, 3> more{0, 0, longer};
        int longest = 0, leads = -longer;
        for (std::size_t k = 0; k < 3; ++k) {
            longest = std::max(longest, v[k].bit_length());
            leads = std::max(leads, v[k].bit_length() - more[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const int s = leads - leading_bits + more[k];
            const Sum bits = s < 0 ? v[k] << -s : v[k] >> s;
            leading[k] = static_cast<std::int32_t>(bits.to_int64());
        }
        limbs = (longest + 2 + 63) / 64;
    }

    std::array<Sum, 3> v;
    LeadingBits leading{};
    std::int32_t limbs = 1;  // of 64 bits that hold each number, with two bits to spare
};

// The sign of det(a, b, c); 0 where the leading bits leave it open.
int sign_by_leading(const LightLine& a, const LightLine& b, const LightLine& c);
// The definition: the sign of the determinant itself.
int sign_by_all_bits(const LightLine& a, const LightLine& b, const LightLine& c);

// Where the planes of two facets meet.
struct Meeting {
    std::uint32_t on, other;
    Sum on_at_light, other_at_light;
    LightLine line;
};

// F . L, as pi . E in planes.hpp.
inline constexpr int at_light_bits = offset_bits + 1;
static_assert(offset_bits + at_light_bits + 2 < Sum::bits - 2);  // a meeting line's numbers

// A line as the eye sees it on one facet's plane; positive inside.
struct ShownLine {
    using Word = fixed::WideInt<4>;
    Word x, y, c;

    int sign_at(std::int64_t px, std::int64_t py) const;
    // The columns of a run at which the sign is positive.
    Run inside(const Space& space, const Run& run, int row) const;
};
// Of a meeting line on a third facet: F . L times a ScreenLine, twice, and a pixel.
static_assert(line_bits + at_light_bits + 1 + word_bits + 2 < ShownLine::Word::bits);

struct SignCounts {
    std::uint64_t edges = 0;     // signs of three edges' lines
    std::uint64_t meetings = 0;  // signs with a meeting line among the three
};

class LightLines {
public:
    static std::size_t bytes(const Mesh& mesh, std::size_t meetings);
    // False if the memory is too small. `setting` is kept by reference.
    bool make(const Setting& setting, std::size_t meetings, std::span<std::byte> memory);

    const Setting& setting() const { return *setting_; }
    // The line of side k of a facet, inside where the facet is.
    LineId side(std::uint32_t facet, std::size_t k) const;
    // The facet's three lines, in the order in which its corners turn positively (see sign).
    std::array<LineId, 3> outline(std::uint32_t facet, SignCounts& counts) const;

    // The line on `on` where the plane of `other` cuts it. Inside is where that plane's value has
    // the sign `side`. Adds it; if there is no room, only counts it, and the id is not to be used.
    LineId meeting(std::uint32_t on, std::uint32_t other, int side);
    std::size_t meetings() const { return used_; }
    std::size_t meetings_needed() const { return most_; }
    bool fits() const { return most_ <= meetings_.size(); }
    // Forgets the meetings from `count` on.
    void release(std::size_t count) { used_ = count; }

    // Whether the meeting point of a and b, which follow each other in a convex piece with their
    // insides on it, is inside c: 1, on it: 0, or outside: -1.
    int sign(LineId a, LineId b, LineId c, SignCounts& counts) const;

    ShownLine shown(std::uint32_t on, LineId id) const;
    const LightLine& line(LineId id) const;
    // The line on a facet where a plane cuts it, as the light sees it.
    LightLine where_cut(std::uint32_t on, const Plane& plane) const;

    // By how many bits the third number of the picture's lines is longer than the others.
    int longer() const { return setting_->light.centre.w != 0 ? 0 : offset_is_longer; }

private:
    std::array<Sum, 3> numbers(const Plane& plane) const;

    const Setting* setting_ = nullptr;
    std::span<LightLine> edges_;
    std::span<Meeting> meetings_;
    std::size_t used_ = 0, most_ = 0;
};

}  // namespace umbra78::shadow::rivals
