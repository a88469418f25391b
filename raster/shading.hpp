// Shading: Lambert's cosine and Phong's highlight (Phong 1975), in 8-bit levels; and other rules.
//
//   I = diffuse (ambient + (1 - ambient) max(0, N.L)) + specular max(0, R.V)^(2^shininess)
//   R = 2 (N.L) N - L,   no highlight where N.L <= 0 or in shadow
//
//   blinn    (N.H)^(4 x 2^shininess) in place of (R.V)^(2^shininess), H = (L + V) / |L + V|
//   lambert  no highlight                              none     N.L = 1 and no highlight
//
// The light's direct share is I less the ambient term alone, both as levels. At 255 it is the
// direct share that is cut, so a shadow never leaves less than the ambient term. Several sources
// add their shares one after the other, and in a coloured frame each channel is shaded by itself
// (hw/MACHINE.md, section 23).
//
// In: a block's corners and corrections in object words with object_guard more fraction bits.
// Out: for each leaf I and the direct share, 0..255. hw/MACHINE.md, section 9, has every rounding.
// A block has a unit normal, Q1.14, at each of its corners, from its own tangents in the world;
// a leaf's normal is the bilinear mean at the leaf's centre, and its length is divided out. It is
// turned toward the viewer, so an open surface has two sides. Cosines are Q1.14, floored. Where a
// normal has no direction (a block that is a point or a line) its cosines are 0: ambient light.
// Not emulated: how the machine of 1978 would have shaded; the paper leaves it open.
#pragma once

#include "raster/block.hpp"
#include "raster/sampling.hpp"
#include "raster/scene.hpp"
#include "raster/vector.hpp"
#include "raster/view.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::raster {

inline constexpr int object_guard = 6;  // fraction bits of places beyond those of object words
inline constexpr int unit_fraction = 14;
using UnitVector = Vector<std::int32_t>;  // Q1.14

// v with as many low bits rounded off, half up, as bring the largest component to `bits` bits.
WideVector scaled_to(WideVector v, int bits);

// v / |v| in Q1.14, rounded half up; 0 for 0.
UnitVector unit_vector(WideVector v);

// Where light comes from or goes to: a direction, the same everywhere, or a point.
struct Toward {
    bool to_point = false;
    UnitVector direction{};  // used where to_point is false
    WideVector point{};      // used where it is true; object words with guard bits
};

// Toward the eye of a view: the observer, or the light that the view is of. An orthographic
// view's eye is at infinity.
Toward toward_eye(const View& view, hw::WordFormat object);

// What the scene calls a light, as the shading has it.
struct ShadingSource {
    Toward toward{};
    Levels level_q8 = 256;  // each 0..256
};
inline constexpr std::size_t max_sources = hw::built(hw::Feature::lights) ? 8 : 1;
template <class T>
using BySource = std::array<T, max_sources>;

// How a sample's levels follow from its normal. Half the angle falls off a quarter as fast, so
// Blinn's highlight (1977) has the size of Phong's with four times its exponent.
enum class ShadingRule : std::uint8_t { phong, blinn, lambert, none };

struct ShadingSpec {
    std::int32_t ambient_q8 = 77;  // 0..256
    Toward viewer{};
    BySource<ShadingSource> sources{};
    std::size_t source_count = 1;
    std::size_t channels = 1;
    ShadingRule rule = ShadingRule::phong;
    bool keeps_normals = false;  // they are made whatever the rule

    ShadingSpec() = default;
    bool makes_normals() const { return keeps_normals || rule != ShadingRule::none; }
    // A grey frame with one source.
    ShadingSpec(std::int32_t ambient, const Toward& light, const Toward& to_viewer)
        : ambient_q8(ambient), viewer(to_viewer) {
        sources[0].toward = light;
    }
};

// What a channel of a sample is shaded with, in levels of 0..255.
struct Shade {
    std::uint8_t intensity = 0;
    BySource<std::uint8_t> direct{};  // how much of it each source gives; the rest is ambient light

    constexpr auto operator<=>(const Shade&) const = default;
};
// By channel. Samples at the same Z are ordered by it.
using Shades = std::array<Shade, max_channels>;

// The sources that a sample is in the shadow of, a bit each.
using Shadowed = std::uint32_t;

// Cosines at a sample, Q1.14, floored: of the normal with the directions to a light and to the
// viewer, and of those with each other; by Blinn's rule of the normal with the halfway direction.
struct Cosines {
    std::int64_t n_dot_l, n_dot_v, l_dot_v, n_dot_h = 0;

    // Of the other side of the surface.
    constexpr void turn() {
        n_dot_l = -n_dot_l;
        n_dot_v = -n_dot_v;
        n_dot_h = -n_dot_h;
    }
};
// Of a surface that faces light and viewer, which is shaded as if every sample were one.
inline constexpr Cosines facing_all{1 << unit_fraction, 1 << unit_fraction, 1 << unit_fraction};

// A normal of any length and two directions. 0 where the normal has no direction.
Cosines cosines(const WideVector& normal, const UnitVector& to_light, const UnitVector& to_viewer,
                ShadingRule rule);

// `cosines` with each source of the spec.
Shades shade(std::span<const Cosines> cosines, const ShadingSpec& spec, const Material& material,
             Shadowed shadowed);

// By a normal of any length, on either side, where viewer and sources are at infinity.
Shades shade_normal(const WideVector& normal, const ShadingSpec& spec, const Material& material);

// From a place, 1024 times as large as `toward` has it.
UnitVector direction(const Toward& toward, const WideVector& place_1024);

// A normal as the store keeps it: of words up to 2^14 and of any length, on the side that the
// viewer sees (hw/MACHINE.md, section 27).
inline constexpr int kept_bits = 14;
UnitVector kept_normal(const WideVector& normal, const UnitVector& to_viewer);

struct ShadeJob;    // block_form.hpp
struct LeafLevels;

// Normals and places at a block's four corners (2 v + u), ready for its 256 leaves.
class BlockShading {
public:
    BlockShading(const std::array<Component, 3>& world, const ShadingSpec& spec,
                 const Material& material);

    // Of leaf (i, j).
    Shades shade(int i, int j, Shadowed shadowed) const;
    Shades shade(const Sample& s, Shadowed shadowed) const {
        return levels_ != nullptr && shadowed == 0 ? kept_levels(s)
                                                   : shade(s.leaf_i, s.leaf_j, shadowed);
    }
    // The same for the lanes, and the levels that they made of it: of every leaf that is asked for.
    // False where lanes do not cover it: light or viewer at a point, no shading, or normals that do
    // not turn little.
    bool job(ShadeJob& out) const;
    // Whether no two of the corners' normals are 60 degrees or more apart.
    bool turns_little() const;
    // Of leaf (i, j), of unit normals, Q.24.
    WideVector mean_normal(int i, int j) const;
    void keep(const LeafLevels& levels) { levels_ = &levels; }
    const LeafLevels* kept() const { return levels_; }
    // What the store keeps of the sample's leaf.
    UnitVector normal(const Sample& s) const;

private:
    UnitVector toward(const Toward& to, int i, int j) const;
    Shades kept_levels(const Sample& s) const;

    const ShadingSpec& spec_;
    const Material& material_;
    std::array<UnitVector, 4> normal_{};
    std::array<WideVector, 4> place_{};
    const LeafLevels* levels_ = nullptr;
};

}  // namespace umbra78::raster
