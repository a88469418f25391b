/* Section 15: the figures' scene, the variants' scenes, views and sources. */
#include <stdlib.h>
#include <string.h>

#include "machine.h"
#include "scenes.h"

static const i64 spheres[4][3] = {
    {-68813, 39322, 0}, {62259, 77332, 19661}, {-49152, -73400, 13107}, {68813, -27525, 29491}};
static const i64 vertices[13][3] = {
    {-196608, -127795, 196608}, {196608, -127795, 196608}, {196608, -127795, -196608},
    {-196608, -127795, -196608}, {132259, 20000, 19661}, {-7741, 20000, 19661},
    {62259, 90000, 19661}, {62259, -50000, 19661}, {62259, 20000, 89661}, {62259, 20000, -50339},
    {-150000, 110000, -90000}, {170000, 130000, -120000}, {-20000, 122000, 100000}};
static const int flat_facets[3][3] = {{0, 1, 2}, {0, 2, 3}, {10, 11, 12}};

static void add_facet(Scene *s, const int three[3], bool smooth) {
  Facet *f = s->facets + s->n_facets++;
  f->smooth = smooth;
  for (int n = 0; n < 3; ++n)
    for (int k = 0; k < 3; ++k) {
      f->p[n][k] = vertices[three[n]][k];
      int way = three[n] - 4;
      f->n[n][k] = smooth && way / 2 == k ? (way % 2 ? -16384 : 16384) : 0;
    }
}

void make_scene(const char *name, Scene *s) {
  static const i64 origin[3] = {-196608, -127795, 196608}, u[3] = {393216, 0, 0},
                   v[3] = {0, 0, -393216};
  bool mesh = !strcmp(name, "mesh");
  memset(s, 0, sizeof *s);
  strncpy(s->name, name, sizeof s->name - 1);
  s->floor = !strcmp(name, "floor");
  if (!mesh && !s->floor && strcmp(name, "spheres")) fail("section 15 has no scene %s", name);
  for (int k = 0; k < (mesh ? 1 : 4); ++k)
    for (int n = 0; n < 32; ++n) s->patches[s->n_patches++] = sphere_patch(spheres[k], 47186, n);
  if (s->floor) s->patches[s->n_patches++] = plane_patch(origin, u, v);
  for (int n = 0; n < s->n_patches; ++n)
    for (int k = 0; k < 16; ++k)
      memcpy(s->points[s->n_points++], s->patches[n].p[k], sizeof *s->points);
  if (!mesh) return;
  for (int k = 0; k < 13; ++k) memcpy(s->points[s->n_points++], vertices[k], sizeof *s->points);
  for (int k = 0; k < 3; ++k) add_facet(s, flat_facets[k], false);
  for (int k = 0; k < 8; ++k) {
    const int three[3] = {4 + k % 2, 6 + k / 2 % 2, 8 + k / 4};
    add_facet(s, three, true);
  }
}

static const struct {
  const char *name;
  bool at_point;
  i64 place[3]; /* azimuth and elevation in degrees, or a position */
  i64 extent, distance, near, far;
} views[] = {
    {"front", false, {0, 0, 0}, 131072, 0, -131072, 131072},
    {"left", false, {-100, 0, 0}, 131072, 0, -131072, 131072},
    {"right", false, {100, 0, 0}, 131072, 0, -131072, 131072},
    {"oblique", false, {30, 20, 0}, 131072, 393216, 0, 0},
    {"sun", false, {-100, 30, 0}, 262144, 0, 0, 0},
    {"lamp", true, {-327680, 262144, 131072}, 262144, 439629, 0, 0},
    {"near_eye", false, {30, 20, 0}, 131072, 98304, 4096, 524288},
    {"clipped", false, {-100, 0, 0}, 65536, 0, -32768, 32768},
    {"spot", false, {-100, 30, 0}, 65536, 0, -196608, 196608},
    {"inside", true, {10000, 60000, 20000}, 131072, 64031, 2048, 524288}};

