// The AP-120B's pipes, banks and matrix loop: the program's bits are the straight loop's, and its
// cycles those that were published.
#include "hw/ap120b/transform.hpp"

#include "tests/fixed/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace umbra78::hw::ap120b {
namespace {

using fixed::test::Random;
using enum From;

struct Machine {
    explicit Machine(MemorySpeed speed) : words(memory_words), processor(span(), speed) {}
    std::span<Float38, memory_words> span() {
        return std::span<Float38, memory_words>(words.data(), memory_words);
    }
    std::vector<Float38> words;
    Processor processor;
};

Float38 whole(std::int64_t v) { return Float38::from_scaled(v, 0); }

Float38 any(Random& random) {
    return Float38::from_scaled(random.between(-(1 << 27), 1 << 27),
                                static_cast<int>(random.between(-40, 10)));
}

// A sum issued in instruction t is FA in t + 2 if the adder is pushed in t + 1, and stays there.
TEST(Ap120b, AdderHasTwoStagesThatMoveOnlyWhenPushed) {
    Machine m(MemorySpeed::fast);
    m.processor.pad_x[0] = whole(3);
    Instruction start, push, keep;
    start.add = Pipe::start;
    start.a1 = start.a2 = pad_x;
    start.x.read = 0;
    push.add = Pipe::push;
    keep.y.source = fa;
    const auto fa_after = [&](std::vector<Instruction> program) {
        keep.y.write = 7;
        program.push_back(keep);
        m.processor.run(program);
        return m.processor.pad_y[7];
    };
    EXPECT_EQ(fa_after({start}), Float38()) << "t + 1: still in stage 2";
    EXPECT_EQ(fa_after({start, {}, {}}), whole(6)) << "pushed out by the start after it";
    EXPECT_EQ(fa_after({push, push, push}), Float38());
    EXPECT_EQ(fa_after({start, {}, {}, {}}), Float38()) << "nothing pushes";
    EXPECT_EQ(fa_after({push}), whole(6)) << "t + 2";
    EXPECT_EQ(fa_after({{}, {}}), whole(6)) << "and there it stays";
}

TEST(Ap120b, MultiplierHasThreeStagesThatMoveOnlyWhenPushed) {
    Machine m(MemorySpeed::fast);
    m.processor.pad_x[0] = whole(3);
    m.processor.pad_y[0] = whole(5);
    Instruction start, push, keep;
    start.multiply = Pipe::start;
    start.m1 = pad_x;
    start.m2 = pad_y;
    start.x.read = start.y.read = 0;
    push.multiply = Pipe::push;
    keep.x.source = fm;
    keep.x.write = 1;
    const auto fm_after = [&](std::vector<Instruction> program) {
        program.push_back(keep);
        m.processor.run(program);
        return m.processor.pad_x[1];
    };
    EXPECT_EQ(fm_after({start, push}), Float38());
    EXPECT_EQ(fm_after({push}), whole(15)) << "t + 3";
    EXPECT_EQ(fm_after({start, push, {}, {}, {}}), Float38()) << "nothing pushes";
    EXPECT_EQ(fm_after({start}), whole(15)) << "pushed out by the start after it";
}

TEST(Ap120b, AReadIsThereThreeInstructionsLater) {
    for (const MemorySpeed speed : {MemorySpeed::fast, MemorySpeed::standard}) {
        Machine m(speed);
        m.words[11] = whole(77);
        m.processor.index[4] = 10;
        Instruction read, keep;
        read.access = Access::read;
        read.index = 4;
        read.step = 1;
        std::vector<Instruction> program{read};
        for (int t = 1; t <= 4; ++t) {
            keep.x.source = md;
            keep.x.write = static_cast<std::int8_t>(t);
            program.push_back(keep);
        }
        EXPECT_EQ(m.processor.run(program), 5u);
        EXPECT_EQ(m.processor.pad_x[2], Float38());
        EXPECT_EQ(m.processor.pad_x[3], whole(77));
        EXPECT_EQ(m.processor.pad_x[4], whole(77));
    }
}

// Successive accesses of these parities, each in the instruction after: cycles they start in.
TEST(Ap120b, BanksWaitForTheirParity) {
    const auto starts = [](MemorySpeed speed, std::vector<int> parities) {
        Banks banks(speed);
        std::vector<std::uint64_t> at;
        std::uint64_t cycle = 10;
        for (const int p : parities) {
            at.push_back(banks.access(cycle, static_cast<std::uint16_t>(100 + p)) - 10);
            cycle = at.back() + 10 + 1;
        }
        return at;
    };
    using Cycles = std::vector<std::uint64_t>;
    EXPECT_EQ(starts(MemorySpeed::fast, {0, 1, 0, 1}), (Cycles{0, 1, 2, 3}));
    EXPECT_EQ(starts(MemorySpeed::fast, {0, 0, 1, 1}), (Cycles{0, 2, 3, 5}));
    EXPECT_EQ(starts(MemorySpeed::standard, {0, 1, 0, 1}), (Cycles{0, 2, 4, 6}));
    EXPECT_EQ(starts(MemorySpeed::standard, {0, 0, 1, 1}), (Cycles{0, 3, 5, 8}));
}

TEST(Ap120b, IllegalInstructionsAreRefused) {
    Instruction both;
    both.multiply = Pipe::start;
    both.m1 = md;  // the multiplier's first input has no path from memory
    both.m2 = md;
    EXPECT_FALSE(legal(both));
    Instruction unread;
    unread.add = Pipe::start;
    unread.a1 = pad_x;
    unread.a2 = zero;
    EXPECT_FALSE(legal(unread)) << "no word of the pad is named";
    Instruction nowhere;
    nowhere.access = Access::read;
    EXPECT_FALSE(legal(nowhere));
    EXPECT_TRUE(legal({}));
}

// Every source at every input, against the list of the machine's paths.
TEST(Ap120b, OnlyTheListedPathsAreLegal) {
    using Sources = std::vector<From>;
    const Sources all{none, zero, pad_x, pad_y, fa, fm, md};
    struct Input {
        const char* name;
        Sources paths;
        void (*use)(Instruction&, From);
    };
    // A unit's other input takes what it always may.
    const std::vector<Input> inputs{
        {"m1", {fm, pad_x, pad_y}, [](Instruction& i, From f) {
             i.multiply = Pipe::start, i.m1 = f, i.m2 = fa;
         }},
        {"m2", {fa, md, pad_x, pad_y}, [](Instruction& i, From f) {
             i.multiply = Pipe::start, i.m1 = fm, i.m2 = f;
         }},
        {"a1", {fm, zero, pad_x, pad_y}, [](Instruction& i, From f) {
             i.add = Pipe::start, i.a1 = f, i.a2 = fa;
         }},
        {"a2", {fa, md, zero, pad_x, pad_y}, [](Instruction& i, From f) {
             i.add = Pipe::start, i.a1 = fm, i.a2 = f;
         }},
        {"store", {fa, fm, pad_x, pad_y}, [](Instruction& i, From f) {
             i.access = Access::write, i.index = 0, i.store = f;
         }},
        {"to pad x", {fa, fm, md}, [](Instruction& i, From f) {
             i.x.write = 0, i.x.source = f;
         }},
        {"to pad y", {fa, fm, md}, [](Instruction& i, From f) {
             i.y.write = 0, i.y.source = f;
         }},
    };
    for (const Input& input : inputs) {
        for (const From from : all) {
            const bool path =
                std::find(input.paths.begin(), input.paths.end(), from) != input.paths.end();
            // Which words of the pads the instruction names: none, X's, Y's, both.
            for (int named = 0; named < 4; ++named) {
                Instruction i;
                if ((named & 1) != 0) i.x.read = 3;
                if ((named & 2) != 0) i.y.read = 31;
                input.use(i, from);
                const bool word = (from != pad_x || (named & 1) != 0) &&
                                  (from != pad_y || (named & 2) != 0);
                EXPECT_EQ(legal(i), path && word)
                    << input.name << " from " << int(from) << ", pads named " << named;
            }
        }
    }
}

// What an instruction only holds or pushes needs no inputs; indices and pad words are in range.
TEST(Ap120b, RangesOfAnInstruction) {
    for (const Pipe pipe : {Pipe::hold, Pipe::push}) {
        Instruction i;
        i.multiply = i.add = pipe;
        EXPECT_TRUE(legal(i));
    }
    const auto with = [](auto change) {
        Instruction i;
        change(i);
        return legal(i);
    };
    EXPECT_TRUE(with([](auto& i) { i.access = Access::read, i.index = 15; }));
    EXPECT_FALSE(with([](auto& i) { i.access = Access::read, i.index = 16; }));
    EXPECT_FALSE(with([](auto& i) { i.access = Access::read; })) << "no index register";
    EXPECT_FALSE(with([](auto& i) { i.access = Access::write, i.store = fa; }));
    EXPECT_TRUE(with([](auto& i) { i.count = true, i.index = 0; }));
    EXPECT_FALSE(with([](auto& i) { i.count = true; })) << "nothing to count";
    for (PadPort Instruction::*pad : {&Instruction::x, &Instruction::y}) {
        const auto port = [&](int read, From source, int write) {
            Instruction i;
            i.*pad = {static_cast<std::int8_t>(read), source, static_cast<std::int8_t>(write)};
            return legal(i);
        };
        EXPECT_TRUE(port(31, fa, 31));
        EXPECT_FALSE(port(32, fa, 31)) << "a pad has 32 words";
        EXPECT_FALSE(port(31, fa, 32));
        EXPECT_FALSE(port(-1, fa, -1)) << "a source, and nowhere to write it";
        EXPECT_FALSE(port(-1, none, 0)) << "a word to write, and no source";
    }
    Machine m(MemorySpeed::fast);
    Instruction nowhere;
    nowhere.access = Access::read;
    EXPECT_DEATH(m.processor.run({&nowhere, 1}), "no path for");
}

TEST(Ap120bTransform, LoopIsThePublishedCounts) {
    const auto loop = transform_program().loop;
    const auto counted = [&](auto what) { return std::count_if(loop.begin(), loop.end(), what); };
    EXPECT_EQ(loop.size(), 19u);
    EXPECT_EQ(counted([](auto& i) { return i.multiply == Pipe::start; }), 16);
    EXPECT_EQ(counted([](auto& i) { return i.add == Pipe::start; }), 12);
    EXPECT_EQ(counted([](auto& i) { return i.access == Access::read; }), 4);
    EXPECT_EQ(counted([](auto& i) { return i.access == Access::write; }), 4);
}

TEST(Ap120bTransform, TakesThePublishedTimes) {
    EXPECT_EQ(transform_cycles_a_vector(MemorySpeed::fast), 20u);      // 3.34 us; published 3.3
    EXPECT_EQ(transform_cycles_a_vector(MemorySpeed::standard), 23u);  // 3.84 us; published 3.8
    for (const MemorySpeed speed : {MemorySpeed::fast, MemorySpeed::standard}) {
        std::uint64_t before = 0;
        for (std::uint16_t n = 1; n <= 20; ++n) {
            Machine m(speed);
            const std::uint64_t cycles = run_transform(m.processor, {}, 100, 1000, n);
            if (n > 2) {
                EXPECT_EQ(cycles - before, transform_cycles_a_vector(speed)) << n;
            }
            before = cycles;
        }
    }
}

TEST(Ap120bTransform, ProgramsBitsAreTheStraightLoops) {
    Random random;
    for (int round = 0; round < 300; ++round) {
        Machine m(round % 2 == 0 ? MemorySpeed::fast : MemorySpeed::standard);
        Matrix matrix{};
        for (Vector& row : matrix)
            for (Float38& c : row) c = any(random);
        const auto n = static_cast<std::uint16_t>(random.between(1, 40));
        const auto in = static_cast<std::uint16_t>(2 * random.between(0, 1000));
        const bool in_place = random.bits() % 4 == 0;
        const auto out =
            static_cast<std::uint16_t>(in_place ? in : in + 4 * n + 2 + 2 * (round % 2));
        for (Float38& w : m.words) w = round % 3 == 0 ? any(random) : whole(random.between(-9, 9));
        std::vector<Float38> expected = m.words;
        for (std::size_t v = 0; v < n; ++v) {
            const Float38* at = m.words.data() + in + 4 * v;
            const Vector result = times(matrix, {at[0], at[1], at[2], at[3]});
            std::copy(result.begin(), result.end(),
                      expected.begin() + static_cast<std::ptrdiff_t>(out + 4 * v));
        }
        run_transform(m.processor, matrix, in, out, n);
        for (std::size_t k = 0; k < memory_words; ++k)
            ASSERT_EQ(m.words[k].bits(), expected[k].bits())
                << "word " << k << ", " << n << " vectors from " << in << " to " << out;
    }
}

}  // namespace
}  // namespace umbra78::hw::ap120b
