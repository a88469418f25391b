// expect_equal_buffers: compares two buffers word by word and reports what differs.
//
// A difference is reported as a count and the first place, x, y and both values; a picture of it is
// written to the test's working folder: black where equal, else |difference|, at least 64, so that
// a difference of 1 is seen. Two buffers that hold the same constant fail as well: nothing was
// drawn, and two empty buffers prove nothing. A test whose buffers may be constant, for example an
// empty view, says so by Constant::expected.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace umbra78::test {

template <class A, class B>
void write_difference(const std::string& path, std::size_t width, const A& a, const B& b) {
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << width << ' ' << std::size(a) / width << "\n255\n";
    for (std::size_t k = 0; k < std::size(a); ++k) {
        const auto difference = std::int64_t{a[k]} - std::int64_t{b[k]};
        const auto shown = std::clamp<std::int64_t>(difference < 0 ? -difference : difference, 64,
                                                    255);
        file.put(static_cast<char>(difference == 0 ? 0 : shown));
    }
}

enum class Constant { fails, expected };

template <class A, class B>
void expect_equal_buffers(std::string_view name, int width_px, const A& a, const B& b,
                          Constant of_constant = Constant::fails) {
    ASSERT_EQ(std::size(a), std::size(b)) << name << ": sizes differ";
    const auto width = static_cast<std::size_t>(width_px);
    std::size_t count = 0, first = 0;
    bool constant = true;
    for (std::size_t k = std::size(a); k-- > 0;) {
        if (a[k] != a[0]) constant = false;
        if (a[k] == b[k]) continue;
        ++count;
        first = k;
    }
    if (count == 0) {
        if (constant && of_constant == Constant::fails)
            ADD_FAILURE() << name << " is constant: nothing is compared";
        return;
    }
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string path = std::string(test->test_suite_name()) + '.' + test->name() + '.' +
                             std::string(name) + ".difference.pgm";
    write_difference(path, width, a, b);
    ADD_FAILURE() << name << ": " << count << " of " << std::size(a) << " words differ, first x "
                  << first % width << " y " << first / width << ": " << +a[first] << " and "
                  << +b[first] << "; see " << path;
}

}  // namespace umbra78::test
