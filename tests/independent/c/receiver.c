/* Sections 24 and 27: casters' slopes and depths, receivers' planes and normals. */
#include "machine.h"

void caster_slope(const Corner t[3], i64 *slope) {
  const Corner *a = t, *b = t + 1, *c = t + 2;
  i128 rise_x = (i128)(b->z - a->z) * (c->y - a->y) - (i128)(c->z - a->z) * (b->y - a->y);
  i128 rise_y = (i128)(c->z - a->z) * (b->x - a->x) - (i128)(b->z - a->z) * (c->x - a->x);
  i128 area = magnitude(cross(a, b, c->x, c->y));
  i128 steep =
      area ? divide(power(13) * greater(magnitude(rise_x), magnitude(rise_y)), area, CEILING) : 0;
  *slope = (i64)clamp(steep, 0, power(31) - 1);
}

i64 slope_offset(i64 slope, i64 factor, i64 limit) {
  i64 offset = (i64)down((i128)slope * factor, 8, CEILING);
  return limit >= 0 && offset > limit ? limit : offset;
}

i64 moved_code(i64 z, i64 offset, const Settings *s) {
  if (z_code(z, s) < 0) return -1;
  i64 code = z_code(z + offset, s);
  return code < 0 ? s->deepest_drawn : code;
}

void keep_two(int32_t layers[2], i64 code) {
  if (code == layers[0] || code >= layers[1]) return;
  layers[1] = code < layers[0] ? layers[0] : (int32_t)code;
  if (code < layers[0]) layers[0] = (int32_t)code;
}

i64 midpoint(const int32_t layers[2]) { return ((i64)layers[0] + layers[1]) >> 1; }

/* The neighbour that is taken along (dx, dy): -1, 1 or, without one, 0. */
int neighbour(const int32_t *z, const Settings *s, i64 px, i64 py, int dx, int dy) {
  i64 best = -1, own = z[py * s->size_px + px];
  int taken = 0;
  for (int way = -1; way <= 1; way += 2) {
    i64 x = px + way * dx, y = py + way * dy;
    if (x < 0 || y < 0 || x >= s->size_px || y >= s->size_px) continue;
    i64 code = z[y * s->size_px + x], away = (i64)magnitude(code - own);
    if (code == s->background_code || (taken && away >= best)) continue;
    best = away;
    taken = way;
  }
  return taken;
}

static i64 slope_word(i128 numerator, i128 d) {
  return (i64)clamp(divide(numerator, d, HALF_UP), -power(39), power(39) - 1);
}

static bool all_fit(const i64 v[3], int n) {
  return fits(v[0], n) && fits(v[1], n) && fits(v[2], n);
}

bool gradient(const i64 u[3], const i64 v[3], i64 slope[2]) {
  if (!all_fit(u, 31) || !all_fit(v, 31)) return false;
  i128 d = (i128)u[0] * v[1] - (i128)v[0] * u[1];
  if (d == 0) return false;
  slope[0] = slope_word(power(12) * ((i128)u[2] * v[1] - (i128)v[2] * u[1]), d);
  slope[1] = slope_word(power(12) * ((i128)v[2] * u[0] - (i128)u[2] * v[0]), d);
  return true;
}

i64 plane_change(const Plane *p, i64 twice_x, i64 twice_y) {
  i128 sum =
      (i128)p->slope[0] * (twice_x - 2 * p->at[0]) + (i128)p->slope[1] * (twice_y - 2 * p->at[1]);
  i128 change = down(sum, 13, HALF_UP);
  return (i64)(p->limit >= 0 ? clamp(change, -p->limit, p->limit) : change);
}

void scale_at(const Scale *s, const i64 at[3], i64 *scale, i64 tilt[2]) {
  *scale = s->quanta;
  tilt[0] = tilt[1] = 0;
  if (s->quanta) return;
  *scale = (i64)clamp(divide(power(16) * (s->reach - 256 * (i128)at[2]), s->focal, HALF_UP), 1,
                      power(40) - 1);
  for (int k = 0; k < 2; ++k)
    tilt[k] = (i64)clamp(quotient(at[k], 24 - s->fraction_bits, s->focal, HALF_UP), -power(25),
                         power(25) - 1);
}

static void in_texels(const i64 u[3], const Scale *s, i64 scale, const i64 tilt[2], i64 out[3]) {
  out[2] = half_up(u[2] * power(28), scale);
  for (int k = 0; k < 2; ++k)
    out[k] = (i64)(down(u[k], s->fraction_bits - 12, HALF_UP) +
                   down((i128)tilt[k] * out[2], 16, HALF_UP));
}

/* n is of any length; the move goes along -way n. */
bool moved_along(const i64 at[3], const i64 n[3], int way, i64 c, const Scale *s, i64 out[3]) {
  i64 scale, tilt[2], unit[3], move[3];
  i128 most = greater(greater(magnitude(n[0]), magnitude(n[1])), magnitude(n[2]));
  for (int k = 0; k < 3; ++k) out[k] = at[k];
  if (most == 0) return false;
  for (int k = 0; k < 3; ++k) unit[k] = (i64)down(n[k], bits((u128)most) - 24, HALF_UP);
  i64 length = (i64)isqrt((u128)dot(unit, unit));
  for (int k = 0; k < 3; ++k) move[k] = half_up((i128)-way * 16 * c * unit[k], length);
  scale_at(s, at, &scale, tilt);
  for (int k = 0; k < 2; ++k)
    out[k] +=
        (i64)down(power(16) * move[k] - (i128)tilt[k] * move[2], 28 - s->fraction_bits, HALF_UP);
  out[2] += (i64)down((i128)scale * move[2], 28, HALF_UP);
  return true;
}

