// The operations that shadow/row_body.hpp is written with, for each instruction set of x86-64, and
// the table of forms. Only the text between a set's pragmas is compiled for that set: nothing of a
// standard header but <immintrin.h> is named there.
#include "shadow/row_form.hpp"

// Without vector registers (-mgeneral-regs-only) and without a host the plain form stands alone.
#if defined(__x86_64__) && defined(__SSE2__) && __STDC_HOSTED__
#define UMBRA78_HAS_LANES 1
#include <immintrin.h>
#endif

namespace umbra78::shadow {

#ifdef UMBRA78_HAS_LANES
#define UMBRA78_LANES static inline __attribute__((always_inline))

// --- SSE2: every x86-64 -------------------------------------------------------------------------

namespace sse2 {

constexpr int lanes = 4;
typedef std::uint32_t Word __attribute__((vector_size(16)));
typedef Word Mask;     // -1 or 0
typedef Word Counter;  // of each lane, downward
typedef __m128i Count;
UMBRA78_LANES __m128i raw(Word v) { return (__m128i)v; }

UMBRA78_LANES Word all(std::int32_t v) { return (Word)_mm_set1_epi32(v); }
UMBRA78_LANES Count count(int n) { return _mm_cvtsi32_si128(n); }
UMBRA78_LANES Word load(const void* at) { return (Word)_mm_loadu_si128((const __m128i*)at); }
UMBRA78_LANES void store(void* at, Word v) { _mm_storeu_si128((__m128i*)at, raw(v)); }
UMBRA78_LANES Word down(Word v, Count n) { return (Word)_mm_sra_epi32(raw(v), n); }
UMBRA78_LANES Word down_unsigned(Word v, Count n) { return (Word)_mm_srl_epi32(raw(v), n); }
UMBRA78_LANES Word up(Word v, Count n) { return (Word)_mm_sll_epi32(raw(v), n); }
UMBRA78_LANES Word down16(Word v) { return (Word)_mm_srai_epi32(raw(v), 16); }
UMBRA78_LANES Word up16(Word v) { return (Word)_mm_slli_epi32(raw(v), 16); }
UMBRA78_LANES Word sum_of_products(Word a, Word b) {
    return (Word)_mm_madd_epi16(raw(a), raw(b));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) { return to + sum_of_products(a, b); }
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm_xor_si128(raw(v), _mm_set1_epi16(-32768));
}

UMBRA78_LANES Mask less(Word a, Word b) { return (Mask)_mm_cmplt_epi32(raw(a), raw(b)); }
UMBRA78_LANES Mask equal(Word a, Word b) { return (Mask)_mm_cmpeq_epi32(raw(a), raw(b)); }
UMBRA78_LANES Mask not_negative(Word v) { return less(all(-1), v); }
UMBRA78_LANES Mask both(Mask a, Mask b) { return a & b; }
UMBRA78_LANES Mask either(Mask a, Mask b) { return a | b; }
UMBRA78_LANES Mask without(Mask a, Mask b) { return a & ~b; }
UMBRA78_LANES Mask in_range(Word v, Word end) { return less(all(-1), v) & less(v, end); }
UMBRA78_LANES bool any(Mask m) { return _mm_movemask_epi8(raw(m)) != 0; }
UMBRA78_LANES bool any_of_both(Mask a, Mask b) { return any(both(a, b)); }
UMBRA78_LANES Word keep(Word v, Mask m) { return v & m; }

struct Codes {
    Word z;  // the z word in the low half of each lane
    Mask visible;
};
struct CodeRule {
    __m128i background, offset, z_up;
};
UMBRA78_LANES CodeRule code_rule(const RowLine& line) {
    return {_mm_set1_epi16((short)line.background), _mm_set1_epi16((short)line.offset),
            _mm_cvtsi32_si128(line.z_up)};
}
UMBRA78_LANES bool read_codes(const hw::Depth16* at, const CodeRule& rule, Codes* c) {
    int backgrounds = 0xffff;
    for (int i = 0; i < 2; ++i) {
        const __m128i code = _mm_loadu_si128((const __m128i*)(at + 8 * i));
        const __m128i none = _mm_cmpeq_epi16(code, rule.background);
        const __m128i z = _mm_sll_epi16(_mm_sub_epi16(code, rule.offset), rule.z_up);
        c[2 * i] = {(Word)_mm_unpacklo_epi16(z, z), ~(Mask)_mm_unpacklo_epi16(none, none)};
        c[2 * i + 1] = {(Word)_mm_unpackhi_epi16(z, z), ~(Mask)_mm_unpackhi_epi16(none, none)};
        backgrounds &= _mm_movemask_epi8(none);
    }
    return backgrounds != 0xffff;
}
UMBRA78_LANES __m128i pair(const hw::Depth16* texels, std::uint32_t at) {
    std::int32_t two;
    __builtin_memcpy(&two, texels + at, sizeof two);
    return _mm_cvtsi32_si128(two);
}
UMBRA78_LANES Word pairs(const hw::Depth16* texels, Word address, Mask some) {
    const Word at = address & some;
    const __m128i a = _mm_unpacklo_epi32(pair(texels, at[0]), pair(texels, at[1]));
    const __m128i b = _mm_unpacklo_epi32(pair(texels, at[2]), pair(texels, at[3]));
    return (Word)_mm_unpacklo_epi64(a, b);
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    const __m128i a = _mm_packs_epi32(raw(m[0]), raw(m[1]));
    const __m128i b = _mm_packs_epi32(raw(m[2]), raw(m[3]));
    _mm_storeu_si128((__m128i*)at, _mm_packs_epi16(a, b));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c += m; }
UMBRA78_LANES std::uint32_t total(Counter c) {
    return 0 - (c[0] + c[1] + c[2] + c[3]);
}

#include "shadow/row_body.hpp"

}  // namespace sse2

