// The methods: what can decide a pixel's shadow, one row of a table each.
//
// A method writes a darkness of 8 bits for each light and pixel, 0 lit to 255 in shadow, into
// LightBuffers::mask. Its row says when it does that, what it needs, what it costs and what it
// cannot do. The plan, the stages, the ledger, the costs, the instruments and the studies ask the
// row; nothing else depends on which method it is. A further method is a further row.
//
// The settings `form`, `arithmetic` and `lookup` choose the row. A test may hand in a row of its
// own instead (FrameInputs::method).
#pragma once

#include "hw/operations.hpp"
#include "shadow/frame/buffers.hpp"
#include "shadow/frame/inputs.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace umbra78::shadow {

struct FramePlan;
struct FrameLedger;
struct StageCycles;
struct DrawnFrame;

// What a method works on.
enum class Surfaces : std::uint8_t { patches, facets };
// A plane of the observer's view that it can use beside Z and intensity.
enum class ExtraPlane : std::uint8_t { none, normal };
enum class Darkness : std::uint8_t { binary, graded };  // 0 and 255 alone, or anything between
// What can be watched of it, tick by tick (tools/watch).
enum class Trace : std::uint8_t { none, clocked_post_process };

// A method's work on buffers of one depth type. `l` is the light's number.
template <class Depth>
struct MethodStages {
    // Draws the observer's view and the masks with it; null if the method tests after the drawing.
    void (*draw)(const FrameInputs&, const FramePlan&, FrameBuffers<Depth>&, FrameCounts&);
    // Writes the darkness, unless `draw` has written it, and counts.
    void (*cast)(const FrameInputs&, const FramePlan&, std::size_t l, FrameBuffers<Depth>&,
                 FrameCounts&);
    // Adds what the method takes for each frame to the ledger, whose drawing is already in it.
    void (*frame_cost)(const FrameInputs&, std::size_t l, const FrameBuffers<Depth>&,
                       const FrameCounts&, FrameLedger&);
};

struct Method {
    std::string_view name, meaning;
    std::string_view cannot;      // in plain words; "" if there is nothing
    Form form;                    // the settings that choose it
    Arithmetic arithmetic;
    std::span<const Lookup> lookups;
    int max_z_bits;
    bool takes_floats;            // a depth_store of floats
    int depth_layers;             // Z codes a texel of the light's map: 1 or 2; 0: it has none
    Surfaces surfaces;
    ExtraPlane plane;
    Darkness darkness;
    bool may_run_out;             // of FrameBuffers::method_memory; LightCounts::capacity says so
    bool takes_plane;             // receiver = plane, but for a window of taps
    bool takes_normal;            // receiver = normal
    bool takes_sectors;           // lights that shine in all directions
    bool in_shading;              // points are tested before they are shaded: nothing to composite
    bool uses_transform_unit;     // so that the width of the coefficients changes bits and cycles
    Trace trace;
    std::string_view no_trace;    // why there is none, and the remedy
    std::string_view no_plan_cost;  // why a plan has no cost, and the remedy; "" if it has one

    // Makes what it needs of the exact matrix from observer to light; null if it needs nothing.
    void (*load)(const hw::RationalMatrix&, const Settings&, LightMatrices&);
    // Of FrameBuffers::method_memory: the bytes that it needs at least; null if none.
    std::size_t (*memory)(const FrameInputs&);
    // Cycles of operations (drawing, filters) on the machine that the method runs on.
    hw::UnitCycles (*units)(const hw::Operations&, const Settings&);
    // Adds what it takes once for a scene, whatever the frames after it; null if nothing.
    void (*scene_cost)(const FrameInputs&, std::size_t l, FrameLedger&);
    // What it takes of each unit under a plan; null if no_plan_cost says why.
    StageCycles (*plan_cost)(const DrawnFrame&, const FramePlan&, std::size_t l);
    MethodStages<hw::Depth16> stages16;
    MethodStages<hw::Depth32> stages32;

    template <class Depth>
    const MethodStages<Depth>& stages() const {
        if constexpr (std::is_same_v<Depth, hw::Depth16>) {
            return stages16;
        } else {
            return stages32;
        }
    }
    // Whether the masks are made with the observer's view.
    bool tests_when_drawn() const { return stages16.draw != nullptr; }
    bool has_map() const { return depth_layers > 0; }
    bool on_ground() const { return is_on_ground(form); }
    // Whether something is drawn for each light: its map, or its shadow on the ground.
    bool draws_light() const { return has_map() || on_ground(); }
    bool takes(Receiver receiver, Lookup lookup) const {
        return receiver == Receiver::point || (receiver == Receiver::normal && takes_normal) ||
               (receiver == Receiver::plane && takes_plane && !has_window(lookup));
    }
};

std::span<const Method> methods();

// The row that the settings choose; null if there is none for them.
const Method* method_of(const Settings&);
// The row that a frame uses; traps if there is none.
const Method& method_of(const FrameInputs&);

// Whether there is a method for these settings and it can do what they ask.
bool method_can(const Settings&);

}  // namespace umbra78::shadow
