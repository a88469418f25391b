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

namespace {

// A quotient of integers this small, in double precision, is floored to the same as in integers:
// where it is not whole, it is farther from a whole number than it is rounded by.
template <class Code>
std::vector<std::uint8_t> gray_of(std::span<const Code> codes, std::uint32_t background) {
    constexpr int brightest = 255, darkest = 40;
    std::uint32_t nearest = background, farthest = 0;
    for (const std::uint32_t code : codes) {
        nearest = std::min(nearest, code);
        farthest = std::max(farthest, code == background ? 0 : code);
    }
    const double range = std::max(farthest, nearest + 1) - nearest;
    std::vector<std::uint8_t> gray(codes.size());
    for (std::size_t at = 0; at < codes.size(); ++at) {
        const bool drawn = codes[at] != background;
        const std::uint32_t behind = drawn ? codes[at] - nearest : 0;
        const double down = double{brightest - darkest} * behind / range;
        gray[at] = static_cast<std::uint8_t>(drawn ? brightest - static_cast<int>(down) : 0);
    }
    return gray;
}

}  // namespace

std::vector<std::uint8_t> depth_as_gray(const Buffer& depth) {
    return std::visit([&](auto codes) { return gray_of(codes, depth.maxval); }, depth.values);
}

}  // namespace umbra78::tools
