// Finds the input with the maximum error of a unit: among all words, or by random draws and climbs.
#include "tools/study/precision/precision.hpp"

#include "fixed/overflow.hpp"

#include <algorithm>

namespace umbra78::tools::study {
namespace {

// Steele, Lea and Flood's splitmix64: the same words on every computer.
class Random {
public:
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    }
    // A word of random length; every length is as likely as any other. One draw in eight is within
    // 3 of an end of the range.
    std::int64_t word(int width) {
        const std::uint64_t draw = bits();
        if (draw % 8 == 0) {
            const std::int64_t end = draw & 8 ? fixed::min_signed(width) : fixed::max_signed(width);
            const auto off = static_cast<std::int64_t>(draw >> 8 & 3);
            return fixed::clamp(end + (end < 0 ? off : -off), fixed::min_signed(width),
                                fixed::max_signed(width));
        }
        const int length = 1 + static_cast<int>((draw >> 8) % static_cast<unsigned>(width));
        return fixed::wrap(static_cast<std::int64_t>(bits()), length);
    }

private:
    std::uint64_t state_ = 1978;
};

class Search {
public:
    explicit Search(const PrecisionUnit& unit) : unit_(unit) {}

    // The error of an input, recorded; negative and not recorded outside the unit's domain.
    double at(const Input& in) {
        const double error = unit_.error(in);
        if (error < 0) return error;
        ++result_.cases;
        sum_ += error;
        const auto bin = static_cast<std::size_t>(error / unit_.bound * error_bins);
        // An error of exactly the bound is within it: a tie.
        ++result_.histogram[error <= unit_.bound ? std::min<std::size_t>(bin, error_bins - 1)
                                                 : error_bins];
        if (error > result_.worst || result_.cases == 1) {
            result_.worst = error;
            result_.at = in;
        }
        return error;
    }

    void all(std::int64_t step) {
        Input in{};
        for (std::int64_t v = fixed::min_signed(unit_.bits[0]);
             v <= fixed::max_signed(unit_.bits[0]); v += step) {
            in[0] = v;
            at(in);
        }
    }

    // From a random input: a step flips a bit of a word, adds one or subtracts one, and is kept
    // unless the error falls.
    void climb(Random& random, int steps) {
        Input best = drawn(random);
        double error = at(best);
        for (int k = 0; k < steps; ++k) {
            Input next = best;
            const auto w = static_cast<std::size_t>(
                random.bits() % static_cast<unsigned>(unit_.words));
            const std::uint64_t draw = random.bits();
            const int width = unit_.bits[w];
            const auto flip = std::uint64_t{1} << (draw >> 8) % static_cast<unsigned>(width);
            const auto word = static_cast<std::uint64_t>(next[w]);
            next[w] = fixed::wrap(static_cast<std::int64_t>(draw % 3 == 0   ? word ^ flip
                                                            : draw % 3 == 1 ? word + 1
                                                                            : word - 1),
                                  width);
            const double there = at(next);
            if (there < error) continue;
            error = there;
            best = next;
        }
    }

    PrecisionResult result() {
        if (result_.cases > 0) result_.mean = sum_ / static_cast<double>(result_.cases);
        return result_;
    }

private:
    Input drawn(Random& random) const {
        Input in{};
        for (std::size_t w = 0; w < static_cast<std::size_t>(unit_.words); ++w)
            in[w] = random.word(unit_.bits[w]);
        return in;
    }

    const PrecisionUnit& unit_;
    PrecisionResult result_;
    double sum_ = 0;
};

}  // namespace

PrecisionResult measure(const PrecisionUnit& unit, bool quick) {
    Search search(unit);
    if (unit.exhaustive) {
        search.all(quick ? 61 : 1);
        return search.result();
    }
    Random random;
    const int climbs = quick ? 2000 : 60000;
    for (int k = 0; k < climbs; ++k) search.climb(random, 60);
    return search.result();
}

}  // namespace umbra78::tools::study
