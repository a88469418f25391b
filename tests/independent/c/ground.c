/* Section 26: shadows on one plane. */
#include "machine.h"

typedef struct {
  i64 o[3], u[3], v[3];
  i128 n[3];
} Base;

static Base base(const Patch *ground) {
  Base b;
  for (int k = 0; k < 3; ++k) {
    b.o[k] = ground->p[0][k];
    b.u[k] = ground->p[3][k] - b.o[k];
    b.v[k] = ground->p[12][k] - b.o[k];
  }
  cross3(b.u, b.v, b.n);
  return b;
}

static Big along(const i128 n[3], const i128 p[3]) {
  Big sum = big(0);
  for (int k = 0; k < 3; ++k) sum = big_add(sum, times(big(n[k]), p[k]));
  return sum;
}

/* Heights and rises are times 2^78, and n is in words: 2^32 times the text's. */
static Big height(const Base *b, const i64 p[3]) {
  const i128 from[3] = {p[0] - b->o[0], p[1] - b->o[1], p[2] - b->o[2]};
  return big_shift(along(b->n, from), 30);
}

static Big rise_of(const Base *b, const View *light) {
  i128 way[3] = {light->back[0], light->back[1], light->back[2]};
  if (!light->distance) return big_shift(along(b->n, way), 16);
  origin_of(light, way);
  for (int k = 0; k < 3; ++k) way[k] -= b->o[k] * power(30);
  return along(b->n, way);
}

bool shadow_matrix(const View *observer, const View *light, const Patch *ground, i64 (*points)[3],
                   int count, const Settings *s, Exact *m) {
  Base b = base(ground);
  const i128 o[3] = {b.o[0], b.o[1], b.o[2]};
  i128 source[3] = {light->back[0] * power(16), light->back[1] * power(16),
                    light->back[2] * power(16)};
  Big rise = rise_of(&b, light), form[4], highest = big(0);
  if (!rise.sign) return false;
  if (rise.sign < 0) {
    for (int k = 0; k < 3; ++k) b.n[k] = -b.n[k];
    rise.sign = 1;
  }
  for (int k = 0; k < 3; ++k) form[k] = big_shift(big(b.n[k]), 46);
  form[3] = big_sub(big(0), big_shift(along(b.n, o), 30));
  if (light->distance) origin_of(light, source);
  Exact flat, screen; /* flat: times 2^46 */
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Big whole = i == j ? big_shift(rise, 46) : big(0);
      Big part = i < 3             ? times(form[j], source[i])
                 : light->distance ? big_shift(form[j], 46)
                                   : big(0);
      flat.n[i][j] = big_sub(whole, part);
    }
  flat.d = big_shift(rise, 46);
  world_to_screen(observer, s, &screen);
  product(&screen, &flat, m);
  for (int k = 0; k < count; ++k) {
    Big h = height(&b, points[k]);
    if (big_compare(h, highest) > 0) highest = h;
  }
  if (!highest.sign) highest = big_shift(along(b.n, b.n), 14);
  Big reach = light->distance ? times(rise, 64) : times(highest, 2), fixed = big_shift(reach, 16);
  i64 near = observer->distance ? observer->near : 65536;
  for (int j = 0; j < 4; ++j) {
    Big h = big_mul(times(form[j], 2 * (i128)s->half_px * near), m->d);
    m->n[2][j] = big_sub(h, big_mul(times(m->n[3][j], s->half_px), fixed));
    for (int i = 0; i < 4; ++i)
      if (i != 2) m->n[i][j] = big_mul(m->n[i][j], fixed);
  }
  m->d = big_mul(m->d, fixed);
  return true;
}

void ellipse(const Patch *ground, i64 (*points)[3], int count, i64 centre[3], i64 a[3], i64 b[3]) {
  Base e = base(ground);
  i128 uu = dot(e.u, e.u), vv = dot(e.v, e.v), uv = dot(e.u, e.v);
  Big g = big_sub(times(big(uu), vv), times(big(uv), uv)), least[2], most[2];
  for (int n = 0; n < count; ++n) {
    const i64 w[3] = {points[n][0] - e.o[0], points[n][1] - e.o[1], points[n][2] - e.o[2]};
    i128 wu = dot(w, e.u), wv = dot(w, e.v);
    const Big at[2] = {big_sub(times(big(wu), vv), times(big(wv), uv)),
                       big_sub(times(big(wv), uu), times(big(wu), uv))};
    for (int k = 0; k < 2; ++k) {
      if (!n || big_compare(at[k], least[k]) < 0) least[k] = at[k];
      if (!n || big_compare(at[k], most[k]) > 0) most[k] = at[k];
    }
  }
  Big twice = times(g, 2);
  for (int k = 0; k < 3; ++k) {
    Big sum = big_add(times(big_add(least[0], most[0]), e.u[k]),
                      times(big_add(least[1], most[1]), e.v[k]));
    centre[k] = e.o[k] + (i64)big_round(sum, twice, HALF_EVEN);
    a[k] = (i64)big_round(times(big_sub(most[0], least[0]), e.u[k]), twice, HALF_EVEN);
    b[k] = (i64)big_round(times(big_sub(most[1], least[1]), e.v[k]), twice, HALF_EVEN);
  }
}

Patch ellipse_patch(const i64 centre[3], const i64 a[3], const i64 b[3], int number) {
  Patch p;
  for (int n = 0; n < 16; ++n) {
    i64 sine, cosine;
    arc(number, n % 4, &sine, &cosine);
    for (int k = 0; k < 3; ++k)
      p.p[n][k] =
          centre[k] + half_even(n / 4 * ((i128)a[k] * cosine + (i128)b[k] * sine), 3 * power(30));
  }
  return p;
}
