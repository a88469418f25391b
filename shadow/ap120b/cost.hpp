// What a frame's post-process takes on the AP-120B: a ledger of its vector routines.
//
// The transform's cycles come from the replay of its loop; every other routine's from the time a
// vector's element is published with (Floating Point Systems, Math Library Routines 7352, 1977),
// to the nearest clock of 167 ns. The host's transfers and the overhead of each library call are
// not cycles of the processor and are counted apart. hw/MACHINE.md, section 18.
#pragma once

#include "hw/ap120b/processor.hpp"
#include "shadow/post_process.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace umbra78::shadow {

// Where a step's cycles come from.
enum class ArrayCycleSource : std::uint8_t { replayed, published, assumed };

// One step of the pass: a vector routine, over all visible pixels of each scan line.
struct ArrayCostStep {
    std::string_view name;
    ArrayCycleSource source;
    int elements = 0;  // a visible pixel
    int cycles = 0;    // an element
    int calls = 0;     // of a library routine, a scan line
};

// The host's side, per frame. A call's overhead is published as 100 to 1000 us; the transfer's
// time is assumed: 2 us a 16-bit word, about what a minicomputer's bus did with direct access.
inline constexpr int array_byte_ns = 1000;
inline constexpr int array_call_min_us = 100, array_call_max_us = 1000;

struct ArrayCost {
    static constexpr std::size_t max_steps = 12;
    std::array<ArrayCostStep, max_steps> step{};
    std::size_t steps = 0;
    std::uint64_t pixels = 0, lines = 0;
    int host_bytes = 0;  // a visible pixel, both ways

    std::span<const ArrayCostStep> list() const { return std::span(step).first(steps); }
    std::uint64_t cycles(const ArrayCostStep& s) const {
        return pixels * static_cast<std::uint64_t>(s.elements * s.cycles);
    }
    const ArrayCostStep& longest() const;
    std::uint64_t cycles() const;
    std::uint64_t calls() const;
    std::uint64_t transfer_us() const {
        return pixels * static_cast<std::uint64_t>(host_bytes) * array_byte_ns / 1000;
    }
};

ArrayCost array_cost(const PostProcessCounts& counts, const ShadowTest& settings,
                     hw::ap120b::MemorySpeed speed, bool affine);

}  // namespace umbra78::shadow
