/* Section 25: a light inside the view, in six sectors. */
#include "machine.h"

typedef struct {
  i64 d[3][4], z[4], one;
  int e_d, e_z, axis, sign;
} Sector;

void sector_view(const i64 p[3], i64 distance, int sector, View *v) {
  i64 target[3] = {p[0], p[1], p[2]};
  target[sector / 2] += sector % 2 ? -distance : distance;
  axes_from_points(p, target, v);
  for (int k = 0; k < 3; ++k) v->target[k] = target[k];
  v->distance = v->extent = distance;
}

static i128 row(const i64 c[4], i64 one, const Settings *s, const i64 p[3]) {
  Loaded m = {.one = one};
  i128 acc[4];
  for (int j = 0; j < 4; ++j) m.c[0][j] = c[j];
  accumulate(&m, s, p, acc);
  return acc[0];
}

/* Section 5's statuses with the sector's four rows. */
static Status in_sector(const void *state, const Settings *s, const i64 p[3], i64 out[3]) {
  static const int right[6][2] = {{2, 1}, {2, -1}, {0, 1}, {0, 1}, {0, -1}, {0, 1}},
                   lower[6][2] = {{1, -1}, {1, -1}, {2, -1}, {2, 1}, {1, -1}, {1, -1}};
  const Sector *q = state;
  int k = 2 * q->axis + (q->sign < 0);
  Loaded m = {.affine = false, .e = {0, 0, q->e_z, q->e_d}};
  i128 a[3], acc[4];
  for (int n = 0; n < 3; ++n) a[n] = row(q->d[n], q->one, s, p);
  acc[0] = right[k][1] * a[right[k][0]];
  acc[1] = lower[k][1] * a[lower[k][0]];
  acc[2] = row(q->z, q->one, s, p);
  acc[3] = q->sign * a[q->axis];
  /* results() has 2^fraction_bits of X and Y; the window's half is 2^(xy_bits - 1) pixels. */
  m.e[0] = m.e[1] = q->e_d + (int)s->xy_bits - 1;
  return results(&m, s, acc, out);
}

static bool find_sector(Sector *q, const Settings *s, const i64 p[3]) {
  i128 best = 0;
  for (int a = 0; a < 3; ++a) {
    i128 acc = row(q->d[a], q->one, s, p);
    if (magnitude(acc) <= best) continue;
    best = magnitude(acc);
    q->axis = a;
    q->sign = acc < 0 ? -1 : 1;
  }
  return best != 0;
}

static void load_directions(const View *observer, const i64 p[3], const Settings *s, Sector *q) {
  static const int rows[3] = {0, 1, 2};
  Exact m;
  screen_to_world(observer, s, &m);
  for (int j = 0; j < 4; ++j)
    for (int a = 0; a < 3; ++a)
      m.n[a][j] = big_sub(big_shift(m.n[a][j], 16), times(m.n[3][j], p[a]));
  m.d = big_shift(m.d, 16);
  q->one = s->one_word;
  if (!load_rows(&m, rows, 3, s, (int)s->input_fraction, s->one_word, &m.d, q->d, &q->e_d))
    fail("a sector's rows are refused (section 25)");
}

void sector_mask(const Observer *o, const View *observer, const View *views, const Light *lights,
                 const i64 p[3], const Settings *s, const int32_t *dither, int32_t *mask) {
  Sector q;
  i64 z[6][4];
  int e[6], third = 2;
  load_directions(observer, p, s, &q);
  for (int k = 0; k < 6; ++k) {
    Exact m;
    observer_to_light(observer, views + k, bias_quanta(views + k, s->bias, s->bias_unit, s), s, &m);
    if (!load_rows(&m, &third, 1, s, (int)s->input_fraction, s->one_word, &m.d, z + k, e + k) ||
        magnitude(e[k] - q.e_d) > 42)
      fail("a sector's rows are refused (section 25)");
  }
  for (i64 pixel = 0; pixel < s->pixels; ++pixel) {
    i64 words[3], px = pixel % s->size_px, py = pixel / s->size_px;
    mask[pixel] = 0;
    if (o->observer_z[pixel] == s->background_code) continue;
    input_words(px, py, o->observer_z[pixel], s, words);
    if (!find_sector(&q, s, words)) continue;
    int k = 2 * q.axis + (q.sign < 0);
    for (int j = 0; j < 4; ++j) q.z[j] = z[k][j];
    q.e_z = e[k];
    mask[pixel] = pixel_darkness(o, lights + k, s, in_sector, &q, px, py, dither, true);
  }
}
