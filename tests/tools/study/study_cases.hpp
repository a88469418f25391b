// For tests of studies: requests for a scene as text, and cases that are run alone.
#pragma once

#include "tools/study/study.hpp"

#include <string>
#include <vector>

namespace umbra78::tools::study {

inline Request request_of(std::string scene_text) {
    Request request;
    request.scene_file = "test.toml";
    request.scene_text = std::move(scene_text);
    request.scene = scene_of(request, {});
    return request;
}

// One sphere, small and quickly drawn.
inline Request small_sphere() {
    return request_of(R"([light]
azimuth = -100
extent  = 2

[observer]
extent  = 2

[[sphere]]
centre  = [0, 0, 0]
radius  = 1.5

[settings]
xy_bits = 7
bias    = 64
bias_unit = "quanta"
)");
}

// The figures of one case, as the framework runs it.
inline Row figures_of(const Study& study, const Request& request, const Case& c) {
    const auto scene = study.scene(request, c);
    return study.run(request, c, scene ? &*scene : nullptr);
}

// A row with these values, as if a case had run.
inline Row row_with(const std::vector<std::pair<std::string, Value>>& cells) {
    Row row;
    for (const auto& [column, value] : cells) row.set(column, value);
    return row;
}

}  // namespace umbra78::tools::study
