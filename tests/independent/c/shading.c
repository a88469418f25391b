/* Sections 9 and 23: from a sample's normal to its levels. Section 27: the normal that is kept. */
#include "machine.h"

static i128 largest(const i128 v[3]) {
  return greater(greater(magnitude(v[0]), magnitude(v[1])), magnitude(v[2]));
}

/* v cut to n bits; the number of bits that it had. */
i64 cut_to(const i128 v[3], int n, i64 out[3]) {
  int w = bits((u128)largest(v));
  for (int k = 0; k < 3; ++k) out[k] = (i64)(w > n ? down(v[k], w - n, HALF_UP) : v[k]);
  return w;
}

void unit14(const i128 v[3], i64 out[3]) {
  cut_to(v, 30, out);
  i64 length = (i64)isqrt((u128)dot(out, out));
  for (int k = 0; k < 3; ++k) out[k] = length ? half_up(out[k] * power(14), length) : 0;
}

void cross3(const i64 a[3], const i64 b[3], i128 out[3]) {
  for (int k = 0; k < 3; ++k) {
    int m = (k + 1) % 3, n = (k + 2) % 3;
    out[k] = (i128)a[m] * b[n] - (i128)a[n] * b[m];
  }
}

Toward toward(const View *v, int object_fraction) {
  Toward t = {.point = v->distance != 0};
  for (int k = 0; k < 3; ++k) {
    i64 eye = v->target[k] + (i64)down((i128)v->distance * v->back[k], 30, HALF_UP);
    t.words[k] = (i64)(t.point ? down(eye, 16 - (object_fraction + 6), HALF_UP)
                               : down(v->back[k], 16, HALF_UP));
  }
  return t;
}

void direction(const Toward *t, const i64 place[3], i64 out[3]) {
  i128 way[3];
  for (int k = 0; k < 3; ++k) out[k] = t->words[k], way[k] = 1024 * (i128)t->words[k] - place[k];
  if (t->point) unit14(way, out);
}

static bool zero(const i128 t[3]) { return !t[0] && !t[1] && !t[2]; }

/* The tangent along u (way 0) or v at a corner, or the chord of its edge. */
static void tangent_at(const Component places[3], int way, int corner, bool chord, i128 out[3]) {
  int step = way ? 2 : 1, a = corner & ~step, b = a | step;
  for (int k = 0; k < 3; ++k) {
    const i64 *f = places[k].v[F], *g = places[k].v[way ? GV : GU];
    out[k] = 3 * ((i128)f[b] - f[a]);
    if (!chord) out[k] += corner == a ? -8 * (i128)g[a] - 4 * (i128)g[b]
                                      : 4 * (i128)g[a] + 8 * (i128)g[b];
  }
}

static void tangent(const Component places[3], int way, int corner, i64 out[3]) {
  int opposite = corner ^ (way ? 1 : 2);
  i128 t[3];
  tangent_at(places, way, corner, false, t);
  if (zero(t)) tangent_at(places, way, opposite, false, t);
  if (zero(t)) tangent_at(places, way, corner, true, t);
  if (zero(t)) tangent_at(places, way, opposite, true, t);
  cut_to(t, 30, out);
}

void corner_normals(const Component places[3], i64 normals[4][3]) {
  for (int corner = 0; corner < 4; ++corner) {
    i64 u[3], v[3];
    i128 n[3];
    tangent(places, 0, corner, u);
    tangent(places, 1, corner, v);
    cross3(u, v, n);
    unit14(n, normals[corner]);
  }
}

i64 at_leaf(const i64 q[4], int i, int j) {
  int u = 2 * i + 1, v = 2 * j + 1;
  return (32 - v) * ((32 - u) * q[0] + u * q[1]) + v * ((32 - u) * q[2] + u * q[3]);
}

static i64 squared(i64 h, i64 times_) {
  for (; times_ > 0; --times_) h = half_up((i128)h * h, 1 << 14);
  return h;
}

/* n_dot_l and the highlight of one source. */
static void cosines(const Shading *sh, const i64 normal[3], i64 length, const i64 to_light[3],
                    const i64 to_viewer[3], int sign, i64 *n_dot_l, i64 *highlight) {
  *n_dot_l = sign * (i64)divide(dot(normal, to_light), length, FLOOR);
  *highlight = 0;
  if (sh->rule == BLINN) {
    i128 sum[3];
    i64 halfway[3];
    for (int k = 0; k < 3; ++k) sum[k] = to_light[k] + to_viewer[k];
    unit14(sum, halfway);
    i64 h = sign * (i64)divide(dot(normal, halfway), length, FLOOR);
    *highlight = squared((i64)clamp(h, 0, 1 << 14), sh->shininess + 2);
  } else if (sh->rule == PHONG) {
    i64 n_dot_v = sign * (i64)divide(dot(normal, to_viewer), length, FLOOR);
    i64 l_dot_v = (i64)(dot(to_light, to_viewer) >> 14);
    i64 h = (i64)clamp(((i128)2 * *n_dot_l * n_dot_v >> 14) - l_dot_v, 0, 1 << 14);
    *highlight = squared(h, sh->shininess);
  }
}

/* The planes of one sample: for each channel intensity, then each source's direct share. A facet's
 * normal has been turned already. */
void shade(const Shading *sh, const i64 normal[3], const i64 place[3], bool facet,
           const bool *shadowed, int32_t *planes) {
  i64 to_viewer[3], n_dot_l[8], highlight[8], length = (i64)isqrt((u128)dot(normal, normal));
  if (length < 1) length = 1;
  direction(&sh->viewer, place, to_viewer);
  int sign = !facet && divide(dot(normal, to_viewer), length, FLOOR) < 0 ? -1 : 1;
  for (int l = 0; l < sh->sources; ++l) {
    i64 to_light[3];
    n_dot_l[l] = 1 << 14, highlight[l] = 0;
    if (sh->rule == UNSHADED) continue;
    direction(sh->light + l, place, to_light);
    cosines(sh, normal, length, to_light, to_viewer, sign, n_dot_l + l, highlight + l);
  }
  for (int c = 0; c < sh->channels; ++c, planes += 1 + sh->sources) {
    i128 sum = power(22) * sh->diffuse[c] * sh->ambient;
    i64 level = 0;
    for (int l = -1; l < sh->sources; ++l) {
      bool lit = l >= 0 && n_dot_l[l] > 0 && !(shadowed && shadowed[l]);
      if (lit)
        sum += (i128)sh->level[l][c] * (sh->diffuse[c] * (256 - sh->ambient) * n_dot_l[l] +
                                        256 * sh->specular[c] * highlight[l]);
      i64 next = (i64)clamp(down(sum, 30, HALF_UP), 0, 255);
      if (l >= 0) planes[1 + l] = (int32_t)(next - level);
      level = next;
    }
    planes[0] = (int32_t)level;
  }
}

void kept_normal(const i64 n[3], const i64 to_viewer[3], int32_t out[3]) {
  int sign = dot(n, to_viewer) < 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) out[k] = (int32_t)(sign * n[k]);
}
