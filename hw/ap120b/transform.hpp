// Matrix times vectors on the AP-120B: 4 x 4 times n vectors of four words, as the library's MVML4.
//
//   r_k = ((m_k0 x + m_k1 y) + m_k2 z) + m_k3 w       each product and each sum rounded
//
// The loop has 19 instructions a vector, with 16 multiplications, 12 additions, 4 reads and 4
// writes, like the published routine. Its schedule is this project's own: column after column, the
// rows' partial sums in pad Y. Two results are kept there for a while, so that no two accesses
// collide. A vector takes the loop's 19 clocks and those that it waits for the memory's banks.
// Published: 3.3 us a vector with fast memory, 3.8 us with standard (Floating Point Systems, Math
// Library Routines 7352, 1977).
#pragma once

#include "hw/ap120b/processor.hpp"

namespace umbra78::hw::ap120b {

using Vector = std::array<Float38, 4>;
using Matrix = std::array<Vector, 4>;  // [row][column]

// The same bits as the program below, without its clock. The order of the sums is the program's.
constexpr Vector times(const Matrix& m, const Vector& v) {
    Vector out{};
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = ((m[k][0] * v[0] + m[k][1] * v[1]) + m[k][2] * v[2]) + m[k][3] * v[3];
    return out;
}

// The loop and what runs before and after it: `head` transforms the first vector, `loop` all
// others, `tail` writes the last results.
struct TransformProgram {
    std::span<const Instruction> head, loop, tail;
};
TransformProgram transform_program();

// Runs the program on `count` >= 1 vectors at the even addresses `in` and `out`; returns its
// cycles. It reads one word after the last vector. in = out is allowed.
std::uint64_t run_transform(Processor& processor, const Matrix& matrix, std::uint16_t in,
                            std::uint16_t out, std::uint16_t count);

// Cycles of one more vector in the steady state, from replaying the loop's accesses.
std::uint64_t transform_cycles_a_vector(MemorySpeed speed);

}  // namespace umbra78::hw::ap120b
