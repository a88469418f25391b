// Memory for the core, which wants it aligned.
#pragma once

#include "shadow/frame/buffers.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace umbra78::tools {

class AlignedRoom {
public:
    explicit AlignedRoom(std::size_t bytes) : lines_(bytes / shadow::frame_alignment + 1) {}
    std::span<std::byte> bytes() { return std::as_writable_bytes(std::span(lines_)); }

private:
    struct alignas(shadow::frame_alignment) Line {
        std::byte bytes[shadow::frame_alignment];
    };
    std::vector<Line> lines_;
};

}  // namespace umbra78::tools
