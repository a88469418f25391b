/* Section 14: words with a W, the block rule with it, corners divided. */
#include "machine.h"

/* Section 6's raster words with W = 1, or section 14's words of 44 bits. */
void screen_words(const Loaded *m, const Settings *s, const i64 object[3], i64 place[4]) {
  const int out[3] = {13, 13, (int)(s->depth_fraction + s->depth_guard)};
  int common = m->e[0], unit = (int)s->coefficient_bits - 2, up = 44 - (unit + 20);
  Rounding round = (Rounding)s->transform_rounding;
  for (int r = 1; r < 4; ++r)
    if (m->e[r] > common) common = m->e[r];
  for (int r = 0; r < 4; ++r) {
    i128 acc = dot(m->c[r], object) + (i128)m->c[r][3] * m->one;
    if (!m->affine) place[r] = (i64)down(acc, common - up - m->e[r], round);
    else if (r < 3) place[r] = (i64)down(acc, unit + m->fraction - out[r] - m->e[r], round);
    else place[r] = 1;
  }
}

static Component combined(const Component *x, i64 c, const Component *w) {
  Component r;
  for (int part = 0; part < 4; ++part)
    for (int k = 0; k < 4; ++k) r.v[part][k] = x->v[part][k] - c * w->v[part][k];
  return r;
}

static i64 whole(const Component *x, const Component *w) {
  return (i64)divide(x->v[F][0], w->v[F][0], FLOOR);
}

static const i64 huge_word = (i64)1 << HUGE_BITS;

typedef struct { int down, out; i64 w_min; } Scaled;

static i128 scaled(const Scaled *q, i64 v) { return (v >> q->down) + 1; }

static i128 over(const Scaled *q, i64 v) {
  i128 wide = scaled(q, v);
  if (q->out > 0 && bits((u128)magnitude(wide)) + q->out > 100) wide = huge_word;
  else wide = clamp(down(wide, -q->out, CEILING), -huge_word, huge_word);
  return divide(wide, q->w_min, FLOOR) + 1;
}

static Bounds of_quotient(const Component *x, const Component *w, const Bounds *bw,
                          const Scaled *q) {
  i64 centre = (i64)clamp(whole(x, w), -4096, 4096);
  Component about = combined(x, centre, w);
  Bounds a = bounds(&about), b;
  i128 reach = over(q, -a.min > a.max ? -a.min : a.max);
  b.min = (i64)(down(centre, -q->out, FLOOR) - reach);
  b.max = (i64)(down(centre, -q->out, CEILING) + reach);
  for (int k = 0; k < 2; ++k) {
    i128 part[2]; /* times() of W's slope and bend */
    for (int n = 0; n < 2; ++n) {
      i128 of_w = scaled(q, n ? bw->bend[k] : bw->slope[k]);
      part[n] = reach >= 1 << 26 || of_w >= (i64)1 << 31
                    ? huge_word : divide(reach * of_w, q->w_min, FLOOR) + 1;
    }
    i128 slope = over(q, a.slope[k]) + part[0], steep = scaled(q, bw->slope[k]);
    i128 mixed = slope >= 1 << 28 || steep >= 1 << 30
                     ? huge_word : divide(slope * steep, 4 * (i128)q->w_min, FLOOR) + 1;
    b.slope[k] = (i64)slope;
    b.bend[k] = (i64)(over(q, a.bend[k]) + part[1] + mixed);
  }
  return b;
}

Fate quotient_bounds(const Component c[4], const Settings *s, Bounds b[3]) {
  Bounds w = bounds(c + 3);
  if (w.max <= 0) return OUTSIDE;
  bool crosses = w.min <= 0, far_out = false;
  for (int k = 0; k < 3 && !crosses; ++k)
    far_out = far_out || magnitude(whole(c + k, c + 3)) > 4096;
  for (int k = 0; k < 3 && (crosses || far_out); ++k) {
    Component before = combined(c + k, s->half_px + 1, c + 3),
              behind = combined(c + k, -s->half_px - 1, c + 3);
    if (bounds(&before).min > 0 || bounds(&behind).max < 0) return OUTSIDE;
  }
  if (crosses) return CROSSES;
  int shift = bits((u128)w.min) - 24;
  Scaled q = {.down = shift > 0 ? shift : 0};
  q.w_min = w.min >> q.down;
  for (int k = 0; k < 3; ++k) {
    q.out = k < 2 ? 13 : (int)(s->depth_fraction + s->depth_guard);
    b[k] = of_quotient(c + k, c + 3, &w, &q);
  }
  return DRAW;
}

bool huge(const Bounds b[3]) {
  bool any[2] = {false, false};
  for (int k = 0; k < 3; ++k)
    for (int way = 0; way < 2; ++way)
      any[way] = any[way] || b[k].slope[way] >= huge_word || b[k].bend[way] >= huge_word;
  return any[0] && any[1];
}

Fate perspective_rule(const Component c[4], const int splits[2], const Settings *s) {
  Bounds b[3];
  Fate found = quotient_bounds(c, s, b), less = splits[0] <= splits[1] ? SPLIT_U : SPLIT_V;
  if (found == OUTSIDE) return OUTSIDE;
  if (found == CROSSES) return less;
  found = block_rule(b, s);
  return found == SPLIT_U && huge(b) ? less : found;
}

bool divide_place(const i64 place[4], const Settings *s, Corner *corner) {
  if (place[3] <= 0) return false;
  i128 x = quotient(place[0], 13, place[3], HALF_UP), y = quotient(place[1], 13, place[3], HALF_UP),
       z = quotient(place[2], (int)(s->depth_fraction + s->depth_guard), place[3], HALF_UP);
  if (!fits(x, 31) || !fits(y, 31) || !fits(z, 31)) return false;
  corner->x = (i64)x, corner->y = (i64)y, corner->z = (i64)z;
  return true;
}
