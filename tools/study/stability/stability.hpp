// The study of stability: stiff and extreme cases, what must hold in each, and what was found.
//
// A frame case is a scene of a few lines, drawn by the program's own job; a limit is a number that
// is moved until the machine names a status; a unit case is a sweep over extreme words against an
// independent wide model. What must hold everywhere: a defined status, transformed words within
// the bound that follows from the coefficients' rounding, an end within a stated number of splits.
#pragma once

#include "fixed/divide.hpp"
#include "hw/transform_unit.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

// What a case found. Numbers that it has not are NaN, or absent.
struct Finding {
    bool holds = false;
    std::string status;    // "ok", or the name under which the machine refused
    std::string observed;  // in words
    double error = not_measured, bound = not_measured;  // in `unit`; the worst of its kind
    std::string unit;
    std::optional<std::int64_t> splits, blocks, unresolved, cycles;
    std::optional<std::int64_t> lost;         // pixels truth sees, inside a surface, not drawn
    std::optional<std::int64_t> far_codes;    // Z codes used for the far half of the depths
    double depth_error_units = not_measured;  // of Z decoded, in world units
    double depth_error_quanta = not_measured;
    double false_shadow = not_measured, false_light = not_measured;  // outside the band
    std::string onset;  // of a limit: the first magnitude that is refused
};

struct Effort {
    bool quick = false;
    int xy_bits() const { return quick ? 6 : 9; }
};

// The units whose words are judged; a test plants a fault here and must see red.
struct UnitsUnderTest {
    fixed::Quotient (*divide)(std::int64_t, std::int64_t, int, int, fixed::Rounding) =
        fixed::divide;
    std::int64_t (*saturate)(std::int64_t, int) = fixed::saturate;
    std::int64_t (*accumulate)(const hw::MatrixWords&, hw::Row, const hw::Words&, std::int32_t) =
        hw::accumulate;
};

// One frame. `must` says what is expected in words; `status` and `splits` say it in figures.
struct FrameCase {
    std::string_view name, kind;  // kind: stiff | extreme
    std::string_view must;
    std::string scene;            // TOML
    std::vector<std::string> set{};
    std::string_view status = "ok";  // or how a refusal must begin; beyond_last_code is told
    std::int64_t max_splits = 50000;
    bool far_half = false;        // measure Z's codes and error over the depths
};
std::vector<FrameCase> stiff_frames();
std::vector<FrameCase> extreme_frames();
Finding examine(const FrameCase&, const Effort&);

// The frame's picture with its shadows.
struct Picture {
    int size;
    std::vector<std::uint8_t> gray;
};
Picture picture_of(const FrameCase&, const Effort&);

// A magnitude 2^k, k = from .. to, that is raised or lowered until the machine refuses.
struct LimitCase {
    std::string_view name, must;
    int from, to;                          // from is held, to is refused (or held, too)
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

// The status of a scene's frame by name, without drawing it; "refused: ..." where the scene's text
// is refused before there is a frame.
std::string frame_status(const std::string& scene, const std::vector<std::string>& set);

// The transform of words by rounded coefficients against the exact matrix: the greatest error over
// its bound, of X, Y (unit: LSB of the output) and Z (quanta). Where the exact W is not above what
// the coefficients' rounding may add to it, nothing can be said and the point is left out.
struct TransformError {
    double worst = 0, bound = 0;  // in LSB of the output, where worst / bound is greatest
    double over_bound = 0;
    int points = 0, refused = 0;  // refused: by a status, as it should be
    bool sound = true;            // no point was refused that must not be, or the reverse
};
TransformError transform_error(const hw::RationalMatrix& exact, const hw::MachineSpec& spec);

}  // namespace umbra78::tools::study
