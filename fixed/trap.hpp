// What happens when a precondition is broken: a bad width, a bad shift, an overflow that was
// ruled out. There is nothing to return, so the program stops, and says why if it can.
//
//   in a constant expression   trap() is not constexpr, so reaching it is a compile error
//   at run time                umbra78_trapped(why) is called if the program defines it; if it is
//                              not defined, or returns, the trap instruction stops the program
//
// The hook. The integer rooms have neither I/O nor exceptions, so they leave the reporting to
// the program. A program that wants a message defines, in one of its own sources,
//
//   extern "C" void umbra78_trapped(const char* why) { std::fprintf(stderr, "%s\n", why); }
//
// The hook may also throw, and this is how a binding to another language turns a broken
// precondition into an exception: no function of the core is noexcept or keeps a resource, so
// the exception passes through it. The core must then be compiled with unwind tables
// (-funwind-tables; the default on x86-64 and AArch64). What the call had begun to write is left
// half written. The hook must not itself be noexcept.
#pragma once

// A weak reference: its address is null in a program that does not define the function.
extern "C" [[gnu::weak]] void umbra78_trapped(const char* why);

namespace umbra78::fixed {

// Out of line, so that a check costs its caller a comparison and a jump.
[[noreturn, gnu::cold, gnu::noinline]] inline void trap(const char* why) {
    if (umbra78_trapped != nullptr) umbra78_trapped(why);
    __builtin_trap();
}

// require(condition, why): the usual form of a precondition.
constexpr void require(bool condition, const char* why) {
    if (!condition) [[unlikely]] {
        trap(why);
    }
}

}  // namespace umbra78::fixed
