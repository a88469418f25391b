#include "tools/io/buffer_files.hpp"

#include <algorithm>

namespace umbra78::tools {

void write_pgm(const Path& path, const Buffer& buffer, FileSet* set) {
    const int size = buffer.size_px, maxval = static_cast<int>(std::min(buffer.maxval, 65535u));
    if (const auto* bytes = std::get_if<std::span<const std::uint8_t>>(&buffer.values)) {
        write_pgm8(path, size, size, *bytes, maxval, set);
    } else if (const auto* words = std::get_if<std::span<const std::uint16_t>>(&buffer.values)) {
        write_pgm16(path, size, size, *words, maxval, set);
    } else {
        std::vector<std::uint32_t> upper(buffer.pixels());
        int shift = 0;
        while (buffer.maxval >> shift > 65535) ++shift;
        for (std::size_t at = 0; at < upper.size(); ++at) upper[at] = buffer.at(at) >> shift;
        write_pgm16(path, size, size, upper, maxval, set);
    }
}

void write_npy(const Path& path, const Buffer& buffer, FileSet* set) {
    std::visit([&](auto values) { write_npy(path, buffer.size_px, buffer.size_px, values, set); },
               buffer.values);
}

std::optional<Difference> compare(const Pgm& expected, const Buffer& actual) {
    std::optional<Difference> difference;
    const auto width = static_cast<std::size_t>(actual.size_px);
    for (std::size_t at = 0; at < actual.pixels(); ++at) {
        const std::uint32_t wanted = at < expected.samples.size() ? expected.samples[at] : 0;
        if (wanted == actual.at(at)) continue;
        if (!difference)
            difference = {static_cast<int>(at % width), static_cast<int>(at / width), wanted,
                          actual.at(at), 0};
        ++difference->pixels;
    }
    return difference;
}

std::vector<std::uint8_t> difference_picture(const Pgm& expected, const Buffer& actual) {
    const std::vector<std::uint8_t> gray = actual.maxval > 255 ? depth_as_gray(actual)
                                                               : std::vector<std::uint8_t>{};
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * actual.pixels());
    for (std::size_t at = 0; at < actual.pixels(); ++at) {
        const bool same = expected.samples[at] == actual.at(at);
        const auto level = gray.empty() ? static_cast<std::uint8_t>(actual.at(at)) : gray[at];
        const auto rest = static_cast<std::uint8_t>(same ? level : 0);
        rgb.insert(rgb.end(), {same ? level : std::uint8_t{255}, rest, rest});
    }
    return rgb;
}

}  // namespace umbra78::tools
