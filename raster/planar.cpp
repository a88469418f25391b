#include "raster/planar.hpp"

#include "fixed/wide_int.hpp"

namespace umbra78::raster {
namespace {

// A sun's reach in heights of the highest point, a lamp's in heights of its own: the last 65th
// below the lamp, whose shadows run to infinity, casts none.
constexpr std::int64_t sun_reach = 2, lamp_reach = 64;

// 33 bits a side, 67 the normal, 102 a height.
using WordInt = fixed::WideInt<2>;

WordInt wide(std::int32_t a, std::int32_t b) { return std::int64_t{a} - b; }

// `words`: how many world words are multiplied in it.
Rational in_units(const WordInt& v, int words) {
    const Rational::Int one = 1;
    return Rational(Rational::Int(v), one << (words * world_fraction));
}

// The plane's normal u x v, and heights over it in that measure.
class Ground {
public:
    explicit Ground(const Patch& plane) : origin_(plane.control[0]) {
        normal_ = cross(from_origin(plane.control[3]), from_origin(plane.control[12]));
    }
    void turn() {
        for (WordInt& n : normal_) n = -n;
    }

    WordInt height(const World& p) const { return dot(normal_, from_origin(p)); }
    Vector<Rational> normal() const {
        return {in_units(normal_[0], 2), in_units(normal_[1], 2), in_units(normal_[2], 2)};
    }
    // height(p) = normal . p - offset
    Rational offset() const { return -in_units(height({0, 0, 0}), 3); }

private:
    Vector<WordInt> from_origin(const World& p) const {
        return {wide(p.x, origin_.x), wide(p.y, origin_.y), wide(p.z, origin_.z)};
    }

    World origin_;
    Vector<WordInt> normal_;
};

// The greatest height of what may cast, or, where none is positive, any that is.
Rational highest(const Surfaces& surfaces, std::size_t ground, const Ground& plane) {
    WordInt most = 0;
    const auto add = [&](const World& p) {
        const WordInt h = plane.height(p);
        if (h > most) most = h;
    };
    for (std::size_t k = 0; k < surfaces.patches.size(); ++k)
        if (k != ground)
            for (const World& p : surfaces.patches[k].control) add(p);
    for (const World& p : surfaces.mesh.vertices) add(p);
    return most.is_zero() ? dot(plane.normal(), plane.normal()) : in_units(most, 3);
}

// flat() as a matrix, where `from` is the light's direction or place.
RationalMatrix flatten(const Vector<Rational>& from, bool lamp, const Vector<Rational>& n,
                       const Rational& offset, const Rational& rise) {
    RationalMatrix m;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational along = from[k] / rise;
        m[k] = {-(along * n[0]), -(along * n[1]), -(along * n[2]), along * offset};
        m[k][k] += 1;
    }
    m[3] = {0, 0, 0, 1};
    if (lamp) m[3] = {-(n[0] / rise), -(n[1] / rise), -(n[2] / rise), Rational(1) + offset / rise};
    return m;
}

}  // namespace

bool planar_shadow(const View& observer, const View& light, const Surfaces& surfaces,
                   std::size_t ground, const MachineSpec& spec, RationalMatrix& out) {
    fixed::require(ground < surfaces.patches.size(), "planar shadow: no such ground");
    const bool lamp = has_eye(light);
    const Vector<Rational> from = lamp ? origin(light) : exact(light.axes.back);
    Ground plane(surfaces.patches[ground]);
    const auto rise_over = [&] {
        return lamp ? dot(plane.normal(), from) - plane.offset() : dot(plane.normal(), from);
    };
    if (rise_over().is_zero()) return false;
    if (rise_over().is_negative()) plane.turn();
    const Rational rise = rise_over();
    const Vector<Rational> n = plane.normal();
    out = multiply(world_to_screen(observer, spec),
                   flatten(from, lamp, n, plane.offset(), rise));
    const Rational reach = lamp ? Rational(lamp_reach) * rise
                                : Rational(sun_reach) * highest(surfaces, ground, plane);
    const Rational near = has_eye(observer) ? Rational(observer.near_depth,
                                                       std::int64_t{1} << world_fraction)
                                            : Rational(1);
    const Rational half = spec.half_px();
    const Rational scale = Rational(2) * half * near / reach;
    const std::array<Rational, 4> height{n[0], n[1], n[2], -plane.offset()};
    for (std::size_t j = 0; j < 4; ++j) out[2][j] = scale * height[j] - half * out[3][j];
    return true;
}

}  // namespace umbra78::raster
