/* Views that several variants have in common are drawn once: a view's planes depend on the scene,
 * the view, its shading, and on those settings that drawing reads. */
#include <string.h>

#include "machine.h"
#include "scenes.h"

typedef struct {
  char scene[16];
  Settings s;
  View view;
  Shading shading;
  int words;
} Key;
static struct { Key key; int32_t *planes; Counts counts; } drawn[64];
static int n_drawn;

/* What drawing does not read is set to its default. */
static Settings of_drawing(const Settings *given) {
  Settings s = *given, d = defaults();
  if (!s.bias_clamp) s.bias_unit = d.bias_unit;
  s.fraction_bits = d.fraction_bits;
  s.accumulator_bits = d.accumulator_bits;
  s.product_rounding = d.product_rounding;
  s.divide_order = d.divide_order;
  s.registration = d.registration;
  s.lookup = d.lookup;
  s.background = d.background;
  s.taps = d.taps;
  s.tap_places = d.tap_places;
  s.bias = d.bias;
  s.receiver = d.receiver;
  s.normal_offset = d.normal_offset;
  s.slope_source = d.slope_source;
  s.dither = d.dither;
  s.dither_size = d.dither_size;
  s.dither_seed = d.dither_seed;
  s.dequantize = d.dequantize;
  s.low_pass = d.low_pass;
  s.composite = d.composite;
  s.density = d.density;
  s.form = d.form;
  s.arithmetic = d.arithmetic;
  widths(&s);
  return s;
}

static Key key_of(const Frame *f, const View *v, const Shading *shading, int words) {
  Key k;
  memset(&k, 0, sizeof k);
  strcpy(k.scene, f->scene.name);
  k.s = of_drawing(&f->s);
  k.view = *v;
  if (shading) k.shading = *shading;
  k.words = words;
  return k;
}

bool reuse(const Frame *f, const View *v, const Shading *shading, int words, int32_t *planes,
           Counts *counts) {
  Key key = key_of(f, v, shading, words);
  for (int k = 0; k < n_drawn; ++k)
    if (!memcmp(&drawn[k].key, &key, sizeof key)) {
      memcpy(planes, drawn[k].planes, (size_t)(f->s.pixels * words) * sizeof *planes);
      *counts = drawn[k].counts;
      return true;
    }
  return false;
}

void keep(const Frame *f, const View *v, const Shading *shading, int words, const int32_t *planes,
          Counts counts) {
  if (n_drawn == sizeof drawn / sizeof *drawn || f->s.pixels < 512 * 512) return;
  size_t size = (size_t)(f->s.pixels * words) * sizeof *planes;
  drawn[n_drawn].key = key_of(f, v, shading, words);
  drawn[n_drawn].planes = zeroed(1, size);
  memcpy(drawn[n_drawn].planes, planes, size);
  drawn[n_drawn++].counts = counts;
}
