// Short texts of model files for the tests, and what reading them gives.
#pragma once

#include "tools/models/model.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace umbra78::tools::test {

// The lines of 16 points (i, j, k / 4) of patch k.
inline std::string patch_points(int k) {
    std::string text;
    for (int n = 0; n < 16; ++n)
        text += std::to_string(n % 4) + " " + std::to_string(n / 4) + " " + std::to_string(k / 4) +
                "." + std::to_string(25 * (k % 4)) + "\n";
    return text;
}

inline std::vector<std::array<std::uint32_t, 3>> facets_of(const ModelData& model) {
    std::vector<std::array<std::uint32_t, 3>> facets;
    for (const raster::Facet& facet : model.facets) facets.push_back(facet.vertex);
    return facets;
}

inline std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int k = 0; k < count; ++k) all += text;
    return all;
}

// The same text with the ends of lines of DOS.
inline std::string with_crlf(const std::string& text) {
    std::string all;
    for (const char c : text) all += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return all;
}

// With comments of their own lines and after numbers.
inline std::string with_comments(const std::string& text) {
    std::string all = "# nan 1e300\n";
    for (const char c : text) all += c == '\n' ? std::string(" # 7 , 7\n\n") : std::string(1, c);
    return all;
}

struct MalformedModel {
    std::string name, text, message;
};

inline void expect_messages(const std::vector<MalformedModel>& cases) {
    for (const MalformedModel& m : cases)
        EXPECT_EQ(read_model(m.text, m.name).error, m.message) << m.text.substr(0, 300);
}

inline constexpr std::int64_t model_one = std::int64_t{1} << model_fraction;

}  // namespace umbra78::tools::test
