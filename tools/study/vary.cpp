#include "tools/study/vary.hpp"

#include "tools/scene/decimal_range.hpp"

#include <fmt/format.h>

#include <unordered_set>

namespace umbra78::tools::study {
namespace {

[[noreturn]] void fail(const std::string& text, std::string_view wrong) {
    throw SceneError(fmt::format("--vary {}: {}; write key=first:last:step as in bias=0:256:32, "
                                 "or key=value,value as in lookup=nearest,bilinear", text, wrong));
}

// The pieces of the text between the marks. A mark between brackets does not count.
std::vector<std::string> cut(std::string_view text, char mark) {
    std::vector<std::string> pieces(1);
    int depth = 0;
    for (const char letter : text) {
        depth += (letter == '[') - (letter == ']');
        if (letter == mark && depth == 0) {
            pieces.emplace_back();
        } else {
            pieces.back() += letter;
        }
    }
    return pieces;
}

}  // namespace

GridKey parse_vary(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) fail(text, "there is no '='");
    if (equals == 0) fail(text, "there is no key");
    const std::string key = text.substr(0, equals), rest = text.substr(equals + 1);
    if (cut(rest, ':').size() > 1) {
        DecimalRange range = read_decimal_range(rest);
        if (!range.error.empty()) fail(text, range.error);
        return {key, std::move(range.values)};
    }
    GridKey axis{key, cut(rest, ',')};
    std::unordered_set<std::string> seen;
    for (const std::string& value : axis.second) {
        if (value.empty()) fail(text, "a value is missing");
        if (!seen.insert(value).second) fail(text, fmt::format("'{}' is given twice", value));
    }
    return axis;
}

void check_vary(const Request& request) {
    for (std::size_t k = 0; k < request.vary.size(); ++k) {
        const auto& [key, values] = request.vary[k];
        for (std::size_t other = 0; other < k; ++other)
            if (request.vary[other].first == key)
                throw SceneError(fmt::format(
                    "--vary {}: it is given twice; write all its values in one --vary", key));
        for (const std::string& value : values) {
            std::vector<std::string> set;
            for (const auto& [other, first] : request.vary)
                set.push_back(other + "=" + (other == key ? value : first.front()));
            try {
                scene_of(request, {{}, set, {}});
            } catch (const SceneError& error) {
                std::string what = error.what();
                if (what.starts_with("--set ")) what.replace(0, 6, "--vary ");
                throw SceneError(what);
            }
        }
    }
}

}  // namespace umbra78::tools::study
