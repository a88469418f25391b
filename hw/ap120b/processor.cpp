#include "hw/ap120b/processor.hpp"

#include "fixed/trap.hpp"

namespace umbra78::hw::ap120b {

std::uint64_t Processor::run(std::span<const Instruction> program) {
    const std::uint64_t start = cycle_;
    for (std::size_t at = 0; at < program.size();) {
        const Instruction& i = program[at];
        step(i);
        const bool taken = i.branch != 0 && counted_ != 0;
        at = static_cast<std::size_t>(static_cast<int>(at) + (taken ? i.branch : 1));
    }
    return cycle_ - start;
}

// All units read the registers as they are at the start of the instruction; pads are written at
// its end.
void Processor::step(const Instruction& i) {
    fixed::require(legal(i), "AP-120B: an instruction the machine has no path for");
    if (reading_[2].there) md_ = reading_[2].word;
    reading_ = {Read{}, reading_[0], reading_[1]};
    const Float38 to_x = word(i, i.x.source), to_y = word(i, i.y.source);
    access(i);
    advance_pipes(i);
    if (i.x.write >= 0) pad_x[static_cast<std::size_t>(i.x.write)] = to_x;
    if (i.y.write >= 0) pad_y[static_cast<std::size_t>(i.y.write)] = to_y;
    ++cycle_;
}

void Processor::advance_pipes(const Instruction& i) {
    const Float38 m1 = word(i, i.m1), m2 = word(i, i.m2), a1 = word(i, i.a1), a2 = word(i, i.a2);
    if (i.multiply != Pipe::hold) {
        fm_ = multiplying_[1];
        multiplying_ = {i.multiply == Pipe::start ? m1 * m2 : Float38(), multiplying_[0]};
    }
    if (i.add != Pipe::hold) {
        fa_ = adding_;
        adding_ = i.add == Pipe::start ? a1 + a2 : Float38();
    }
}

// The index operation, and the access at its result when its bank is free. Until then the clock
// runs and nothing else moves.
void Processor::access(const Instruction& i) {
    if (i.index < 0) return;
    std::uint16_t& at = index[static_cast<std::size_t>(i.index)];
    at = static_cast<std::uint16_t>(at + i.step);
    if (i.count) counted_ = at;
    if (i.access == Access::none) return;
    cycle_ = banks_.access(cycle_, at);
    if (i.access == Access::read) {
        reading_[0] = {memory_[at], true};
    } else {
        memory_[at] = word(i, i.store);
    }
}

Float38 Processor::word(const Instruction& i, From from) const {
    switch (from) {
        case From::none:
        case From::zero: return {};
        case From::pad_x: return pad_x[static_cast<std::size_t>(i.x.read)];
        case From::pad_y: return pad_y[static_cast<std::size_t>(i.y.read)];
        case From::fa: return fa_;
        case From::fm: return fm_;
        case From::md: return md_;
    }
    fixed::trap("AP-120B: unknown operand");
}

}  // namespace umbra78::hw::ap120b
