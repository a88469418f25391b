// The cases of a grid, and the scene of a case.
#include "tools/study/study.hpp"

#include "tools/study/paper_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbra78::tools::study {

std::vector<Case> grid(const Request& request, std::vector<GridKey> axes) {
    for (const GridKey& varied : request.vary) {
        const auto found = std::find_if(axes.begin(), axes.end(),
                                        [&](const GridKey& a) { return a.first == varied.first; });
        if (found != axes.end()) {
            found->second = varied.second;
        } else {
            axes.push_back(varied);
        }
    }
    std::vector<Case> cases(1);
    for (const auto& [key, values] : axes) {
        std::vector<Case> more;
        for (const Case& so_far : cases)
            for (const std::string& value : values) {
                more.push_back(so_far);
                more.back().set.push_back(fmt::format("{}={}", key, value));
            }
        cases = std::move(more);
    }
    for (Case& c : cases) c.name = fmt::format("{}", fmt::join(c.set, " "));
    return cases;
}

Request for_sweep(Request request, std::span<const std::string_view> own,
                  std::span<const std::string_view> keys) {
    const auto holds = [](std::span<const std::string_view> list, std::string_view key) {
        return std::find(list.begin(), list.end(), key) != list.end();
    };
    std::erase_if(request.vary, [&](const GridKey& axis) {
        return axis.second.size() > 1 && holds(own, axis.first) && !holds(keys, axis.first);
    });
    return request;
}

std::vector<Case> joined(std::vector<Case> first, const std::vector<Case>& more) {
    for (const Case& c : more) {
        const auto is_it = [&](const Case& there) {
            return there.set == c.set && there.extra == c.extra;
        };
        if (std::none_of(first.begin(), first.end(), is_it)) first.push_back(c);
    }
    return first;
}

LoadedScene scene_of(const Request& request, const Case& c) {
    if (!request.scene_text.empty())
        return parse_scene(request.scene_text, request.scene_file, c.set);
    return parse_scene(paper_scene_text, "figures.toml", c.set);
}

}  // namespace umbra78::tools::study