// --- AVX2 ---------------------------------------------------------------------------------------

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2 {

constexpr int lanes = 8;
typedef std::uint32_t Word __attribute__((vector_size(32)));
typedef Word Mask;
typedef Word Counter;
typedef Word Count;
UMBRA78_LANES __m256i raw(Word v) { return (__m256i)v; }

UMBRA78_LANES Word all(std::int32_t v) { return (Word)_mm256_set1_epi32(v); }
UMBRA78_LANES Count count(int n) { return all(n); }
UMBRA78_LANES Word load(const void* at) { return (Word)_mm256_loadu_si256((const __m256i*)at); }
UMBRA78_LANES void store(void* at, Word v) { _mm256_storeu_si256((__m256i*)at, raw(v)); }
UMBRA78_LANES Word down(Word v, Count n) { return (Word)_mm256_srav_epi32(raw(v), raw(n)); }
UMBRA78_LANES Word down_unsigned(Word v, Count n) {
    return (Word)_mm256_srlv_epi32(raw(v), raw(n));
}
UMBRA78_LANES Word up(Word v, Count n) { return (Word)_mm256_sllv_epi32(raw(v), raw(n)); }
UMBRA78_LANES Word down16(Word v) { return (Word)_mm256_srai_epi32(raw(v), 16); }
UMBRA78_LANES Word up16(Word v) { return (Word)_mm256_slli_epi32(raw(v), 16); }
UMBRA78_LANES Word sum_of_products(Word a, Word b) {
    return (Word)_mm256_madd_epi16(raw(a), raw(b));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) { return to + sum_of_products(a, b); }
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm256_xor_si256(raw(v), _mm256_set1_epi16(-32768));
}

UMBRA78_LANES Mask less(Word a, Word b) { return (Mask)_mm256_cmpgt_epi32(raw(b), raw(a)); }
UMBRA78_LANES Mask equal(Word a, Word b) { return (Mask)_mm256_cmpeq_epi32(raw(a), raw(b)); }
UMBRA78_LANES Mask not_negative(Word v) { return less(all(-1), v); }
UMBRA78_LANES Mask both(Mask a, Mask b) { return a & b; }
UMBRA78_LANES Mask either(Mask a, Mask b) { return a | b; }
UMBRA78_LANES Mask without(Mask a, Mask b) { return a & ~b; }
UMBRA78_LANES Mask in_range(Word v, Word end) { return less(all(-1), v) & less(v, end); }
UMBRA78_LANES bool any(Mask m) { return _mm256_movemask_epi8(raw(m)) != 0; }
UMBRA78_LANES bool any_of_both(Mask a, Mask b) { return !_mm256_testz_si256(raw(a), raw(b)); }
UMBRA78_LANES Word keep(Word v, Mask m) { return v & m; }

