// Images of numbers for tests: by a formula, or drawn from a generator with a seed of its own.
#pragma once

#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace umbra78::tools::test {

inline constexpr double pi = std::numbers::pi;
inline constexpr unsigned seed = 1978;

using Image = std::vector<double>;

inline Image image(int size, const std::function<double(int, int)>& value) {
    Image made;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) made.push_back(value(x, y));
    return made;
}

struct Uniform {
    std::mt19937 bits{seed};
    double operator()() { return (static_cast<double>(bits()) + 0.5) / 4294967296.0; }  // 0 .. 1
};

}  // namespace umbra78::tools::test
