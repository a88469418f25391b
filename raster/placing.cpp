#include "raster/placing.hpp"

#include "fixed/rounding.hpp"
#include "fixed/sine.hpp"
#include "fixed/trap.hpp"

namespace umbra78::raster {
namespace {

// v / 2^n, half to even.
std::int64_t round_wide(const Wide& v, int n) {
    const Wide floor = v >> n;
    const Wide twice = (v - (floor << n)) << 1, divisor = Wide(1) << n;
    const bool up = twice > divisor || (twice == divisor && floor.is_odd());
    return (floor + (up ? 1 : 0)).to_int64();
}

}  // namespace

Rotation rotation_of(const Turn& turn) {
    const auto [sx, cx] = fixed::sine_cosine(turn.x);
    const auto [sy, cy] = fixed::sine_cosine(turn.y);
    const auto [sz, cz] = fixed::sine_cosine(turn.z);
    const std::int32_t sysx = axis_product(sy, sx), sycx = axis_product(sy, cx);
    return {{{axis_product(cz, cy), axis_product(cz, sysx) - axis_product(sz, cx),
              axis_product(cz, sycx) + axis_product(sz, sx)},
             {axis_product(sz, cy), axis_product(sz, sysx) + axis_product(cz, cx),
              axis_product(sz, sycx) - axis_product(cz, sx)},
             {-sy, axis_product(cy, sx), axis_product(cy, cx)}}};
}

Vector<Wide> rotated(const Rotation& rotation, const Vector<Wide>& local) {
    Vector<Wide> out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = local[0] * rotation[k][0] + local[1] * rotation[k][1] + local[2] * rotation[k][2];
    return out;
}

WideVector placed(const Placing& placing, const Vector<Wide>& local, int fraction) {
    const Vector<Wide> exact = rotated(placing.rotation, local);
    const int shift = fraction + axis_fraction - world_fraction;
    return {placing.place.x + round_wide(exact[0], shift),
            placing.place.y + round_wide(exact[1], shift),
            placing.place.z + round_wide(exact[2], shift)};
}

bool in_world(const WideVector& words) {
    constexpr std::int64_t reach = std::int64_t{32767} << world_fraction;
    bool in = true;
    for (const std::int64_t word : words) in = in && word >= -reach && word <= reach;
    return in;
}

World world_of(const WideVector& words) {
    fixed::require(in_world(words), "world_of: a point outside the world");
    return {static_cast<std::int32_t>(words[0]), static_cast<std::int32_t>(words[1]),
            static_cast<std::int32_t>(words[2])};
}

}  // namespace umbra78::raster