struct Codes {
    Word z;
    Mask visible;
};
struct CodeRule {
    __m256i background, offset;
    __m128i z_up;
};
UMBRA78_LANES CodeRule code_rule(const RowLine& line) {
    return {_mm256_set1_epi16((short)line.background), _mm256_set1_epi16((short)line.offset),
            _mm_cvtsi32_si128(line.z_up)};
}
UMBRA78_LANES bool read_codes(const hw::Depth16* at, const CodeRule& rule, Codes* c) {
    const __m256i code = _mm256_loadu_si256((const __m256i*)at);
    const __m256i none = _mm256_cmpeq_epi16(code, rule.background);
    const __m256i z = _mm256_sll_epi16(_mm256_sub_epi16(code, rule.offset), rule.z_up);
    c[0] = {(Word)_mm256_cvtepu16_epi32(_mm256_castsi256_si128(z)),
            ~(Mask)_mm256_cvtepi16_epi32(_mm256_castsi256_si128(none))};
    c[1] = {(Word)_mm256_cvtepu16_epi32(_mm256_extracti128_si256(z, 1)),
            ~(Mask)_mm256_cvtepi16_epi32(_mm256_extracti128_si256(none, 1))};
    return _mm256_movemask_epi8(none) != -1;
}
UMBRA78_LANES Word pairs(const hw::Depth16* texels, Word address, Mask some) {
    return (Word)_mm256_mask_i32gather_epi32(_mm256_setzero_si256(), (const int*)texels,
                                             raw(address), raw(some), sizeof(hw::Depth16));
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    const __m256i words = _mm256_packs_epi32(raw(m[0]), raw(m[1]));  // in quarters 0 2 1 3
    const __m256i in_order = _mm256_permute4x64_epi64(words, 0xd8);
    _mm_storeu_si128((__m128i*)at, _mm_packs_epi16(_mm256_castsi256_si128(in_order),
                                                   _mm256_extracti128_si256(in_order, 1)));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c += m; }
UMBRA78_LANES std::uint32_t total(Counter c) {
    return 0 - (c[0] + c[1] + c[2] + c[3] + c[4] + c[5] + c[6] + c[7]);
}

#include "shadow/row_body.hpp"

}  // namespace avx2
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

// --- AVX-512: masks of a bit a lane --------------------------------------------------------------

