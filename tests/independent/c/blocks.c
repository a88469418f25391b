/* Section 6: components, their splits and bounds, and the block rule of an affine view. */
#include "machine.h"

Component component(const i64 p[16]) {
  Component c;
  for (int corner = 0; corner < 4; ++corner) {
    int u = corner % 2, v = corner / 2;
    i128 along_u[4];
    for (int j = 0; j < 4; ++j)
      along_u[j] = p[4 * j + u] - 2 * (i128)p[4 * j + u + 1] + p[4 * j + u + 2];
    const i64 *q = p + 3 * u + 4 * v;
    c.v[F][corner] = p[12 * v + 3 * u];
    c.v[GU][corner] = half_up(3 * along_u[3 * v], 4);
    c.v[GV][corner] = half_up(3 * (q[0] - 2 * (i128)q[4] + q[8]), 4);
    c.v[GUV][corner] = half_up(9 * (along_u[v] - 2 * along_u[v + 1] + along_u[v + 2]), 16);
  }
  return c;
}

static i64 by(i64 a, int n) { return (a + ((i64)1 << (n - 1))) >> n; } /* half_up(a / 2^n) */

/* One pair (value, correction) at corners a and b. */
static void halve(const Component *c, int value, int correction, int a, int b, Component *low,
                  Component *high) {
  const i64 *f = c->v[value], *g = c->v[correction];
  i64 middle = by(f[a] + f[b] - g[a] - g[b], 1);
  low->v[value][a] = f[a];
  low->v[value][b] = high->v[value][a] = middle;
  high->v[value][b] = f[b];
  low->v[correction][b] = high->v[correction][a] = by(g[a] + g[b], 3);
  low->v[correction][a] = by(g[a], 2);
  high->v[correction][b] = by(g[b], 2);
}

void split(const Component *c, int way, Component *low, Component *high) {
  for (int k = 0; k < 2; ++k) {
    int a = way ? k : 2 * k, b = way ? k + 2 : 2 * k + 1;
    halve(c, F, way ? GV : GU, a, b, low, high);
    halve(c, way ? GU : GV, GUV, a, b, low, high);
  }
}

static i64 most(i64 a, i64 b) { return a > b ? a : b; }
static i64 away(i64 a, i64 b) { return a > b ? a - b : b - a; }
static i64 largest(const i64 g[4]) {
  return most(most(away(g[0], 0), away(g[1], 0)), most(away(g[2], 0), away(g[3], 0)));
}

Bounds bounds(const Component *c) {
  const i64 *f = c->v[F], *gu = c->v[GU], *gv = c->v[GV];
  i64 mu = largest(gu), mv = largest(gv), muv = largest(c->v[GUV]), reach = mu + mv + muv;
  Bounds b = {.min = f[0], .max = f[0]};
  for (int k = 1; k < 4; ++k) {
    if (f[k] < b.min) b.min = f[k];
    if (f[k] > b.max) b.max = f[k];
  }
  b.min -= reach;
  b.max += reach;
  b.slope[0] = most(away(f[1], f[0]), away(f[3], f[2])) + 4 * mu +
               most(away(gv[1], gv[0]), away(gv[3], gv[2])) + 4 * muv;
  b.slope[1] = most(away(f[2], f[0]), away(f[3], f[1])) + 4 * mv +
               most(away(gu[2], gu[0]), away(gu[3], gu[1])) + 4 * muv;
  b.bend[0] = mu + muv;
  b.bend[1] = mv + muv;
  return b;
}

Fate block_rule(const Bounds b[3], const Settings *s) {
  const i64 side = s->half_px * 8192 + 128, limit[3] = {
      side, side, (i64)((s->depth_offset + 1) * power((int)s->depth_guard))};
  i128 urge[2] = {0, 0};
  bool small = true;
  for (int k = 0; k < 3; ++k)
    if (b[k].max < -limit[k] || b[k].min > limit[k]) return OUTSIDE;
  for (int k = 0; k < 3; ++k) {
    small = small && away(b[k].min, 0) < 1 << 29 && away(b[k].max, 0) < 1 << 29 &&
            b[k].bend[0] <= 8192 && b[k].bend[1] <= 8192;
    if (k < 2) small = small && b[k].slope[0] + b[k].slope[1] <= 126976;
    for (int way = 0; way < 2; ++way) {
      urge[way] = greater(urge[way], (i128)16 * b[k].bend[way]);
      if (k < 2) urge[way] = greater(urge[way], b[k].slope[way]);
    }
  }
  return small ? DRAW : urge[0] >= urge[1] ? SPLIT_U : SPLIT_V;
}
