#include "tools/web/session.hpp"

#include "tools/web/polygon_truth.hpp"

#include <utility>

namespace umbra78::tools::web {
namespace {

FileSource among(const std::map<std::string, std::string>& files) {
    return [&files](const std::string& path) {
        const auto found = files.find(path);
        if (found != files.end()) return FileText{path, found->second};
        return FileText{.name = path, .error = "the page does not hold '" + path +
                                               "'; draw this scene with umbra78 render"};
    };
}

// What truth depends on: the text, the views' overrides, the picture's size.
std::string key_of_truth(const Request& request, std::string_view text, int size_px) {
    std::string key = std::to_string(size_px) + "\n";
    for (const std::string& each : request.set)
        if (each.substr(0, each.find('=')).find('.') != std::string::npos) key += each + "\n";
    return key.append(text);
}

bool fits_page(const LoadedScene& scene) {
    return scene.settings.machine.size_px() <= most_traced_px;
}

}  // namespace

std::string Session::draw(const Request& request) {
    const auto found = files_.find(request.scene);
    if (!request.text && found == files_.end())
        return "there is no scene '" + request.scene + "' in this page; choose one of its list";
    const std::string& text = request.text ? *request.text : found->second;
    SceneResult read = read_scene(text, request.scene, request.set, among(files_));
    if (!read.ok()) return read.error;
    auto next = std::make_unique<LoadedScene>(std::move(read.scene));
    if (job_ && job_has_room_for(*next)) {
        job_->advance(next->view(), next->settings);
    } else {
        job_.reset();  // first, so that not both frames are there at once
        job_ = std::make_unique<RenderJob>(next->view(), next->settings);
    }
    job_->render();
    scene_ = std::move(next);
    truth_key_ = key_of_truth(request, text, scene_->settings.machine.size_px());
    return "";
}

// Whether advance() takes it: planes of the same number and size, and no more patches.
bool Session::job_has_room_for(const LoadedScene& next) const {
    const hw::MachineSpec &a = job_->settings().machine, &b = next.settings.machine;
    return a.xy_bits == b.xy_bits && a.z_bits == b.z_bits &&
           shadow::FrameShape(scene_->view(), job_->settings()) ==
               shadow::FrameShape(next.view(), next.settings) &&
           next.patches.size() == scene_->patches.size();
}

const SceneTruth* Session::truth() {
    if (traced_key_ != truth_key_) {
        truth_.reset();
        if (fits_page(*scene_))
            truth_ = scene_->has_closed_form() ? trace(*scene_) : polygon_truth(*scene_);
        traced_key_ = truth_key_;
    }
    return truth_ ? &*truth_ : nullptr;
}

std::string Session::why_no_truth() const {
    if (!fits_page(*scene_)) return "of a frame this large it takes too long in a browser";
    return scene_->has_closed_form() ? "" : why_no_polygon_truth(*scene_);
}

MachineMask Session::mask() {
    visible_ = job_->visible();
    return {job_->bytes(Plane::filtered), visible_};
}

ShadowError Session::rates() {
    return shadow_error(truth_->truth, mask(), truth_->unlit_side);
}

ShadowReport Session::error() {
    const Buffer depths = job_->buffer(Plane::observer_z);
    return report(*truth_, mask(),
                  widened(light_texel_band(*truth_), *truth_, job_->settings()), &depths);
}

}  // namespace umbra78::tools::web
