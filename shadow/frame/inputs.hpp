// What a frame is made from: a scene, settings, the matrices loaded from both, and the method that
// decides what is in shadow.
//
// A frame has an observer and up to max_lights lights. A light is one view of the scene: its
// matrices, its map, its mask, its part of the plan are elements of arrays of max_lights. A source
// is what a scene calls a light: one light, or several that stand on its area, and the levels by
// which they shade (hw/MACHINE.md, section 23).
#pragma once

#include "hw/ap120b/transform.hpp"
#include "raster/blob.hpp"
#include "raster/draw.hpp"
#include "shadow/bias.hpp"
#include "shadow/frame/settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::shadow {

struct Method;

inline constexpr std::size_t max_lights = hw::built(hw::Feature::lights) ? 64 : 1;
using raster::max_sources;

// A source's lights follow one another, and the sources' lights too.
struct Source {
    std::size_t first_light = 0, lights = 1;
    raster::View place{};          // shading is from the eye of this view
    raster::Levels level_q8 = 256;
    // Its six lights are the sectors of one place (hw/sectors.hpp), and they have one mask.
    bool sectored = false;
    // The width of Crow's ramp around its shadow (shadow/filters/ramp.hpp), 0 for none.
    int ramp_px = 0;

    bool has_area() const { return lights > 1 && !sectored; }
    // Whether its darkness is made from its masks, in a plane of its own, and has grey levels.
    bool is_graded() const { return has_area() || ramp_px > 0; }
};

struct Scene {
    std::span<const raster::Patch> patches;
    std::span<const raster::Material> materials;
    raster::View observer;
    std::array<raster::View, max_lights> lights;  // a view in perspective: a point light at its eye
    std::size_t light_count = 1;
    raster::Mesh mesh{};
    std::array<Source, max_sources> sources{};
    std::size_t source_count = 0;  // 0: each light is a source of level 256
    std::size_t channels = 1;      // 3: coloured
    // The surfaces come batch by batch (shadow/frame/stream.hpp) and are not those above. Their
    // coordinates have at most this magnitude, a world word.
    bool streamed = false;
    std::uint32_t largest_streamed = 0;
    // Which of the patches is the plane that form = ground and blob cast shadows on, and the blobs.
    static constexpr std::size_t no_ground = SIZE_MAX;
    std::size_t ground = no_ground;
    std::span<const raster::Ellipse> blobs{};

    raster::Surfaces surfaces() const { return {patches, mesh}; }
    std::size_t sources_used() const { return source_count == 0 ? light_count : source_count; }
    Source source(std::size_t s) const {
        return source_count == 0 ? Source{s, 1, lights[s], 256} : sources[s];
    }
    // The source that light l is of.
    Source source_of(std::size_t l) const {
        std::size_t s = 0;
        while (s + 1 < sources_used() && source(s + 1).first_light <= l) ++s;
        return source(s);
    }
    // The lights and sources are numbered through, there is room for them, what has sectors has
    // six, and an area has no ramp.
    bool in_order() const;
};

enum class FrameStatus : std::uint8_t {
    ok,
    not_built,          // this build leaves out a stage that is asked for (frame/features.hpp)
    spec_out_of_range,  // a width outside its range (hw::check), or what the method cannot do
    observer_matrix,    // a coefficient of world -> observer outside the exponent's range
    light_matrix,
    shadow_matrix,
    bias_out_of_range,
    area_when_drawn,  // a source has an area or a ramp, and the method tests points when drawn
    sectors_refused,  // a source has sectors, and the method has none
    no_ground,        // the form casts shadows on a ground, and the scene names none
    light_in_ground,  // a light lies in the plane of the ground
    rival_of_stream,     // a rival holds its polygons
    too_wide_for_rival,  // what lies too far from the target for a rival's words
};

// A light's matrices, rounded to the unit's words. Of a form without a map the first is what its
// shadow is drawn by, from the world to the observer's screen, and the second is 0.
struct LightMatrices {
    hw::MatrixWords world_to_light, observer_to_light;
    std::int64_t bias_quanta_q16;
    std::int64_t clamp_quanta_q16;  // bias_clamp's
    LightScale scale;               // what receiver = normal reads, and kept normals
    LightAxes axes;                 // what kept normals read
    hw::ap120b::Matrix array;  // observer to light in the AP-120B's words; 0 on the fixed machine
};

struct FrameMatrices {
    hw::WordFormat object;
    hw::MatrixWords world_to_observer;
    std::array<LightMatrices, max_lights> lights;
};

// Rounds all matrices of a frame; `out` is complete only if it returns ok.
FrameStatus load_matrices(const Scene& scene, const Settings& settings, FrameMatrices& out);

// What a plan and the stages read. The scene's spans are the caller's.
struct FrameInputs {
    Scene scene;
    Settings settings;
    FrameMatrices matrices;
    const Method* method = nullptr;  // null: the settings' own, method_of(settings)
    // Whether anything but the shadow test reads the lights' maps. If nothing does, the map of a
    // light in whose volume nothing visible lies is not drawn and holds the background alone.
    bool shows_maps = true;
};

}  // namespace umbra78::shadow
