#include "tools/python/session.hpp"

#include "shadow/frame/paper_figures.hpp"
#include "tools/bias/answer.hpp"
#include "tools/cli/study_list.hpp"
#include "tools/io/text_formats.hpp"
#include "tools/render/plan_report.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/study/paper_scene.hpp"
#include "tools/study/runner.hpp"
#include "tools/study/vary.hpp"
#include "tools/watch/pixel_trace.hpp"
#include "tools/watch/rival_trace.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>

namespace umbra78::tools::python {
namespace {

using nlohmann::ordered_json;

LoadedScene load(const SceneText& scene, const Overrides& set) {
    return parse_scene(scene.text, scene.path, set, files_beside(scene.path));
}

// A folder of its own for a study's rows, which is gone when they have been returned.
class OwnFolder {
public:
    OwnFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "umbra78-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("cannot make a folder for the study's rows; set TMPDIR to a "
                                     "place that can be written to");
        path_ = name;
    }
    ~OwnFolder() {
        std::error_code none;
        std::filesystem::remove_all(path_, none);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    const Path& path() const { return path_; }

private:
    Path path_;
};

std::string unit_of(Plane plane) {
    switch (plane) {
        case Plane::observer_z:
        case Plane::light_z: return "Z code";
        case Plane::normal: return "Q1.14, two's complement";
        case Plane::intensity:
        case Plane::direct:
        case Plane::picture: return "grey level";
        default: return "darkness";
    }
}

}  // namespace

SceneText read_file(const std::string& path) {
    load_scene(path, {});  // for its errors
    std::ifstream file(path, std::ios::binary);
    return {{std::istreambuf_iterator<char>(file), {}}, path};
}

SceneText paper_scene() { return {std::string(study::paper_scene_text), "figures.toml"}; }

std::shared_ptr<const Rendered> draw(const SceneText& scene, const Overrides& set, bool truth,
                                     int threads) {
    return std::make_shared<Rendered>(load(scene, set), RenderOptions{truth, "", threads});
}

std::string report_of(const Rendered& rendered) { return print(to_json(rendered)); }

Scaling scaling_of(const Rendered& rendered, const PlaneOf& of) {
    Scaling scaling{unit_of(of.plane), rendered.job.buffer(of).maxval};
    if (of.plane != Plane::observer_z && of.plane != Plane::light_z) return scaling;
    const shadow::Scene& scene = rendered.job.inputs().scene;
    const raster::View& view =
        of.plane == Plane::observer_z ? scene.observer : scene.lights[of.light];
    scaling.near = std::ldexp(static_cast<double>(view.near_depth), -16);
    scaling.far = std::ldexp(static_cast<double>(view.far_depth), -16);
    scaling.perspective = view.projection == raster::Projection::perspective;
    return scaling;
}

std::string frame_plan(const SceneText& scene, const Overrides& set) {
    return print(to_json(Planned(load(scene, set))));
}

std::string pixel_trace(const SceneText& text, const Overrides& set, int x, int y) {
    const LoadedScene scene = load(text, set);
    require_one_light(scene, "a trace");
    RenderJob job(scene.view(), scene.settings);
    if (shadow::is_rival(scene.settings.form)) return print(to_json(trace_rival(job, {x, y})));
    job.render();
    return print(to_json(trace_pixel(job, {x, y})));
}

std::string bias_of(const SceneText& scene, const Overrides& set) {
    return print(bias::to_json(bias::answer(load(scene, set))));
}

std::string bias_of_map(const bias::MapOptions& options) {
    return print(bias::to_json(bias::answer(bias::setup_of(options))));
}

std::string study_rows(const StudyRequest& request) {
    const study::Studies known = tools::study::studies();
    const study::Study& chosen = study::study_of(request.name, "study", known);
    study::Request asked;
    if (request.scene) study::take_scene(request.scene->text, request.scene->path, asked);
    for (const std::string& vary : request.vary) asked.vary.push_back(study::parse_vary(vary));
    asked.quick = request.quick;
    asked.automatic = request.automatic;
    const study::Asked cases = study::ask(chosen, std::move(asked));
    const OwnFolder folder;
    std::vector<study::Row> rows;
    for (auto& [index, row] : study::run_cases(cases, {request.jobs, {}, false},
                                               folder.path() / "rows.jsonl"))
        rows.push_back(row);
    ordered_json json = ordered_json::array();
    for (const study::Row& row : study::aligned(rows)) json.push_back(to_json(row));
    return print(json);
}

std::string studies() {
    ordered_json list = ordered_json::array();
    for (const auto& each : tools::study::studies())
        list.push_back({{"study", each->name()}, {"meaning", each->meaning()}});
    return print(list);
}

Shadowed shadow_of(const Captured& asked) {
    const captured::CapturedFrame frame(asked.capture);
    captured::Asked of;
    of.least_bias = asked.least_bias;
    of.pixel = asked.pixel;
    if (asked.truth) {
        const NumberImage &truth = *asked.truth, &observer = asked.capture.observer;
        if (truth.width != observer.width || truth.height != observer.height)
            throw SceneError(fmt::format("truth has {} x {} numbers, and the observer's buffer {} "
                                         "x {}; give a mask of that size", truth.width,
                                         truth.height, observer.width, observer.height));
        of.truth = captured::darkness_of(truth, asked.truth_bright,
                                         asked.capture.convention.first_row_on_top, frame.spec());
    }
    const captured::Answer answer(asked.capture, frame, of);
    Shadowed shadowed{print(captured::to_json(answer)), captured::mask_picture(answer), {}, {}, 0};
    shadowed.error = captured::cut(std::span<const double>(answer.judged.error_image),
                                   frame.observer_sides(), frame.spec().size_px());
    if (answer.judged.window) {
        shadowed.side = answer.judged.window->side;
        shadowed.spectrum = answer.judged.window->power;
    }
    return shadowed;
}

captured::Convention convention_of(const std::string& name) {
    const captured::Convention* found = captured::find_convention(name);
    if (found == nullptr)
        throw SceneError(fmt::format("'{}' is no convention; give d3d, vulkan or opengl", name));
    return *found;
}

captured::DepthFormat depth_format_of(const std::string& name) {
    const captured::DepthFormat* found = captured::find_depth_format(name);
    if (found == nullptr)
        throw SceneError(fmt::format("'{}' is no depth format; give one of {}", name,
                                     captured::names_of_depth_formats()));
    return *found;
}

std::string settings_table() { return print(settings_json()); }

std::string figure_settings(int figure) {
    if (figure < 1 || figure > shadow::figure_count)
        throw SceneError(fmt::format("there is no figure {} with settings of its own; give 1 .. {}",
                                     figure, shadow::figure_count));
    return print(settings_json(shadow::figure_settings(figure)));
}

}  // namespace umbra78::tools::python
