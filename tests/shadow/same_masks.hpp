// Two masks of the post-process, compared.
#pragma once

#include "tests/support/buffers.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace umbra78::shadow::test {

// Quiet where equal, even where both are constant: the tests count what is in shadow.
inline void expect_same(const std::vector<std::uint8_t>& expected,
                        const std::vector<std::uint8_t>& got, int size, const std::string& where) {
    if (expected == got) return;
    SCOPED_TRACE(where);
    umbra78::test::expect_equal_buffers("mask", size, expected, got);
}

}  // namespace umbra78::shadow::test
