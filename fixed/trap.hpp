// The one end of a broken contract: bad width, bad shift, overflow that was ruled out.
//
//   in constant evaluation   trap() is not constexpr, so reaching it is a compile error
//   at run time              the program stops at the trap instruction, `why` in a register
//
// There are no exceptions and no I/O in the integer rooms, so there is nothing to catch or print:
// the text is for the compiler's message, the debugger and the reader.
#pragma once

namespace umbra78::fixed {

[[noreturn]] inline void trap(const char* why) {
    (void)why;
    __builtin_trap();
}

// require(condition, why): the usual spelling of a precondition.
constexpr void require(bool condition, const char* why) {
    if (!condition) [[unlikely]] {
        trap(why);
    }
}

}  // namespace umbra78::fixed
