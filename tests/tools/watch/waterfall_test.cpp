// The waterfall: every character is where the rules of valid and ready put the point.
#include "tools/watch/waterfall.hpp"

#include "tests/support/effort.hpp"
#include "tests/tools/watch/traced.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace umbra78::tools {
namespace {

using test::Random;

// A picture without breaks, as rows in order; the reader's first.
struct Rows {
    std::vector<std::string> names, cells;
    std::string rest;
};

Rows rows_of(const std::string& text) {
    Rows rows;
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line.substr(0, 5), "cycle");
    std::getline(in, line);
    while (std::getline(in, line) && !line.empty()) {
        rows.names.push_back(line.substr(0, line.find(' ')));
        rows.cells.push_back(line.substr(13));
    }
    while (std::getline(in, line)) rows.rest += line + "\n";
    return rows;
}

WaterfallOptions whole(int points) {
    WaterfallOptions o;
    o.points = points;
    o.from = 0;
    o.max_cycles = o.wide = 1 << 20;
    return o;
}

// Without holds a point is in stage k from when it left the reader, and for the stage's stay.
TEST(Waterfall, WithoutHoldsEveryPointKeepsStep) {
    Random random;
    int points = 0;
    for (int round = 0; round < umbra78::test::effort(100); ++round) {
        const shadow::Settings s = test::random_machine(random);
        const auto frame = test::random_frame(random, s);
        const auto machine = frame->machine();
        const Rows rows = rows_of(waterfall(*machine, whole(61)));
        ASSERT_EQ(rows.names.size(), std::size_t(machine->chain().stages()) + 1);
        for (const char letter : std::string("123456789abcdefghijklmnopqrstuvwxyz")) {
            std::size_t at = rows.cells[0].rfind(letter);  // leaves the reader in this cycle
            if (at == std::string::npos) break;
            ++points;
            for (std::size_t k = 1; k < rows.cells.size(); ++k) {
                const auto stay = std::size_t(machine->chain().stay(static_cast<int>(k) - 1));
                const std::string& cells = rows.cells[k];
                EXPECT_EQ(rows.names[k], machine->chain().name(static_cast<int>(k) - 1));
                EXPECT_EQ(cells.substr(at + 1, stay), std::string(stay, letter)) << k;
                EXPECT_EQ(std::size_t(std::count(cells.begin(), cells.end(), letter)), stay);
                at += stay;
            }
        }
        for (std::size_t k = 1; k < rows.cells.size(); ++k)
            EXPECT_EQ(rows.cells[k].find_first_of("=#<"), std::string::npos);
        if (HasFailure()) return;
    }
    EXPECT_GT(points, umbra78::test::effort(100) * 10);
}

// Under holds the rows are the machine's own account of its cycles.
TEST(Waterfall, UnderHoldsRowsAreTheStagesAccounts) {
    Random random;
    std::size_t blocked = 0, held = 0;
    for (int round = 0; round < umbra78::test::effort(60); ++round) {
        const shadow::Settings s = test::random_machine(random);
        const auto frame = test::random_frame(random, s);
        const auto machine = frame->machine();
        const auto holds =
            shadow::test::random_holds(random, machine->chain().stages(), 2000, 20);
        WaterfallOptions options = whole(61);
        options.holds = [&](std::uint64_t t) { return t < holds.size() ? holds[t] : 0; };
        options.points = 1 << 20;  // to the frame's end
        const Rows rows = rows_of(waterfall(*machine, options));
        ASSERT_TRUE(machine->done());
        for (std::size_t k = 1; k < rows.cells.size(); ++k) {
            const std::string& cells = rows.cells[k];
            const hw::StageTime& time = machine->chain().time(static_cast<int>(k) - 1);
            const auto count = [&](char c) {
                return std::size_t(std::count(cells.begin(), cells.end(), c));
            };
            EXPECT_EQ(cells.size(), machine->cycles());
            EXPECT_EQ(count('='), time.blocked);
            EXPECT_EQ(count('#'), time.held);
            EXPECT_EQ(cells.size() - count('.') - count('=') - count('#'), time.work);
            blocked += count('=');
            held += count('#');
        }
        const std::string& reader = rows.cells[0];
        const auto r = machine->reader();
        EXPECT_EQ(std::size_t(std::count(reader.begin(), reader.end(), '=')), r.blocked);
        EXPECT_EQ(std::size_t(std::count(reader.begin(), reader.end(), '#')), r.held);
        if (HasFailure()) return;
    }
    EXPECT_GT(blocked, 1000u);
    EXPECT_GT(held, 1000u);
}

// The picture a reader sees, to the letter: four multipliers, nearest lookup, a gap of background,
// and the fetch stage's clock held for three cycles.
TEST(Waterfall, APictureToTheLetter) {
    shadow::Settings s;
    s.machine.xy_bits = 4;
    std::vector<hw::Depth32> observer(256, s.machine.background()), light = observer;
    for (const std::size_t visible : {3u, 4u, 5u, 11u}) observer[visible] = 1000;
    hw::MatrixWords matrix;
    for (std::size_t r = 0; r < 3; ++r) matrix.word[r][r] = 16384;
    WatchedFrame frame(s, matrix, observer, light);
    const auto machine = frame.machine();
    WaterfallOptions options;
    options.points = 3;
    options.holds = [](std::uint64_t t) { return t >= 11 && t < 14 ? hw::StageMask{1} << 5 : 0; };
    EXPECT_EQ(waterfall(*machine, options),
              R"(cycle               10
                    |
reader       12~23~3.....>....
multiply     .111222333...>>>.
sum          ....1..2..3.....>
accumulate   .....1..2..3.....
round        ......1..2..3....
place        .......1..2=.3...
fetch        ........###12.3..
compare      ............12.3.
write        .............12.3

1  pixel (3, 0): leaves the reader in cycle 3, is written in 16: 13 cycles, 3 of them waiting
2  pixel (4, 0): leaves the reader in cycle 6, is written in 17: 11 cycles, 1 of them waiting
3  pixel (5, 0): leaves the reader in cycle 9, is written in 19: 10 cycles, 0 of them waiting
closed form: points are S = 3 cycles apart or more, L = 10 cycles on their way; 1 to read a pixel
)");
}

TEST(Waterfall, LongOnesAreBrokenAndCut) {
    shadow::Settings s;
    s.machine.xy_bits = 4;
    s.machine.multipliers = 1;
    std::vector<hw::Depth32> observer(256, 1000), light = observer;
    hw::MatrixWords matrix;
    for (std::size_t r = 0; r < 3; ++r) matrix.word[r][r] = 16384;
    WatchedFrame frame(s, matrix, observer, light);
    WaterfallOptions options;
    options.wide = 20;
    options.max_cycles = 50;
    const std::string text = waterfall(*frame.machine(), options);
    std::size_t pieces = 0;
    for (std::size_t at = 0; (at = text.find("reader  ", at)) != std::string::npos; ++at) ++pieces;
    EXPECT_EQ(pieces, 3u);
    EXPECT_NE(text.find("; later cycles are not shown\n"), std::string::npos) << text;
    EXPECT_NE(text.find("points are S = 9 cycles apart or more"), std::string::npos) << text;

    std::fill(observer.begin(), observer.end(), s.machine.background());
    WatchedFrame empty(s, matrix, observer, light);
    EXPECT_EQ(waterfall(*empty.machine()).substr(0, 15), "no point enters");
}

}  // namespace
}  // namespace umbra78::tools
