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
