// The hash against published vectors.
#include "fixed/fnv.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace umbra78::fixed {
namespace {

constexpr std::uint64_t hash_of(std::string_view text) {
    Fnv1a64 hash;
    for (const char c : text) {
        hash.byte(static_cast<std::uint8_t>(c));
    }
    return hash.value();
}

// The published test vectors of the FNV draft.
TEST(Fnv1a64, PublishedVectors) {
    static_assert(hash_of("") == 0xcbf29ce484222325);
    static_assert(hash_of("a") == 0xaf63dc4c8601ec8c);
    static_assert(hash_of("b") == 0xaf63df4c8601f1a5);
    static_assert(hash_of("foobar") == 0x85944171f73967e8);
    EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);  // at run time too
}

TEST(Fnv1a64, WordsGoHighByteFirst) {
    Fnv1a64 half, word;
    half.u16be(0x666f);      // "fo"
    half.u32be(0x6f626172);  // "obar"
    word.u32be(0x666f6f62);  // "foob"
    word.u16be(0x6172);      // "ar"
    EXPECT_EQ(half.value(), hash_of("foobar"));
    EXPECT_EQ(word.value(), hash_of("foobar"));
}

}  // namespace
}  // namespace umbra78::fixed
