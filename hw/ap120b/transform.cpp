#include "hw/ap120b/transform.hpp"

#include "fixed/trap.hpp"

#include <algorithm>

namespace umbra78::hw::ap120b {
namespace {

constexpr std::int8_t in_register = 0, out_register = 1, count_register = 2;

// Pad X holds the matrix, column after column; pad Y the four partial sums and two results.
constexpr std::int8_t first_held = 4, second_held = 5;

using enum From;

// --- pieces of an instruction, each one of the machine's parallel operations --------------------

// FMUL DPX(k), MD
constexpr Instruction multiply(Instruction i, int k) {
    i.multiply = Pipe::start;
    i.m1 = pad_x;
    i.m2 = md;
    i.x.read = static_cast<std::int8_t>(k);
    return i;
}
constexpr Instruction push_multiplier(Instruction i) {
    i.multiply = Pipe::push;
    return i;
}
// FADD FM, DPY(row)
constexpr Instruction add(Instruction i, int row) {
    i.add = Pipe::start;
    i.a1 = fm;
    i.a2 = pad_y;
    i.y.read = static_cast<std::int8_t>(row);
    return i;
}
constexpr Instruction push_adder(Instruction i) {
    i.add = Pipe::push;
    return i;
}
// DPY(word) < FM or FA
constexpr Instruction keep(Instruction i, From from, int word) {
    i.y.source = from;
    i.y.write = static_cast<std::int8_t>(word);
    return i;
}
constexpr Instruction read(Instruction i) {
    i.access = Access::read;
    i.index = in_register;
    i.step = 1;
    return i;
}
constexpr Instruction write(Instruction i, From from, int held = -1) {
    i.access = Access::write;
    i.store = from;
    i.index = out_register;
    i.step = 1;
    if (held >= 0) i.y.read = static_cast<std::int8_t>(held);
    return i;
}
constexpr Instruction count_down(Instruction i) {
    i.index = count_register;
    i.step = -1;
    i.count = true;
    return i;
}
constexpr Instruction back(Instruction i, int length) {
    i.branch = static_cast<std::int8_t>(1 - length);
    return i;
}

// --- the loop -----------------------------------------------------------------------------------

constexpr int loop_length = 19;
constexpr Instruction no{};

// MD holds x in instructions 0..3, y in 4..7, z in 8..11, w in 12..15. Rows 0..3 in this order,
// always. Instructions 0, 2 and 3 write the last three results of the vector before.
constexpr std::array<Instruction, loop_length> loop{
    /*  0 */ keep(write(push_adder(multiply(no, 0)), pad_y, first_held), fa, second_held),
    /*  1 */ read(multiply(no, 1)),
    /*  2 */ write(multiply(no, 2), pad_y, second_held),
    /*  3 */ write(keep(multiply(no, 3), fm, 0), fa),
    /*  4 */ keep(multiply(no, 4), fm, 1),
    /*  5 */ read(keep(multiply(no, 5), fm, 2)),
    /*  6 */ keep(multiply(no, 6), fm, 3),
    /*  7 */ add(multiply(no, 7), 0),
    /*  8 */ add(multiply(no, 8), 1),
    /*  9 */ read(keep(add(multiply(no, 9), 2), fa, 0)),
    /* 10 */ keep(add(multiply(no, 10), 3), fa, 1),
    /* 11 */ keep(add(multiply(no, 11), 0), fa, 2),
    /* 12 */ keep(add(multiply(no, 12), 1), fa, 3),
    /* 13 */ read(keep(add(multiply(no, 13), 2), fa, 0)),
    /* 14 */ keep(add(multiply(no, 14), 3), fa, 1),
    /* 15 */ keep(add(multiply(no, 15), 0), fa, 2),
    /* 16 */ count_down(keep(add(push_multiplier(no), 1), fa, 3)),
    /* 17 */ write(add(push_multiplier(no), 2), fa),
    /* 18 */ back(keep(add(no, 3), fa, first_held), loop_length),
};

// The head reads x of the first vector, waits two instructions for it, and runs the loop once
// without the writes of a vector before and without its branch. The tail is the loop's first four
// instructions, of which only the writes of the last vector's results are left.
constexpr std::size_t prologue_length = 3, tail_length = 4;

constexpr Instruction without_index(Instruction i) {
    i.access = Access::none;
    i.store = none;
    i.index = -1;
    i.count = false;
    i.branch = 0;
    return i;
}

constexpr auto build_head() {
    std::array<Instruction, prologue_length + loop_length> p{};
    p[0] = read(no);
    for (std::size_t k = 0; k < loop_length; ++k) {
        const bool before = k < tail_length && loop[k].access == Access::write;
        const bool counts = loop[k].count || loop[k].branch != 0;
        p[prologue_length + k] = before || counts ? without_index(loop[k]) : loop[k];
    }
    return p;
}
constexpr auto build_tail() {
    std::array<Instruction, tail_length> p{};
    for (std::size_t k = 0; k < tail_length; ++k) {
        p[k] = loop[k].access == Access::read ? without_index(loop[k]) : loop[k];
        p[k].multiply = Pipe::hold;
        p[k].m1 = p[k].m2 = none;
    }
    return p;
}
constexpr auto head = build_head();
constexpr auto tail = build_tail();

static_assert(std::all_of(head.begin(), head.end(), legal) &&
                  std::all_of(loop.begin(), loop.end(), legal) &&
                  std::all_of(tail.begin(), tail.end(), legal),
              "every instruction has its paths in the machine");

}  // namespace

TransformProgram transform_program() { return {head, loop, tail}; }

std::uint64_t run_transform(Processor& processor, const Matrix& matrix, std::uint16_t in,
                            std::uint16_t out, std::uint16_t count) {
    fixed::require(count >= 1 && in % 2 == 0 && out % 2 == 0, "AP-120B: vectors at even words");
    for (std::size_t k = 0; k < 16; ++k) processor.pad_x[k] = matrix[k % 4][k / 4];
    processor.index[in_register] = static_cast<std::uint16_t>(in - 1);
    processor.index[out_register] = static_cast<std::uint16_t>(out - 1);
    processor.index[count_register] = static_cast<std::uint16_t>(count - 1);
    std::uint64_t cycles = processor.run(head);
    if (count > 1) cycles += processor.run(loop);
    return cycles + processor.run(tail);
}

std::uint64_t transform_cycles_a_vector(MemorySpeed speed) {
    Banks banks(speed);
    std::array<std::uint16_t, index_registers> index{};
    index[in_register] = 0;   // x of this vector is read
    index[out_register] = 0;  // and the first result of the one before written
    std::uint64_t cycle = 0, last = 0;
    constexpr int settled = 3;  // the first pass has no access before it
    for (int pass = 0; pass <= settled; ++pass) {
        last = cycle;
        for (const Instruction& i : loop) {
            if (i.access != Access::none) {
                auto& at = index[static_cast<std::size_t>(i.index)];
                at = static_cast<std::uint16_t>(at + i.step);
                cycle = banks.access(cycle, at);
            }
            ++cycle;
        }
    }
    return cycle - last;
}

}  // namespace umbra78::hw::ap120b
