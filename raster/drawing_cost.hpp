// What drawing a view costs, in operations: the counts of a drawing times what each thing costs.
//
// The constants count the additions, products and quotients in the formulas of hw/MACHINE.md,
// sections 6, 7, 9, 14 and 21 to 24, component by component; the tables there (sections 16 and 21
// to 23) are these.
#pragma once

#include "hw/operations.hpp"
#include "raster/draw.hpp"

#include <cstdint>

namespace umbra78::raster {

namespace cost {

using hw::Operations;

// Additions a component.
inline constexpr std::uint64_t corners_from_control = 60;  // 4 x (gu 3, gv 3, guv 9)
inline constexpr std::uint64_t bounds_and_action = 43;
inline constexpr std::uint64_t split = 16;  // 2 ends x 2 pairs x 4
// 15 midpoints on 2 edges of 2 pairs, then on 17 columns of one pair, 4 additions each.
inline constexpr std::uint64_t leaf_corners = 15 * 2 * 2 * 4 + 15 * 17 * 4;

inline constexpr Operations leaf_window{16};           // min, max, slack, of X and Y
inline constexpr Operations leaf_mean{12};             // three means of four, rounded
inline constexpr Operations tested_centre{60, 16, 16};  // two triangles: an area, three edges each
// Z of the plane (two products of 32 x 16 bits, a quotient of 22), the code; read, compare, write.
inline constexpr Operations centre_sample{6, 2, 4, 1, 22, 2};
inline constexpr Operations leaf_sample{3, 0, 0, 0, 0, 2};
// Two tangents, their product and its length in 30-bit words; a root and three quotients.
inline constexpr Operations corner_normal{48, 9, 36, 4, 30 + 3 * 15, 0};
// Phong: the normal at the leaf (18 products), its length, N.l, N.v, r, S; a root and two
// quotients; intensity and direct share written. Lambert: of N.v the sign, no r, no powers and no
// specular level. Blinn: in place of r and the quotient N.v the halfway direction (a root, three
// quotients) and N.h, and two powers more. None: the material's levels, written.
constexpr Operations shaded_sample(int shininess, ShadingRule rule = ShadingRule::phong) {
    const auto n = static_cast<std::uint64_t>(shininess);
    switch (rule) {
        case ShadingRule::phong: return {40 + n, 34 + n, 18 + 12 + 12 + 4 + n, 3, 30 + 2 * 15, 2};
        case ShadingRule::blinn: return {48 + n, 41 + n, 56 + n, 7, 30 + 15 + 16 + 3 * 15 + 15, 2};
        case ShadingRule::lambert: return {36, 32, 44, 2, 30 + 15, 2};
        case ShadingRule::none: break;
    }
    return {0, 0, 0, 0, 0, 2};
}
// A further source: N.l and l.v (six products), r, its powers, the sum and the level; a quotient;
// its direct share written. The other rules as above.
constexpr Operations shaded_source(int shininess, ShadingRule rule = ShadingRule::phong) {
    const auto n = static_cast<std::uint64_t>(shininess);
    switch (rule) {
        case ShadingRule::phong: return {11 + n, 12 + n, 16 + n, 1, 15, 1};
        case ShadingRule::blinn: return {17 + n, 16 + n, 23 + n, 6, 15 + 16 + 3 * 15 + 15, 1};
        case ShadingRule::lambert: return {5, 7, 11, 1, 15, 1};
        case ShadingRule::none: break;
    }
    return {0, 0, 0, 0, 0, 1};
}
// A further channel: an intensity, and for each source a sum and a level.
inline constexpr Operations channel{1, 1, 1, 0, 0, 1};
inline constexpr Operations channel_source{4, 4, 6, 0, 0, 1};
// A normal that is kept: a leaf's is cut to its words (8) and turned to the viewer (3), and the
// three are written. The rule none has neither the leaf's normal nor N.v. A facet's is turned by
// its own product with V.
inline constexpr Operations leaf_normal_kept{8 + 3, 0, 0, 0, 0, 3};
inline constexpr Operations leaf_normal_made{9 + 2, 18 + 3, 18 + 6, 0, 0, 0};
inline constexpr Operations facet_normal_kept{3 + 3, 3, 3, 0, 0, 3};
inline constexpr std::uint64_t divided_corner_bits = 31;  // X, Y and Z of each corner

// A triangle begins: three edges' crossings and steps, the area, Z and its steps in X and Y.
inline constexpr Operations triangle_setup{36, 18, 72, 9, 9 * 31, 0};
// Three crossings and Z step down (two additions each), four compares make the span.
inline constexpr Operations triangle_line{12};
inline constexpr Operations triangle_sample{4, 0, 0, 0, 0, 2};  // Z steps; the code; the compare
// Two sides of the facet, their product and its length.
inline constexpr Operations facet_normal{12, 6, 24, 4, 30 + 3 * 15, 0};
inline constexpr Operations corner_weights{0, 6, 24, 2, 2 * 11, 0};  // of a shaded sample
// A vertex of a diced patch: Bernstein's sums by rows, then over the rows, of three components; two
// tangents, their product and its length.
inline constexpr Operations diced_vertex{48, 60, 120};
inline constexpr Operations diced_normal{120, 105, 228, 4, 30 + 3 * 15, 0};
// The slope of a triangle that casts: two rises, the greater over the area, times the factor; and a
// leaf's sample is moved by it. A facet's is made once, and each of its samples is moved.
inline constexpr Operations leaf_slope{11, 5, 20, 1, 31, 0};
inline constexpr Operations facet_slope{10, 5, 20, 1, 31, 0};
inline constexpr Operations moved_sample{1};
inline constexpr std::uint64_t facet_quotients = 9;  // in perspective: X, Y and Z of 3 corners

}  // namespace cost

// What a shaded sample takes: the max exponent of a highlight, the sources, the channels.
struct SampleCost {
    int shininess = 0;
    std::size_t sources = 1, channels = 1;
    ShadingRule rule = ShadingRule::phong;
    bool keeps_normals = false;

