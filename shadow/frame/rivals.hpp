// The stages of the rivals (shadow/rivals): rows of shadow/frame/methods.cpp.
//
// A rival tests the pixels after the observer's view is drawn, as the post-process does, but
// against the scene's polygons and not against a depth map. Its polygons are the scene's mesh and
// its patches, diced alike with dice_levels; a light shines as far as there are polygons, whatever
// its view. The picture is the machine's, whose silhouettes may differ from the polygons' by a
// pixel; a pixel where the polygons show nothing is lit.
#pragma once

#include "shadow/frame/methods.hpp"
#include "shadow/rivals/visible.hpp"

#include <array>
#include <string_view>

namespace umbra78::shadow {

struct RivalRow {
    Form form;
    std::string_view name, meaning;
    bool is_exact = true;  // its mask is that of the polygons, in every pixel
};
inline constexpr std::array rival_rows{
    RivalRow{Form::brute, "brute", "every facet is asked whether it is before the point"},
    RivalRow{Form::volumes, "volumes", "shadow volumes are counted (Crow 1977, third class)"},
    RivalRow{Form::ordered_volumes, "ordered_volumes",
             "their sides are kept in order of depth along scan lines, as Crow has it"},
    RivalRow{Form::stencil_pass, "stencil_pass",
             "they are counted in the frame store, by Z codes, before the point (z-pass)", false},
    RivalRow{Form::stencil_fail, "stencil_fail",
             "the same, from the point on, with the volumes' ends (z-fail)", false},
    RivalRow{Form::bouknight_kelley, "bouknight_kelley",
             "facets' shadows are found while the picture is scanned out (first class)"},
    RivalRow{Form::appel, "appel", "the number of surfaces before the points of a scan line"},
    RivalRow{Form::splitting, "splitting", "facets are split by their casters (second class)"},
    RivalRow{Form::perimeters, "perimeters",
             "facets from the light on are clipped by the outlines before them (second class)"},
    RivalRow{Form::atherton, "atherton",
             "outlines are taken away from concave polygons with holes (second class)"},
    RivalRow{Form::irregular, "irregular",
             "the alias-free map: the visible points are its texels"}};

constexpr bool is_exact(Form form) {
    for (const RivalRow& row : rival_rows)
        if (row.form == form) return row.is_exact;
    return false;
}

// Whether the scene can be had in rivals' words: it is held, and not too wide.
FrameStatus check_rival(const Scene& scene, const Settings& settings);

// The scene's polygons as a rival has them for light l, and what each pixel shows of them. `memory`
// is of at least rival_bytes(), aligned to frame_alignment, and both refer to it.
struct RivalView {
    rivals::Setting setting{};
    std::span<const std::uint32_t> shown{};
};
RivalView rival_view(const FrameInputs&, std::size_t light, std::span<std::byte> memory);

// Of method_memory: what every rival needs, and what this one does where that is known before.
std::size_t rival_bytes(const FrameInputs&);

template <class Depth>
void cast_rival(const FrameInputs&, const FramePlan&, std::size_t light, FrameBuffers<Depth>&,
                FrameCounts&);
template <class Depth>
void cost_of_rival(const FrameInputs&, std::size_t light, const FrameBuffers<Depth>&,
                   const FrameCounts&, FrameLedger&);

template <class Depth>
constexpr MethodStages<Depth> rival_stages{nullptr, cast_rival<Depth>, cost_of_rival<Depth>};

}  // namespace umbra78::shadow
