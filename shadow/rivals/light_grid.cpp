#include "shadow/rivals/light_grid.hpp"

#include <bit>
#include <cstdlib>

namespace umbra78::shadow::rivals {
namespace {

using fixed::Rounding;

inline constexpr int face_fraction = 20;
inline constexpr std::int64_t face_one = std::int64_t{1} << face_fraction;

Sum floor_divide(const Sum& num, const Sum& den) {  // den > 0
    const auto [quotient, rest] = Sum::divide(num, den);
    return rest.is_negative() ? quotient - 1 : quotient;
}

}  // namespace

LightPicture::LightPicture(const Centre& light) : light_(light), axis_{0, 1, 2} {
    const std::array size{std::abs(light.x), std::abs(light.y), std::abs(light.z)};
    if (size[1] > size[0] && size[1] >= size[2]) axis_ = {1, 2, 0};
    if (size[2] > size[0] && size[2] > size[1]) axis_ = {2, 0, 1};
}

// Faces 2 a and 2 a + 1 look along axis a and against it.
bool LightPicture::box(const std::array<Point, 3>& corners, int face, LightBox& out) const {
    out = {face, INT64_MAX, INT64_MIN, INT64_MAX, INT64_MIN};
    const auto add = [&](std::int64_t u, std::int64_t v) {
        out.u0 = std::min(out.u0, u);
        out.u1 = std::max(out.u1, u);
        out.v0 = std::min(out.v0, v);
        out.v1 = std::max(out.v1, v);
    };
    const std::array l{std::int64_t{light_.x}, std::int64_t{light_.y}, std::int64_t{light_.z}};
    const auto word = [](const Point& p) {
        return std::array<std::int64_t, 3>{p.x, p.y, p.z};
    };
    if (light_.w == 0) {
        const auto [d, a, b] = axis_;
        for (const Point& corner : corners) {
            const auto p = word(corner);
            add(p[a] * l[d] - p[d] * l[a], p[b] * l[d] - p[d] * l[b]);
        }
        return true;
    }
    const auto axis = static_cast<std::size_t>(face / 2);
    const std::int64_t sense = face % 2 == 0 ? 1 : -1;
    int right = 0, left = 0, above = 0, below = 0, before = 0;
    for (const Point& corner : corners) {
        const auto p = word(corner);
        const std::int64_t m = sense * (p[axis] - l[axis]);
        const std::int64_t u = p[(axis + 1) % 3] - l[(axis + 1) % 3];
        const std::int64_t v = p[(axis + 2) % 3] - l[(axis + 2) % 3];
        right += u > m ? 1 : 0, left += u < -m ? 1 : 0;
        above += v > m ? 1 : 0, below += v < -m ? 1 : 0;
        if (m <= 0) continue;
        ++before;
        const auto on_face = [&](std::int64_t w) {
            return std::clamp(fixed::round_divide(w * face_one, m, Rounding::floor), -face_one,
                              face_one);
        };
        add(on_face(u), on_face(v));
    }
    if (right == 3 || left == 3 || above == 3 || below == 3 || before == 0) return false;
    // Where it passes the light it may be anywhere on the face.
    if (before < 3) out = {face, -face_one, face_one, -face_one, face_one};
    return true;
}

LightPlace LightPicture::place(const SeenPlane& on, const Centre& eye, std::int32_t px,
                               std::int32_t py) const {
    // (x, y, z, w) = e p - (pi . p) E, with w > 0.
    const Sum value = Sum(on.x) * px + Sum(on.y) * py + on.c;
    const bool flip = on.e.is_negative();
    const Sum e = flip ? -on.e : on.e, t = flip ? -value : value;
    const std::array<Sum, 3> p{e * px - t * eye.x, e * py - t * eye.y, -(t * eye.z)};
    const Sum w = e - t * eye.w;
    const std::array<std::int64_t, 3> l{light_.x, light_.y, light_.z};
    const auto small = [](const Sum& v) { return v.to_int64(); };
    if (light_.w == 0) {
        const auto [d, a, b] = axis_;
        return {0, small(floor_divide(p[a] * l[d] - p[d] * l[a], w)),
                small(floor_divide(p[b] * l[d] - p[d] * l[b], w))};
    }
    const std::array<Sum, 3> from{p[0] - w * l[0], p[1] - w * l[1], p[2] - w * l[2]};
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (from[k].abs() > from[axis].abs()) axis = k;
    if (from[axis].is_zero()) return {0, 0, 0};  // the light's own place: before it is nothing
    const Sum m = from[axis].abs();
    const auto on_face = [&](const Sum& v) { return small(floor_divide(v * face_one, m)); };
    return {static_cast<int>(2 * axis) + (from[axis].is_negative() ? 1 : 0),
            on_face(from[(axis + 1) % 3]), on_face(from[(axis + 2) % 3])};
}

std::int64_t LightPicture::depth(const Point& p, int face) const {
    const std::array<std::int64_t, 3> at{p.x, p.y, p.z}, l{light_.x, light_.y, light_.z};
    if (light_.w == 0) return -(at[0] * l[0] + at[1] * l[1] + at[2] * l[2]);
    const auto axis = static_cast<std::size_t>(face / 2);
    return face % 2 == 0 ? at[axis] - l[axis] : l[axis] - at[axis];
}

// --- the grid -------------------------------------------------------------------------------

std::size_t LightGrid::column(std::int64_t u) const {
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(fixed::floor_shift(u - u0_, shift_u_), 0, cells_ - 1));
}
std::size_t LightGrid::row(std::int64_t v) const {
    return static_cast<std::size_t>(
        std::clamp<std::int64_t>(fixed::floor_shift(v - v0_, shift_v_), 0, cells_ - 1));
}

