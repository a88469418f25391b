// What every target of a model's reader does: whatever the bytes are, they are read and placed, or
// refused in one line with file and line.
#pragma once

#include "tools/io/first_error.hpp"
#include "tools/models/place_model.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace umbra78::tools::test {

inline void require(bool holds) {
    if (!holds) __builtin_trap();
}

inline bool is_one_line(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

inline int fuzz_model(const std::uint8_t* bytes, std::size_t size, const std::string& name) {
    const ModelResult result = read_model({reinterpret_cast<const char*>(bytes), size}, name);
    if (!result.ok()) {
        require(result.error.starts_with(name + ":") && is_one_line(result.error));
        return 0;
    }
    for (const bool smooth : {true, false}) {
        FirstError error;
        place_model(result.model, {.smooth = smooth}, "make it smaller", error);
    }
    return 0;
}

}  // namespace umbra78::tools::test
