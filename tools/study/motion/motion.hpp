// The parts of the study of motion: a sequence of frames in which the light or the observer moves a
// little, and the pixels of the mask that flip from each frame to the next.
//
// A flip is rightful where truth flips as well. Every other flip is flicker: the pixel's true state
// stays, and the mask changes. Compared are the pixels that truth and the machine see in both
// frames, without those that show a surface's unlit side.
#pragma once

#include "tools/study/measures.hpp"
#include "tools/study/study.hpp"

#include <string_view>
#include <vector>

namespace umbra78::tools::study {

enum class Motion : std::uint8_t { light_turns, observer_turns, light_moves, observer_moves };
inline constexpr std::string_view motion_names[] = {"light turns", "observer turns", "light moves",
                                                    "observer moves"};

// What a frame adds to the one before it. A turn is about the vertical axis through the view's
// target. A light at infinity that moves is the same light: its window slides over the scene, by
// this much along its X and Y. An observer who moves takes the window of such a light along.
inline constexpr double turn_degrees = 0.1;
inline constexpr double step_x = 0.3, step_y = 0.2;  // of the moving view's own pixels

struct MotionCase {
    Motion motion = Motion::light_turns;
    bool snapped = false;  // the light's window is moved so that the origin is a texel's corner
    bool renewed = false;  // another seed of the noise in each frame
    int frames = 2;
};
MotionCase motion_case(const Case&);  // from its extra columns
const char* frames_of(const Request&);

// The scene of frame 0, 1, ... Throws SceneError if a lamp's view is to be snapped: in perspective
// a texel has no one size.
LoadedScene motion_frame(const LoadedScene&, const MotionCase&, int frame);

// How far the scene's origin is from the nearest corner of the light's texels, in texels.
double off_corner_texels(const LoadedScene&);

// From one frame to the next.
struct Flips {
    std::int64_t compared = 0, truth = 0, mask = 0, rightful = 0;
    std::int64_t compared_outside = 0, flicker_outside = 0;  // the edge bands of both frames

    std::int64_t flicker() const { return mask - rightful; }
    double share(std::int64_t pixels) const {
        return compared > 0 ? static_cast<double>(pixels) / static_cast<double>(compared) : 0;
    }
    double outside_share() const {
        return compared_outside > 0 ? static_cast<double>(flicker_outside) /
                                          static_cast<double>(compared_outside)
                                    : 0;
    }
};

// What is needed of a frame to find flips.
struct SeenFrame {
    std::shared_ptr<const Traced> traced;
    std::vector<std::uint8_t> mask, visible;

    bool compares(std::size_t at) const {
        return traced->truth.truth.visible[at] && visible[at] && !traced->truth.unlit_side[at];
    }
    bool lit(std::size_t at) const { return traced->truth.truth.lit[at] != 0; }
    bool shadowed(std::size_t at) const { return mask[at] >= 128; }
};
// `flickers`, if not empty, gets 1 more where the mask flickered.
Flips flips(const SeenFrame& before, const SeenFrame& after, std::span<int> flickers = {});

struct MotionSeen {
    int size_px = 0;
    std::vector<Flips> compared, filtered;  // a step each: of the mask, and of the filtered one
    std::vector<int> flickers;              // of each pixel of the mask, over the sequence
    std::vector<std::uint8_t> seen;         // 1: compared in some step
    Coverage worst{};                       // of the frame that lacks most
    std::size_t outside_light = 0;  // surfaces that leave the light's volume while it moves
    double false_shadow = 0, false_light = 0;  // means over the frames
    double off_corner_texels = 0;              // the greatest over the frames
};
MotionSeen see_motion(const LoadedScene&, const MotionCase&, const TruthCache&);

void report_motion(const Request&, std::span<const Row>, Report&);

// The shares of a row's column of steps, "0.01;0.02": each step in turn.
std::vector<double> steps_of(const Row&, const char* column);

}  // namespace umbra78::tools::study
