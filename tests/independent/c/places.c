/* The light sampled at the visible points: shadow/rivals/scan_out.md, section 5, "In the machine's
 * words". */
#include "machine.h"

void find_places(const int32_t *observer_z, const Loaded *m, const Settings *s, Places *places) {
  i64 end = s->half_px * s->one_texel;
  places->places = zeroed((size_t)s->pixels, sizeof *places->places);
  places->heads = zeroed((size_t)s->pixels, sizeof *places->heads);
  for (i64 k = 0; k < s->pixels; ++k) places->heads[k] = -1;
  for (i64 pixel = 0; pixel < s->pixels; ++pixel) {
    i64 words[3], at[3];
    Place *p = places->places + pixel;
    p->code = -1;
    p->least = s->background_code;
    if (observer_z[pixel] == s->background_code) continue;
    input_words(pixel % s->size_px, pixel / s->size_px, observer_z[pixel], s, words);
    if (transform(m, s, words, at) != OK) continue;
    i64 code = at[2] + s->depth_offset;
    if (at[0] < -end || at[0] >= end || at[1] < -end || at[1] >= end) continue;
    if (code < 0 || code > s->deepest_drawn) continue;
    p->code = code;
    p->x = (i64)(at[0] * power(13 - (int)s->fraction_bits));
    p->y = (i64)(at[1] * power(13 - (int)s->fraction_bits));
    i64 texel = ((p->y >> 13) + s->half_px) * s->size_px + (p->x >> 13) + s->half_px;
    p->next = places->heads[texel];
    places->heads[texel] = (int32_t)pixel;
  }
}
