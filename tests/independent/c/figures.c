/* Section 15: the frames of figures and variants. Sections 23 and 26: what a frame of several
 * lights, or with a ground, consists of. */
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "scenes.h"

static int32_t *plane(const Frame *f) { return zeroed((size_t)f->s.pixels, sizeof(int32_t)); }

static Surfaces drawn(const Frame *f, const Patch *patches, int count, const Facet *facets,
                      int n_facets) {
  Surfaces all = {zeroed((size_t)count, sizeof *all.patches), 0, NULL, 0};
  bool diced = f->s.surface == DICED;
  i64 tolerance = f->observer.extent >> (f->s.xy_bits + 1);
  all.facets = zeroed((size_t)(n_facets + (diced ? 2048 * count : 0)), sizeof *all.facets);
  for (int n = 0; n < count; ++n) {
    if (diced) {
      all.n_facets += dice(patches + n, tolerance, f->s.dice_levels, f->fraction,
                           all.facets + all.n_facets);
      continue;
    }
    Patch *p = all.patches + all.n_patches++;
    for (int k = 0; k < 48; ++k)
      p->p[k / 3][k % 3] = object_word(patches[n].p[k / 3][k % 3], f->fraction);
  }
  for (int n = 0; n < n_facets; ++n) {
    Facet *to = all.facets + all.n_facets++;
    *to = facets[n];
    for (int k = 0; k < 9; ++k) to->p[k / 3][k % 3] = object_word(to->p[k / 3][k % 3], f->fraction);
  }
  return all;
}

static void make_surfaces(Frame *f) {
  Scene *s = &f->scene;
  Patch blobs[32];
  int n_blobs = 0;
  i128 largest = 0;
  for (int k = 0; k < 4 && f->s.form == BLOB; ++k) { /* an ellipse beneath each sphere */
    i64 centre[3], a[3], b[3];
    ellipse(s->patches + 128, s->points + 512 * k, 512, centre, a, b);
    for (int n = 0; n < 8; ++n) blobs[n_blobs++] = ellipse_patch(centre, a, b, n);
  }
  for (int n = 0; n < s->n_points; ++n)
    for (int k = 0; k < 3; ++k) largest = greater(largest, magnitude(s->points[n][k]));
  for (int n = 0; n < 48 * n_blobs; ++n)
    largest = greater(largest, magnitude(blobs[n / 48].p[n % 48 / 3][n % 3]));
  f->fraction = object_fraction((i64)largest);
  int others = s->n_patches - s->floor;
  f->all = drawn(f, s->patches, s->n_patches, s->facets, s->n_facets);
  f->ground = drawn(f, s->patches + others, s->floor, NULL, 0);
  f->others = drawn(f, s->patches, others, s->facets, s->n_facets);
  f->blobs = drawn(f, blobs, n_blobs, NULL, 0);
}

static void make_shading(Frame *f) {
  static const i64 diffuse[3] = {215, 140, 60};
  Shading *sh = &f->shading;
  f->channels = 1;
  for (int n = 0; n < f->n_sources; ++n)
    if (f->sources[n].coloured) f->channels = 3;
  f->kept = f->s.receiver != POINT && f->s.slope_source == NORMALS;
  *sh = (Shading){.sources = f->n_sources, .channels = f->channels, .ambient = f->s.ambient,
                  .shininess = 5, .rule = f->s.shading, .kept = f->kept};
  sh->viewer = toward(&f->observer, f->fraction);
  for (int c = 0; c < 3; ++c) sh->diffuse[c] = diffuse[c], sh->specular[c] = 90;
  for (int n = 0; n < f->n_sources; ++n) {
    sh->light[n] = toward(&f->sources[n].place, f->fraction);
    memcpy(sh->level[n], f->sources[n].level, sizeof sh->level[n]);
  }
}

static void loaded(const Exact *m, const Settings *s, int fraction, i64 one, Loaded *to) {
  if (!load(m, s, fraction, one, to)) fail("a matrix is refused (section 5)");
}

static Drawing drawing(Frame *f, const View *v) {
  Drawing d = {.s = &f->s, .fraction = f->fraction, .front = f->s.facing == FRONT,
               .slope_limit = -1};
  Exact m;
  world_to_screen(v, &f->s, &m);
  loaded(&m, &f->s, f->fraction, 1 << 14, &d.m);
  return d;
}

