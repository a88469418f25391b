#include "tools/io/buffers.hpp"

#include "fixed/fnv.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace umbra78::tools {
namespace {

void feed(fixed::Fnv1a64& hash, std::uint8_t value) { hash.byte(value); }
void feed(fixed::Fnv1a64& hash, std::uint16_t value) { hash.u16be(value); }
void feed(fixed::Fnv1a64& hash, std::uint32_t value) { hash.u32be(value); }

const char* format_name(const BufferValues& values) {
    constexpr const char* names[] = {"u8", "u16be", "u32be"};
    return names[values.index()];
}

}  // namespace

std::string hash_of(const Buffer& buffer) {
    fixed::Fnv1a64 hash;
    std::visit(
        [&](auto values) {
            for (const auto value : values) feed(hash, value);
        },
        buffer.values);
    return fmt::format("{}:{}x{}:fnv1a64:{:016x}", format_name(buffer.values), buffer.size_px,
                       buffer.size_px, hash.value());
}

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

std::vector<std::uint8_t> depth_as_gray(const Buffer& depth) {
    constexpr std::uint32_t brightest = 255, darkest = 40;
    std::uint32_t nearest = depth.maxval, farthest = 0;
    for (std::size_t at = 0; at < depth.pixels(); ++at) {
        const std::uint32_t code = depth.at(at);
        if (code == depth.maxval) continue;  // background
        nearest = std::min(nearest, code);
        farthest = std::max(farthest, code);
    }
    const std::uint64_t range = std::max(farthest, nearest + 1) - nearest;
    std::vector<std::uint8_t> gray(depth.pixels());
    for (std::size_t at = 0; at < depth.pixels(); ++at) {
        const std::uint32_t code = depth.at(at);
        if (code == depth.maxval) continue;
        const std::uint64_t down = (brightest - darkest) * std::uint64_t{code - nearest} / range;
        gray[at] = static_cast<std::uint8_t>(brightest - down);
    }
    return gray;
}

}  // namespace umbra78::tools
