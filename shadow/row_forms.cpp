// The table of row forms: shadow/row_body.hpp with the operations of each instruction set of
// x86-64. Only the text between a set's pragmas is compiled for that set: nothing of a standard
// header but <immintrin.h> is named there.
#include "shadow/row_form.hpp"

// Without vector registers (-mgeneral-regs-only) and without a host the plain form stands alone.
#if defined(__x86_64__) && defined(__SSE2__) && __STDC_HOSTED__
#define UMBRA78_HAS_LANES 1
#include <immintrin.h>
#endif

namespace umbra78::shadow {

#ifdef UMBRA78_HAS_LANES
#define UMBRA78_INLINE __attribute__((always_inline))
#define UMBRA78_LANES static inline UMBRA78_INLINE
#define UMBRA78_APART __attribute__((noinline)) static

// --- SSE2: every x86-64 -------------------------------------------------------------------------

namespace sse2 {

#include "shadow/row_sse2.hpp"
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

#include "shadow/row_avx2.hpp"
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

#include "shadow/row_avx512.hpp"
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
constexpr RowForm forms[] = {{"plain", always, plain_row, plain_drawn},
                             {"SSE2", always, sse2::run, sse2::find_drawn},
                             {"AVX2", has_avx2, avx2::run, avx2::find_drawn},
                             {"AVX-512", has_avx512, avx512::run, avx512::find_drawn}};
}  // namespace

#else
namespace {
bool always() { return true; }
constexpr RowForm forms[] = {{"plain", always, plain_row, plain_drawn}};
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
