// Class 3 with memory for tests: the number of surfaces before each pixel's point, in each form.
#pragma once

#include "shadow/rivals/ordered_volumes.hpp"
#include "shadow/rivals/stencil.hpp"
#include "tests/shadow/rivals/figures_scene.hpp"

#include <algorithm>
#include <vector>

namespace umbra78::shadow::rivals::test {

using Numbers = std::vector<std::int32_t>;

inline std::vector<ContourEdge> contour_of(const Setting& s) {
    std::vector<ContourEdge> contour(find_contour(s, {}));
    find_contour(s, contour);
    return contour;
}

inline std::vector<std::uint8_t> mask_of(const Setting& s, std::span<const std::uint32_t> shown,
                                         const Numbers& numbers) {
    std::vector<std::uint8_t> mask(numbers.size());
    mask_of_counts(s, shown, numbers, mask);
    return mask;
}

inline Numbers summed(const Setting& s, std::span<const std::uint32_t> shown) {
    Numbers numbers(shown.size());
    VolumeCounts counts;
    count_volumes(s, shown, contour_of(s), numbers, counts);
    return numbers;
}

inline Numbers ordered(const Setting& s, std::span<const std::uint32_t> shown,
                       OrderedCounts& counts) {
    const std::vector<ContourEdge> contour = contour_of(s);
    Numbers numbers(shown.size(), 77);
    Memory none(0);
    order_volumes(s, shown, contour, none.bytes().first(0), numbers, counts);
    Memory memory(counts.bytes);
    counts = {};
    fixed::require(order_volumes(s, shown, contour, memory.bytes(), numbers, counts),
                   "a test's room for sides");
    return numbers;
}

// From the nearest to the farthest vertex, a word beyond each.
inline DepthScale scale_of(const Setting& s, int bits = 16) {
    const std::int64_t distance = s.space.eye().w == 0 ? 0 : -std::int64_t{s.space.eye().z};
    std::int64_t near = INT64_MAX, far = INT64_MIN;
    for (const Point& p : s.mesh.vertices) {
        near = std::min(near, p.z + distance - 1);
        far = std::max(far, p.z + distance + 1);
    }
    if (distance != 0) near = std::max<std::int64_t>(near, 1);
    return {near, std::max(far, near + 1), 1, 1, bits};
}

// The machine's of the figures' scene: its cube, as deep as the frame is wide.
inline DepthScale figures_scale(const FiguresScene& scene, int bits = 16) {
    constexpr std::int64_t reach = paper_scene::extent_q16;
    const Space& space = scene.setting().space;
    return {-reach, reach, reach, std::int64_t{1} << (space.xy_bits() - 1 + space.fraction()),
            bits};
}

inline constexpr StencilOptions z_pass{StencilPass::z_pass}, z_fail{StencilPass::z_fail};

// In the frame store: its codes and counters.
struct Stenciled {
    std::vector<std::uint32_t> codes;
    Numbers numbers;
    StencilCounts counts{};

    Stenciled(const Setting& s, std::span<const std::uint32_t> shown, const DepthScale& scale,
              const StencilOptions& options)
        : codes(shown.size()), numbers(shown.size(), 77) {
        const StencilStore store{codes, numbers};
        count_stencil(s, shown, contour_of(s), scale, options, store, counts);
    }
};

inline std::size_t differing(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    std::size_t n = 0;
    for (std::size_t at = 0; at < a.size(); ++at) n += a[at] != b[at] ? 1 : 0;
    return n;
}

}  // namespace umbra78::shadow::rivals::test
