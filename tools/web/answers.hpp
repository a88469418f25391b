// What a session answers to the page, in JSON: each is made of the program's own reports.
#pragma once

#include "tools/web/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace umbra78::tools::web {

// Of the frame as drawn: its planes' names and sizes, each stage's host milliseconds, the bias in
// three units, the views' angles and places, the settings, the scene's warnings, isolated pixels,
// and the rates of error if truth is known already.
nlohmann::ordered_json frame_json(Session&);

// {"mask": "u8:512x512:fnv1a64:...", ...}, as umbra78 render --json has it.
nlohmann::ordered_json hashes_json(const Session&);

// The machine's cycles and milliseconds: umbra78 render --json, "machine".
nlohmann::ordered_json machine_json(const Session&);

// Error against exact truth, isolated pixels, the spectrum's flatness and its highest line; or
// {"error": null, "because": ...} where there is no truth (Session::truth).
nlohmann::ordered_json error_json(Session&);

// Every word of one pixel's way (tools/watch/pixel_trace.hpp), and where in the light's view it was
// looked up. Throws SceneError for a frame that cannot be watched.
nlohmann::ordered_json trace_json(const Session&, int x, int y);

// The codes of a plane's (2 radius + 1)^2 pixels about one, by rows; null beyond the border.
nlohmann::ordered_json around_json(const Session&, const std::string& plane, int x, int y,
                                   int radius);

// A picture of size x size pixels, four bytes each: a plane of the frame by its name, Z as grey;
// "picture" and "intensity" of a coloured frame in colour; "error", the error map; "spectrum".
// Empty if there is no such thing. A plane is made `by` times smaller each way where its size is a
// multiple of that.
struct Picture {
    int size = 0;
    std::vector<std::uint8_t> rgba;
};
inline constexpr int smallest_share = 16;
Picture picture_of(Session&, const std::string& name, int by = 1);

}  // namespace umbra78::tools::web
