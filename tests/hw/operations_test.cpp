// What operations_counted operations cost on the machine's units and on the AP-120B's, by hand.
#include "hw/operations.hpp"

#include <gtest/gtest.h>

#include <string>

namespace umbra78::hw {
namespace {

// Adds, products, passes and so on.
constexpr Operations operations_counted{1001, 500, 1002, 3, 75, 2000};

MachineSpec with_multipliers(int n) {
    MachineSpec spec;
    spec.multipliers = n;
    return spec;
}

// As many adders as multipliers, a partly used turn counts as one; one divider, one store.
TEST(Operations, CyclesOfTheMachinesUnits) {
    struct Case {
        int multipliers;
        std::uint64_t adders, passes;
    };
    for (const Case& c : {Case{1, 1001, 1002}, Case{4, 251, 251}, Case{16, 63, 63}}) {
        const UnitCycles u = unit_cycles(operations_counted, with_multipliers(c.multipliers));
        EXPECT_EQ(u.adders, c.adders) << c.multipliers;
        EXPECT_EQ(u.multipliers, c.passes) << c.multipliers;
        EXPECT_EQ(u.divider, 75u);
        EXPECT_EQ(u.store, 2000u);
        EXPECT_EQ(u.one_after_the_other(), c.adders + c.passes + 75 + 2000);
        EXPECT_EQ(u.side_by_side(), 2000u);
    }
    const UnitCycles none = unit_cycles({}, with_multipliers(16));
    EXPECT_EQ(none.one_after_the_other(), 0u);
}

// A product is one operation whatever its passes; a quotient 23 cycles, an access 1 or 2.
TEST(Operations, CyclesOfTheArrayProcessor) {
    for (const int memory : {1, 2}) {
        const UnitCycles u = ap120b_cycles(operations_counted, memory);
        EXPECT_EQ(u.adders, 1001u);
        EXPECT_EQ(u.multipliers, 500u);
        EXPECT_EQ(u.divider, 69u);
        EXPECT_EQ(u.store, 2000u * static_cast<unsigned>(memory));
    }
}

TEST(Operations, TheBusiestUnitDecides) {
    const auto busiest = [](UnitCycles u) { return std::string(u.busiest()); };
    EXPECT_EQ(busiest({9, 8, 7, 6}), "adders");
    EXPECT_EQ(busiest({8, 9, 7, 6}), "multipliers");
    EXPECT_EQ(busiest({8, 7, 9, 6}), "divider");
    EXPECT_EQ(busiest({8, 7, 6, 9}), "frame store");
    EXPECT_EQ(busiest({9, 9, 9, 9}), "divider") << "the scarcest of equals";
    EXPECT_EQ(busiest({9, 9, 8, 9}), "multipliers");
    EXPECT_EQ(busiest({9, 8, 8, 9}), "adders");
    EXPECT_EQ((UnitCycles{5, 6, 7, 4}.side_by_side()), 7u);
    EXPECT_EQ((UnitCycles{5, 6, 7, 4}.one_after_the_other()), 22u);
}

TEST(Operations, SumsAndMultiplesAreByField) {
    const Operations a{1, 2, 3, 4, 5, 6}, b{10, 20, 30, 40, 50, 60};
    const Operations sum = a + b, three = 3 * a;
    EXPECT_EQ(sum.adds, 11u);
    EXPECT_EQ(sum.products, 22u);
    EXPECT_EQ(sum.passes, 33u);
    EXPECT_EQ(sum.quotients, 44u);
    EXPECT_EQ(sum.quotient_bits, 55u);
    EXPECT_EQ(sum.accesses, 66u);
    EXPECT_EQ(three.adds, 3u);
    EXPECT_EQ(three.products, 6u);
    EXPECT_EQ(three.passes, 9u);
    EXPECT_EQ(three.quotients, 12u);
    EXPECT_EQ(three.quotient_bits, 15u);
    EXPECT_EQ(three.accesses, 18u);
}

}  // namespace
}  // namespace umbra78::hw
