#include "raster/solids.hpp"

#include "fixed/rounding.hpp"
#include "raster/arc.hpp"

namespace umbra78::raster {
namespace {

using fixed::Rounding;

// (a (3 - j) + b j) / 3 with 30 more fraction bits.
std::int64_t profile_third(std::int32_t a, std::int32_t b, int j) {
    const std::int64_t thrice = std::int64_t{a} * (3 - j) + std::int64_t{b} * j;
    return fixed::round_divide(thrice * axis_one, 3, Rounding::half_even);
}

// False, and no word, where the point lies outside the world.
bool put(const WideVector& words, World& out) {
    const bool in = in_world(words);
    if (in) out = world_of(words);
    return in;
}

bool revolve_line(std::int32_t radius0, std::int32_t height0, std::int32_t radius1,
                  std::int32_t height1, const Placing& placing,
                  std::span<Patch, patches_round> out) {
    Profile profile{};
    for (int j = 0; j < 4; ++j)
        profile[static_cast<std::size_t>(j)] = {profile_third(radius0, radius1, j),
                                                profile_third(height0, height1, j)};
    return revolve(profile, placing, out);
}

}  // namespace

bool revolve(const Profile& profile, const Placing& placing,
             std::span<Patch, patches_round> out) {
    bool in = true;
    for (int k = 0; k < patches_round; ++k) {
        for (int n = 0; n < 16; ++n) {
            const auto [sine, cosine] = arc_point(k, n % 4);
            const ProfilePoint& p = profile[static_cast<std::size_t>(n / 4)];
            const Vector<Wide> local{Wide(p.radius) * sine, Wide(p.height) * axis_one,
                                     Wide(p.radius) * cosine};
            World& point = out[static_cast<std::size_t>(k)].control[static_cast<std::size_t>(n)];
            in = put(placed(placing, local, profile_fraction + axis_fraction), point) && in;
        }
    }
    return in;
}

bool torus_patches(std::int32_t radius, std::int32_t tube, const Placing& placing,
                   std::span<Patch, patches_per_torus> out) {
    bool in = true;
    for (int q = 0; q < patches_round; ++q) {
        Profile profile{};
        for (int j = 0; j < 4; ++j) {
            const auto [sine, cosine] = arc_point(q, j);
            profile[static_cast<std::size_t>(j)] = {
                std::int64_t{radius} * axis_one + std::int64_t{tube} * cosine,
                std::int64_t{tube} * sine};
        }
        const auto ring = out.subspan(static_cast<std::size_t>(q * patches_round));
        in = revolve(profile, placing, ring.first<patches_round>()) && in;
    }
    return in;
}

bool wall_patches(std::int32_t base, std::int32_t top, std::int32_t height, const Placing& placing,
                  std::span<Patch, patches_round> out) {
    return revolve_line(base, 0, top, height, placing, out);
}

bool disc_patches(std::int32_t radius, std::int32_t height, const Placing& placing,
                  std::span<Patch, patches_round> out) {
    return revolve_line(0, height, radius, height, placing, out);
}

bool box_patches(const World& size, const Placing& placing,
                 std::span<Patch, patches_per_box> out) {
    const Vector<std::int32_t> sides{size.x, size.y, size.z};
    // Step i of 0..3 along a side: from -1/2 to +1/2 of it.
    const auto step = [&](std::size_t axis, int i) {
        return Wide(fixed::round_divide(std::int64_t{sides[axis]} * axis_one * (2 * i - 3), 6,
                                        Rounding::half_even));
    };
    bool in = true;
    for (std::size_t face = 0; face < patches_per_box; ++face) {
        const std::size_t axis = face / 2, along_i = (axis + 1) % 3, along_j = (axis + 2) % 3;
        for (int n = 0; n < 16; ++n) {
            Vector<Wide> local;
            local[axis] = step(axis, face % 2 == 0 ? 0 : 3);
            local[along_i] = step(along_i, n % 4);
            local[along_j] = step(along_j, n / 4);
            World& point = out[face].control[static_cast<std::size_t>(n)];
            in = put(placed(placing, local, profile_fraction), point) && in;
        }
    }
    return in;
}

}  // namespace umbra78::raster
