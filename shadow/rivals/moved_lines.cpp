#include "shadow/rivals/moved_lines.hpp"

#include <bit>

namespace umbra78::shadow::rivals {
namespace {

using Rows = std::array<const LightLine*, 3>;

int sign_of_rows(const Rows& r) {
    const int s = sign_by_leading(*r[0], *r[1], *r[2]);
    return s != 0 ? s : sign_by_all_bits(*r[0], *r[1], *r[2]);
}

inline constexpr std::size_t numbers_of_line = 3;
using Units = std::array<LightLine, numbers_of_line>;
constexpr Units units_of(int longer) {
    return {LightLine({Sum(1), Sum(0), Sum(0)}, longer),
            LightLine({Sum(0), Sum(1), Sum(0)}, longer),
            LightLine({Sum(0), Sum(0), Sum(1)}, longer)};
}
constexpr Units units_of_place = units_of(0), units_of_direction = units_of(offset_is_longer);
const Units& units_of(const LightLines& lines) {
    return lines.longer() == 0 ? units_of_place : units_of_direction;
}

// The infinitesimal of number c of the line with rank k is h^(2^(3 k + c)): so a product of some of
// them is greater than another if its set, as a binary number, is less. Its coefficient is the
// determinant with units in place of these lines; 0 if two of them are of one line or one column.
// False if the set is such a one.
bool put_units(const Units& units, std::uint32_t set, std::span<const std::size_t> places,
               Rows& rows) {
    std::uint32_t columns = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::uint32_t of_line = set >> (numbers_of_line * k) & 7u;
        if (of_line == 0) continue;
        if (!std::has_single_bit(of_line) || (columns & of_line) != 0) return false;
        columns |= of_line;
        rows[places[k]] = &units[static_cast<std::size_t>(std::countr_zero(of_line))];
    }
    return true;
}

}  // namespace

int moved_sign(const LightLines& lines, LineId a, LineId b, LineId c, MovedCounts& counts) {
    const int s = lines.sign(a, b, c, counts.signs);
    if (s != 0) return s;
    ++counts.ties;
    const std::array ids{a, b, c};
    std::array<std::size_t, 3> places{0, 1, 2};  // in the order of the lines' numbers
    std::sort(places.begin(), places.end(), [&](std::size_t i, std::size_t j) {
        return ids[i].number() < ids[j].number();
    });
    const Rows unmoved{&lines.line(a), &lines.line(b), &lines.line(c)};
    const int inside = a.inside() * b.inside() * c.inside();
    const Units& units = units_of(lines);
    for (std::uint32_t set = 1; set < 1u << 9; ++set) {
        Rows rows = unmoved;
        if (!put_units(units, set, places, rows)) continue;
        if (const int t = sign_of_rows(rows); t != 0) return t * inside;
    }
    fixed::require(false, "lines that are moved meet");
    return 0;
}

// The plane through the eye E and the row at y: (0, E.z, y E.w - E.y), with the offset -y E.z.
SeenRow seen_row(const LightLines& lines, std::uint32_t on, int row) {
    const Space& space = lines.setting().space;
    const Centre& eye = space.eye();
    const std::int64_t y = space.centre(row), z = eye.z;
    const Plane at{{0, z, y * eye.w - eye.y}, Sum(-y * z)};
    const Plane growth{{0, 0, eye.w}, Sum(-z)};
    return {lines.where_cut(on, at), lines.where_cut(on, growth)};
}

int row_sign(const LightLines& lines, LineId a, LineId b, const SeenRow& row) {
    const bool in_order = a.number() < b.number();
    const std::array<std::size_t, 2> places{in_order ? 0u : 1u, in_order ? 1u : 0u};
    const Units& units = units_of(lines);
    for (std::uint32_t set = 0; set < 1u << 6; ++set) {
        for (const LightLine* line : {&row.at, &row.growth}) {
            Rows rows{&lines.line(a), &lines.line(b), line};
            if (!put_units(units, set, places, rows)) break;
            if (const int s = sign_of_rows(rows); s != 0) return s * a.inside() * b.inside();
        }
    }
    fixed::require(false, "a row of pixels is no line");
    return 0;
}

}  // namespace umbra78::shadow::rivals
