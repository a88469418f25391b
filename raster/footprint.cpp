#include "raster/footprint.hpp"

#include "raster/sampling.hpp"

#include <algorithm>

namespace umbra78::raster {

Footprint whole_frame(const MachineSpec& spec) {
    const int last = spec.size_px() - 1;
    return {0, 0, last, last, 0, spec.deepest_drawn()};
}

Footprint footprint(const ScreenBounds& b, const MachineSpec& spec) {
    const auto pixel = [&](std::int64_t v) {
        const std::int64_t p = fixed::floor_shift(v, raster_fraction) + spec.half_px();
        return static_cast<int>(std::clamp<std::int64_t>(p, 0, spec.size_px() - 1));
    };
    const std::int64_t one_quantum = std::int64_t{1} << depth_guard(spec);
    Footprint f{pixel(b[0].min - slack), pixel(b[1].min - slack), pixel(b[0].max + slack),
                pixel(b[1].max + slack), 0, spec.deepest_drawn()};
    std::uint32_t code = 0;
    if (depth_code(b[2].min - one_quantum, spec, code)) f.nearest = code;
    if (depth_code(b[2].max + one_quantum, spec, code)) f.farthest = code;
    return f;
}

Visibility patch_footprint(const Patch& patch, const MatrixWords& matrix, const MachineSpec& spec,
                           WordFormat object, Footprint& out) {
    const ObjectWords words = to_object_words(patch, object);
    ScreenBounds bounds{};
    if (!matrix.divides()) {
        bounds = affine_bounds(affine_components(words, matrix, spec, object));
    } else {
        const Visibility v =
            projected_bounds(homogeneous_components(words, matrix, spec, object), spec, bounds);
        if (v == Visibility::unknown) out = whole_frame(spec);
        if (v != Visibility::bounded) return v;
    }
    if (block_action(bounds, spec) == BlockAction::outside) return Visibility::outside;
    out = footprint(bounds, spec);
    return Visibility::bounded;
}

}  // namespace umbra78::raster
