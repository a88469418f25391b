// A 32-bit RISC-V, as QEMU's board `virt` has it: no operating system, and no multiplier if it is
// compiled for none. Text goes out by the serial port; instructions are the processor's own count.
#include "tests/exact/bare.hpp"
#include "tests/exact/port.hpp"

namespace {

volatile std::uint8_t& serial = *reinterpret_cast<volatile std::uint8_t*>(0x10000000);
volatile std::uint32_t& finisher = *reinterpret_cast<volatile std::uint32_t*>(0x100000);

[[noreturn]] void leave(int status) {
    finisher = status == 0 ? 0x5555u : static_cast<std::uint32_t>(status) << 16 | 0x3333u;
    for (;;) {}
}

}  // namespace

namespace umbra78::exact::port {

void write(const char* text, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) serial = static_cast<std::uint8_t>(text[k]);
}
std::uint64_t instructions() {
    std::uint32_t high, low, again;
    do {
        asm volatile("csrr %0, minstreth\n csrr %1, minstret\n csrr %2, minstreth"
                     : "=r"(high), "=r"(low), "=r"(again));
    } while (high != again);
    return std::uint64_t{high} << 32 | low;
}
void show(const std::uint8_t*, int) {}

}  // namespace umbra78::exact::port

extern "C" {

[[gnu::aligned(4)]] void umbra78_fault() { leave(3); }
void umbra78_trapped(const char*) { leave(4); }

void umbra78_reset() {
    umbra78::exact::bare::start_memory();
    const int status = umbra78_exact(UMBRA78_EXACT_FILLER, UMBRA78_EXACT_ONLY);
    umbra78::exact::bare::print_stack();
    leave(status);
}

[[gnu::naked, gnu::section(".vectors"), gnu::used]] void umbra78_start() {
    asm volatile("la sp, umbra78_stack_end\n la t0, umbra78_fault\n csrw mtvec, t0\n"
                 "j umbra78_reset");
}
}
