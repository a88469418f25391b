/* Integers of up to 3072 bits, in sign and magnitude, for the exact matrices of section 4. */
#include <string.h>

#include "machine.h"

static Big trimmed(Big a) {
  while (a.n && !a.w[a.n - 1]) --a.n;
  if (!a.n) a.sign = 0;
  return a;
}

Big big(i128 a) {
  Big r = {.sign = a < 0 ? -1 : 1, .n = 4};
  u128 m = a < 0 ? -(u128)a : (u128)a;
  for (int k = 0; k < 4; ++k, m >>= 32) r.w[k] = (uint32_t)m;
  return trimmed(r);
}

static int compare_magnitudes(const Big *a, const Big *b) {
  if (a->n != b->n) return a->n < b->n ? -1 : 1;
  for (int k = a->n - 1; k >= 0; --k)
    if (a->w[k] != b->w[k]) return a->w[k] < b->w[k] ? -1 : 1;
  return 0;
}

static Big sum_of_magnitudes(const Big *a, const Big *b, int sign) {
  Big r = {.sign = sign};
  u64 carry = 0;
  for (r.n = 0; r.n < a->n || r.n < b->n || carry; ++r.n) {
    if (r.n == LIMBS) fail("a number outgrows %d bits", 32 * LIMBS);
    carry += (u64)(r.n < a->n ? a->w[r.n] : 0) + (r.n < b->n ? b->w[r.n] : 0);
    r.w[r.n] = (uint32_t)carry;
    carry >>= 32;
  }
  return trimmed(r);
}

/* |a| - |b| of |a| >= |b| */
static Big difference_of_magnitudes(const Big *a, const Big *b, int sign) {
  Big r = {.sign = sign, .n = a->n};
  u64 borrow = 0;
  for (int k = 0; k < a->n; ++k) {
    u64 d = (u64)a->w[k] - (k < b->n ? b->w[k] : 0) - borrow;
    r.w[k] = (uint32_t)d;
    borrow = d >> 63;
  }
  return trimmed(r);
}

Big big_add(Big a, Big b) {
  if (!a.sign) return b;
  if (!b.sign) return a;
  if (a.sign == b.sign) return sum_of_magnitudes(&a, &b, a.sign);
  return compare_magnitudes(&a, &b) >= 0 ? difference_of_magnitudes(&a, &b, a.sign)
                                         : difference_of_magnitudes(&b, &a, b.sign);
}

Big big_sub(Big a, Big b) {
  b.sign = -b.sign;
  return big_add(a, b);
}

Big big_mul(Big a, Big b) {
  Big r = {.sign = a.sign * b.sign, .n = a.n + b.n};
  if (r.n > LIMBS) fail("a number outgrows %d bits", 32 * LIMBS);
  for (int i = 0; i < a.n; ++i) {
    u64 carry = 0;
    for (int j = 0; j < b.n; ++j) {
      carry += (u64)a.w[i] * b.w[j] + r.w[i + j];
      r.w[i + j] = (uint32_t)carry;
      carry >>= 32;
    }
    r.w[i + b.n] = (uint32_t)carry;
  }
  return trimmed(r);
}

Big times(Big a, i128 b) { return big_mul(a, big(b)); }

Big big_shift(Big a, int n) {
  Big r = {.sign = a.sign, .n = a.n + n / 32 + 1};
  if (r.n > LIMBS) fail("a number outgrows %d bits", 32 * LIMBS);
  for (int k = 0; k < a.n; ++k) {
    u64 both = (u64)a.w[k] << n % 32;
    r.w[k + n / 32] |= (uint32_t)both;
    r.w[k + n / 32 + 1] = (uint32_t)(both >> 32);
  }
  return trimmed(r);
}

int big_bits(const Big *a) { return a->n ? 32 * (a->n - 1) + bits(a->w[a->n - 1]) : 0; }

int big_compare(Big a, Big b) { return big_sub(a, b).sign; }

static void halve(Big *a) {
  for (int k = 0; k < a->n; ++k)
    a->w[k] = a->w[k] >> 1 | (k + 1 < a->n ? a->w[k + 1] << 31 : 0);
  *a = trimmed(*a);
}

i128 big_round(Big a, Big b, Rounding r) {
  if (!b.sign) fail("a division by 0");
  bool negative = a.sign * b.sign < 0;
  int more = big_bits(&a) - big_bits(&b);
  if (more > 124) return negative ? -power(126) : power(126);
  i128 q = 0;
  a.sign = a.sign ? 1 : 0;
  b.sign = 1;
  if (more >= 0) {
    Big part = big_shift(b, more);
    for (int k = more; k >= 0; --k, halve(&part))
      if (compare_magnitudes(&a, &part) >= 0) {
        a = difference_of_magnitudes(&a, &part, 1);
        q += power(k);
      }
  }
  Big twice = big_shift(a, 1);
  return rounded(negative, q, compare_magnitudes(&twice, &b), a.n == 0, r);
}
