// The programs beside the proofs: what each of them tells, and the words that they try.
#pragma once

#include "fixed/rounding.hpp"
#include "tests/proofs/model.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

namespace umbra78::proofs {

inline constexpr fixed::Rounding roundings[] = {
    fixed::Rounding::floor,        fixed::Rounding::ceiling,   fixed::Rounding::to_zero,
    fixed::Rounding::half_up,      fixed::Rounding::half_to_zero,
    fixed::Rounding::half_away,    fixed::Rounding::half_even};

// Words of any width, half of them near the ends of their range, near 0 or near a power of two.
class Words {
public:
    std::uint64_t bits() {  // SplitMix64 (Steele, Lea and Flood 2014)
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    Wide between(Wide low, Wide high) {
        const Bits span = static_cast<Bits>(high - low) + 1;
        const Bits any = Bits{bits()} << 64 | bits();
        if (bits() % 2 == 0) return low + static_cast<Wide>(span == 0 ? any : any % span);
        const Wide near = static_cast<Wide>(bits() % 5) - 2;
        Wide at = 0;
        switch (bits() % 4) {
            case 0: at = low; break;
            case 1: at = high; break;
            case 2: break;
            default: at = Wide{1} << (bits() % 120); break;
        }
        if (bits() % 2 == 0) at = -at;
        at += near;
        return at < low ? low : at > high ? high : at;
    }
    std::int64_t word(int width = 64) {
        const Wide half = Wide{1} << (width - 1);
        return static_cast<std::int64_t>(between(-half, half - 1));
    }
    int number(int low, int high) { return static_cast<int>(between(low, high)); }
    fixed::Rounding rounding() { return roundings[bits() % 7]; }

private:
    std::uint64_t state_ = 0x1978;
};

inline std::string decimal(Wide v) {
    if (v < 0) return "-" + decimal(-v);
    std::string digits;
    do {
        digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(v % 10)));
        v /= 10;
    } while (v != 0);
    return digits;
}

// Counts what was compared and prints the first that differs.
class Verdict {
public:
    explicit Verdict(const char* name) : name_(name) {}
    template <class Inputs>
    bool equal(Wide is, Wide wanted, const Inputs& inputs) {
        ++cases_;
        if (is == wanted) return true;
        if (differ_++ == 0) {
            std::printf("%s: %s, and not %s, for", name_, decimal(is).c_str(),
                        decimal(wanted).c_str());
            for (const Wide v : inputs) std::printf(" %s", decimal(v).c_str());
            std::printf("\n");
        }
        return false;
    }
    bool tell() const {
        std::printf("%s: %llu cases, %llu differ\n", name_,
                    static_cast<unsigned long long>(cases_),
                    static_cast<unsigned long long>(differ_));
        return differ_ == 0 && cases_ > 0;
    }

private:
    const char* name_;
    std::uint64_t cases_ = 0, differ_ = 0;
};

using Given = std::vector<Wide>;

// Whether a fault is planted, which the program must then find.
extern bool planted;

bool agree();       // agree.cpp
bool exhaustive();  // exhaustive.cpp
bool forms();       // forms.cpp
bool errors();      // errors.cpp

}  // namespace umbra78::proofs
