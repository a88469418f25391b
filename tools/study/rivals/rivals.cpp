// umbra78 study rivals: what Crow's classes cost and miss beside the depth map of 1978.
//
// Crow 1977 described three classes of shadow algorithms and found the third the most appealing;
// Williams' depth map came a year later; nobody has measured them together. Here each draws the
// mask of one scene: the depth map on the patches and on facets, and the rivals on facets, over how
// finely patches are diced and over the picture's resolution; of boxes on a floor, over their
// number and that of the lights; and what textbooks offer beside the depth map, on things on a
// floor. Two truths are kept apart. Against the polygons' own, which is brute force, an exact rival
// has no wrong pixel. Against the smooth surfaces' every one has those that dicing makes.
#include "tools/study/rivals/rivals.hpp"

#include <algorithm>
#include <cmath>

namespace umbra78::tools::study {
namespace {

class Rivals final : public Study {
public:
    std::string_view name() const override { return "rivals"; }
    std::string_view meaning() const override {
        return "Crow's three classes and the depth map: errors, operations, growth";
    }
    std::vector<Case> cases(const Request& request) const override {
        return rivals_cases(request);
    }
    std::optional<LoadedScene> scene(const Request& request, const Case& c) const override {
        const std::string own = own_scene(c);
        return own.empty() ? scene_of(request, c) : parse_scene(own, "the study's scene", c.set);
    }
    Row run(const Request&, const Case&, const LoadedScene*) const override;
    std::vector<ColumnMeaning> columns() const override;
    void report(const Request& request, std::span<const Row> rows, Report& to) const override {
        report_rivals(request, rows, to);
    }

private:
    TruthCache truths_;
    BruteMasks brute_;
};

Row Rivals::run(const Request&, const Case& c, const LoadedScene* scene) const {
    if (!extra_of(c, "cells").empty()) return scan_out_row(*scene, c);
    const bool one_light = scene->view().light_count == 1;  // which the rates of error are of
    return frame_row(c, *scene, one_light ? truths_.of(*scene).get() : nullptr, brute_);
}

std::vector<ColumnMeaning> Rivals::columns() const {
    return {
        {"question", "what is varied: how finely patches are diced; the picture's resolution; the "
                     "bits of a Z code; the number of boxes; of lights; what a textbook offers; "
                     "and of the first class the size of its sectors, the edges projected, the "
                     "layers over the floor"},
        {"method", "the depth map on patches or on facets, a rival's name, or what is tried"},
        {"at", "bits of a Z code; boxes a side; lights; the ramp's width in pixels; cells a side "
               "of the light's picture; dice levels; sheets over the floor"},
        {"cells", "of the first class: sectors a side of the light's picture; 0: by the facets"},
        {"edges", "of the first class: every edge is projected, or contours alone"},
        {"stop", "of the first class: whether a run that is wholly dark asks no more casters"},
        {"facets", "that patches and meshes make; the depth map on patches does not read them"},
        {"mask_hash", "FNV-1a-64 of the mask: equal hashes, equal pixels"},
        {"wrong_on_polygons_px", "pixels that differ from brute force on the same polygons; empty "
                                 "for the depth map"},
        {"compared_px", "pixels that both truth and the machine see"},
        {"wrong_cast_px", "of them, those that differ from the smooth surfaces' truth away from "
                          "where the surface turns from the light"},
        {"wrong_terminator_px", "those that differ where the cosine of surface and light is below "
                                "0.2: attached shadow, which facets get wrong, and acne"},
        {"false_shadow", "share of the pixels lit in smooth truth that the mask shadows, 0 .. 1"},
        {"false_light", "share of the pixels shadowed in smooth truth that the mask lights"},
        {"mask_error", "mean absolute difference of the mask and the part of the light that truth "
                       "does not see, 0 .. 1"},
        {"edge_mean_px", "mean distance of the drawn shadow's edge from the true one and back"},
        {"once_cycles", "cycles of the machine once for a scene and its lights, simulated"},
        {"*_cycles", "cycles for each frame, simulated, units side by side: of the lights' maps, "
                     "of the test, of both, of the observer's view"},
        {"entries", "what the method adds to the scene's entries: sides of volumes, links, "
                    "borders, pieces, samples"},
        {"frame_bytes", "memory of the frame and of what the method keeps, on this computer"},
        {"shadow_host_ms", "this computer's time for the light's map and the test, ms"},
        {"links", "of the first class: pairs of a facet and one that can shadow it"},
        {"link_tests", "boxes compared to find them"},
        {"edges_projected", "from the light on a visible facet, and cut by a row"},
        {"crossings", "of edges and rows that were sorted"},
        {"runs_stopped", "that were wholly dark before all casters were asked"},
    };
}

}  // namespace

PowerLaw power_law(std::span<const std::pair<double, double>> points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    PowerLaw law{std::nan(""), std::nan(""), INFINITY, 0};
    for (const auto& [px, py] : points) {
        if (!(px > 0) || !(py > 0)) continue;
        const double u = std::log(px), v = std::log(py);
        ++n, x += u, y += v, xx += u * u, xy += u * v;
        law.from = std::min(law.from, px);
        law.to = std::max(law.to, px);
    }
    const double spread = n * xx - x * x;
    if (n < 2 || !(spread > 1e-9)) return law;
    law.exponent = (n * xy - x * y) / spread;
    law.factor = std::exp((y - law.exponent * x) / n);
    return law;
}

std::unique_ptr<Study> make_rivals_study() { return std::make_unique<Rivals>(); }

}  // namespace umbra78::tools::study