static void draw_map(Frame *f, int light) {
  const Settings *s = &f->s;
  const View *v = f->views + light;
  Drawing d = drawing(f, v);
  d.light = true;
  d.back = s->map_depth == BACK;
  d.front = d.front && !d.back;
  d.slope_factor = s->bias_slope;
  if (s->bias_clamp)
    d.slope_limit = (i64)down(bias_quanta(v, s->bias_clamp, s->bias_unit, s),
                              16 - (int)s->depth_guard, FLOOR);
  d.records = zeroed((size_t)s->pixels, 2 * sizeof(int32_t));
  for (i64 k = 0; k < 2 * s->pixels; ++k) d.records[k] = (int32_t)s->background_code;
  if (!reuse(f, v, NULL, 2, d.records, &d.counts)) {
    draw(&d, &f->all);
    keep(f, v, NULL, 2, d.records, d.counts);
  }
  f->maps[light] = plane(f);
  for (i64 k = 0; k < s->pixels; ++k)
    f->maps[light][k] = s->map_depth == MIDPOINT ? (int32_t)midpoint(d.records + 2 * k)
                                                 : d.records[2 * k];
  free(d.records);
  if (light == 0) f->counts[1] = d.counts;
}

static void make_lights(Frame *f) {
  for (int k = 0; k < f->n_lights; ++k) {
    Light *l = f->lights + k;
    Exact m;
    if (f->s.form != GROUND && f->s.form != BLOB && f->s.form != IRREGULAR_MAP) draw_map(f, k);
    l->map = f->maps[k];
    observer_to_light(&f->observer, f->views + k,
                      bias_quanta(f->views + k, f->s.bias, f->s.bias_unit, &f->s), &f->s, &m);
    bool sectored = false;
    for (int n = 0, first = 0; n < f->n_sources; first += f->sources[n++].n_views)
      if (k >= first && k < first + f->sources[n].n_views) sectored = f->sources[n].sectored;
    if (!sectored) loaded(&m, &f->s, (int)f->s.input_fraction, f->s.one_word, &l->m);
    set_receiver(f->views + k, &f->s, l);
  }
}

static void clear_store(Frame *f) {
  int masks = f->s.form == CORRECT ? f->n_lights : 0;
  f->record_words = 1 + f->channels * (1 + f->n_sources) + masks + 3 * f->kept;
  f->records = zeroed((size_t)f->s.pixels, (size_t)f->record_words * sizeof(int32_t));
  for (i64 k = 0; k < f->s.pixels; ++k)
    f->records[k * f->record_words] = (int32_t)f->s.background_code;
  f->masks = zeroed((size_t)f->s.pixels, (size_t)f->n_lights * sizeof(int32_t));
}

static void draw_observer(Frame *f, const Surfaces *surfaces, const Tests *tests, int cleared) {
  Drawing d = drawing(f, &f->observer);
  d.shading = &f->shading;
  d.records = f->records;
  d.record_words = f->record_words;
  d.tests = tests;
  d.masks = tests ? f->n_lights : 0;
  d.mask = f->masks;
  d.cleared_masks = cleared;
  bool alone = surfaces == &f->all && !tests;
  if (!alone || !reuse(f, &f->observer, d.shading, d.record_words, d.records, &d.counts)) {
    draw(&d, surfaces);
    if (alone) keep(f, &f->observer, d.shading, d.record_words, d.records, d.counts);
  }
  f->counts[0] = d.counts;
}

static void draw_shadows(Frame *f) {
  for (int k = 0; k < f->n_lights; ++k) {
    Drawing d = drawing(f, &f->observer);
    Exact m;
    int others = f->scene.n_patches - 1; /* the ground, and its points, are the last */
    if (f->s.form == GROUND) {
      if (!shadow_matrix(&f->observer, f->views + k, f->scene.patches + others, f->scene.points,
                         f->scene.n_points - 16, &f->s, &m))
        fail("a light lies in the ground's plane (section 26)");
      loaded(&m, &f->s, f->fraction, 1 << 14, &d.m);
    }
    d.front = false;
    d.records = f->records;
    d.record_words = f->record_words;
    d.mask = f->masks + k * f->s.pixels;
    draw(&d, f->s.form == GROUND ? &f->others : &f->blobs);
  }
}

static void mask_at_places(Frame *f, int light, int32_t *mask) {
  Drawing d = drawing(f, f->views + light);
  Places places;
  find_places(f->observer_z, &f->lights[light].m, &f->s, &places);
  d.light = true;
  d.places = &places;
  draw(&d, &f->all);
  for (i64 k = 0; k < f->s.pixels; ++k)
    mask[k] = places.places[k].code > places.places[k].least ? 255 : 0;
}

