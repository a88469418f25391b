/* Section 5: the transform unit. */
#include "machine.h"

static int log2_of(i64 one) { return bits((u128)one) - 1; }

/* A word of column j at an exponent: M 2^(coefficient_bits - 2 - exponent), M = n / d. */
static i128 word_at(const Big *n, const Big *d, int j, int exponent, const Settings *s,
                    int fraction, i64 one) {
  int up = (int)s->coefficient_bits - 2 - exponent + (j == 3 ? fraction - log2_of(one) : 0);
  return big_round(up > 0 ? big_shift(*n, up) : *n, up < 0 ? big_shift(*d, -up) : *d,
                   (Rounding)s->coefficient_rounding);
}

/* Rows with one common exponent, the smallest at which all words fit. */
bool load_rows(const Exact *m, const int *rows, int count, const Settings *s, int fraction, i64 one,
               const Big *d, i64 (*c)[4], int *e) {
  bool zeros = true;
  for (int r = 0; r < count; ++r)
    for (int j = 0; j < 4; ++j) zeros = zeros && !m->n[rows[r]][j].sign;
  int least = zeros ? 0 : -31, most = zeros ? 0 : 32;
  while (least < most) { /* what fits at an exponent fits at every greater one */
    int middle = least + (most - least) / 2;
    bool all = true;
    for (int r = 0; r < count && all; ++r)
      for (int j = 0; j < 4 && all; ++j)
        all = fits(word_at(&m->n[rows[r]][j], d, j, middle, s, fraction, one),
                   (int)s->coefficient_bits);
    if (all) most = middle;
    if (!all) least = middle + 1;
  }
  if (least > 31) return false;
  for (int r = 0; r < count; ++r)
    for (int j = 0; j < 4; ++j)
      c[r][j] = (i64)word_at(&m->n[rows[r]][j], d, j, least, s, fraction, one);
  *e = least;
  return true;
}

bool load(const Exact *m, const Settings *s, int fraction, i64 one, Loaded *loaded) {
  const Big *w = m->n[3];
  loaded->affine = !w[0].sign && !w[1].sign && !w[2].sign;
  loaded->fraction = fraction;
  loaded->one = one;
  if (loaded->affine && !w[3].sign) return false;
  const Big *d = loaded->affine ? &w[3] : &m->d;
  for (int r = 0; r < 4; ++r)
    if (!load_rows(m, &r, 1, s, fraction, one, d, loaded->c + r, loaded->e + r)) return false;
  for (int r = 0; r < 3 && !loaded->affine; ++r)
    if (magnitude(loaded->e[r] - loaded->e[3]) > 42) return false;
  return true;
}

void accumulate(const Loaded *m, const Settings *s, const i64 p[3], i128 acc[4]) {
  for (int r = 0; r < 4; ++r) {
    const i64 word[4] = {p[0], p[1], p[2], m->one};
    acc[r] = 0;
    for (int j = 0; j < 4; ++j) {
      i128 term = (i128)m->c[r][j] * word[j];
      int n = (int)s->dropped_bits;
      acc[r] += n ? down(term, n, (Rounding)s->product_rounding) * power(n) : term;
    }
  }
}

Status results(const Loaded *m, const Settings *s, const i128 given[4], i64 out[3]) {
  const int fraction[3] = {(int)s->fraction_bits, (int)s->fraction_bits, (int)s->depth_fraction};
  Rounding r = (Rounding)s->transform_rounding;
  int unit = (int)s->coefficient_bits - 2;
  i128 acc[4] = {given[0], given[1], given[2], given[3]};
  if (m->affine) {
    for (int k = 0; k < 3; ++k)
      out[k] = (i64)down(acc[k], unit + m->fraction - fraction[k] - m->e[k], r);
    return OK;
  }
  for (int k = 0; k < 4 && s->divide_order == ROUND_FIRST; ++k) acc[k] = down(acc[k], unit, r);
  if (acc[3] <= 0) return DIVISOR_NOT_POSITIVE;
  for (int k = 0; k < 3; ++k) {
    i128 q = quotient(acc[k], fraction[k] + m->e[k] - m->e[3], acc[3], r);
    if (!fits(q, 1 + (int)(k < 2 ? s->xy_bits + s->fraction_bits : s->z_bits))) return OVERFLOWED;
    out[k] = (i64)q;
  }
  return OK;
}

Status transform(const Loaded *m, const Settings *s, const i64 p[3], i64 out[3]) {
  i128 acc[4];
  accumulate(m, s, p, acc);
  return results(m, s, acc, out);
}
