// A broken precondition prints its reason and stops the program, can be made an exception, and is
// a compile error in a constant expression.
#include "fixed/trap.hpp"
#include "fixed/rounding.hpp"
#include "tests/support/trapped.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace umbra78::fixed {
namespace {

TEST(Trap, TheReasonIsPrintedBeforeTheProgramStops) {
    EXPECT_DEATH(require(false, "the reason"), "^umbra78: internal error: the reason\n$");
    EXPECT_DEATH(trap("another one"), "another one");
    EXPECT_DEATH((void)round_shift(5, 63, Rounding::floor), "round_shift: shift outside 0..62");
}

TEST(Trap, AConditionThatHoldsDoesNothing) { require(true, "not printed"); }

// As a binding does it: the hook throws, through the core's frames, to its caller.
TEST(Trap, TheHookMayThrow) {
    throw_when_trapped = true;
    std::string reason;
    try {
        (void)round_shift(5, 63, Rounding::floor);
    } catch (const std::logic_error& error) {
        reason = error.what();
    }
    throw_when_trapped = false;
    EXPECT_EQ(reason, "round_shift: shift outside 0..62");
}

template <int N>
concept is_constant = requires { typename std::bool_constant<(require(N == 1, "not 1"), true)>; };
static_assert(is_constant<1> && !is_constant<2>,
              "a condition that fails is no constant expression, so it does not compile");

}  // namespace
}  // namespace umbra78::fixed
