// One scene, its frame and what is known of it, for a page that draws it again and again.
//
// A scene's text and overrides are read each time; what of the frame before is still right is kept
// (shadow/frame/reuse.hpp), and so is the exact truth while surfaces, views and size are the same.
// Files that scenes name are handed in as texts. Errors are the program's own lines.
#pragma once

#include "tools/render/render_job.hpp"
#include "tools/scene/scene.hpp"
#include "tools/truth/scene_truth.hpp"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbra78::tools::web {

// What is drawn: a scene file that was handed in, or a text in its place, and overrides as --set
// takes them.
struct Request {
    std::string scene;
    std::optional<std::string> text{};
    std::vector<std::string> set{};
};

// Truth of a larger frame takes more memory and time than a page should: some 130 bytes a pixel.
inline constexpr int most_traced_px = 2048;

class Session {
public:
    void hand_in(const std::string& path, std::string text) { files_[path] = std::move(text); }
    const std::map<std::string, std::string>& files() const { return files_; }

    // Returns an error's line, and then the frame before is still there; or "". Throws SceneError
    // where RenderJob does.
    std::string draw(const Request&);

    bool drawn() const { return job_ != nullptr; }
    const LoadedScene& scene() const { return *scene_; }  // of the frame that was drawn
    const RenderJob& job() const { return *job_; }

    // Traced where it is not known yet: by the closed form, else by the polygons. Null, and
    // why_no_truth() says why, where there is neither, or the frame is too large: n/a.
    const SceneTruth* truth();
    std::string why_no_truth() const;
    bool knows_truth() const { return truth_ && traced_key_ == truth_key_; }
    // Of the first light's mask, after the filters; of a truth of closed form.
    ShadowReport error();
    MachineMask mask();
    // Its rates alone, which take no time worth speaking of; needs knows_truth().
    ShadowError rates();

private:
    bool job_has_room_for(const LoadedScene&) const;

    std::map<std::string, std::string> files_;
    std::unique_ptr<LoadedScene> scene_;
    std::unique_ptr<RenderJob> job_;
    std::string truth_key_, traced_key_;
    std::optional<SceneTruth> truth_;
    std::vector<std::uint8_t> visible_;
};

}  // namespace umbra78::tools::web
