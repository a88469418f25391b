// Seeded inputs of tests: the same numbers everywhere.
#pragma once

#include <cstdint>
#include <random>

namespace umbra78::test {

// The generator's outputs are the standard's; distributions would be the library's.
class Inputs {
public:
    explicit Inputs(std::uint64_t seed) : generator_(seed) {}
    std::int64_t between(std::int64_t low, std::int64_t high) {
        const auto count = static_cast<std::uint64_t>(high - low) + 1;
        return low + static_cast<std::int64_t>(generator_() % count);
    }
    // A signed word of up to `bits` bits, each length as likely as any other.
    std::int64_t word(int bits) {
        const std::int64_t limit = std::int64_t{1} << between(0, bits - 1);
        return between(-limit, limit - 1);
    }

private:
    std::mt19937_64 generator_;
};

}  // namespace umbra78::test
