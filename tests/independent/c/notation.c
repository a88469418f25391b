/* Section 1: roundings, roots, the hash. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "machine.h"

void fail(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  exit(1);
}

void *zeroed(size_t count, size_t size) {
  void *p = calloc(count ? count : 1, size);
  if (!p) fail("out of memory");
  return p;
}

i128 power(int n) { return (i128)1 << n; }

/* A quotient's magnitude q and what is left of it: `half` says how that compares with 1/2. */
i128 rounded(bool negative, i128 q, int half, bool exact, Rounding r) {
  bool more = false;
  switch (r) {
    case FLOOR: more = negative && !exact; break;
    case CEILING: more = !negative && !exact; break;
    case TO_ZERO: break;
    case HALF_UP: more = half > 0 || (half == 0 && !negative); break;
    case HALF_TO_ZERO: more = half > 0; break;
    case HALF_AWAY: more = half >= 0; break;
    case HALF_EVEN: more = half > 0 || (half == 0 && (q & 1)); break;
  }
  q += more;
  return negative ? -q : q;
}

i128 divide(i128 a, i128 b, Rounding r) {
  if (b < 0) a = -a, b = -b;
  bool negative = a < 0;
  i128 m = negative ? -a : a, q, rest;
  if (m <= INT64_MAX && b <= INT64_MAX) {
    q = (i64)m / (i64)b;
    rest = (i64)m % (i64)b;
  } else {
    q = m / b;
    rest = m % b;
  }
  return rounded(negative, q, rest > b - rest ? 1 : rest == b - rest ? 0 : -1, rest == 0, r);
}

i64 half_up(i128 a, i128 b) { return (i64)divide(a, b, HALF_UP); }
i64 half_even(i128 a, i128 b) { return (i64)divide(a, b, HALF_EVEN); }

i128 down(i128 a, int n, Rounding r) {
  if (n <= 0) return a * power(-n);
  if (n > 126) return divide(a > 0 ? 1 : a < 0 ? -1 : 0, 4, r);
  if (r == HALF_UP) return (a >> n) + (a >> (n - 1) & 1);
  return divide(a, power(n), r);
}

i128 quotient(i128 a, int up, i128 b, Rounding r) {
  if (up >= 0 ? bits((u128)magnitude(a)) + up <= 125 : bits((u128)magnitude(b)) - up <= 125)
    return up >= 0 ? divide(a * power(up), b, r) : divide(a, b * power(-up), r);
  return up >= 0 ? big_round(big_shift(big(a), up), big(b), r)
                 : big_round(big(a), big_shift(big(b), -up), r);
}

int bits(u128 a) {
  u64 high = (u64)(a >> 64), low = (u64)a;
  return high ? 128 - __builtin_clzll(high) : low ? 64 - __builtin_clzll(low) : 0;
}

static u64 small_root(u64 a) {
  u64 root = 0;
  for (u64 bit = a ? (u64)1 << ((bits(a) - 1) & ~1) : 0; bit; bit >>= 2)
    if (a >= root + bit) {
      a -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  return root;
}

u64 isqrt(u128 a) {
  if (bits(a) <= 64) return small_root((u64)a);
  u128 root = 0;
  for (u128 bit = (u128)1 << ((bits(a) - 1) & ~1); bit; bit >>= 2)
    if (a >= root + bit) {
      a -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  return (u64)root;
}

bool fits(i128 word, int n) { return -power(n - 1) <= word && word < power(n - 1); }

i128 clamp(i128 a, i128 least, i128 most) { return a < least ? least : a > most ? most : a; }
i128 magnitude(i128 a) { return a < 0 ? -a : a; }
i128 greater(i128 a, i128 b) { return a > b ? a : b; }

i128 dot(const i64 a[3], const i64 b[3]) {
  return (i128)a[0] * b[0] + (i128)a[1] * b[1] + (i128)a[2] * b[2];
}

u64 fnv(const int32_t *values, size_t count, int size, u64 h) {
  for (size_t k = 0; k < count; ++k)
    for (int byte = size - 1; byte >= 0; --byte)
      h = (h ^ ((uint32_t)values[k] >> 8 * byte & 255)) * 0x100000001b3u;
  return h;
}
