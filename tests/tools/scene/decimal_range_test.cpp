// Ranges first:last:step in exact decimals.
#include "tools/scene/decimal_range.hpp"

#include <gtest/gtest.h>

namespace umbra78::tools {
namespace {

using Texts = std::vector<std::string>;

TEST(DecimalRange, IsExactAndHoldsBothEnds) {
    const struct {
        const char* text;
        Texts values;
    } cases[] = {
        {"0:1:0.25", {"0", "0.25", "0.5", "0.75", "1"}},
        {"0:0.3:0.1", {"0", "0.1", "0.2", "0.3"}},
        {"0:10:4", {"0", "4", "8"}},
        {"10:8:-1", {"10", "9", "8"}},
        {"-100.50:-99.5:0.5", {"-100.5", "-100", "-99.5"}},
        {"-0.5:0.5:0.5", {"-0.5", "0", "0.5"}},
        {"7:7:1", {"7"}},
        {"7:7:-1", {"7"}},
        {"100:300:100", {"100", "200", "300"}},
        {"+1_0:10:1.0_0", {"10"}},
        {"0:0.000000000000000002:0.000000000000000001",
         {"0", "0.000000000000000001", "0.000000000000000002"}},
        {"4611686018427387902:4611686018427387903:1",
         {"4611686018427387902", "4611686018427387903"}},
    };
    for (const auto& [text, values] : cases) {
        const DecimalRange range = read_decimal_range(text);
        EXPECT_EQ(range.values, values) << text;
        EXPECT_EQ(range.error, "") << text;
    }
    EXPECT_EQ(read_decimal_range("1:100000:1").values.size(), 100000u);
}

TEST(DecimalRange, SaysWhatIsWrong) {
    const char *three = "a range has a first value, a last one and a step",
               *step = "the step does not lead from the first value to the last",
               *long_numbers = "the numbers are too long";
    const struct {
        const char *text, *error;
    } cases[] = {
        {"", three},
        {"0:1", three},
        {"0:1:1:1", three},
        {"0:1:0", step},
        {"7:7:0", step},
        {"0:1:-1", step},
        {"1:0:1", step},
        {"a:2:1", "'a' is not a number"},
        {"0::1", "'' is not a number"},
        {"0:1e3:1", "'1e3' is not a number"},
        {"0:.5:1", "'.5' is not a number"},
        {"0:100000:1", "100001 values are too many"},
        {"9000000000000000000:9000000000000000000:0.0001", long_numbers},
        {"0:4611686018427387904:4611686018427387904", long_numbers},
    };
    for (const auto& [text, error] : cases) {
        const DecimalRange range = read_decimal_range(text);
        EXPECT_EQ(range.error, error) << text;
        EXPECT_EQ(range.values, Texts{}) << text;
    }
}

}  // namespace
}  // namespace umbra78::tools
