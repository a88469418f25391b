#include "tools/watch/rival_trace.hpp"

#include "shadow/frame/rivals.hpp"
#include "shadow/rivals/volumes.hpp"
#include "tools/render/aligned_room.hpp"
#include "tools/scene/scene_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbra78::tools {
namespace {

namespace rivals = shadow::rivals;

void find_sides(const rivals::Setting& s, std::uint32_t on, Pixel at, RivalTrace& trace) {
    std::vector<rivals::ContourEdge> contour(rivals::find_contour(s, {}));
    rivals::find_contour(s, contour);
    trace.contour = contour.size();
    for (const rivals::ContourEdge& edge : contour) {
        const rivals::ShadowSide side(s, edge);
        if (!side.is_seen()) continue;
        const rivals::Run run = side.covered_run(s.space, at.y);
        if (at.x < run.from || at.x >= run.to) continue;
        const rivals::ScreenLine line = side.crossed(s.planes[on]);
        if (line.sign_at(s.space.centre(at.x), s.space.centre(at.y)) != side.crossed_sign())
            continue;
        const rivals::Edge& e = s.mesh.edges[edge.edge];
        trace.sides.push_back({e.low, e.high, side.change()});
    }
}

}  // namespace

RivalTrace trace_rival(const RenderJob& job, Pixel at) {
    const int size = job.settings().machine.size_px();
    if (at.x < 0 || at.y < 0 || at.x >= size || at.y >= size)
        throw SceneError(fmt::format("pixel {},{} lies outside the picture, 0..{}", at.x, at.y,
                                     size - 1));
    AlignedRoom room(shadow::rival_bytes(job.inputs()));
    const shadow::RivalView view = shadow::rival_view(job.inputs(), 0, room.bytes());
    const rivals::Setting& s = view.setting;
    RivalTrace trace{.pixel = at, .state = "nothing seen", .facets = s.mesh.facets.size()};
    trace.facet = view.shown[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size) +
                             static_cast<std::size_t>(at.x)];
    if (trace.facet == rivals::nothing_seen) return trace;
    if (s.attached(trace.facet)) {  // its own volume begins here, and no more is asked
        trace.state = "attached shadow";
        return trace;
    }
    const std::int32_t px = s.space.centre(at.x), py = s.space.centre(at.y);
    for (std::uint32_t f = 0; f < s.mesh.facets.size(); ++f)
        if (s.hides(s.light, f, trace.facet, px, py)) trace.casters.push_back(f);
    find_sides(s, trace.facet, at, trace);
    trace.at_eye = static_cast<std::int32_t>(trace.casters.size());
    for (const RivalTrace::Side& side : trace.sides) trace.at_eye -= side.change;
    trace.state = trace.casters.empty() ? "lit" : "cast shadow";
    return trace;
}

std::string print(const RivalTrace& t) {
    if (t.state == "nothing seen") return "no polygon covers the pixel's centre\n";
    std::string text = fmt::format("shows facet {} of {}\n", t.facet, t.facets);
    if (t.state == "attached shadow")
        return text + "the light is not on the side of it that is seen\n";
    text += fmt::format("{} facets lie between its point and the light\n", t.casters.size());
    for (const std::uint32_t f : t.casters) text += fmt::format("  facet {}\n", f);
    text += fmt::format("the eye is in {} shadow volumes; {} of the {} sides are crossed on the "
                        "way to the point\n", t.at_eye, t.sides.size(), t.contour);
    for (const RivalTrace::Side& side : t.sides)
        text += fmt::format("  the side at vertices {} and {}: {:+}\n", side.low, side.high,
                            side.change);
    return text;
}

nlohmann::ordered_json to_json(const RivalTrace& t) {
    nlohmann::ordered_json json{{"pixel", {t.pixel.x, t.pixel.y}}, {"state", t.state}};
    if (t.state == "nothing seen") return json;
    json["facet"] = t.facet;
    json["facets"] = t.facets;
    if (t.state == "attached shadow") return json;
    json["casters"] = t.casters;
    json["volumes_at_eye"] = t.at_eye;
    json["contour_edges"] = t.contour;
    json["sides_crossed"] = nlohmann::ordered_json::array();
    for (const RivalTrace::Side& s : t.sides)
        json["sides_crossed"].push_back({{"vertices", {s.low, s.high}}, {"change", s.change}});
    return json;
}

}  // namespace umbra78::tools
