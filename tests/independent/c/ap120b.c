/* Section 18: the post-process on the AP-120B. */
#include "machine.h"

typedef struct {
  i64 m;
  int e;
} Word; /* m 2^(e - 539) */
enum { ONE = 539, MOST = (1 << 27) - 1 };

/* The word of sign q 2^e, with something less than 1 beside q if it is not exact. */
static Word fl(bool negative, u128 q, bool exact, int e) {
  if (!q) return (Word){0, 0};
  int drop = bits(q) - 27;
  u128 m = drop > 0 ? q >> drop : q << -drop, rest = drop > 0 ? q - (m << drop) : 0;
  if (drop > 0) {
    u128 half = (u128)1 << (drop - 1);
    m += rest > half || (rest == half && (!exact || (m & 1)));
  }
  if (m >> 27) m >>= 1, ++drop;
  e += 539 + drop;
  if (e < 0) return (Word){0, 0};
  if (e > 1023) m = MOST, e = 1023;
  return (Word){negative ? -(i64)m : (i64)m, e};
}

static Word whole(i64 m) { return (Word){m, ONE}; }

static Word add(Word a, Word b) {
  if (!a.m || !b.m)
    return a.m ? fl(a.m < 0, (u128)magnitude(a.m), true, a.e - 539)
               : fl(b.m < 0, (u128)magnitude(b.m), true, b.e - 539);
  if (a.e < b.e) {
    Word t = a;
    a = b;
    b = t;
  }
  int apart = a.e - b.e;
  /* Beyond 80 places only the sign of the smaller one matters. */
  i128 sum = apart > 80 ? a.m * power(80) + (b.m < 0 ? -1 : 1) : a.m * power(apart) + b.m;
  return fl(sum < 0, (u128)magnitude(sum), true, a.e - (apart > 80 ? 80 : apart) - 539);
}

static Word negated(Word a) { return (Word){-a.m, a.e}; }
static Word sub(Word a, Word b) { return add(a, negated(b)); }

static Word mul(Word a, Word b) {
  i128 p = (i128)a.m * b.m;
  return fl(p < 0, (u128)magnitude(p), true, a.e + b.e - 2 * 539);
}

static Word quotient_of(Word a, Word b) {
  if (!a.m) return (Word){0, 0};
  if (!b.m) return (Word){a.m < 0 ? -MOST : MOST, 1023};
  i128 n = magnitude(a.m) * power(80), d = magnitude(b.m);
  return fl((a.m < 0) != (b.m < 0), (u128)(n / d), n % d == 0, a.e - b.e - 80);
}

static i64 fixt(Word a) { return (i64)down(a.m, 539 - a.e, TO_ZERO); }
static bool below(Word a, Word b) { return sub(a, b).m < 0; }

static Word float_exact(Big n, Big d) {
  if (!n.sign) return (Word){0, 0};
  bool negative = n.sign * d.sign < 0;
  n.sign = d.sign = 1;
  int up = 60 + big_bits(&d) - big_bits(&n);
  if (up > 0)
    n = big_shift(n, up);
  else
    d = big_shift(d, -up);
  i128 q = big_round(n, d, FLOOR);
  return fl(negative, (u128)q, big_compare(big_mul(big(q), d), n) == 0, -up);
}

/* The matrix that takes (px, py, code - depth_offset, 1) to the map's texels and codes. */
static bool load_words(const Exact *m, const Settings *s, Word w[4][4]) {
  Big n[4][4], d = m->d;
  bool affine = !m->n[3][0].sign && !m->n[3][1].sign && !m->n[3][2].sign;
  int up = (int)(s->depth_fraction > 0 ? s->depth_fraction : 0), less = up - (int)s->depth_fraction;
  i64 centre = s->registration == REGISTER_CENTRE;
  if (affine) d = m->n[3][3];
  for (int r = 0; r < 4; ++r) { /* all of it times 2^(1 + up) */
    Big both = big_add(m->n[r][0], m->n[r][1]);
    n[r][0] = big_shift(m->n[r][0], 1 + up);
    n[r][1] = big_shift(m->n[r][1], 1 + up);
    n[r][2] = big_shift(m->n[r][2], 1 + less);
    n[r][3] =
        big_add(big_shift(m->n[r][3], 1 + up), big_shift(times(both, centre - 2 * s->half_px), up));
  }
  for (int r = 0; r < 4; ++r)
    for (int j = 0; j < 4; ++j) {
      Big entry =
          r == 2 ? big_add(big_shift(n[2][j], up), times(n[3][j], s->depth_offset * power(less)))
                 : n[r][j];
      if (r < 2) entry = big_add(entry, times(n[3][j], s->half_px));
      w[r][j] = float_exact(entry, big_shift(d, 1 + up + (r == 2 ? less : 0)));
    }
  return affine;
}

static Word texel(const int32_t *map, const Settings *s, i64 x, i64 y) {
  bool out = x < 0 || y < 0 || x >= s->size_px || y >= s->size_px;
  return whole(out ? s->background_code : map[y * s->size_px + x]);
}

static Word lerp(Word a, Word b, Word t) { return add(a, mul(t, sub(b, a))); }

static bool shadowed(const int32_t *map, const Settings *s, Word x, Word y, Word k) {
  Word size = whole(s->size_px), deepest = whole(s->deepest_drawn), half = {1, ONE - 1};
  if (x.m < 0 || !below(x, size) || y.m < 0 || !below(y, size)) return false;
  if (k.m < 0 || below(deepest, k)) return false;
  bool nearest = s->lookup == NEAREST;
  Word four[4], u = add(x, half), v = add(y, half);
  i64 i = fixt(u), j = fixt(v);
  for (int n = 0; n < 4 && !nearest; ++n) {
    four[n] = texel(map, s, i - 1 + n % 2, j - 1 + n / 2);
    if (s->background == FALL_BACK && four[n].m == s->background_code) nearest = true;
  }
  if (nearest) return below(texel(map, s, fixt(x), fixt(y)), k);
  Word f = sub(u, whole(i)), g = sub(v, whole(j));
  return below(lerp(lerp(four[0], four[1], f), lerp(four[2], four[3], f), g), k);
}

void array_mask(const int32_t *observer_z, const int32_t *map, const Exact *m, const Settings *s,
                const int32_t *dither, int32_t *mask) {
  Word w[4][4], p[4];
  bool affine = load_words(m, s, w);
  for (i64 pixel = 0; pixel < s->pixels; ++pixel) {
    mask[pixel] = 0;
    if (observer_z[pixel] == s->background_code) continue;
    const Word at[4] = {whole(pixel % s->size_px), whole(pixel / s->size_px),
                        whole(observer_z[pixel] - s->depth_offset), whole(1)};
    for (int r = 0; r < 4; ++r)
      p[r] = add(add(add(mul(w[r][0], at[0]), mul(w[r][1], at[1])), mul(w[r][2], at[2])),
                 mul(w[r][3], at[3]));
    if (!affine && p[3].m <= 0) continue;
    for (int r = 0; r < 3 && !affine; ++r) p[r] = quotient_of(p[r], p[3]);
    for (int k = 0; k < 2; ++k)
      p[k] = add(p[k], (Word){dither[2 * pixel + k], ONE - (int)s->fraction_bits});
    mask[pixel] = shadowed(map, s, p[0], p[1], p[2]) ? 255 : 0;
  }
}
