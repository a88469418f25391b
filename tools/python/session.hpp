// What the module for Python does, without Python: the program's commands as functions.
//
// Reports are JSON texts, those that the commands print with --json. Every function throws the
// program's errors, whose text is one line with the remedy, and none of them needs the interpreter:
// main.cpp calls them with its lock released.
#pragma once

#include "tools/bias/map_options.hpp"
#include "tools/captured/report.hpp"
#include "tools/render/rendered.hpp"

#include <memory>
#include <string>
#include <vector>

namespace umbra78::tools::python {

// A scene file's text; `path` names it in errors, and its models count from that path's folder.
struct SceneText {
    std::string text, path;
};
SceneText read_file(const std::string& path);
SceneText paper_scene();

using Overrides = std::vector<std::string>;  // "key=value", as --set takes them

std::shared_ptr<const Rendered> draw(const SceneText&, const Overrides&, bool truth,
                                     int threads);
std::string report_of(const Rendered&);

// What a plane's words mean: of a Z code where near and far lie, and whether in perspective.
struct Scaling {
    std::string unit;
    std::uint32_t max = 255;  // of a Z code it means that nothing was drawn
    double near = 0, far = 0;
    bool perspective = false;
};
Scaling scaling_of(const Rendered&, const PlaneOf&);

std::string frame_plan(const SceneText&, const Overrides&);
std::string pixel_trace(const SceneText&, const Overrides&, int x, int y);

std::string bias_of(const SceneText&, const Overrides&);
std::string bias_of_map(const bias::MapOptions&);

struct StudyRequest {
    std::string name;
    std::optional<SceneText> scene;
    std::vector<std::string> vary;  // as --vary takes them
    bool quick = false, automatic = false;
    int jobs = 0;
};
std::string study_rows(const StudyRequest&);  // an array of rows
std::string studies();                        // an array of names and meanings

// The shadow test on depth buffers captured elsewhere, as umbra78 shadow runs it. The arrays are of
// the observer's buffer, row 0 at the top.
struct Captured {
    captured::Capture capture;
    std::optional<NumberImage> truth;
    bool truth_bright = false, least_bias = false;
    std::optional<Pixel> pixel;
};
struct Shadowed {
    std::string report;
    std::vector<std::uint8_t> mask;
    std::vector<double> error;     // 1 false shadow, -1 false light
    std::vector<double> spectrum;  // side x side bins; none if there are too few errors
    int side = 0;
};
Shadowed shadow_of(const Captured&);
captured::Convention convention_of(const std::string& name);
captured::DepthFormat depth_format_of(const std::string& name);

std::string settings_table();
std::string figure_settings(int figure);  // 1 .. 6

}  // namespace umbra78::tools::python
