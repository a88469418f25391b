// Vectors of three doubles, for truth and studies: places in world units, or directions.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbra78::tools {

using Real3 = std::array<double, 3>;

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline double dot(const Real3& a, const Real3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// origin + t direction: a point of a ray, and every other weighted sum used here.
inline Real3 along(const Real3& origin, double t, const Real3& direction) {
    return {origin[0] + t * direction[0], origin[1] + t * direction[1],
            origin[2] + t * direction[2]};
}

inline Real3 minus(const Real3& a, const Real3& b) { return along(a, -1, b); }

inline Real3 times(double factor, const Real3& a) { return along({}, factor, a); }

inline Real3 cross(const Real3& a, const Real3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Real3& a) { return std::sqrt(dot(a, a)); }

}  // namespace umbra78::tools
