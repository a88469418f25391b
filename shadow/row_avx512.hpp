// The operations of AVX-512, whose masks have a bit a lane. A text for shadow/row_forms.cpp,
// which includes it before shadow/row_body.hpp; alone it is empty.
#ifdef UMBRA78_LANES

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
UMBRA78_LANES Word add_bytes(Word to, Word v) {
    return (Word)_mm512_dpbusd_epi32(raw(to), raw(v), _mm512_set1_epi8(1));
}
UMBRA78_LANES void store_high_halves(std::int16_t* at, Word v) {
    _mm256_storeu_si256((__m256i*)at, _mm512_cvtepi32_epi16(_mm512_srli_epi32(raw(v), 16)));
}
UMBRA78_LANES Word add_products(Word to, Word a, Word b) {
    return (Word)_mm512_dpwssd_epi32(raw(to), raw(a), raw(b));
}
UMBRA78_LANES Word product(Word a, Word b) { return a * b; }
UMBRA78_LANES Word low_half(Word v) { return v & 0xffff; }
UMBRA78_LANES Word signed_halves(Word v) {
    return (Word)_mm512_xor_si512(raw(v), _mm512_set1_epi16(-32768));
}
UMBRA78_LANES Word add_where_greater(Word to, Word a, Word b, Word v) {
    const __mmask32 greater = _mm512_cmpgt_epi16_mask(raw(a), raw(b));
    return (Word)_mm512_mask_add_epi16(raw(to), greater, raw(to), raw(v));
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
UMBRA78_LANES std::uint64_t drawn_of_64(const hw::Depth16* at, hw::Depth16 background) {
    const __m512i none = _mm512_set1_epi16((short)background);
    const std::uint64_t low = _mm512_cmpneq_epi16_mask(_mm512_loadu_si512(at), none);
    const std::uint64_t high = _mm512_cmpneq_epi16_mask(_mm512_loadu_si512(at + 32), none);
    return high << 32 | low;
}
UMBRA78_LANES Word pairs(const hw::Depth16* texels, Word address, Mask some) {
    return (Word)_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), some, raw(address), texels,
                                             sizeof(hw::Depth16));
}
UMBRA78_LANES __m512i four(const hw::Depth16* texels, __m256i at, __mmask16 some) {
    return _mm512_mask_i32gather_epi64(_mm512_setzero_si512(), (__mmask8)some, at, texels,
                                       sizeof(hw::Depth16));
}
UMBRA78_LANES __m256i lower(Word v) { return _mm512_castsi512_si256(raw(v)); }
UMBRA78_LANES __m256i upper(Word v) { return _mm512_extracti64x4_epi64(raw(v), 1); }
UMBRA78_LANES void quads(const hw::Depth16* texels, Word address, Mask some, Word* two) {
    two[0] = (Word)four(texels, lower(address), some);
    two[1] = (Word)four(texels, upper(address), (__mmask16)(some >> 8));
}
UMBRA78_LANES __m512i twice(__m256i v) {
    const __m512i wide = _mm512_cvtepu32_epi64(v);
    return _mm512_or_si512(wide, _mm512_slli_epi64(wide, 32));
}
UMBRA78_LANES void widen(Word v, Word* two) {
    two[0] = (Word)twice(lower(v));
    two[1] = (Word)twice(upper(v));
}
UMBRA78_LANES Word narrow(const Word* two) {
    const __m512i a = _mm512_add_epi32(raw(two[0]), _mm512_srli_epi64(raw(two[0]), 32));
    const __m512i b = _mm512_add_epi32(raw(two[1]), _mm512_srli_epi64(raw(two[1]), 32));
    return (Word)_mm512_inserti64x4(_mm512_castsi256_si512(_mm512_cvtepi64_epi32(a)),
                                    _mm512_cvtepi64_epi32(b), 1);
}
UMBRA78_LANES void store_masks(std::uint8_t* at, const Mask* m) {
    _mm_storeu_si128((__m128i*)at, _mm_movm_epi8(*m));
}
UMBRA78_LANES void store_bytes(std::uint8_t* at, const Word* w) {
    _mm_storeu_si128((__m128i*)at, _mm512_cvtepi32_epi8(raw(*w)));
}
UMBRA78_LANES void add(Counter& c, Mask m) { c = _mm_sub_epi8(c, _mm_movm_epi8(m)); }
UMBRA78_LANES std::uint32_t total(Counter c) {
    const __m128i sums = _mm_sad_epu8(c, _mm_setzero_si128());
    return (std::uint32_t)(_mm_extract_epi16(sums, 0) + _mm_extract_epi16(sums, 4));
}

#endif
