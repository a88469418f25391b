/* Section 7: a block's leaves, and the samples of their triangles. */
#include "machine.h"

static i64 by(i64 a, int n) { return (a + ((i64)1 << (n - 1))) >> n; }

/* Four halvings of one pair over 17 places. */
static void halved(i64 *f, i64 *g) {
  for (int half = 8; half; half /= 2) {
    for (int m = half; m < 16; m += 2 * half) {
      i64 ga = g[(m - half)], gb = g[(m + half)];
      f[m] = by(f[(m - half)] + f[(m + half)] - ga - gb, 1);
      g[m] = by(ga + gb, 3);
    }
    for (int old = 0; old <= 16; old += 2 * half) g[old] = by(g[old], 2);
  }
}

void leaf_corners(const Component *c, i64 grid[17][17]) {
  i64 gu[17], guv[17], gv[17][17]; /* gv as the grid: [i][j] */
  for (int v = 0; v < 2; ++v) {
    for (int u = 0; u < 2; ++u) {
      grid[16 * u][16 * v] = c->v[F][2 * v + u];
      gv[16 * u][16 * v] = c->v[GV][2 * v + u];
      gu[16 * u] = c->v[GU][2 * v + u];
      guv[16 * u] = c->v[GUV][2 * v + u];
    }
    i64 f[17], g[17];
    f[0] = grid[0][16 * v], f[16] = grid[16][16 * v];
    g[0] = gv[0][16 * v], g[16] = gv[16][16 * v];
    halved(f, gu);
    halved(g, guv);
    for (int i = 0; i <= 16; ++i) grid[i][16 * v] = f[i], gv[i][16 * v] = g[i];
  }
  for (int i = 0; i <= 16; ++i) halved(grid[i], gv[i]);
}

i64 cross(const Corner *p, const Corner *q, i64 x, i64 y) {
  return (q->x - p->x) * (y - p->y) - (x - p->x) * (q->y - p->y);
}

static i64 least(i64 a, i64 b) { return a < b ? a : b; }
static i64 most(i64 a, i64 b) { return a > b ? a : b; }
static i64 away(i64 a, i64 b) { return a > b ? a - b : b - a; }

/* Whether a weight is no more than the slack outside its edge. */
static bool within(i64 weight, const Corner *p, const Corner *q) {
  return weight >= -128 * (away(q->x, p->x) + away(q->y, p->y));
}

bool triangle_depth(const Corner t[3], i64 x, i64 y, i64 *z) {
  const Corner *a = t, *b = t + 1, *c = t + 2;
  i64 area = cross(a, b, c->x, c->y), sign = area < 0 ? -1 : 1;
  if (area == 0) return false;
  if (x < least(least(a->x, b->x), c->x) - 128 || x > most(most(a->x, b->x), c->x) + 128 ||
      y < least(least(a->y, b->y), c->y) - 128 || y > most(most(a->y, b->y), c->y) + 128)
    return false;
  i64 weight_c = sign * cross(a, b, x, y), weight_a = sign * cross(b, c, x, y),
      weight_b = sign * cross(c, a, x, y);
  if (!within(weight_c, a, b) || !within(weight_a, b, c) || !within(weight_b, c, a)) return false;
  i128 sum = (i128)weight_b * (b->z - a->z) + (i128)weight_c * (c->z - a->z);
  *z = (i64)clamp(a->z + divide(sum, sign * area, HALF_UP), least(least(a->z, b->z), c->z),
                  most(most(a->z, b->z), c->z));
  return true;
}

/* A pixel's centre, or a place of scan_out.md, in a triangle's box. */
static void visit_places(Drawing *d, const Corner t[3], const i64 box[4], i64 rise, Visit *visit) {
  const Settings *s = d->s;
  i64 edge[4];
  for (int k = 0; k < 4; ++k) edge[k] = (i64)clamp((box[k] >> 13) + s->half_px, 0, s->size_px - 1);
  for (i64 ty = edge[1]; ty <= edge[3]; ++ty)
    for (i64 tx = edge[0]; tx <= edge[2]; ++tx)
      for (i64 n = d->places->heads[ty * s->size_px + tx]; n >= 0; n = d->places->places[n].next) {
        const Place *p = d->places->places + n;
        Sample sample = {.x = p->x, .y = p->y, .rise = rise, .place = (int)n};
        if (p->x >= box[0] && p->x <= box[2] && p->y >= box[1] && p->y <= box[3])
          visit(d, t, &sample);
      }
}