bool moved(const i64 at[3], const i64 u[3], const i64 v[3], int way, i64 c, const Scale *s,
           i64 out[3]) {
  i64 scale, tilt[2], a[3], b[3], n[3];
  i128 wide[3];
  for (int k = 0; k < 3; ++k) out[k] = at[k];
  if (!all_fit(u, 31) || !all_fit(v, 31)) return false;
  scale_at(s, at, &scale, tilt);
  in_texels(u, s, scale, tilt, a);
  in_texels(v, s, scale, tilt, b);
  if (!all_fit(a, 26) || !all_fit(b, 26)) return false;
  cross3(a, b, wide);
  for (int k = 0; k < 3; ++k) n[k] = (i64)wide[k];
  return moved_along(at, n, way, c, s, out);
}

/* Right, up and back, Q1.14. */
void light_axes(const View *v, i64 axes[3][3]) {
  const i64 *from[3] = {v->right, v->up, v->back};
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < 3; ++k) axes[a][k] = (i64)down(from[a][k], 16, HALF_UP);
}

void in_light(const i64 n[3], i64 axes[3][3], i64 m[3]) {
  for (int k = 0; k < 3; ++k) m[k] = (i64)down((k ? -1 : 1) * dot(n, axes[k]), 6, HALF_UP);
}

bool leaning(const i64 at[3], const i64 m[3], const Scale *s, i64 slope[2]) {
  i64 scale, tilt[2];
  scale_at(s, at, &scale, tilt);
  i64 d = m[2] + (i64)down((i128)tilt[0] * m[0] + (i128)tilt[1] * m[1], 16, HALF_UP);
  if (d == 0) return false;
  for (int k = 0; k < 2; ++k)
    slope[k] = slope_word(-(i128)scale * m[k], d * power(4 + s->fraction_bits));
  return true;
}

void set_receiver(const View *v, const Settings *s, Light *light) {
  Scale *scale = &light->scale;
  i64 bias = bias_quanta(v, s->bias, s->bias_unit, s), range = v->far - v->near;
  *scale = (Scale){.fraction_bits = (int)s->fraction_bits};
  light->limit = s->bias_clamp ? bias_quanta(v, s->bias_clamp, s->bias_unit, s) >> 16 : -1;
  light_axes(v, light->axes);
  if (!v->distance) {
    scale->quanta = (i64)clamp(
        divide(v->extent * power((int)s->z_bits + 16), (i128)s->half_px * range, HALF_EVEN), 1,
        power(40) - 1);
    return;
  }
  i128 end = power(53), reach = v->far * power((int)s->z_bits + 24) -
                                (s->depth_offset * power(24) + bias * power(8)) * range;
  scale->focal =
      (i64)clamp(divide((i128)s->half_px * v->distance * 256, v->extent, HALF_EVEN), 1, end);
  scale->reach = (i64)clamp(divide(reach, range * power(16), HALF_EVEN), -end, end);
}

/* What section 24 or 27 makes of a pixel's results: a plane, or the results moved. */
static void follow_surface(const Observer *o, const Light *l, const Settings *s, Unit *unit,
                           const void *state, i64 px, i64 py, i64 result[3], Plane *plane) {
  i64 pixel = py * s->size_px + px, at[3] = {result[0], result[1], result[2]}, way = 1, step[2][3];
  *plane = (Plane){.at = {at[0], at[1]}, .limit = l->limit};
  if (s->slope_source == NORMALS) {
    i64 n[3], m[3], axes[3][3];
    for (int k = 0; k < 9; ++k) axes[k / 3][k % 3] = l->axes[k / 3][k % 3];
    for (int k = 0; k < 3; ++k) n[k] = o->normals[k][pixel] - 32768;
    if (!n[0] && !n[1] && !n[2]) return;
    in_light(n, axes, m);
    if (s->receiver == PLANE)
      plane->found = leaning(at, m, &l->scale, plane->slope);
    else
      moved_along(at, m, -1, s->normal_offset, &l->scale, result);
    return;
  }
  for (int k = 0; k < 2; ++k) {
    int side = neighbour(o->observer_z, s, px, py, !k, k);
    i64 x = px + !k * side, y = py + k * side, words[3];
    if (!side) return;
    input_words(x, y, o->observer_z[y * s->size_px + x], s, words);
    if (unit(state, s, words, step[k]) != OK) return;
    for (int c = 0; c < 3; ++c) step[k][c] -= at[c];
    way *= side;
  }
  if (s->receiver == PLANE)
    plane->found = gradient(step[0], step[1], plane->slope);
  else
    moved(at, step[0], step[1], (int)way, s->normal_offset, &l->scale, result);
}

int pixel_darkness(const Observer *o, const Light *light, const Settings *s, Unit *unit,
                   const void *state, i64 px, i64 py, const int32_t *dither, bool clamped) {
  i64 pixel = py * s->size_px + px, words[3], result[3];
  int taps[25][2];
  Plane plane = {.found = false};
  input_words(px, py, o->observer_z[pixel], s, words);
  if (unit(state, s, words, result) != OK) return 0;
  if (s->receiver != POINT) follow_surface(o, light, s, unit, state, px, py, result, &plane);
  if (s->tap_places == JITTERED) tap_bytes(s->dither_seed, s->taps, pixel, taps);
  const i64 d[2] = {dither[2 * pixel], dither[2 * pixel + 1]};
  return darkness(light->map, s, result, d, taps, &plane, clamped);
}
