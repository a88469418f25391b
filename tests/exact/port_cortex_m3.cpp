// An Arm MPS2 board with a Cortex-M3, as QEMU's mps2-an385 has it: no operating system, no FPU.
// Text goes out by semihosting; instructions are counted by a timer of the board, which runs at
// 25 MHz of a time in which QEMU (-icount shift=0) gives each instruction a nanosecond.
#include "tests/exact/bare.hpp"
#include "tests/exact/port.hpp"

namespace {

std::uintptr_t semihosting(std::uintptr_t operation, const void* block) {
    register std::uintptr_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = block;
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

[[noreturn]] void leave(int status) {
    const std::uintptr_t block[2] = {0x20026, static_cast<std::uintptr_t>(status)};
    semihosting(0x20, block);  // SYS_EXIT_EXTENDED, the application's own end
    for (;;) {}
}

constexpr std::uint32_t nanoseconds_a_tick = 40;
volatile std::uint32_t& timer(std::uintptr_t offset) {
    return *reinterpret_cast<volatile std::uint32_t*>(0x40000000 + offset);
}

}  // namespace

namespace umbra78::exact::port {

void write(const char* text, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) semihosting(0x03, text + k);  // SYS_WRITEC
}
std::uint64_t instructions() {
    static std::uint64_t before = 0;  // the timer counts down and passes 0 each 171 s
    std::uint64_t now = (before & ~std::uint64_t{0xffffffff}) | (0xffffffff - timer(4));
    if (now < before) now += std::uint64_t{1} << 32;
    before = now;
    return now * nanoseconds_a_tick;
}
void show(const std::uint8_t*, int) {}

}  // namespace umbra78::exact::port

extern "C" {

void umbra78_reset() {
    umbra78::exact::bare::start_memory();
    timer(8) = 0xffffffff;  // reload
    timer(4) = 0xffffffff;
    timer(0) = 1;
    const int status = umbra78_exact(UMBRA78_EXACT_FILLER, UMBRA78_EXACT_ONLY);
    umbra78::exact::bare::print_stack();
    leave(status);
}
void umbra78_fault() { leave(3); }
void umbra78_trapped(const char*) { leave(4); }

using Handler = void (*)();
extern const Handler umbra78_vectors[16];
[[gnu::section(".vectors"), gnu::used]] const Handler umbra78_vectors[16] = {
    reinterpret_cast<Handler>(&umbra78_stack_end), umbra78_reset, umbra78_fault, umbra78_fault,
    umbra78_fault, umbra78_fault, umbra78_fault};
}