void visit_box(Drawing *d, const Corner t[3], i64 slack, i64 rise, Visit *visit) {
  const Settings *s = d->s;
  const i64 box[4] = {least(least(t[0].x, t[1].x), t[2].x) - slack,
                      least(least(t[0].y, t[1].y), t[2].y) - slack,
                      most(most(t[0].x, t[1].x), t[2].x) + slack,
                      most(most(t[0].y, t[1].y), t[2].y) + slack};
  if (d->places) {
    visit_places(d, t, box, rise, visit);
    return;
  }
  i64 px0 = most(((box[0] + 4095) >> 13) + s->half_px, 0),
      py0 = most(((box[1] + 4095) >> 13) + s->half_px, 0),
      px1 = least(((box[2] - 4096) >> 13) + s->half_px, s->size_px - 1),
      py1 = least(((box[3] - 4096) >> 13) + s->half_px, s->size_px - 1);
  for (i64 py = py0; py <= py1; ++py)
    for (i64 px = px0; px <= px1; ++px) {
      Sample sample = {.px = px, .py = py, .rise = rise};
      sample.x = (2 * (px - s->half_px) + 1) * 4096;
      sample.y = (2 * (py - s->half_px) + 1) * 4096;
      visit(d, t, &sample);
    }
}

static void leaf_sample(Drawing *d, const Corner t[3], Sample *sample) {
  if (triangle_depth(t, sample->x, sample->y, &sample->z)) put(d, sample);
}

static void at_centres(Drawing *d, Corner (*corners)[17], int i, int j) {
  const Corner *a = &corners[i][j], *b = &corners[i + 1][j], *c = &corners[i + 1][j + 1],
               *e = &corners[i][j + 1];
  const Corner triangles[2][3] = {{*a, *b, *c}, {*a, *c, *e}};
  for (int n = 0; n < 2; ++n) {
    const Corner *t = triangles[n];
    i64 rise = 0;
    if (d->back && cross(t, t + 1, t[2].x, t[2].y) <= 0) continue;
    if (d->slope_factor && cross(t, t + 1, t[2].x, t[2].y)) {
      caster_slope(t, &rise);
      rise = slope_offset(rise, d->slope_factor, d->slope_limit);
    }
    visit_box(d, t, 128, rise, leaf_sample);
  }
}

static void at_mean(Drawing *d, Corner (*corners)[17], int i, int j) {
  const Corner *a = &corners[i][j], *b = &corners[i + 1][j], *c = &corners[i + 1][j + 1],
               *e = &corners[i][j + 1];
  const Corner first[3] = {*a, *b, *c}, second[3] = {*a, *c, *e};
  Sample sample = {.x = by(a->x + b->x + c->x + e->x, 2), .y = by(a->y + b->y + c->y + e->y, 2),
                   .z = by(a->z + b->z + c->z + e->z, 2)};
  sample.px = (sample.x + d->s->half_px * 8192) >> 13;
  sample.py = (sample.y + d->s->half_px * 8192) >> 13;
  if (sample.px < 0 || sample.px >= d->s->size_px || sample.py < 0 || sample.py >= d->s->size_px)
    return;
  i64 areas[2] = {cross(a, b, c->x, c->y), cross(a, c, e->x, e->y)}, slopes[2] = {0, 0};
  if (d->back && areas[0] + areas[1] <= 0) return;
  if (d->slope_factor) {
    if (areas[0]) caster_slope(first, slopes);
    if (areas[1]) caster_slope(second, slopes + 1);
    sample.rise = slope_offset(most(slopes[0], slopes[1]), d->slope_factor, d->slope_limit);
  }
  put(d, &sample);
}

void draw_leaves(Drawing *d, Corner (*corners)[17]) {
  bool leaf = d->s->sampling == LEAF && !d->places;
  for (d->leaf_j = 0; d->leaf_j < 16; ++d->leaf_j)
    for (d->leaf_i = 0; d->leaf_i < 16; ++d->leaf_i) {
      d->shaded = false;
      if (leaf) at_mean(d, corners, d->leaf_i, d->leaf_j);
      else at_centres(d, corners, d->leaf_i, d->leaf_j);
    }
}

i64 z_code(i64 z, const Settings *s) {
  i64 code = (i64)down(z, (int)s->depth_guard, (Rounding)s->depth_rounding) + s->depth_offset;
  if (code < 0 || code > s->background_code) return -1;
  return code == s->background_code ? s->deepest_drawn : code;
}
