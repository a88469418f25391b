// What a frame is made from: a scene, settings, and the matrices loaded from both.
#pragma once

#include "hw/ap120b/transform.hpp"
#include "raster/draw.hpp"
#include "shadow/bias.hpp"
#include "shadow/frame/settings.hpp"

#include <cstdint>
#include <span>

namespace umbra78::shadow {

struct Scene {
    std::span<const raster::Patch> patches;
    std::span<const raster::Material> materials;
    raster::View observer, light;  // a perspective "view" is a point light at its eye
};

enum class FrameStatus : std::uint8_t {
    ok,
    spec_out_of_range,      // a width outside its range (hw::check), or the AP-120B's
    observer_matrix,        // a coefficient of world -> observer outside the exponent's range
    light_matrix,
    shadow_matrix,
    bias_out_of_range,
};

// The matrices of a frame, rounded to the unit's words.
struct FrameMatrices {
    hw::WordFormat object;
    hw::MatrixWords world_to_observer, world_to_light, observer_to_light;
    std::int64_t bias_quanta_q16;
    hw::ap120b::Matrix array;  // observer to light again, where that is the arithmetic
};
FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out);

// All of it, as a plan is made from it. The scene's spans are the caller's.
struct FrameInputs {
    Scene scene;
    Settings settings;
    FrameMatrices matrices;
};

}  // namespace umbra78::shadow