    // Whether shading is of the normal.
    bool needs_normal() const { return rule != ShadingRule::none; }
    // Without it neither places nor normals are carried through the drawing.
    bool makes_normals() const { return keeps_normals || needs_normal(); }
    hw::Operations kept_normals(std::uint64_t of_leaves, std::uint64_t of_facets) const {
        if (!keeps_normals) return {};
        hw::Operations o = of_leaves * cost::leaf_normal_kept + of_facets * cost::facet_normal_kept;
        if (!needs_normal()) o += of_leaves * cost::leaf_normal_made;
        return o;
    }
    hw::Operations operations() const {
        hw::Operations o = cost::shaded_sample(shininess, rule);
        o += (sources - 1) * cost::shaded_source(shininess, rule);
        if (needs_normal()) {
            o += (channels - 1) * (cost::channel + sources * cost::channel_source);
        } else {
            o.accesses += (channels - 1) * (1 + sources);
        }
        return o;
    }
};

// What it costs that a light's casters are moved by their slopes.
inline hw::Operations slope_operations(const DrawCounts& counts) {
    return (counts.samples - counts.facet_samples) * cost::leaf_slope +
           counts.triangles * cost::facet_slope + counts.facet_samples * cost::moved_sample;
}

// The operations of a drawing with these counts, in which nothing was left out as hidden.
inline hw::Operations drawing_operations(const DrawCounts& counts, const MachineSpec& spec,
                                         bool affine, Sampling sampling, bool shades,
                                         const SampleCost& sample) {
    using hw::Operations;
    constexpr std::uint64_t leaves_a_block = std::uint64_t{leaves} * leaves;
    constexpr std::uint64_t corners_a_block = std::uint64_t{corners} * corners;
    const bool normals = shades && sample.makes_normals();
    const std::uint64_t screen = affine ? 3 : 4, components = screen + (normals ? 3 : 0);
    const auto transform = static_cast<std::uint64_t>(
        hw::transform_cycles(spec, affine) * spec.multipliers);  // an idle multiplier counts
    const std::uint64_t points = 16 * counts.subdivided() + 3 * counts.facets;
    Operations o{.products = points * (affine ? 9u : 16u), .passes = points * transform};
    o.adds += components * (counts.subdivided() * cost::corners_from_control +
                            counts.splits * cost::split);
    o.adds += screen * (counts.tested_blocks * cost::bounds_and_action +
                        counts.blocks * cost::leaf_corners);
    if (!affine) {
        const std::uint64_t quotients =
            3 * corners_a_block * counts.blocks + cost::facet_quotients * counts.facets;
        o += Operations{.quotients = quotients,
                        .quotient_bits = quotients * cost::divided_corner_bits};
    }
    const std::uint64_t leaves_drawn = leaves_a_block * counts.blocks;
    const std::uint64_t of_patches = counts.samples - counts.facet_samples;
    if (sampling == Sampling::centre) {
        o += leaves_drawn * cost::leaf_window + counts.tested_centres * cost::tested_centre +
             of_patches * cost::centre_sample;
    } else {
        o += leaves_drawn * cost::leaf_mean + of_patches * cost::leaf_sample;
    }
    o += counts.diced_vertices * cost::diced_vertex;
    if (shades && sample.needs_normal()) o += counts.diced_vertices * cost::diced_normal;
    o += counts.triangles * cost::triangle_setup + counts.triangle_lines * cost::triangle_line +
         counts.facet_samples * cost::triangle_sample;
    if (normals)
        o += 4 * counts.blocks * cost::corner_normal + counts.facets * cost::facet_normal;
    if (shades && sample.needs_normal()) o += counts.facet_samples * cost::corner_weights;
    if (shades)
        o += counts.samples * sample.operations() +
             sample.kept_normals(of_patches, counts.facet_samples);
    return o;
}

}  // namespace umbra78::raster
