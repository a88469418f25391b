// The page's way to the machine: one function, JSON in and JSON out.
//
//   {"do": "hand_in", "path": "figures.toml", "text": "..."}
//   {"do": "table"}                       the settings and profiles; "presets", "draw", ... below
//   {"do": "draw", "scene": "figures.toml", "text": null, "set": ["bias=64"]}
//
// An answer is {"problem": "a line"} where there is one. A picture's bytes stay in the machine's
// memory; its answer says where, until the next one is asked for.
#include "tools/scene/settings_text.hpp"
#include "tools/web/answers.hpp"
#include "tools/web/bridge.hpp"
#include "tools/web/cycle_log.hpp"
#include "tools/web/presets.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace umbra78::tools::web {

using nlohmann::ordered_json;

struct Bridge::Kept {
    Session session;
    Picture picture;
};

namespace {

ordered_json problem(std::string line) { return {{"problem", std::move(line)}}; }

Request request_of(const ordered_json& asked) {
    Request request{.scene = asked.value("scene", "")};
    if (asked.contains("text") && asked.at("text").is_string())
        request.text = asked.at("text").get<std::string>();
    if (asked.contains("set"))
        for (const ordered_json& each : asked.at("set")) request.set.push_back(each);
    return request;
}

ordered_json draw(Session& session, const ordered_json& asked) {
    const std::string error = session.draw(request_of(asked));
    return error.empty() ? frame_json(session) : problem(error);
}

ordered_json picture(Bridge::Kept& kept, const ordered_json& asked) {
    const int by = std::clamp(asked.value("by", 1), 1, smallest_share);
    kept.picture = picture_of(kept.session, asked.value("name", ""), by);
    return {{"size", kept.picture.size},
            {"at", reinterpret_cast<std::uintptr_t>(kept.picture.rgba.data())},
            {"bytes", kept.picture.rgba.size()}};
}

// What is asked of a frame that is drawn.
ordered_json of_frame(Bridge::Kept& kept, const std::string& what, const ordered_json& asked) {
    Session& session = kept.session;
    if (!session.drawn()) return problem("nothing is drawn yet");
    const int x = asked.value("x", 0), y = asked.value("y", 0);
    if (what == "frame") return frame_json(session);
    if (what == "hashes") return hashes_json(session);
    if (what == "machine") return machine_json(session);
    if (what == "error") return error_json(session);
    if (what == "picture") return picture(kept, asked);
    if (what == "trace") return trace_json(session, x, y);
    if (what == "around")
        return around_json(session, asked.value("plane", "light_z"), x, y,
                           asked.value("radius", 2));
    if (what == "cycles")
        return cycles_json(session.job(), asked.value("from", std::uint64_t{0}),
                           asked.value("count", 40));
    return problem("the machine does not know what to do: " + what);
}

ordered_json answer_to(Bridge::Kept& kept, const ordered_json& asked) {
    if (!asked.is_object()) return problem("this is no request");
    const std::string what = asked.value("do", "");
    if (what == "hand_in") {
        kept.session.hand_in(asked.value("path", ""), asked.value("text", ""));
        return ordered_json::object();
    }
    if (what == "table") return settings_json();
    if (what == "presets") return presets_json(kept.session);
    if (what == "draw") return draw(kept.session, asked);
    return of_frame(kept, what, asked);
}

}  // namespace

Bridge::Bridge() : kept_(std::make_unique<Kept>()) {}
Bridge::~Bridge() = default;

std::string Bridge::answer(std::string_view request) {
    const ordered_json asked = ordered_json::parse(request, nullptr, false);
    return answer_to(*kept_, asked).dump(-1, ' ', false,
                                         ordered_json::error_handler_t::replace);
}

}  // namespace umbra78::tools::web

#ifdef __wasm__
#define UMBRA78_EXPORT(name) __attribute__((export_name(name)))

namespace {

umbra78::tools::web::Bridge& bridge() {
    static umbra78::tools::web::Bridge one;
    return one;
}
std::string request_text, answer_text;

}  // namespace

extern "C" {

// Where the page writes a request of so many bytes.
UMBRA78_EXPORT("room") char* umbra78_room(std::size_t bytes) {
    request_text.resize(bytes);
    return request_text.data();
}
UMBRA78_EXPORT("ask") std::size_t umbra78_ask() {  // returns the bytes of the answer
    answer_text = bridge().answer(request_text);
    return answer_text.size();
}
UMBRA78_EXPORT("answer") const char* umbra78_answer() { return answer_text.data(); }
}
#endif
