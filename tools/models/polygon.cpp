#include "tools/models/polygon.hpp"

#include "fixed/wide_int.hpp"
#include "raster/vector.hpp"

namespace umbra78::tools {
namespace {

// Coordinates have 53 bits with sign, differences 54, doubled areas 109, sums of 2^16 of them 125.
using Area = fixed::WideInt<2>;
using Corners = std::array<std::uint32_t, 3>;

struct Flat {
    std::int64_t x, y;
    bool operator==(const Flat&) const = default;
};

int sign_of(const Area& v) { return v.is_zero() ? 0 : v.is_negative() ? -1 : 1; }

// The way from a by b to c turns: 1 to the left, -1 to the right, 0 not.
int turn(const Flat& a, const Flat& b, const Flat& c) {
    return sign_of(Area(b.x - a.x) * (c.y - a.y) - Area(b.y - a.y) * (c.x - a.x));
}

// The corners along the two axes in which the polygon's area is largest, turning to the left.
std::vector<Flat> flattened(std::span<const ModelPoint> corners) {
    raster::Vector<Area> normal;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto &p = corners[k].word, &q = corners[(k + 1) % corners.size()].word;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] += Area(p[u] - q[u]) * (p[v] + q[v]);
        }
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (normal[k].abs() > normal[axis].abs()) axis = k;
    std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis].is_negative()) std::swap(u, v);
    std::vector<Flat> flat;
    for (const ModelPoint& p : corners) flat.push_back({p.word[u], p.word[v]});
    return flat;
}

class EarCutter {
public:
    explicit EarCutter(std::span<const ModelPoint> corners) : flat_(flattened(corners)) {
        for (std::uint32_t k = 0; k < corners.size(); ++k) left_.push_back(k);
    }

    std::vector<Corners> cut() {
        std::vector<Corners> triangles;
        std::size_t at = 0;  // goes on from the last ear, so that a fan of slivers is avoided
        while (left_.size() >= 3) {
            std::size_t tried = 0;
            while (tried < left_.size() && !is_ear((at + tried) % left_.size())) ++tried;
            const std::size_t ear = (at + tried) % left_.size();  // `at` itself where none is
            triangles.push_back(triangle_at(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
            at = left_.empty() ? 0 : ear % left_.size();
        }
        return triangles;
    }

private:
    Corners triangle_at(std::size_t k) const {
        const std::size_t n = left_.size();
        return {left_[(k + n - 1) % n], left_[k], left_[(k + 1) % n]};
    }

    bool is_ear(std::size_t k) const {
        const Corners t = triangle_at(k);
        const Flat &a = flat_[t[0]], &b = flat_[t[1]], &c = flat_[t[2]];
        if (turn(a, b, c) <= 0) return false;
        for (const std::uint32_t other : left_) {
            const Flat& p = flat_[other];
            const bool corner = p == a || p == b || p == c;
            if (!corner && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    std::vector<Flat> flat_;
    std::vector<std::uint32_t> left_;  // the corners that are not cut off yet
};

}  // namespace

std::vector<Corners> triangulate(std::span<const ModelPoint> corners) {
    if (corners.size() == 3) return {{0, 1, 2}};
    return EarCutter(corners).cut();
}

bool without_area(const ModelPoint& a, const ModelPoint& b, const ModelPoint& c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto flat = [&](const ModelPoint& p) { return Flat{p.word[u], p.word[v]}; };
        if (turn(flat(a), flat(b), flat(c)) != 0) return false;
    }
    return true;
}

}  // namespace umbra78::tools
