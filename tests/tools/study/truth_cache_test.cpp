// The truth cache: traced once, bounded in bytes, the oldest dropped first.
#include "tests/tools/study/study_cases.hpp"
#include "tools/study/truth_cache.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

namespace umbra78::tools::study {
namespace {

// The sphere at 16 x 16 pixels, under a light of its own azimuth: each is another truth.
LoadedScene lit_from(int azimuth) {
    return scene_of(small_sphere(),
                    {"", {"xy_bits=4", "light.azimuth=" + std::to_string(azimuth)}, {}});
}

using Held = std::shared_ptr<const Traced>;

TEST(TruthCache, WhatACaseDoesNotChangeIsTracedOnce) {
    const TruthCache truths;
    const Held first = truths.of(lit_from(-100));
    LoadedScene other = lit_from(-100);
    other.settings.bias_q16 = 0;
    other.settings.machine.z_bits = 12;
    EXPECT_EQ(truths.of(other), first);
    EXPECT_EQ(truths.bytes(), bytes_of(*first));
    EXPECT_NE(truths.of(lit_from(-90)), first);
    EXPECT_GT(truths.bytes(), bytes_of(*first));
}

TEST(TruthCache, CountsAllThatATruthHolds) {
    const Held traced = TruthCache().of(lit_from(-100));
    // Visible, lit, surface, depth, position, normal, cosine, caster; unlit side, band, slope.
    const std::size_t pixel = 2 + 4 + 8 + 24 + 24 + 8 + 8 + 1 + 1 + 8;
    EXPECT_GE(bytes_of(*traced), 256 * pixel);
    EXPECT_LE(bytes_of(*traced), 2 * 256 * pixel + sizeof(Traced));
}

TEST(TruthCache, DropsWhatWasNotAskedForTheLongest) {
    const std::size_t one = bytes_of(*TruthCache().of(lit_from(0)));
    const TruthCache truths(2 * one + one / 2);
    const Held a = truths.of(lit_from(-10)), b = truths.of(lit_from(-20));
    EXPECT_EQ(truths.of(lit_from(-10)), a) << "both fit";
    const Held c = truths.of(lit_from(-30));  // b is the oldest now
    EXPECT_EQ(truths.bytes(), 2 * one);
    EXPECT_EQ(truths.of(lit_from(-10)), a);
    EXPECT_EQ(truths.of(lit_from(-30)), c);
    const Held again = truths.of(lit_from(-20));
    EXPECT_NE(again, b) << "it was dropped and traced anew";
    EXPECT_EQ(again->slope, b->slope) << "a dropped truth is whole as long as it is used";
    EXPECT_EQ(truths.bytes(), 2 * one);
}

TEST(TruthCache, TheNewestIsHeldThoughItAloneIsOverTheBudget) {
    const TruthCache truths(1);
    const Held a = truths.of(lit_from(-10));
    EXPECT_EQ(truths.of(lit_from(-10)), a);
    const Held b = truths.of(lit_from(-20));
    EXPECT_EQ(truths.bytes(), bytes_of(*b));
    EXPECT_NE(truths.of(lit_from(-10)), a);
}

// Four threads that ask for many truths stay within the budget.
TEST(TruthCache, IsBoundedUnderThreads) {
    const std::size_t one = bytes_of(*TruthCache().of(lit_from(0)));
    const TruthCache truths(4 * one);
    std::vector<std::jthread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&, k] {
            for (int azimuth = 0; azimuth < 40; ++azimuth)
                EXPECT_NE(truths.of(lit_from((azimuth * (k + 1)) % 90)), nullptr);
        });
    threads.clear();
    EXPECT_LE(truths.bytes(), 4 * one);
    EXPECT_GE(truths.bytes(), one);
}

}  // namespace
}  // namespace umbra78::tools::study