#ifdef __clang__
#pragma clang attribute push(                                                              \
    __attribute__((target("avx512f,avx512bw,avx512vl,avx512dq,avx512vnni"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512vl,avx512dq,avx512vnni,prefer-vector-width=512")
#endif
namespace avx512 {

constexpr int lanes = 16;
typedef std::uint32_t Word __attribute__((vector_size(64)));
typedef __mmask16 Mask;
typedef __m128i Counter;  // bytes, of at most 32 blocks
typedef Word Count;
UMBRA78_LANES __m512i raw(Word v) { return (__m512i)v; }

UMBRA78_LANES Word all(std::int32_t v) { return (Word)_mm512_set1_epi32(v); }
UMBRA78_LANES Count count(int n) { return all(n); }
UMBRA78_LANES Word load(const void* at) { return (Word)_mm512_loadu_si512(at); }
UMBRA78_LANES void store(void* at, Word v) { _mm512_storeu_si512(at, raw(v)); }
UMBRA78_LANES Word down(Word v, Count n) { return (Word)_mm512_srav_epi32(raw(v), raw(n)); }
UMBRA78_LANES Word down_unsigned(Word v, Count n) {
    return (Word)_mm512_srlv_epi32(raw(v), raw(n));
}
UMBRA78_LANES Word up(Word v, Count n) { return (Word)_mm512_sllv_epi32(raw(v), raw(n)); }
UMBRA78_LANES Word down16(Word v) { return (Word)_mm512_srai_epi32(raw(v), 16); }
UMBRA78_LANES Word up16(Word v) { return (Word)_mm512_slli_epi32(raw(v), 16); }
UMBRA78_LANES Word sum_of_products(Word a, Word b) {
    return (Word)_mm512_madd_epi16(raw(a), raw(b));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) {
    return (Word)_mm512_dpwssd_epi32(raw(to), raw(a), raw(b));
}
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm512_xor_si512(raw(v), _mm512_set1_epi16(-32768));
}

UMBRA78_LANES Mask less(Word a, Word b) { return _mm512_cmplt_epi32_mask(raw(a), raw(b)); }
UMBRA78_LANES Mask equal(Word a, Word b) { return _mm512_cmpeq_epi32_mask(raw(a), raw(b)); }
UMBRA78_LANES Mask not_negative(Word v) { return (Mask)~_mm512_movepi32_mask(raw(v)); }
UMBRA78_LANES Mask both(Mask a, Mask b) { return a & b; }
UMBRA78_LANES Mask either(Mask a, Mask b) { return a | b; }
UMBRA78_LANES Mask without(Mask a, Mask b) { return (Mask)(a & ~b); }
UMBRA78_LANES Mask in_range(Word v, Word end) {  // 0 <= v < end
    return _mm512_cmplt_epu32_mask(raw(v), raw(end));
}
UMBRA78_LANES bool any(Mask m) { return m != 0; }
UMBRA78_LANES bool any_of_both(Mask a, Mask b) { return any(both(a, b)); }
UMBRA78_LANES Word keep(Word v, Mask m) { return (Word)_mm512_maskz_mov_epi32(m, raw(v)); }

struct Codes {
    Word z;
    Mask visible;
};
struct CodeRule {
    __m256i background, offset;
    __m128i z_up;
};
UMBRA78_LANES CodeRule code_rule(const RowLine& line) {
    return {_mm256_set1_epi16((short)line.background), _mm256_set1_epi16((short)line.offset),
            _mm_cvtsi32_si128(line.z_up)};
}
UMBRA78_LANES bool read_codes(const hw::Depth16* at, const CodeRule& rule, Codes* c) {
    const __m256i code = _mm256_loadu_si256((const __m256i*)at);
    const __m256i z = _mm256_sll_epi16(_mm256_sub_epi16(code, rule.offset), rule.z_up);
    *c = {(Word)_mm512_cvtepu16_epi32(z), _mm256_cmpneq_epi16_mask(code, rule.background)};
    return any(c->visible);
}
UMBRA78_LANES Word pairs(const hw::Depth16* texels, Word address, Mask some) {
    return (Word)_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), some, raw(address), texels,
                                             sizeof(hw::Depth16));
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    _mm_storeu_si128((__m128i*)at, _mm_movm_epi8(*m));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c = _mm_sub_epi8(c, _mm_movm_epi8(m)); }
UMBRA78_LANES std::uint32_t total(Counter c) {
    const __m128i sums = _mm_sad_epu8(c, _mm_setzero_si128());
    return (std::uint32_t)(_mm_extract_epi16(sums, 0) + _mm_extract_epi16(sums, 4));
}

#include "shadow/row_body.hpp"

}  // namespace avx512
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

namespace {
bool always() { return true; }
bool has_avx2() { return __builtin_cpu_supports("avx2") != 0; }
bool has_avx512() {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vnni") != 0;
}
constexpr RowForm forms[] = {{"plain", always, plain_row},
                             {"SSE2", always, sse2::run},
                             {"AVX2", has_avx2, avx2::run},
                             {"AVX-512", has_avx512, avx512::run}};
}  // namespace

#else
namespace {
bool always() { return true; }
constexpr RowForm forms[] = {{"plain", always, plain_row}};
}  // namespace
#endif

std::span<const RowForm> row_forms() { return forms; }

const RowForm& fastest_row_form() {
    const RowForm* best = forms;
    for (const RowForm& form : forms)
        if (form.supported()) best = &form;
    return *best;
}

}  // namespace umbra78::shadow
