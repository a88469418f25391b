/* A third reading of hw/MACHINE.md and hw/machine/, in C, written from that text alone: what the
 * files share. Each file is a section or two of the text and is best read beside it. All
 * arithmetic is on integers; `Big` holds those that outgrow 128 bits. */
#ifndef MACHINE_H
#define MACHINE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef int64_t i64;
typedef uint64_t u64;
__extension__ typedef __int128 i128;
__extension__ typedef unsigned __int128 u128;

/* Section 1: notation.c, and big.c. */
typedef enum {
  FLOOR, CEILING, TO_ZERO, HALF_UP, HALF_TO_ZERO, HALF_AWAY, HALF_EVEN
} Rounding;
enum { LIMBS = 96 };
typedef struct {
  int sign, n; /* -1, 0 or 1; limbs in use, least significant first */
  uint32_t w[LIMBS];
} Big;

_Noreturn void fail(const char *format, ...);
void *zeroed(size_t count, size_t size);
i128 power(int n);                                       /* 2^n */
i128 divide(i128 a, i128 b, Rounding r);                 /* a / b, b not 0 */
i64 half_up(i128 a, i128 b);
i64 half_even(i128 a, i128 b);
i128 down(i128 a, int n, Rounding r);                    /* a / 2^n, n of either sign */
i128 quotient(i128 a, int up, i128 b, Rounding r);       /* a 2^up / b, up of either sign */
i128 rounded(bool negative, i128 q, int half, bool exact, Rounding r);
u64 isqrt(u128 a);
int bits(u128 a);
bool fits(i128 word, int n);
i128 clamp(i128 a, i128 least, i128 most);
i128 magnitude(i128 a);
i128 greater(i128 a, i128 b);
i128 dot(const i64 a[3], const i64 b[3]);
u64 fnv(const int32_t *values, size_t count, int size, u64 h);

Big big(i128 a);
Big big_add(Big a, Big b);
Big big_sub(Big a, Big b);
Big big_mul(Big a, Big b);
Big times(Big a, i128 b);
Big big_shift(Big a, int n);                             /* a 2^n, n >= 0 */
int big_bits(const Big *a);
int big_compare(Big a, Big b);
i128 big_round(Big a, Big b, Rounding r);                /* saturates at +-2^126 */

/* Section 2: settings.c. Choices are numbered as the table lists them. */
enum { EXACT_ORDER, ROUND_FIRST };
enum { CATMULL, DICED };
enum { BOTH, FRONT };
enum { LEAF, CENTRE };
enum { REGISTER_CENTRE, REGISTER_INDEX };
enum { NEAREST, BILINEAR, PERCENTAGE, FILTERED_DEPTH };
enum { BLEND, FALL_BACK };
enum { GRID, JITTERED };
enum { QUANTA, TEXELS, WORLD };
enum { FIRST, BACK, MIDPOINT };
enum { POINT, PLANE, NORMAL };
enum { DEPTHS, NORMALS };
enum { NO_DITHER, UNIFORM, TRIANGULAR, NORMAL4, NORMAL12 };
enum { PHONG, BLINN, LAMBERT, UNSHADED };
enum { DIRECT, WHOLE };
enum { POST_PROCESS, CORRECT, GROUND, BLOB, IRREGULAR_MAP };
enum { FIXED, AP120B };
typedef struct {
  i64 xy_bits, z_bits, coefficient_bits, fraction_bits, accumulator_bits, product_rounding,
      transform_rounding, coefficient_rounding, depth_rounding, divide_order, surface, dice_levels,
      facing, sampling, registration, lookup, background, taps, tap_places, bias, bias_unit,
      map_depth, bias_slope, bias_clamp, receiver, normal_offset, slope_source, dither,
      dither_size, dither_seed, dequantize, low_pass, ambient, shading, composite, density, form,
      arithmetic;
  /* What follows from them. */
  i64 size_px, half_px, pixels, depth_fraction, depth_offset, background_code, deepest_drawn,
      input_fraction, word_bits, one_word, dropped_bits, depth_guard, one_texel;
} Settings;
void read_defaults(const char *text);
Settings defaults(void);
void set(Settings *s, const char *key, const char *value); /* then widths() */
void widths(Settings *s);
Settings settings(const char *written); /* "key value, key value", ambient 90 */
const char *choice(const Settings *s, const char *key);
i64 decimal(const char *written, int fraction_bits);

