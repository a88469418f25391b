#include "tools/web/presets.hpp"

#include "shadow/frame/paper_figures.hpp"
#include "tools/paper/scene_pictures.hpp"
#include "tools/scene/settings_text.hpp"
#include "tools/web/session.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace umbra78::tools::web {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view paper_scene = "figures.toml";

// Which plane each of the paper's first figures shows, and its golden (tools/paper/figure_set.cpp).
struct PlaneShown {
    std::string_view shows, plane, golden;
};
constexpr PlaneShown shown[shadow::figure_count] = {
    {"the picture, without shadows", "intensity", "intensity"},
    {"the light's depth map", "light_z", "light_z"},
    {"shadow: nearest lookup, low bias", "mask", "mask3"},
    {"shadow: bilinear, dither, bias", "mask", "mask4"},
    {"edges dequantized, low-passed", "filtered", "filtered5"},
    {"the shadow laid on the picture", "picture", "picture6"},
};

ordered_json overrides_of(const shadow::Settings& from, const shadow::Settings& to) {
    ordered_json set = ordered_json::array();
    for (const shadow::Setting& s : shadow::settings_table())
        if (s.get(from) != s.get(to))
            set.push_back(std::string(s.key) + "=" + print(s, s.get(to)));
    return set;
}

std::string spoken(const ScenePicture& p) {
    std::string name(p.name);
    return p.figure && name.starts_with("fig") ? "figure " + name.substr(3) : name;
}

ordered_json overrides_of(const ScenePicture& p) {
    ordered_json set = ordered_json::array();
    for (std::string_view rest = p.set; !rest.empty();) {
        const std::size_t end = rest.find(' ');
        set.push_back(rest.substr(0, end));
        rest = end == rest.npos ? std::string_view{} : rest.substr(end + 1);
    }
    return set;
}

}  // namespace

ordered_json presets_json(const Session& session) {
    ordered_json presets = ordered_json::array();
    const auto held = [&](std::string_view scene) {
        return session.files().contains(std::string(scene));
    };
    if (held(paper_scene)) {
        const SceneResult paper =
            read_scene(session.files().at(std::string(paper_scene)), "figures.toml", {});
        for (int k = 1; k <= shadow::figure_count; ++k) {
            const PlaneShown& of = shown[k - 1];
            presets.push_back(
                {{"name", "figure " + std::to_string(k)},
                 {"shows", of.shows},
                 {"scene", paper_scene},
                 {"set", overrides_of(paper.scene.settings, shadow::figure_settings(k))},
                 {"plane", of.plane},
                 {"golden", of.golden}});
        }
    }
    for (const ScenePicture& p : scene_pictures())
        if (p.needs.empty() && held(p.scene))
            presets.push_back({{"name", spoken(p)},
                               {"shows", p.shows},
                               {"scene", p.scene},
                               {"set", overrides_of(p)},
                               {"plane", "picture"},
                               {"golden", p.name}});
    return presets;
}

}  // namespace umbra78::tools::web
