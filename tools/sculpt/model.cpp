#include "tools/sculpt/model.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace umbra78::tools {
namespace {

// In units of 1/10000. A hair more than half is added, so that a value that is half but for the
// rounding of its computation goes the same way on every computer.
long ten_thousandths(double value) {
    const double hair = 1e-6;
    const long rounded = static_cast<long>(std::floor(std::abs(value) * 10000 + 0.5 + hair));
    return value < 0 ? -rounded : rounded;
}

// Without zeros at the end, and 0 for -0.
std::string decimal(double value) {
    const long n = ten_thousandths(value);
    std::string text = fmt::format("{}{}.{:04}", n < 0 ? "-" : "", std::abs(n) / 10000,
                                   std::abs(n) % 10000);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::size_t patches_of(const std::vector<Part>& parts) {
    std::size_t count = 0;
    for (const Part& part : parts) count += part.surface.size();
    return count;
}

}  // namespace

const std::vector<Model>& models() {
    static const std::vector<Model> all{
        {"robot", "a friendly machine, waving (figure 8)", robot_parts},
        {"smile", "lips and teeth (figure 7)", smile_parts},
        {"knot", "a trefoil knot (gallery)", knot_parts},
    };
    return all;
}

const Model* find_model(std::string_view name) {
    const auto found = std::ranges::find(models(), name, &Model::name);
    return found == models().end() ? nullptr : &*found;
}

std::vector<std::string> groups_of(const std::vector<Part>& parts) {
    std::vector<std::string> groups;
    for (const Part& part : parts)
        if (std::ranges::find(groups, part.group) == groups.end()) groups.push_back(part.group);
    return groups;
}

std::vector<Part> only_group(const std::vector<Part>& parts, std::string_view group) {
    std::vector<Part> some;
    std::ranges::copy_if(parts, std::back_inserter(some),
                         [&](const Part& part) { return part.group == group; });
    return some;
}

std::string to_bpt(std::string_view title, const std::vector<Part>& parts) {
    std::string text = fmt::format("# {}\n{}\n", title, patches_of(parts));
    for (const Part& part : parts) {
        text += fmt::format("# {}\n", part.name);
        for (const Net& net : part.surface) {
            text += "3 3\n";
            for (const Point& p : net)
                text += fmt::format("{} {} {}\n", decimal(p.x), decimal(p.y), decimal(p.z));
        }
    }
    return text;
}

nlohmann::ordered_json model_summary(std::string_view name, const std::vector<Part>& parts) {
    Point low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Part& part : parts) {
        list.push_back({{"name", part.name}, {"group", part.group},
                        {"patches", part.surface.size()}});
        for (const Net& net : part.surface)
            for (const Point& p : net) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            }
    }
    const auto corner = [](Point p) {
        const auto rounded = [](double v) { return static_cast<double>(ten_thousandths(v)) / 1e4; };
        return nlohmann::ordered_json{rounded(p.x), rounded(p.y), rounded(p.z)};
    };
    return {{"model", name}, {"patches", patches_of(parts)}, {"parts", list},
            {"box", {{"low", corner(low)}, {"high", corner(high)}}}};
}

}  // namespace umbra78::tools