/* Section 3: words.c. World words, then object words. */
typedef struct { i64 p[16][3]; } Patch;
typedef struct { i64 p[3][3], n[3][3]; bool smooth; } Facet;
typedef struct { Patch *patches; int n_patches; Facet *facets; int n_facets; } Surfaces;
i64 mul30(i64 a, i64 b);
void sine_cosine(i64 angle, i64 *sine, i64 *cosine);
void arc(int k, int point, i64 *sine, i64 *cosine);
Patch sphere_patch(const i64 centre[3], i64 radius, int number);
Patch plane_patch(const i64 origin[3], const i64 u[3], const i64 v[3]);
int object_fraction(i64 largest);
i64 object_word(i64 world, int fraction);

/* Section 4: views.c. */
typedef struct {
  i64 right[3], up[3], back[3], target[3];
  i64 extent, distance, near, far; /* distance 0: orthographic */
} View;
typedef struct { Big n[4][4], d; } Exact; /* n / d */
void axes_from_angles(i64 azimuth, i64 elevation, View *v);
void axes_from_points(const i64 from[3], const i64 to[3], View *v);
void fit_depths(View *v, i64 (*points)[3], int count);
void origin_of(const View *v, i128 origin[3]); /* Q.46 */
void world_to_screen(const View *v, const Settings *s, Exact *m);
void screen_to_world(const View *v, const Settings *s, Exact *m);
void product(const Exact *a, const Exact *b, Exact *m);
i64 bias_quanta(const View *v, i64 bias, i64 unit, const Settings *s);
void observer_to_light(const View *observer, const View *light, i64 quanta, const Settings *s,
                       Exact *m);

/* Section 5: transform_unit.c. */
typedef struct { bool affine; i64 c[4][4]; int e[4]; int fraction; i64 one; } Loaded;
typedef enum { OK, DIVISOR_NOT_POSITIVE, OVERFLOWED } Status;
bool load_rows(const Exact *m, const int *rows, int count, const Settings *s, int fraction, i64 one,
               const Big *d, i64 (*c)[4], int *e);
bool load(const Exact *m, const Settings *s, int fraction, i64 one, Loaded *loaded);
void accumulate(const Loaded *m, const Settings *s, const i64 p[3], i128 acc[4]);
Status results(const Loaded *m, const Settings *s, const i128 acc[4], i64 out[3]);
Status transform(const Loaded *m, const Settings *s, const i64 p[3], i64 out[3]);

/* Sections 6 and 14: blocks.c, perspective.c. A component's f, gu, gv and guv at the corners. */
typedef struct { i64 v[4][4]; } Component;
typedef struct { i64 min, max, slope[2], bend[2]; } Bounds;
typedef struct { i64 tested, splits, drawn, samples; } Counts;
enum { F, GU, GV, GUV };
enum { HUGE_BITS = 58 };
typedef enum { OUTSIDE, SPLIT_U, SPLIT_V, DRAW, CROSSES } Fate;
Component component(const i64 p[16]);
void split(const Component *c, int way, Component *low, Component *high);
Bounds bounds(const Component *c);
Fate block_rule(const Bounds b[3], const Settings *s);
Fate quotient_bounds(const Component c[4], const Settings *s, Bounds b[3]); /* DRAW: b is found */
bool huge(const Bounds b[3]);
Fate perspective_rule(const Component c[4], const int splits[2], const Settings *s);
typedef struct { i64 x, y, z; } Corner;
bool divide_place(const i64 place[4], const Settings *s, Corner *corner);
void screen_words(const Loaded *m, const Settings *s, const i64 object[3], i64 place[4]);

/* Sections 9, 23 and 27: shading.c, normals.c. */
typedef struct { bool point; i64 words[3]; } Toward; /* a direction, or where it leads to */
typedef struct {
  int sources, channels;
  Toward viewer, light[8];
  i64 level[8][3], diffuse[3], specular[3], shininess, ambient, rule;
  bool kept;
} Shading;
i64 cut_to(const i128 v[3], int n, i64 out[3]);
void unit14(const i128 v[3], i64 out[3]);
void cross3(const i64 a[3], const i64 b[3], i128 out[3]);
Toward toward(const View *v, int object_fraction);
void direction(const Toward *t, const i64 place[3], i64 out[3]); /* place: times 1024 */
void corner_normals(const Component places[3], i64 normals[4][3]);
i64 at_leaf(const i64 q[4], int i, int j);
void shade(const Shading *sh, const i64 normal[3], const i64 place[3], bool facet,
           const bool *shadowed, int32_t *planes);
