// Stages that a build may leave out: cmake -DUMBRA78_FEATURES="bilinear;filters" builds these two.
//
// CMakeLists.txt reads the names from the list below, leaves out the files that are a stage's own,
// and defines UMBRA78_LEFT_OUT, a bit for each feature in this order. The few places where a stage
// is entered ask built(). What asks for a stage that is not built is refused by load_matrices() and
// traps at a stage's entry; missing_feature() names it (shadow/frame/features.hpp). What is built
// has the same bits in every build.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#ifndef UMBRA78_LEFT_OUT
#define UMBRA78_LEFT_OUT 0
#endif

#define UMBRA78_FEATURE_LIST(X) \
    X(perspective, "views in perspective: lamps, and an observer with an eye") \
    X(triangles, "meshes of triangles") \
    X(dicing, "patches diced to triangles (needs triangles)") \
    X(leaf_sampling, "sampling = leaf") \
    X(bilinear, "lookup = bilinear") \
    X(windows, "lookup = percentage and filtered_depth") \
    X(dither, "noise: dither other than none") \
    X(rows, "the post-process a scan line at a time: faster, the same bits") \
    X(correct_form, "form = correct") \
    X(ap120b, "arithmetic = ap120b") \
    X(filters, "edge dequantizing and low-pass") \
    X(ledger, "cycles: the clocked post-process, the ledger, the costs of a plan") \
    X(reuse, "keeping what does not change from frame to frame") \
    X(z32, "more than 16 bits of Z") \
    X(lights, "several lights, lights with area, colour") \
    X(surface_bias, "map_depth other than first, bias_slope, and receiver other than point") \
    X(ground, "form = ground and blob") \
    X(rivals, "the rivals of the depth map: form = brute to irregular (needs dicing)")

namespace umbra78::hw {

enum class Feature : std::uint8_t {
#define UMBRA78_NAME(name, meaning) name,
    UMBRA78_FEATURE_LIST(UMBRA78_NAME)
#undef UMBRA78_NAME
};

struct FeatureText {
    std::string_view name, meaning;
};
inline constexpr FeatureText feature_texts[] = {
#define UMBRA78_TEXT(name, meaning) {#name, meaning},
    UMBRA78_FEATURE_LIST(UMBRA78_TEXT)
#undef UMBRA78_TEXT
};
constexpr std::string_view name_of(Feature f) {
    return feature_texts[static_cast<std::size_t>(f)].name;
}

constexpr bool built(Feature f) {
    return (std::uint32_t{UMBRA78_LEFT_OUT} >> static_cast<unsigned>(f) & 1u) == 0;
}
static_assert(built(Feature::triangles) || !built(Feature::dicing));
static_assert(built(Feature::dicing) || !built(Feature::rivals));

}  // namespace umbra78::hw
