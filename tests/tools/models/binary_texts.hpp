// Bytes of binary model files for the tests.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace umbra78::tools::test {

inline std::string bytes_of(std::uint64_t bits, int count, bool big = false) {
    std::string bytes;
    for (int k = 0; k < count; ++k)
        bytes += static_cast<char>(bits >> 8 * (big ? count - 1 - k : k) & 255);
    return bytes;
}

inline std::string bytes_of(float value, bool big = false) {
    return bytes_of(std::bit_cast<std::uint32_t>(value), 4, big);
}

inline std::string bytes_of(double value, bool big = false) {
    return bytes_of(std::bit_cast<std::uint64_t>(value), 8, big);
}

// A binary STL file of corners: nine floats a triangle, normals and attributes that are to be
// skipped.
inline std::string binary_stl(const std::vector<float>& corners,
                              const std::string& title = "made for a test") {
    std::string text = title;
    text.resize(80, '\0');
    text += bytes_of(corners.size() / 9, 4);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (k % 9 == 0)
            for (const float n : {0.5f, -1e30f, 7.0f}) text += bytes_of(n);
        text += bytes_of(corners[k]);
        if (k % 9 == 8) text += "\x12\x34";
    }
    return text;
}

}  // namespace umbra78::tools::test
