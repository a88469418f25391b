// What is said of a captured frame, as text and as JSON, and its pictures.
#pragma once

#include "tools/captured/judge.hpp"
#include "tools/watch/pixel_trace.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace umbra78::tools::captured {

struct Asked {
    std::optional<Pixel> pixel;           // its trace
    bool least_bias = false;              // the search
    std::vector<std::uint8_t> truth;      // darkness of the frame; empty: it is estimated
};

// The frame with everything that was asked about it.
struct Answer {
    Answer(const Capture&, const CapturedFrame&, const Asked&);

    const Capture& capture;
    const CapturedFrame& frame;
    std::vector<std::uint8_t> mask;
    Outcomes outcomes;
    Judged judged;
    bool searched = false;
    std::optional<LeastBias> least;
    std::optional<PixelTrace> trace;
    std::vector<std::string> warnings;  // a line each
};

std::string print(const Answer&);
nlohmann::ordered_json to_json(const Answer&);

// Pictures of the observer's buffer: the mask, light and dark; and three bytes a pixel: red false
// shadow, blue false light, else the mask in grey.
std::vector<std::uint8_t> mask_picture(const Answer&);
std::vector<std::uint8_t> error_picture(const Answer&);

}  // namespace umbra78::tools::captured
