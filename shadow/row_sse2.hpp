// The operations of SSE2, which every x86-64 has. A text for shadow/row_forms.cpp,
// which includes it before shadow/row_body.hpp; alone it is empty.
#ifdef UMBRA78_LANES

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
UMBRA78_LANES Word add_bytes(Word to, Word v) {  // four of each lane, without signs
    const Word two = (v & 0x00ff00ff) + (Word)_mm_srli_epi16(raw(v), 8);
    return to + (Word)_mm_madd_epi16(raw(two), _mm_set1_epi16(1));
}
UMBRA78_LANES void store_high_halves(std::int16_t* at, Word v) {
    const __m128i high = _mm_srai_epi32(raw(v), 16);
    _mm_storel_epi64((__m128i*)at, _mm_packs_epi32(high, high));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) { return to + sum_of_products(a, b); }
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm_xor_si128(raw(v), _mm_set1_epi16(-32768));
}
UMBRA78_LANES Word add_where_greater(Word to, Word a, Word b, Word v) {  // in signed halves
    return (Word)_mm_add_epi16(raw(to), _mm_and_si128(_mm_cmpgt_epi16(raw(a), raw(b)), raw(v)));
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
UMBRA78_LANES std::uint64_t drawn_of_64(const hw::Depth16* at, hw::Depth16 background) {
    const __m128i none = _mm_set1_epi16((short)background), *codes = (const __m128i*)at;
    std::uint64_t backgrounds = 0;
    for (int i = 0; i < 4; ++i) {
        const __m128i a = _mm_cmpeq_epi16(_mm_loadu_si128(codes + 2 * i), none);
        const __m128i b = _mm_cmpeq_epi16(_mm_loadu_si128(codes + 2 * i + 1), none);
        backgrounds |= (std::uint64_t)_mm_movemask_epi8(_mm_packs_epi16(a, b)) << 16 * i;
    }
    return ~backgrounds;
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
UMBRA78_LANES __m128i four(const hw::Depth16* texels, std::uint32_t at) {
    return _mm_loadl_epi64((const __m128i*)(texels + at));
}
// Four texels from each address on, in 64-bit lanes, half of the addresses in each word.
UMBRA78_LANES void quads(const hw::Depth16* texels, Word address, Mask some, Word* two) {
    const Word at = address & some;
    two[0] = (Word)_mm_unpacklo_epi64(four(texels, at[0]), four(texels, at[1]));
    two[1] = (Word)_mm_unpacklo_epi64(four(texels, at[2]), four(texels, at[3]));
}
UMBRA78_LANES void widen(Word v, Word* two) {  // each lane twice
    two[0] = (Word)_mm_unpacklo_epi32(raw(v), raw(v));
    two[1] = (Word)_mm_unpackhi_epi32(raw(v), raw(v));
}
UMBRA78_LANES Word narrow(const Word* two) {  // the sums of two lanes
    const __m128i a = _mm_add_epi32(raw(two[0]), _mm_srli_epi64(raw(two[0]), 32));
    const __m128i b = _mm_add_epi32(raw(two[1]), _mm_srli_epi64(raw(two[1]), 32));
    return (Word)_mm_unpacklo_epi64(_mm_shuffle_epi32(a, 0x08), _mm_shuffle_epi32(b, 0x08));
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    const __m128i a = _mm_packs_epi32(raw(m[0]), raw(m[1]));
    const __m128i b = _mm_packs_epi32(raw(m[2]), raw(m[3]));
    _mm_storeu_si128((__m128i*)at, _mm_packs_epi16(a, b));
}
UMBRA78_LANES void store_bytes(std::uint8_t* at, const Word* w) {  // of 0..255
    const __m128i a = _mm_packs_epi32(raw(w[0]), raw(w[1]));
    const __m128i b = _mm_packs_epi32(raw(w[2]), raw(w[3]));
    _mm_storeu_si128((__m128i*)at, _mm_packus_epi16(a, b));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c += m; }
UMBRA78_LANES std::uint32_t total(Counter c) {
    return 0 - (c[0] + c[1] + c[2] + c[3]);
}

#endif