static void split_records(Frame *f) {
  f->observer_z = plane(f);
  f->visible = zeroed((size_t)f->s.pixels, 1);
  for (int k = 0; k < 3; ++k) f->normals[k] = plane(f);
  for (i64 p = 0; p < f->s.pixels; ++p) {
    const int32_t *r = f->records + p * f->record_words;
    f->observer_z[p] = r[0];
    f->visible[p] = r[0] != f->s.background_code;
    for (int k = 0; k < 3 && f->kept; ++k) f->normals[k][p] = r[f->record_words - 3 + k] + 32768;
    for (int l = 0; l < f->n_lights && f->s.form == CORRECT; ++l)
      f->masks[l * f->s.pixels + p] = r[f->record_words - f->n_lights + l];
  }
}

static void make_masks(Frame *f) {
  const Observer o = {f->observer_z, {f->normals[0], f->normals[1], f->normals[2]}};
  for (int n = 0, k = 0; n < f->n_sources; k += f->sources[n++].n_views)
    for (int l = k; l < k + f->sources[n].n_views; ++l) {
      int32_t *mask = f->masks + l * f->s.pixels;
      if (f->sources[n].sectored) {
        if (l == k)
          sector_mask(&o, &f->observer, f->views + k, f->lights + k, f->sources[n].p, &f->s,
                      f->dither, mask);
      } else if (f->s.form == IRREGULAR_MAP) {
        mask_at_places(f, l, mask);
      } else if (f->s.arithmetic == AP120B) {
        Exact m;
        observer_to_light(&f->observer, f->views + l,
                          bias_quanta(f->views + l, f->s.bias, f->s.bias_unit, &f->s), &f->s, &m);
        array_mask(f->observer_z, f->maps[l], &m, &f->s, f->dither, mask);
      } else {
        post_process(&o, f->lights + l, &f->s, f->dither, mask);
      }
    }
}

static void filter(Frame *f) {
  int size = (int)f->s.size_px;
  for (int n = 0, first = 0; n < f->n_sources; first += f->sources[n++].n_views) {
    const Source *of = f->sources + n;
    int lights = of->sectored ? 1 : of->n_views;
    int32_t *dark = f->darkness[n] = plane(f), *edges = f->edges[n] = plane(f),
            *out = f->filtered[n] = plane(f), *next = plane(f);
    for (i64 p = 0; p < f->s.pixels; ++p) {
      for (int k = 0; k < lights; ++k) dark[p] += f->masks[(first + k) * f->s.pixels + p];
      dark[p] = (2 * dark[p] + lights) / (2 * lights);
    }
    if (of->ramp) ramp(dark, f->visible, of->ramp, size);
    bool graded = f->s.lookup == PERCENTAGE || of->ramp || lights > 1;
    size_t bytes = (size_t)f->s.pixels * sizeof *dark;
    if (f->s.dequantize && !graded)
      dequantize(dark, f->visible, (int)f->s.dequantize, size, edges);
    else memcpy(edges, dark, bytes);
    memcpy(out, edges, bytes);
    for (int pass = 0; pass < f->s.low_pass; ++pass) {
      low_pass(out, f->visible, size, next);
      memcpy(out, next, bytes);
    }
    free(next);
  }
}

void make_frame(Frame *f) {
  make_surfaces(f);
  make_shading(f);
  clear_store(f);
  f->dither = zeroed((size_t)f->s.pixels, 2 * sizeof *f->dither);
  dither_words(&f->s, f->dither);
  make_lights(f);
  const Tests tests = {&f->s, f->lights, f->n_lights, f->dither};
  if (f->s.form == GROUND || f->s.form == BLOB) {
    draw_observer(f, &f->ground, NULL, 0);
    draw_shadows(f);
    draw_observer(f, &f->others, NULL, f->n_lights);
    split_records(f);
  } else {
    draw_observer(f, &f->all, f->s.form == CORRECT ? &tests : NULL, 0);
    split_records(f);
    if (f->s.form != CORRECT) make_masks(f);
  }
  filter(f);
}

void free_frame(Frame *f) {
  Surfaces *surfaces[4] = {&f->all, &f->ground, &f->others, &f->blobs};
  for (int k = 0; k < 4; ++k) free(surfaces[k]->patches), free(surfaces[k]->facets);
  for (int k = 0; k < 3; ++k) free(f->normals[k]);
  for (int k = 0; k < f->n_lights; ++k) free(f->maps[k]);
  for (int k = 0; k < f->n_sources; ++k)
    free(f->darkness[k]), free(f->edges[k]), free(f->filtered[k]);
  free(f->records), free(f->dither), free(f->observer_z), free(f->masks), free(f->visible);
}
