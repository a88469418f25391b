#include "tools/study/grid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_set>

namespace umbra78::tools::study {
namespace {

// The settings and extra columns of a case as one text, for a set of cases. A zero byte ends each
// part: no part holds one.
std::string key_of(const Case& c) {
    std::string key;
    for (const std::string& set : c.set) (key += set) += '\0';
    key += '\0';
    for (const auto& [column, value] : c.extra) (((key += column) += '\0') += value) += '\0';
    return key;
}

}  // namespace

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
        more.reserve(cases.size() * values.size());
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

std::vector<Case> joined(std::vector<Case> first, const std::vector<Case>& more) {
    std::unordered_set<std::string> there;
    for (const Case& c : first) there.insert(key_of(c));
    for (const Case& c : more)
        if (there.insert(key_of(c)).second) first.push_back(c);
    return first;
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

}  // namespace umbra78::tools::study
