// The study of stability: stiff and extreme cases, what must hold in each, and what was found.
//
// A frame case is a scene of a few lines, drawn by the program's own job. A limit case is a number
// that is raised or lowered until the machine refuses with a status. A unit case is a sweep over
// extreme words, checked with an independent wide model. What must hold everywhere: a defined
// status, transformed words within the bound that follows from the rounding of the coefficients,
// and an end within a stated number of splits.
#pragma once

#include "fixed/divide.hpp"
#include "hw/transform_unit.hpp"
#include "tools/scene/scene_file.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

// What a case found. A number that the case does not measure is NaN or absent.
struct Finding {
    bool holds = false;
    std::string status;    // "ok", or the name of the machine's refusal
    std::string observed;  // in words
    double error = not_measured, bound = not_measured;  // in `unit`, where error / bound is maximal
    std::string unit;
    std::optional<std::int64_t> splits, blocks, unresolved, cycles;
    std::optional<std::int64_t> lost;         // pixels inside a surface in truth, but not drawn
    std::optional<std::int64_t> far_over_near;  // of a case that varies it
    std::optional<std::int64_t> far_codes;    // Z codes for the far half of the depths
    double depth_error_units = not_measured;  // of Z decoded, in world units
    double depth_error_quanta = not_measured;
    double false_shadow = not_measured, false_light = not_measured;  // outside the band
    std::string onset;  // of a limit case: the first magnitude that is refused
};

struct Effort {
    bool quick = false;
    int xy_bits() const { return quick ? 6 : 9; }
};

// The units whose words are checked. A test plants a fault here, and the study must find it.
struct UnitsUnderTest {
    fixed::Quotient (*divide)(std::int64_t, std::int64_t, int, int, fixed::Rounding) =
        fixed::divide;
    std::int64_t (*saturate)(std::int64_t, int) = fixed::saturate;
    std::int64_t (*accumulate)(const hw::MatrixWords&, hw::Row, const hw::Words&, std::int32_t) =
        hw::accumulate;
};

// One frame. `must` says in words what is expected.
struct FrameCase {
    std::string_view name, kind;  // kind: stiff | extreme
    std::string_view must;
    std::string scene;            // TOML
    std::vector<std::string> set{};
    std::string_view status = "ok";  // what the status must begin with; beyond_last_code is allowed
    std::int64_t max_splits = 50000;
    std::int64_t far_over_near = 0;  // not 0: measure Z's codes for the far half of the depths
};
std::vector<FrameCase> stiff_frames();
std::vector<FrameCase> extreme_frames();

// The case's scene, with `effort`'s resolution unless the case sets one. Throws SceneError.
LoadedScene scene_of(const FrameCase&, const Effort&);
Finding examine(const FrameCase&, const LoadedScene&);  // of scene_of()
Finding examine(const FrameCase&, const Effort&);       // a refused scene is a finding, too

// The frame's picture with its shadows.
struct Picture {
    int size;
    std::vector<std::uint8_t> gray;
};
Picture picture_of(const FrameCase&, const Effort&);

// A magnitude 2^k that is raised or lowered, k = from .. to, until the machine refuses.
struct LimitCase {
    std::string_view name, must;
    int from, to;                          // `from` is accepted; `to` may be refused
    std::string (*status)(int k);          // "ok" or a name
    std::string_view magnitude;            // what 2^k is
};
std::vector<LimitCase> limit_cases();
Finding examine(const LimitCase&);

struct UnitCase {
    std::string_view name, must;
    Finding (*examine)(const UnitsUnderTest&, const Effort&);
};
std::vector<UnitCase> unit_cases();

// The name of a frame's status, without drawing it; "refused: ..." if the scene's text is refused
// before there is a frame.
std::string frame_status(const std::string& scene, const std::vector<std::string>& set);

// The transform of words with rounded coefficients against the exact matrix: the maximum of the
// error over its bound, of X, Y (in LSB of the output) and Z (in quanta). Points whose exact W is
// no greater than what the rounding of the coefficients may add to it are left out.
struct TransformError {
    double worst = 0, bound = 0;  // in LSB of the output, where worst / bound is maximal
    double over_bound = 0;
    int points = 0, refused = 0;  // refused: with a status, rightly
    bool sound = true;            // no point was wrongly refused or wrongly accepted
};
TransformError transform_error(const hw::RationalMatrix& exact, const hw::MachineSpec& spec);

}  // namespace umbra78::tools::study
