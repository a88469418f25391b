// A frame's buffers by name, and their hashes. tools/io/buffer_files.hpp has their files.
//
// A hash is FNV-1a-64 over the values, row by row from the top, high byte first, preceded by
// the format: "u16be:512x512:fnv1a64:0123456789abcdef". Z is u16be up to 16 bits, else u32be;
// everything else is u8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace umbra78::tools {

using BufferValues = std::variant<std::span<const std::uint8_t>, std::span<const std::uint16_t>,
                                  std::span<const std::uint32_t>>;

// size_px * size_px values, 0 .. maxval; the memory is the frame's.
struct Buffer {
    std::string name;
    int size_px;
    std::uint32_t maxval;
    BufferValues values;

    std::uint32_t at(std::size_t index) const {
        return std::visit([index](auto v) -> std::uint32_t { return v[index]; }, values);
    }
    std::size_t pixels() const { return static_cast<std::size_t>(size_px) * size_px; }
};

std::string hash_of(const Buffer&);

// Depth codes as gray: the nearest drawn code 255, the farthest 40, the background 0.
std::vector<std::uint8_t> depth_as_gray(const Buffer&);

}  // namespace umbra78::tools