static size_t number_of(const char *name) {
  for (size_t k = 0; k < sizeof views / sizeof *views; ++k)
    if (!strcmp(views[k].name, name)) return k;
  fail("section 15 has no view %s", name);
}

View make_view(const char *name, Scene *s) {
  static const i64 middle[3] = {0, 0, 0};
  size_t n = number_of(name);
  View v = {.extent = views[n].extent, .distance = views[n].distance, .near = views[n].near,
            .far = views[n].far};
  if (views[n].at_point) axes_from_points(views[n].place, middle, &v);
  else axes_from_angles(views[n].place[0] * 65536, views[n].place[1] * 65536, &v);
  if (v.near == v.far) fit_depths(&v, s->points, s->n_points);
  return v;
}

/* Section 23: the views of a square source's lights. */
static void area(Source *source, const char *name, i64 size, int n, i64 seed, Scene *s) {
  static const i64 middle[3] = {0, 0, 0};
  size_t number = number_of(name);
  Noise noise = noise_at(seed ? seed : 1, 0);
  for (int light = 0; light < n * n; ++light) {
    View *v = source->views + source->n_views++;
    i64 a = 2 * (light % n) + 1 - n, b = 2 * (light / n) + 1 - n, over = 2 * n, place[3];
    if (seed) {
      int byte_u = noise_byte(&noise), byte_v = noise_byte(&noise);
      a = 512 * (light % n) - 256 * n + 2 * byte_u + 1;
      b = 512 * (light / n) - 256 * n + 2 * byte_v + 1;
      over = 512 * n;
    }
    for (int k = 0; k < 3; ++k)
      place[k] = views[number].place[k] +
                 half_up(((i128)a * source->place.right[k] + (i128)b * source->place.up[k]) * size,
                         over * power(30));
    *v = (View){.extent = views[number].extent};
    axes_from_points(place, middle, v);
    i128 square = dot(place, place), root = isqrt((u128)square);
    v->distance = (i64)(root + (square - root * root > root));
    fit_depths(v, s->points, s->n_points);
  }
}

static void bulb(Source *source) {
  static const i64 p[3] = {10000, 60000, 20000};
  memcpy(source->p, p, sizeof p);
  source->sectored = true;
  for (; source->n_views < 6; ++source->n_views) {
    View *v = source->views + source->n_views;
    sector_view(p, 65536, source->n_views, v);
    v->near = 2048;
    v->far = 524288;
  }
  source->place = source->views[0];
}

/* "view" or a source of section 15's table, and "ramp w" after its name. */
Source make_source(const char *written, Scene *s) {
  static const struct {
    const char *name, *view;
    i64 level[3], size;
    int n;
    i64 seed;
  } known[] = {{"dim", "right", {128, 128, 128}, 0, 0, 0},
               {"red", "sun", {256, 64, 32}, 0, 0, 0},
               {"panel", "lamp", {256, 256, 256}, 131072, 2, 0},
               {"scatter", "lamp", {256, 256, 256}, 131072, 2, 78}};
  Source source = {.level = {256, 256, 256}};
  char name[32];
  size_t length = strcspn(written, " ");
  if (length >= sizeof name) fail("no source: %s", written);
  memcpy(name, written, length);
  name[length] = 0;
  if (!strncmp(written + length, " ramp ", 6)) source.ramp = atoi(written + length + 6);
  if (!strcmp(name, "bulb")) {
    bulb(&source);
    return source;
  }
  const char *view = name;
  size_t k = 0;
  while (k < 4 && strcmp(known[k].name, name)) ++k;
  if (k < 4) {
    view = known[k].view;
    memcpy(source.level, known[k].level, sizeof source.level);
    source.coloured = known[k].level[0] != known[k].level[1];
  }
  source.place = make_view(view, s);
  if (k < 4 && known[k].n) {
    area(&source, view, known[k].size, known[k].n, known[k].seed, s);
  } else {
    source.views[source.n_views++] = source.place;
  }
  return source;
}