bool LightGrid::build(const Setting& setting, int cells, std::span<std::byte> memory,
                      std::size_t& needed) {
    const Mesh& mesh = setting.mesh;
    picture_ = LightPicture(setting.light.centre);
    if (cells == 0) {
        cells = 1;
        while (cells < 256 && static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells) <
                                  mesh.facets.size())
            cells *= 2;
    }
    cells_ = cells;
    const auto for_boxes = [&](auto&& visit) {
        LightBox box{};
        for (std::uint32_t f = 0; f < mesh.facets.size(); ++f)
            for (int face = 0; face < picture_.faces(); ++face)
                if (setting.light.sides[f] != 0 && picture_.box(mesh.corners(f), face, box))
                    visit(f, box);
    };
    LightBox all{0, 0, 0, 0, 0};
    bool any = false;
    for_boxes([&](std::uint32_t, const LightBox& b) {
        all = any ? LightBox{0, std::min(all.u0, b.u0), std::max(all.u1, b.u1),
                             std::min(all.v0, b.v0), std::max(all.v1, b.v1)}
                  : b;
        any = true;
    });
    const auto shift_for = [&](std::int64_t extent) {
        const auto bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(extent)));
        return std::max(0, bits - std::countr_zero(static_cast<unsigned>(cells)));
    };
    u0_ = all.u0, v0_ = all.v0;
    shift_u_ = shift_for(all.u1 - all.u0), shift_v_ = shift_for(all.v1 - all.v0);

    const auto side = static_cast<std::size_t>(cells_);
    const std::size_t count = static_cast<std::size_t>(picture_.faces()) * side * side;
    Carver carver(memory);
    starts_ = carver.take<std::uint32_t>(count + 1);
    items_ = {};
    std::size_t entries = 0;
    if (starts_.empty()) {
        for_boxes([&](std::uint32_t, const LightBox& b) {
            for_cells(b, [&](std::size_t) { ++entries; });
        });
        carver.take<std::uint32_t>(entries);
        needed = carver.used();
        return false;
    }
    // Counts, then starts, then each list from its end to its start.
    std::fill(starts_.begin(), starts_.end(), 0);
    for_boxes([&](std::uint32_t, const LightBox& b) {
        for_cells(b, [&](std::size_t cell) { ++starts_[cell], ++entries; });
    });
    items_ = carver.take<std::uint32_t>(entries);
    needed = carver.used();
    if (!carver.fits()) return false;
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) start = sum += start;
    for_boxes([&](std::uint32_t f, const LightBox& b) {
        for_cells(b, [&](std::size_t cell) { items_[--starts_[cell]] = f; });
    });
    return true;
}

}  // namespace umbra78::shadow::rivals
