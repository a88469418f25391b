// What a processor without an operating system needs before its first frame, and says after its
// last: the names are those of the linker scripts.
#pragma once

#include "tests/exact/port.hpp"

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t umbra78_data_start, umbra78_data_end, umbra78_data_load;
extern std::uint32_t umbra78_zero_start, umbra78_zero_end;
extern std::uint32_t umbra78_stack_start, umbra78_stack_end;
extern void (*const umbra78_starts_first[])(), (*const umbra78_starts_last[])();
}

namespace umbra78::exact::bare {

inline constexpr std::uint32_t unused_stack = 0x5afe5afe;

// Data and zeros as the language has them, constructors, and a mark on every word of the stack
// below this function.
[[gnu::noinline]] inline void start_memory() {
    volatile std::uint32_t* to = &umbra78_data_start;
    for (const std::uint32_t* from = &umbra78_data_load; to < &umbra78_data_end;) *to++ = *from++;
    for (to = &umbra78_zero_start; to < &umbra78_zero_end;) *to++ = 0;
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) - 256;
    for (to = &umbra78_stack_start; reinterpret_cast<std::uintptr_t>(to) < here;)
        *to++ = unused_stack;
    for (auto start = umbra78_starts_first; start < umbra78_starts_last; ++start) (*start)();
}

// "stack BYTES": from its end down to the deepest word that no longer holds the mark.
inline void print_stack() {
    const volatile std::uint32_t* deepest = &umbra78_stack_start;
    while (deepest < &umbra78_stack_end && *deepest == unused_stack) ++deepest;
    std::size_t bytes = static_cast<std::size_t>(
        reinterpret_cast<std::uintptr_t>(&umbra78_stack_end) -
        reinterpret_cast<std::uintptr_t>(deepest));
    char text[32] = "stack ";
    std::size_t at = 6, digits = 1;
    for (std::size_t v = bytes; v >= 10; v /= 10) ++digits;
    for (std::size_t k = digits; k > 0; bytes /= 10)
        text[at + --k] = static_cast<char>('0' + bytes % 10);
    at += digits;
    text[at++] = '\n';
    port::write(text, at);
}

}  // namespace umbra78::exact::bare
