// One text of plain loops, compiled once for each instruction set that a program may meet.
//
// A source file names the text in UMBRA78_LANES_TEXT and includes this header within its
// namespace. The text then stands in plain_lanes, for the processor that the build is for, and on
// x86-64 in avx2_lanes and avx512_lanes, too. UMBRA78_LANE_SETS(X) calls X(namespace, name), the
// fastest last; the namespace's supported() says whether this processor has the set.
//
// Without vector registers (-mgeneral-regs-only) and without a host there is plain_lanes alone. A
// text defines static functions over plain arrays and names no template that is not compiled
// before: the linker could take one set's copy of it for all.
#ifdef UMBRA78_LANES_TEXT

namespace plain_lanes {
static bool supported() { return true; }
#include UMBRA78_LANES_TEXT
}  // namespace plain_lanes

#if defined(__x86_64__) && defined(__SSE2__) && __STDC_HOSTED__

namespace avx2_lanes {
static bool supported() { return __builtin_cpu_supports("avx2") != 0; }
}
namespace avx512_lanes {
static bool supported() {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512dq") != 0;
}
}
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2_lanes {
#include UMBRA78_LANES_TEXT
}  // namespace avx2_lanes
#ifdef __clang__
#pragma clang attribute pop
#pragma clang attribute push(__attribute__((target("avx512f,avx512bw,avx512vl,avx512dq"))), \
                             apply_to = function)
#else
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f,avx512bw,avx512vl,avx512dq,prefer-vector-width=512")
#endif
namespace avx512_lanes {
#include UMBRA78_LANES_TEXT
}  // namespace avx512_lanes
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#undef UMBRA78_LANE_SETS
#define UMBRA78_LANE_SETS(X) X(plain_lanes, "plain") X(avx2_lanes, "AVX2") \
    X(avx512_lanes, "AVX-512")
#else
#undef UMBRA78_LANE_SETS
#define UMBRA78_LANE_SETS(X) X(plain_lanes, "plain")
#endif
#undef UMBRA78_LANES_TEXT

#endif
