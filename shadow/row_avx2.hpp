// The operations of AVX2. A text for shadow/row_forms.cpp,
// which includes it before shadow/row_body.hpp; alone it is empty.
#ifdef UMBRA78_LANES

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
UMBRA78_LANES Word add_bytes(Word to, Word v) {
    const __m256i two = _mm256_maddubs_epi16(raw(v), _mm256_set1_epi8(1));
    return to + (Word)_mm256_madd_epi16(two, _mm256_set1_epi16(1));
}
UMBRA78_LANES void store_high_halves(std::int16_t* at, Word v) {
    const __m256i high = _mm256_srai_epi32(raw(v), 16);
    const __m256i halves = _mm256_permute4x64_epi64(_mm256_packs_epi32(high, high), 0xd8);
    _mm_storeu_si128((__m128i*)at, _mm256_castsi256_si128(halves));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) { return to + sum_of_products(a, b); }
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm256_xor_si256(raw(v), _mm256_set1_epi16(-32768));
}
UMBRA78_LANES Word add_where_greater(Word to, Word a, Word b, Word v) {
    const __m256i greater = _mm256_cmpgt_epi16(raw(a), raw(b));
    return (Word)_mm256_add_epi16(raw(to), _mm256_and_si256(greater, raw(v)));
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
UMBRA78_LANES std::uint64_t drawn_of_64(const hw::Depth16* at, hw::Depth16 background) {
    const __m256i none = _mm256_set1_epi16((short)background), *codes = (const __m256i*)at;
    std::uint64_t backgrounds = 0;
    for (int i = 0; i < 2; ++i) {
        const __m256i a = _mm256_cmpeq_epi16(_mm256_loadu_si256(codes + 2 * i), none);
        const __m256i b = _mm256_cmpeq_epi16(_mm256_loadu_si256(codes + 2 * i + 1), none);
        const __m256i in_order = _mm256_permute4x64_epi64(_mm256_packs_epi16(a, b), 0xd8);
        backgrounds |= (std::uint64_t)(std::uint32_t)_mm256_movemask_epi8(in_order) << 32 * i;
    }
    return ~backgrounds;
}
UMBRA78_LANES Word pairs(const hw::Depth16* texels, Word address, Mask some) {
    return (Word)_mm256_mask_i32gather_epi32(_mm256_setzero_si256(), (const int*)texels,
                                             raw(address), raw(some), sizeof(hw::Depth16));
}
UMBRA78_LANES __m256i four(const hw::Depth16* texels, __m128i at, __m128i some) {
    return _mm256_mask_i32gather_epi64(_mm256_setzero_si256(), (const long long*)texels, at,
                                       _mm256_cvtepi32_epi64(some), sizeof(hw::Depth16));
}
UMBRA78_LANES __m128i lower(Word v) { return _mm256_castsi256_si128(raw(v)); }
UMBRA78_LANES __m128i upper(Word v) { return _mm256_extracti128_si256(raw(v), 1); }
UMBRA78_LANES void quads(const hw::Depth16* texels, Word address, Mask some, Word* two) {
    two[0] = (Word)four(texels, lower(address), lower(some));
    two[1] = (Word)four(texels, upper(address), upper(some));
}
UMBRA78_LANES __m256i twice(__m128i v) {
    const __m256i wide = _mm256_cvtepu32_epi64(v);
    return _mm256_or_si256(wide, _mm256_slli_epi64(wide, 32));
}
UMBRA78_LANES void widen(Word v, Word* two) {
    two[0] = (Word)twice(lower(v));
    two[1] = (Word)twice(upper(v));
}
UMBRA78_LANES Word narrow(const Word* two) {
    const __m256i a = _mm256_add_epi32(raw(two[0]), _mm256_srli_epi64(raw(two[0]), 32));
    const __m256i b = _mm256_add_epi32(raw(two[1]), _mm256_srli_epi64(raw(two[1]), 32));
    const __m256i quarters = _mm256_unpacklo_epi64(_mm256_shuffle_epi32(a, 0x08),
                                                   _mm256_shuffle_epi32(b, 0x08));
    return (Word)_mm256_permute4x64_epi64(quarters, 0xd8);
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    const __m256i words = _mm256_packs_epi32(raw(m[0]), raw(m[1]));  // in quarters 0 2 1 3
    const __m256i in_order = _mm256_permute4x64_epi64(words, 0xd8);
    _mm_storeu_si128((__m128i*)at, _mm_packs_epi16(_mm256_castsi256_si128(in_order),
                                                   _mm256_extracti128_si256(in_order, 1)));
}
UMBRA78_LANES void store_bytes(std::uint8_t* at, const Word* w) {
    const __m256i words = _mm256_packs_epi32(raw(w[0]), raw(w[1]));
    const __m256i in_order = _mm256_permute4x64_epi64(words, 0xd8);
    _mm_storeu_si128((__m128i*)at, _mm_packus_epi16(_mm256_castsi256_si128(in_order),
                                                    _mm256_extracti128_si256(in_order, 1)));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c += m; }
UMBRA78_LANES std::uint32_t total(Counter c) {
    return 0 - (c[0] + c[1] + c[2] + c[3] + c[4] + c[5] + c[6] + c[7]);
}

#endif
