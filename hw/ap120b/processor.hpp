// The FPS AP-120B, an array processor of 1976, run instruction by instruction.
//
//            +-> multiplier: 3 stages --+        one instruction, one clock of 167 ns, starts
//   pads X, Y, MD, FM, FA               +-> FM     one multiplication, one addition,
//            +-> adder: 2 stages -------+-> FA     one 16-bit index operation,
//   main memory, 64K words: MD three instructions    one memory operation, and a read and a
//            after a read                             write of each pad of 32 words
//
// A result started in instruction t can be used in t + 2 (sum), t + 3 (product) and t + 3 (read).
// Both pipes move only in instructions that start or push them. Main memory has an even and an odd
// bank: an access is a clock (fast memory) or two (standard) later than the one before it, and one
// more if both have the same parity; until then the whole machine waits.
// An instruction that the machine has no path for is a broken precondition of run().
// Sources: Floating Point Systems, AP Math Library Manual 860-7288-004, 1979; R. W. Hockney and
// C. R. Jesshope, Parallel Computers 2, 1988, 2.5. Ours, from memory: which register each operand
// of the units can take (below). Not emulated: pads addressed relative to a register (here by
// word), table memory, the 64-bit encoding, host interface, interrupts.
#pragma once

#include "fixed/float38.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace umbra78::hw::ap120b {

using fixed::Float38;

inline constexpr int clock_ns = 167;
inline constexpr std::size_t memory_words = 65536;
inline constexpr std::size_t pad_words = 32;
inline constexpr std::size_t index_registers = 16;

enum class MemorySpeed : std::uint8_t { standard, fast };

// Where a unit or a write takes its word from. FA and FM are the pipes' outputs, MD the memory's.
enum class From : std::uint8_t { none, zero, pad_x, pad_y, fa, fm, md };
enum class Pipe : std::uint8_t { hold, push, start };
enum class Access : std::uint8_t { none, read, write };

struct PadPort {
    std::int8_t read = -1;  // the word that From::pad_x or pad_y means in this instruction
    From source = From::none;
    std::int8_t write = -1;
};

struct Instruction {
    Pipe multiply = Pipe::hold;
    From m1 = From::none, m2 = From::none;  // m1: FM, pads; m2: FA, pads, MD
    Pipe add = Pipe::hold;
    From a1 = From::none, a2 = From::none;  // a1: FM, pads, zero; a2: FA, pads, MD, zero
    PadPort x, y;
    Access access = Access::none;
    From store = From::none;                // what is written: FA, FM, pads
    std::int8_t index = -1;                 // this register is stepped; an access is at its result
    std::int8_t step = 0;
    std::int8_t branch = 0;                 // how far to go if the last `count` was not 0
    bool count = false;                     // the index operation's result is what branches test
};

// Whether the machine has a path for everything that the instruction asks for.
constexpr bool legal(const Instruction& i) {
    const auto pad = [&](From f) {
        return (f == From::pad_x && i.x.read >= 0) || (f == From::pad_y && i.y.read >= 0);
    };
    const auto m1 = i.m1 == From::fm || pad(i.m1);
    const auto m2 = i.m2 == From::fa || i.m2 == From::md || pad(i.m2);
    const auto a1 = i.a1 == From::fm || i.a1 == From::zero || pad(i.a1);
    const auto a2 = i.a2 == From::fa || i.a2 == From::md || i.a2 == From::zero || pad(i.a2);
    const auto stored = i.store == From::fa || i.store == From::fm || pad(i.store);
    const auto in_range = [](const PadPort& p) {
        constexpr int words = pad_words;
        return p.read < words && p.write < words;
    };
    const auto written = [](const PadPort& p) {
        return (p.source == From::none) == (p.write < 0) &&
               (p.source == From::none || p.source == From::fa || p.source == From::fm ||
                p.source == From::md);
    };
    return (i.multiply != Pipe::start || (m1 && m2)) && (i.add != Pipe::start || (a1 && a2)) &&
           (i.access != Access::write || stored) && (i.access == Access::none || i.index >= 0) &&
           (!i.count || i.index >= 0) && i.index < static_cast<int>(index_registers) &&
           in_range(i.x) && in_range(i.y) && written(i.x) && written(i.y);
}

// When the even and the odd bank can be accessed: how long an access has to wait.
class Banks {
public:
    explicit Banks(MemorySpeed speed) : cycle_(speed == MemorySpeed::fast ? 1 : 2) {}

    // The cycle in which the access starts, `cycle` or later.
    std::uint64_t access(std::uint64_t cycle, std::uint16_t address) {
        const bool odd = (address & 1) != 0;
        const std::uint64_t earliest = last_ + cycle_ + (odd == odd_ ? 1 : 0);
        last_ = used_ && earliest > cycle ? earliest : cycle;
        odd_ = odd;
        used_ = true;
        return last_;
    }

private:
    std::uint64_t cycle_;
    std::uint64_t last_ = 0;
    bool odd_ = false, used_ = false;
};

// The processor: pads, pipes, index registers, and its main memory, which the caller hands in.
class Processor {
public:
    Processor(std::span<Float38, memory_words> memory, MemorySpeed speed)
        : memory_(memory), banks_(speed) {}

    std::array<Float38, pad_words> pad_x{}, pad_y{};
    std::array<std::uint16_t, index_registers> index{};

    // Runs a program from its first instruction until it leaves it after its last; returns the
    // cycles it took.
    std::uint64_t run(std::span<const Instruction> program);

private:
    void step(const Instruction& i);
    void advance_pipes(const Instruction& i);
    void access(const Instruction& i);
    Float38 word(const Instruction& i, From from) const;

    std::span<Float38, memory_words> memory_;
    Banks banks_;
    std::uint64_t cycle_ = 0;
    std::uint16_t counted_ = 0;  // the last counting index operation's result
    std::array<Float38, 2> multiplying_{};  // after stages 1 and 2; FM is after stage 3
    Float38 adding_{};                      // after stage 1; FA is after stage 2
    Float38 fm_{}, fa_{}, md_{};
    struct Read {
        Float38 word;
        bool there = false;
    };
    std::array<Read, 3> reading_{};
};

}  // namespace umbra78::hw::ap120b