void kept_normal(const i64 n[3], const i64 to_viewer[3], int32_t out[3]);

/* Sections 7, 8 and 21: samples.c, store.c, triangles.c. */
typedef struct Sample {
  i64 px, py, z, x, y; /* x, y: raster units */
  i64 rise;            /* the slope's offset */
  int place;           /* of the places of scan_out.md */
} Sample;
typedef struct { i64 v[10]; } Vertex; /* X Y Z W, object place times 2^6, normal */
typedef struct {
  i64 x, y, code, least, next;
} Place;
typedef struct { Place *places; int32_t *heads; int count; } Places;
typedef struct Tests Tests; /* of the correct form */
typedef struct {
  const Settings *s;
  Loaded m;
  int fraction;
  bool light, back, front; /* the light's map; only clockwise triangles; only the others */
  i64 slope_factor, slope_limit;
  /* What a sample meets, one of three: a record, a mask over a store, places. */
  int record_words;
  int32_t *records; /* of the light: code, and the second one */
  int32_t *mask;
  Places *places;
  const Shading *shading;
  const Tests *tests;
  int masks;
  int cleared_masks; /* of a source that is drawn over a shadow on the ground */
  Counts counts;
  /* The leaf or facet at hand. */
  const Component *object;
  i64 normals[4][3];
  int leaf_i, leaf_j;
  bool shaded; /* planes holds the levels of this leaf */
  int32_t planes[96];
  const Facet *facet;
  i64 own[3], e[3];
  const Vertex *corners[3];
} Drawing;
void draw(Drawing *d, const Surfaces *surfaces);
void draw_facet(Drawing *d, const Facet *facet);
void leaf_corners(const Component *c, i64 grid[17][17]); /* [i][j] */
bool triangle_depth(const Corner t[3], i64 x, i64 y, i64 *z);
i64 cross(const Corner *p, const Corner *q, i64 x, i64 y);
void draw_leaves(Drawing *d, Corner (*corners)[17]);
i64 z_code(i64 z, const Settings *s); /* -1: no sample */
void put(Drawing *d, const Sample *sample);
void facet_normal(const Drawing *d, i64 normal[3], i64 place[3]);
typedef void Visit(Drawing *d, const Corner t[3], Sample *sample);
void visit_box(Drawing *d, const Corner t[3], i64 slack, i64 rise, Visit *visit);
int guard_band(const Vertex in[3], bool affine, const Settings *s, Vertex out[9]);
bool covered(const Corner t[3], i64 x, i64 y);
i64 plane_depth(const Corner t[3], i64 x, i64 y);
void own_normal(const Vertex facet[3], i64 g[3]);

/* Section 10: noise.c. */
typedef struct { uint32_t bits; } Noise;
Noise noise_at(i64 seed, u64 offset);
int noise_byte(Noise *n);
i64 amplitude(int bytes, i64 size, int fraction_bits);
int bytes_a_word(const Settings *s);
void dither_pair(Noise *n, int bytes, i64 amplitude, i64 d[2]);
void dither_words(const Settings *s, int32_t *words); /* X and Y of each pixel */
void tap_bytes(i64 seed, i64 taps, i64 pixel, int bytes[25][2]);

/* Sections 11, 12, 24, 25 and 27: shadow_test.c, receiver.c, sectors.c. */
typedef struct { i64 quanta, reach, focal; int fraction_bits; } Scale; /* quanta 0: a lamp */
typedef struct {
  const int32_t *map;
  Loaded m;
  i64 limit; /* -1: none */
  Scale scale;
  i64 axes[3][3];
} Light;
struct Tests { const Settings *s; const Light *lights; int count; const int32_t *dither; };
typedef struct { bool found; i64 slope[2], at[2], limit; } Plane;
typedef struct { const int32_t *observer_z, *normals[3]; } Observer;
void input_words(i64 px, i64 py, i64 code, const Settings *s, i64 words[3]);
int darkness(const int32_t *map, const Settings *s, const i64 result[3], const i64 dither[2],
             int taps[25][2], const Plane *plane, bool clamped);
