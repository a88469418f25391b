/* Section 4: views and their matrices, exactly; the bias. */
#include "machine.h"

void axes_from_angles(i64 azimuth, i64 elevation, View *v) {
  i64 sa, ca, se, ce;
  sine_cosine(azimuth, &sa, &ca);
  sine_cosine(elevation, &se, &ce);
  const i64 right[3] = {ca, 0, -sa}, up[3] = {-mul30(sa, se), ce, -mul30(ca, se)},
            back[3] = {mul30(sa, ce), se, mul30(ca, ce)};
  for (int k = 0; k < 3; ++k) v->right[k] = right[k], v->up[k] = up[k], v->back[k] = back[k];
}

static void unit30(const i64 v[3], i64 out[3]) {
  i128 largest = greater(greater(magnitude(v[0]), magnitude(v[1])), magnitude(v[2]));
  for (int k = 0; k < 3; ++k) out[k] = (i64)down(v[k], bits((u128)largest) - 30, HALF_EVEN);
  i64 length = (i64)isqrt((u128)dot(out, out));
  for (int k = 0; k < 3; ++k) out[k] = half_even(out[k] * power(30), length);
}

void axes_from_points(const i64 from[3], const i64 to[3], View *v) {
  const i64 way[3] = {from[0] - to[0], from[1] - to[1], from[2] - to[2]};
  const i64 level[3] = {way[2], 0, -way[0]};
  unit30(way, v->back);
  v->right[0] = (i64)1 << 30, v->right[1] = v->right[2] = 0;
  if (way[0] || way[2]) unit30(level, v->right);
  const i64 *b = v->back, *r = v->right;
  v->up[0] = mul30(b[1], r[2]);
  v->up[1] = mul30(b[2], r[0]) - mul30(b[0], r[2]);
  v->up[2] = -mul30(b[1], r[0]);
}

void origin_of(const View *v, i128 origin[3]) {
  for (int k = 0; k < 3; ++k)
    origin[k] = v->target[k] * power(30) + (i128)v->distance * v->back[k];
}

/* An axis . (p - origin) of (p, 1) in world units, times 2^76. */
static void form(const View *v, const i64 axis[3], int sign, Big out[4]) {
  i128 origin[3];
  origin_of(v, origin);
  out[3] = big(0);
  for (int k = 0; k < 3; ++k) {
    out[k] = big_shift(big(sign * axis[k]), 46);
    out[3] = big_sub(out[3], times(big(origin[k]), sign * axis[k]));
  }
}

void fit_depths(View *v, i64 (*points)[3], int count) {
  i128 origin[3], least = 0, most = 0; /* 2^60 depth */
  origin_of(v, origin);
  for (int n = 0; n < count; ++n) {
    i128 depth = 0;
    for (int k = 0; k < 3; ++k) depth -= v->back[k] * (points[n][k] * power(30) - origin[k]);
    if (!n || depth < least) least = depth;
    if (!n || depth > most) most = depth;
  }
  i64 depth_min = (i64)down(least, 60, FLOOR), depth_max = (i64)down(most, 60, CEILING);
  if (!v->distance) {
    v->far = (i64)greater(greater(v->extent, -depth_min), depth_max + 1);
    v->near = -v->far;
    return;
  }
  v->far = (i64)greater(depth_max + depth_max / 64 + 1, 1024);
  v->near = (i64)greater(depth_min - depth_min / 64 - 1, v->far / 1024);
  if (v->near >= v->far) v->near = v->far / 1024;
}

