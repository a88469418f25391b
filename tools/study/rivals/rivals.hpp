// The parts of the study of rivals: Crow's classes and the depth map, side by side.
//
//   questions.cpp --cases--> rivals.cpp --measure.cpp, scan_out.cpp--> rows --report.cpp--> page
#pragma once

#include "tools/study/measures.hpp"
#include "tools/study/study.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra78::tools::study {

// What is varied. Objects, lights, textbook and layers ask it of scenes of their own, the others of
// the study's; sectors, edges and layers look into the first class (Bouknight & Kelley).
namespace question {
inline constexpr std::string_view dicing = "dicing", resolution = "resolution", codes = "codes",
                                  objects = "objects", lights = "lights", textbook = "textbook",
                                  sectors = "sectors", edges = "edges", layers = "layers";
}

// The depth map as a method of the table: drawn from patches, as the paper's, or from facets; or
// from patches at the visible points themselves (form irregular_map).
inline constexpr std::string_view map_on_patches = "depth map, patches",
                                  map_on_facets = "depth map, facets",
                                  map_at_points = "depth map, at its points";

std::vector<Case> rivals_cases(const Request&);
// The forms whose masks hang on the width of the Z codes: volumes counted in the frame store.
std::vector<std::string_view> stencils();
// What distinguishes a case: "question", "method", "at", and what scan-out does.
std::string_view extra_of(const Case&, std::string_view column);
// The text of the scene that the case's question asks of; "" for the study's scene.
std::string own_scene(const Case&);

// side x side boxes on a floor, which together cover what one would, and up to eight lights.
std::string boxes_scene(int side, int lights);
// Sheets above each other between the light and a floor.
std::string layers_scene(int sheets);
// Things of all kinds on a floor that is the ground. A ramp's light is a lamp, and far away.
std::string textbook_scene(double ramp_px);

// The masks of brute force, by light: one drawing for all rivals of the same polygons and views.
// Safe to call from several threads: the first to ask for a scene's draws, the others wait.
class BruteMasks {
public:
    using Masks = std::vector<std::vector<std::uint8_t>>;
    // `scene` is the case's, whose overrides may differ in the form alone where masks are shared.
    const Masks& of(const Case&, const LoadedScene& scene) const;

private:
    struct Slot {
        std::once_flag once;
        Masks masks;
    };
    mutable std::mutex mutex_;  // of the map
    mutable std::map<std::string, Slot> slots_;
};

// A drawn frame's errors, cycles and memory.
Row frame_row(const Case&, const LoadedScene&, const Traced* truth, const BruteMasks&);
// What Bouknight & Kelley's second scan does, as the case's extra columns ask for it.
Row scan_out_row(const LoadedScene&, const Case&);

// Whether the method has no wrong pixel on its polygons, by definition.
bool is_exact(std::string_view method);

void report_rivals(const Request&, std::span<const Row>, Report&);

// Of log y over log x, by least squares; NaN with fewer than two different x.
struct PowerLaw {
    double exponent, factor;
    double from, to;  // the range of x
};
PowerLaw power_law(std::span<const std::pair<double, double>> points);

std::unique_ptr<Study> make_rivals_study();

}  // namespace umbra78::tools::study
