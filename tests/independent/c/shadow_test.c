/* Sections 11 and 12: the post-process, and the test of the correct form. */
#include "machine.h"

void input_words(i64 px, i64 py, i64 code, const Settings *s, i64 words[3]) {
  int centre = s->registration == REGISTER_CENTRE, up = (int)s->input_fraction - 1;
  words[0] = (i64)((2 * (px - s->half_px) + centre) * power(up));
  words[1] = (i64)((2 * (py - s->half_px) + centre) * power(up));
  words[2] = (i64)((code - s->depth_offset) * power((int)(s->input_fraction - s->depth_fraction)));
}

static i64 texel(const int32_t *map, const Settings *s, i64 x, i64 y, bool clamped) {
  if (clamped) {
    x = (i64)clamp(x, 0, s->size_px - 1);
    y = (i64)clamp(y, 0, s->size_px - 1);
  }
  if (x < 0 || y < 0 || x >= s->size_px || y >= s->size_px) return s->background_code;
  return map[y * s->size_px + x];
}

static int window(const int32_t *map, const Settings *s, i64 x, i64 y, i64 code, int taps[25][2],
                  bool clamped) {
  i64 k = s->taps, one = s->one_texel, count = 0, sum = 0;
  int f = (int)s->fraction_bits;
  for (i64 j = 0; j < k; ++j)
    for (i64 i = 0; i < k; ++i) {
      i64 tx = ((2 * x - (k - 1) * one) >> (f + 1)) + i,
          ty = ((2 * y - (k - 1) * one) >> (f + 1)) + j;
      if (s->tap_places == JITTERED) {
        const int *byte = taps[k * j + i];
        tx = (512 * x + (512 * i - 256 * k + 2 * byte[0] + 1) * one) >> (f + 9);
        ty = (512 * y + (512 * j - 256 * k + 2 * byte[1] + 1) * one) >> (f + 9);
      }
      i64 z = texel(map, s, tx + s->half_px, ty + s->half_px, clamped);
      count += code > z;
      sum += z;
    }
  if (s->lookup == PERCENTAGE) return (int)half_up(255 * count, k * k);
  return k * k * code > sum ? 255 : 0;
}

/* Twice the place, in words of X and Y, at which the receiver's plane is asked. */
static i64 at_plane(i64 code, const Plane *plane, i64 twice_x, i64 twice_y) {
  return plane && plane->found ? code + plane_change(plane, twice_x, twice_y) : code;
}

static bool nearest(const int32_t *map, const Settings *s, i64 x, i64 y, i64 code,
                    const Plane *plane, bool clamped) {
  i64 tx = x >> s->fraction_bits, ty = y >> s->fraction_bits, one = s->one_texel;
  code = at_plane(code, plane, 2 * one * tx + one, 2 * one * ty + one);
  return code > texel(map, s, tx + s->half_px, ty + s->half_px, clamped);
}

static bool bilinear(const int32_t *map, const Settings *s, i64 x, i64 y, i64 code,
                     const Plane *plane, bool clamped) {
  i64 one = s->one_texel, left = x - one / 2, top = y - one / 2, fx = left & (one - 1),
      fy = top & (one - 1), four[4];
  for (int k = 0; k < 4; ++k) {
    four[k] = texel(map, s, (left >> s->fraction_bits) + s->half_px + k % 2,
                    (top >> s->fraction_bits) + s->half_px + k / 2, clamped);
    if (s->background == FALL_BACK && four[k] == s->background_code)
      return nearest(map, s, x, y, code, plane, clamped);
  }
  code = at_plane(code, plane, 2 * x, 2 * y);
  return code * one * one > (one - fy) * ((one - fx) * four[0] + fx * four[1]) +
                                fy * ((one - fx) * four[2] + fx * four[3]);
}

int darkness(const int32_t *map, const Settings *s, const i64 result[3], const i64 dither[2],
             int taps[25][2], const Plane *plane, bool clamped) {
  i64 end = s->half_px * s->one_texel, place[2], code = result[2] + s->depth_offset;
  for (int k = 0; k < 2; ++k) {
    place[k] = result[k] + dither[k];
    if (clamped) place[k] = (i64)clamp(place[k], -end, end - 1);
    if (place[k] < -end || place[k] >= end) return 0;
  }
  if (code < 0 || code > s->deepest_drawn) return 0;
  if (s->lookup == PERCENTAGE || s->lookup == FILTERED_DEPTH)
    return window(map, s, place[0], place[1], code, taps, clamped);
  bool four = s->lookup == BILINEAR && s->fraction_bits > 0;
  return (four ? bilinear : nearest)(map, s, place[0], place[1], code, plane, clamped) ? 255 : 0;
}

bool correct_shadow(const Tests *t, int light, const Sample *sample, i64 code) {
  const Settings *s = t->s;
  i64 pixel = sample->py * s->size_px + sample->px,
      shift = s->registration == REGISTER_INDEX ? 4096 : 0;
  i64 words[3], result[3];
  int taps[25][2];
  input_words(0, 0, code, s, words);
  words[0] = (i64)down(sample->x - shift, 13 - (int)s->input_fraction, HALF_UP);
  words[1] = (i64)down(sample->y - shift, 13 - (int)s->input_fraction, HALF_UP);
  const Light *l = t->lights + light;
  if (transform(&l->m, s, words, result) != OK) return false;
  const i64 dither[2] = {t->dither[2 * pixel], t->dither[2 * pixel + 1]};
  if (s->tap_places == JITTERED) tap_bytes(s->dither_seed, s->taps, pixel, taps);
  return darkness(l->map, s, result, dither, taps, NULL, false) != 0;
}

static Status by_matrix(const void *m, const Settings *s, const i64 p[3], i64 out[3]) {
  return transform(m, s, p, out);
}

void post_process(const Observer *o, const Light *light, const Settings *s, const int32_t *dither,
                  int32_t *mask) {
  for (i64 pixel = 0; pixel < s->pixels; ++pixel)
    mask[pixel] = o->observer_z[pixel] == s->background_code
                      ? 0
                      : pixel_darkness(o, light, s, by_matrix, &light->m, pixel % s->size_px,
                                       pixel / s->size_px, dither, false);
}