void world_to_screen(const View *v, const Settings *s, Exact *m) {
  Big right[4], down_[4], depth[4];
  form(v, v->right, 1, right);
  form(v, v->up, -1, down_);
  form(v, v->back, -1, depth);
  i64 range = v->far - v->near, sum = v->far + v->near;
  for (int j = 0; j < 4; ++j) {
    Big one = j == 3 ? big_shift(big(1), 76) : big(0);
    if (!v->distance) { /* over 2^76 extent range */
      m->n[0][j] = times(times(right[j], s->half_px * power(16)), range);
      m->n[1][j] = times(times(down_[j], s->half_px * power(16)), range);
      m->n[2][j] = big_sub(times(depth[j], power(17)), times(one, sum));
      m->n[2][j] = times(times(m->n[2][j], s->half_px), v->extent);
      m->n[3][j] = times(times(one, v->extent), range);
    } else { /* over 2^92 extent range */
      m->n[0][j] = times(times(right[j], s->half_px * power(16)), (i128)v->distance * range);
      m->n[1][j] = times(times(down_[j], s->half_px * power(16)), (i128)v->distance * range);
      m->n[2][j] = big_sub(times(depth[j], sum * power(16)),
                           times(one, (i128)2 * v->far * v->near));
      m->n[2][j] = times(times(m->n[2][j], s->half_px), v->extent);
      m->n[3][j] = times(times(depth[j], v->extent * power(16)), range);
    }
  }
  m->d = big_shift(times(big(v->extent), range), v->distance ? 92 : 76);
}

void screen_to_world(const View *v, const Settings *s, Exact *m) {
  i128 origin[3];
  origin_of(v, origin);
  i64 range = v->far - v->near, sum = v->far + v->near;
  i128 planes = (i128)v->far * v->near;
  for (int j = 0; j < 4; ++j) m->n[3][j] = big(0);
  for (int k = 0; k < 3; ++k) {
    Big *row = m->n[k], back = big(v->back[k]);
    if (!v->distance) { /* over 2^47 half_px */
      row[0] = times(big(v->right[k]), 2 * (i128)v->extent);
      row[1] = times(big(v->up[k]), -2 * (i128)v->extent);
      row[2] = times(back, -range);
      row[3] = times(big_sub(big(2 * origin[k]), times(back, sum)), s->half_px);
    } else { /* over 2^47 half_px distance far near */
      row[0] = times(times(big(v->right[k]), planes), v->extent * power(17));
      row[1] = times(times(big(v->up[k]), planes), v->extent * -power(17));
      row[2] = times(times(big(origin[k]), -range), v->distance * power(16));
      row[3] = big_sub(times(big(origin[k]), sum * power(16)), times(times(back, planes), 1 << 17));
      row[3] = times(row[3], (i128)s->half_px * v->distance);
    }
  }
  m->d = big_shift(big(s->half_px), 47);
  m->n[3][3] = m->d;
  if (!v->distance) return;
  m->d = times(times(m->d, v->distance), planes);
  m->n[3][2] = times(big_shift(big(-range), 62), v->distance);
  m->n[3][3] = times(big_shift(big(sum), 62), (i128)s->half_px * v->distance);
}

void product(const Exact *a, const Exact *b, Exact *m) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      m->n[i][j] = big(0);
      for (int k = 0; k < 4; ++k)
        m->n[i][j] = big_add(m->n[i][j], big_mul(a->n[i][k], b->n[k][j]));
    }
  m->d = big_mul(a->d, b->d);
}

i64 bias_quanta(const View *v, i64 bias, i64 unit, const Settings *s) {
  if (unit == QUANTA) return bias;
  Big n = big_shift(big(bias), (int)s->z_bits + 16), d = big(v->far - v->near);
  if (v->distance) {
    n = times(n, (i128)v->far * v->near);
    d = times(d, (i128)v->distance * v->distance);
  }
  if (unit == TEXELS) {
    n = times(n, v->extent);
    d = big_shift(times(d, s->half_px), 16);
  }
  return (i64)big_round(n, d, HALF_EVEN);
}

void observer_to_light(const View *observer, const View *light, i64 quanta, const Settings *s,
                       Exact *m) {
  Exact to_screen, to_world;
  world_to_screen(light, s, &to_screen);
  screen_to_world(observer, s, &to_world);
  product(&to_screen, &to_world, m);
  /* Row Z less bias / 2^depth_fraction of row W, all of it times 2^shift. */
  int shift = 16 + (int)s->depth_fraction;
  for (int j = 0; j < 4; ++j) {
    Big bias = times(m->n[3][j], quanta);
    for (int i = 0; i < 4; ++i) m->n[i][j] = big_shift(m->n[i][j], shift);
    m->n[2][j] = big_sub(m->n[2][j], bias);
  }
  m->d = big_shift(m->d, shift);
}
