#include "tools/io/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace umbra78::tools {

// Optimal string alignment (Damerau 1964). The whole table is kept, since names are short.
int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    std::vector<int> cost((a.size() + 1) * width);
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            int& here = cost[i * width + j];
            if (i == 0 || j == 0) {
                here = static_cast<int>(i + j);
                continue;
            }
            const int replaced = cost[(i - 1) * width + j - 1] + (a[i - 1] != b[j - 1]);
            here = std::min({replaced, cost[(i - 1) * width + j] + 1, cost[i * width + j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                here = std::min(here, cost[(i - 2) * width + j - 2] + 1);
        }
    }
    return cost.back();
}

std::string suggest(std::string_view word, std::span<const std::string_view> known) {
    constexpr std::size_t longest = 64;  // what is longer is not treated as a misspelling
    word = word.substr(0, longest);
    const auto nearest = std::min_element(
        known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
            return edit_distance(word, a) < edit_distance(word, b);
        });
    const int bearable = std::clamp(static_cast<int>(word.size()) / 3, 1, 3);
    if (nearest != known.end() && edit_distance(word, *nearest) <= bearable)
        return fmt::format("did you mean '{}'?", *nearest);
    return fmt::format("known here: {}", fmt::join(known, ", "));
}

}  // namespace umbra78::tools
