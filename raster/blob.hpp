// Blobs: an ellipse on the ground beneath each object, the simplest shadow there is (hw/MACHINE.md,
// section 26).
//
//   p - o = s u + t v + h n, and over all points of an object s and t have a least and a greatest:
//   centre = o + half_even((s_min + s_max) / 2 u + (t_min + t_max) / 2 v)
//   a = half_even((s_max - s_min) / 2 u),   b = half_even((t_max - t_min) / 2 v)
//
// In: the ground's patch, and an object's points, all world words. Out: world words, each
// coordinate rounded once; and the eight patches that the ellipse is drawn as.
#pragma once

#include "fixed/wide_int.hpp"
#include "raster/scene.hpp"
#include "raster/vector.hpp"

#include <cstdint>
#include <span>

namespace umbra78::raster {

// centre + a cos + b sin, filled.
struct Ellipse {
    World centre{}, a{}, b{};
    constexpr bool operator==(const Ellipse&) const = default;
};

class EllipseFit {
public:
    explicit EllipseFit(const Patch& ground);
    void add(const World& point);
    // False, and `out` as it was, if there was no point or the ellipse's corners leave the world.
    bool fit(Ellipse& out) const;

private:
    using Int = fixed::WideInt<3>;  // s and t times the square of |u x v|: 138 bits
    struct Range {
        Vector<Int> along{};  // whose product with p - o it is
        Int min = 0, max = 0;
        void add(const Vector<Int>& from_origin, bool first);
    };

    World origin_;
    Vector<std::int64_t> u_, v_;
    Int scale_;
    Range s_, t_;
    bool any_ = false;
};

inline constexpr int patches_per_ellipse = 8;

// Patch m from 45 m degrees: i along the rim, from a toward b, and j from the centre to the rim.
void ellipse_patches(const Ellipse& ellipse, std::span<Patch, patches_per_ellipse> out);

}  // namespace umbra78::raster
