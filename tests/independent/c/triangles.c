/* Section 21: facets, cut at the guard band, and their samples. Section 22: facing. */
#include <string.h>

#include "machine.h"

static i128 inside(const Vertex *v, int plane, const i64 limit[3]) {
  static const int axis[6] = {2, 2, 0, 0, 1, 1};
  int k = axis[plane];
  i128 side = (i128)limit[k] * v->v[3];
  return plane % 2 ? side - v->v[k] : side + v->v[k];
}

static Vertex between(const Vertex *in, i128 d, const Vertex *out, i128 beyond) {
  Vertex v;
  for (int k = 0; k < 10; ++k)
    v.v[k] = in->v[k] + half_up(((i128)out->v[k] - in->v[k]) * d, d - beyond);
  return v;
}

int guard_band(const Vertex in[3], bool affine, const Settings *s, Vertex out[9]) {
  i64 quantum = (i64)down(1, (int)-s->depth_fraction, CEILING), pixel;
  pixel = (i64)down(1, (int)s->depth_fraction, CEILING);
  i64 side = (i64)1 << (affine ? 27 : 14);
  const i64 limit[3] = {
      side, side, affine ? (s->depth_offset + quantum) << s->depth_guard : s->half_px + pixel};
  int count = 3;
  bool cut = false;
  memcpy(out, in, 3 * sizeof *in);
  for (int plane = 0; plane < 6; ++plane) {
    int beyond = 0;
    for (int k = 0; k < 3; ++k) beyond += inside(in + k, plane, limit) < 0;
    if (beyond == 3) return 0;
    cut = cut || beyond;
  }
  for (int plane = 0; plane < 6 && cut; ++plane) {
    Vertex left[10];
    int n = 0;
    for (int k = 0; k < count; ++k) {
      const Vertex *v = out + k, *w = out + (k + 1) % count;
      i128 d = inside(v, plane, limit), e = inside(w, plane, limit);
      if (d >= 0) left[n++] = *v;
      if (d >= 0 && e < 0) left[n++] = between(v, d, w, e);
      if (d < 0 && e >= 0) left[n++] = between(w, e, v, d);
    }
    count = n;
    memcpy(out, left, (size_t)count * sizeof *out);
  }
  return count < 3 ? 0 : count;
}

static bool belongs(const Corner *p, const Corner *q, i64 x, i64 y) {
  i64 side = cross(p, q, x, y);
  return side > 0 || (side == 0 && (q->y < p->y || (q->y == p->y && q->x > p->x)));
}

bool covered(const Corner t[3], i64 x, i64 y) {
  return belongs(t, t + 1, x, y) && belongs(t + 1, t + 2, x, y) && belongs(t + 2, t, x, y);
}

i64 plane_depth(const Corner t[3], i64 x, i64 y) {
  i64 area = cross(t, t + 1, t[2].x, t[2].y);
  i128 sum = (i128)cross(t + 2, t, x, y) * (t[1].z - t[0].z) +
             (i128)cross(t, t + 1, x, y) * (t[2].z - t[0].z);
  return t[0].z + half_up(sum, area);
}

/* g, of a facet's object places times 2^6 */
void own_normal(const Vertex facet[3], i64 g[3]) {
  i64 b[3], c[3];
  i128 n[3];
  for (int k = 0; k < 3; ++k) {
    b[k] = facet[1].v[4 + k] - facet[0].v[4 + k];
    c[k] = facet[2].v[4 + k] - facet[0].v[4 + k];
  }
  cross3(b, c, n);
  unit14(n, g);
}

static i128 largest(const i64 v[3]) { return greater(greater(v[0], v[1]), v[2]); }

/* The corners' weights of 1024 at the sample whose edge values are d->e. */
static void weights(const Drawing *d, i64 t[3]) {
  i64 e[3], w[3];
  int cut = bits((u128)largest(d->e)) - 24, cut_w;
  for (int k = 0; k < 3; ++k) w[k] = d->corners[k]->v[3];
  cut_w = bits((u128)largest(w)) - 14;
  for (int k = 0; k < 3; ++k) {
    e[k] = cut > 0 ? d->e[k] >> cut : d->e[k];
    w[k] = cut_w > 0 ? w[k] >> cut_w : w[k];
    if (w[k] < 1) w[k] = 1;
  }
  i64 s[3], sum = 0;
  for (int k = 0; k < 3; ++k) sum += s[k] = e[k] * w[(k + 1) % 3] * w[(k + 2) % 3];
  t[1] = half_up((i128)1024 * s[1], sum);
  t[2] = half_up((i128)1024 * s[2], sum);
  t[0] = 1024 - t[1] - t[2];
}

void facet_normal(const Drawing *d, i64 normal[3], i64 place[3]) {
  i64 t[3], to_viewer[3];
  weights(d, t);
  for (int k = 0; k < 3; ++k) {
    normal[k] = place[k] = 0;
    for (int n = 0; n < 3; ++n) {
      place[k] += t[n] * d->corners[n]->v[4 + k];
      normal[k] += t[n] * d->corners[n]->v[7 + k];
    }
    if (!d->facet->smooth) normal[k] = d->own[k];
  }
  direction(&d->shading->viewer, place, to_viewer);
  if ((dot(normal, d->own) < 0) != (dot(d->own, to_viewer) < 0))
    for (int k = 0; k < 3; ++k) normal[k] = -normal[k];
}

static void facet_sample(Drawing *d, const Corner t[3], Sample *sample) {
  if (!covered(t, sample->x, sample->y)) return;
  sample->z = plane_depth(t, sample->x, sample->y);
  for (int k = 0; k < 3; ++k)
    d->e[k] = cross(t + (k + 1) % 3, t + (k + 2) % 3, sample->x, sample->y);
  put(d, sample);
}

static void draw_triangle(Drawing *d, const Corner *a, const Corner *b, const Corner *c,
                          const Vertex *va, const Vertex *vb, const Vertex *vc) {
  i64 area = cross(a, b, c->x, c->y), rise = 0;
  if (area == 0 || (d->front && area > 0) || (d->back && area < 0)) return;
  Corner t[3] = {*a, area < 0 ? *c : *b, area < 0 ? *b : *c};
  d->corners[0] = va;
  d->corners[1] = area < 0 ? vc : vb;
  d->corners[2] = area < 0 ? vb : vc;
  if (d->slope_factor) {
    caster_slope(t, &rise);
    rise = slope_offset(rise, d->slope_factor, d->slope_limit);
  }
  visit_box(d, t, 0, rise, facet_sample);
}

void draw_facet(Drawing *d, const Facet *facet) {
  Vertex given[3], left[9];
  Corner corners[9];
  for (int n = 0; n < 3; ++n) {
    screen_words(&d->m, d->s, facet->p[n], given[n].v);
    for (int k = 0; k < 3; ++k) {
      given[n].v[4 + k] = 64 * facet->p[n][k];
      given[n].v[7 + k] = facet->n[n][k];
    }
  }
  int count = guard_band(given, d->m.affine, d->s, left);
  for (int k = 0; k < count; ++k) {
    corners[k] = (Corner){left[k].v[0], left[k].v[1], left[k].v[2]};
    if (!d->m.affine && !divide_place(left[k].v, d->s, corners + k)) return;
  }
  d->facet = facet;
  own_normal(given, d->own);
  for (int k = 1; k + 1 < count; ++k)
    draw_triangle(d, corners, corners + k, corners + k + 1, left, left + k, left + k + 1);
  d->facet = NULL;
}
