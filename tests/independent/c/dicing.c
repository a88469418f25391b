/* Section 22: patches cut into facets. */
#include "machine.h"

static i64 second(const Patch *p, int a, int step, int k) {
  return (i64)magnitude(p->p[a][k] - 2 * p->p[a + step][k] + p->p[a + 2 * step][k]);
}

static i64 level(i128 departure, i64 tolerance, i64 most) {
  i64 l = 0;
  while (l < most && departure > 8 * (i128)tolerance * power((int)(2 * l))) ++l;
  return l;
}

i64 patch_level(const Patch *p, i64 tolerance, i64 most) {
  i128 uu = 0, vv = 0, uv = 0;
  for (int k = 0; k < 3; ++k) {
    for (int n = 0; n < 8; ++n) {
      uu = greater(uu, second(p, 4 * (n / 2) + n % 2, 1, k));
      vv = greater(vv, second(p, n, 4, k));
    }
    for (int n = 0; n < 9; ++n) {
      int a = 4 * (n / 3) + n % 3;
      uv = greater(uv, magnitude(p->p[a][k] - p->p[a + 1][k] - p->p[a + 4][k] + p->p[a + 5][k]));
    }
  }
  return level(6 * uu + 18 * uv + 6 * vv, tolerance, most);
}

/* Edges 0 to 3: j = 0, j = k, i = 0, i = k. */
i64 edge_level(const Patch *p, int edge, i64 tolerance, i64 most) {
  static const int first[4] = {0, 12, 0, 3};
  int step = edge < 2 ? 1 : 4;
  i128 e = 0;
  for (int k = 0; k < 3; ++k)
    for (int n = 0; n < 2; ++n) e = greater(e, second(p, first[edge] + n * step, step, k));
  return level(6 * e, tolerance, most);
}

static void cubic(int n, int k, i64 b[4]) {
  i64 m = k - n;
  b[0] = m * m * m, b[1] = 3 * n * m * m, b[2] = 3 * n * n * m, b[3] = n * n * n;
}
static void quadratic(int n, int k, i64 c[3]) {
  c[0] = (k - n) * (k - n), c[1] = 2 * n * (k - n), c[2] = n * n;
}

void diced_vertex(const Patch *p, int i, int j, int k, i64 place[3]) {
  i64 bu[4], bv[4];
  cubic(i, k, bu);
  cubic(j, k, bv);
  for (int c = 0; c < 3; ++c) {
    i128 sum = 0;
    for (int n = 0; n < 16; ++n) sum += (i128)bu[n % 4] * bv[n / 4] * p->p[n][c];
    place[c] = half_even(sum, (i128)k * k * k * k * k * k);
  }
}

static bool tangent(const Patch *p, int way, int i, int j, int k, i128 t[3]) {
  i64 along[3], across[4];
  int step = way ? 4 : 1, other = way ? 1 : 4;
  quadratic(way ? j : i, k, along);
  cubic(way ? i : j, k, across);
  for (int c = 0; c < 3; ++c) {
    t[c] = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 4; ++b) {
        const i64 *at = p->p[a * step + b * other], *next = p->p[(a + 1) * step + b * other];
        t[c] += (i128)along[a] * across[b] * (next[c] - at[c]);
      }
  }
  return t[0] || t[1] || t[2];
}

void diced_normal(const Patch *p, int i, int j, int k, i64 normal[3]) {
  i128 u[3], v[3], n[3];
  i64 cut_u[3], cut_v[3];
  if (!tangent(p, 0, i, j, k, u)) tangent(p, 0, i, j == 0 ? 1 : k - 1, k, u);
  if (!tangent(p, 1, i, j, k, v)) tangent(p, 1, i == 0 ? 1 : k - 1, j, k, v);
  cut_to(u, 30, cut_u);
  cut_to(v, 30, cut_v);
  cross3(cut_u, cut_v, n);
  unit14(n, normal);
}

/* The number of the vertex that stands at (i, j). */
static int standing(int i, int j, int k, const i64 step[4]) {
  int x = i, y = j;
  if (j == 0) x -= x % (int)step[0];
  if (j == k) x -= x % (int)step[1];
  if (i == 0) y -= y % (int)step[2];
  if (i == k) y -= y % (int)step[3];
  return y * (k + 1) + x;
}

int dice(const Patch *p, i64 tolerance, i64 most, int fraction, Facet *facets) {
  int k = 1 << patch_level(p, tolerance, most), count = 0;
  i64 step[4];
  for (int edge = 0; edge < 4; ++edge) step[edge] = k >> edge_level(p, edge, tolerance, most);
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) {
      const int a = standing(i, j, k, step), b = standing(i + 1, j, k, step),
                c = standing(i + 1, j + 1, k, step), e = standing(i, j + 1, k, step);
      const int both[2][3] = {{a, b, c}, {a, c, e}};
      for (int n = 0; n < 2; ++n) {
        const int *v = both[n];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue;
        Facet *f = facets + count++;
        f->smooth = true;
        for (int m = 0; m < 3; ++m) {
          i64 place[3];
          diced_vertex(p, v[m] % (k + 1), v[m] / (k + 1), k, place);
          diced_normal(p, v[m] % (k + 1), v[m] / (k + 1), k, f->n[m]);
          for (int x = 0; x < 3; ++x) f->p[m][x] = object_word(place[x], fraction);
        }
      }
    }
  return count;
}