bool correct_shadow(const Tests *t, int light, const Sample *sample, i64 code);
void post_process(const Observer *o, const Light *light, const Settings *s, const int32_t *dither,
                  int32_t *mask);
typedef Status Unit(const void *unit, const Settings *s, const i64 p[3], i64 out[3]);
int pixel_darkness(const Observer *o, const Light *light, const Settings *s, Unit *unit,
                   const void *state, i64 px, i64 py, const int32_t *dither, bool clamped);
void set_receiver(const View *v, const Settings *s, Light *light);
int neighbour(const int32_t *z, const Settings *s, i64 px, i64 py, int dx, int dy);
bool gradient(const i64 u[3], const i64 v[3], i64 slope[2]);
i64 plane_change(const Plane *p, i64 twice_x, i64 twice_y);
void scale_at(const Scale *s, const i64 at[3], i64 *scale, i64 tilt[2]);
bool moved(const i64 at[3], const i64 u[3], const i64 v[3], int way, i64 c, const Scale *s,
           i64 out[3]);
bool moved_along(const i64 at[3], const i64 n[3], int way, i64 c, const Scale *s, i64 out[3]);
void light_axes(const View *v, i64 axes[3][3]);
void in_light(const i64 n[3], i64 axes[3][3], i64 m[3]);
bool leaning(const i64 at[3], const i64 m[3], const Scale *s, i64 slope[2]);
void sector_view(const i64 p[3], i64 distance, int sector, View *v);
void sector_mask(const Observer *o, const View *observer, const View *views, const Light *lights,
                 const i64 p[3], const Settings *s, const int32_t *dither, int32_t *mask);
void caster_slope(const Corner t[3], i64 *slope);
i64 slope_offset(i64 slope, i64 factor, i64 limit);
i64 moved_code(i64 z, i64 offset, const Settings *s);
void keep_two(int32_t layers[2], i64 code);
i64 midpoint(const int32_t layers[2]);

/* Section 13: filters.c; 18: ap120b.c; 22: dicing.c; 26: ground.c; scan_out.md: places.c. */
void dequantize(const int32_t *mask, const bool *visible, int passes, int size, int32_t *out);
void low_pass(const int32_t *in, const bool *visible, int size, int32_t *out);
i64 darken(i64 out, i64 share, i64 mask, i64 density);
void ramp(int32_t *mask, const bool *visible, int w, int size);
void array_mask(const int32_t *observer_z, const int32_t *map, const Exact *m, const Settings *s,
                const int32_t *dither, int32_t *mask);
i64 patch_level(const Patch *p, i64 tolerance, i64 most);
i64 edge_level(const Patch *p, int edge, i64 tolerance, i64 most);
void diced_vertex(const Patch *p, int i, int j, int k, i64 place[3]);
void diced_normal(const Patch *p, int i, int j, int k, i64 normal[3]);
int dice(const Patch *p, i64 tolerance, i64 most, int fraction, Facet *facets);
bool shadow_matrix(const View *observer, const View *light, const Patch *ground,
                   i64 (*points)[3], int count, const Settings *s, Exact *m);
void ellipse(const Patch *ground, i64 (*points)[3], int count, i64 centre[3], i64 a[3], i64 b[3]);
Patch ellipse_patch(const i64 centre[3], const i64 a[3], const i64 b[3], int number);
void find_places(const int32_t *observer_z, const Loaded *m, const Settings *s, Places *places);

/* The text, and what is checked: document.c, figures.c, vectors.c. */
typedef struct { char *cell[8]; int cells; } Row;
Row *table(const char *text, const char *head, int *count);
int check_figures(const char *text, char **only, int n_only, int part, int parts);
int check_vectors(const char *folder);

/* A line of a vectors' file: its words, and what is computed from them. */
typedef struct { char **words; int at, count; char result[4096]; } Line;
const char *word(Line *l);
i64 number(Line *l);
void numbers(Line *l, i64 *to, int count);
void say(Line *l, i64 value);
void says(Line *l, const i64 *values, int count);
void write_word(Line *l, const char *name);
void surface_vector(Line *l, const char *stage); /* vectors_of_surfaces.c */
#endif
