/* The vectors of ../vectors: "input words -> output words", computed anew. Here those of views,
 * noise, shadow test and filters; vectors_of_surfaces.c has the others. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine.h"

const char *word(Line *l) {
  if (l->at == l->count) fail("a vector is too short");
  return l->words[l->at++];
}
i64 number(Line *l) { return strtoll(word(l), NULL, 10); }
void numbers(Line *l, i64 *to, int count) {
  for (int k = 0; k < count; ++k) to[k] = number(l);
}
void write_word(Line *l, const char *name) {
  size_t used = strlen(l->result);
  snprintf(l->result + used, sizeof l->result - used, "%s%s", used ? " " : "", name);
}
void say(Line *l, i64 value) {
  char text[32];
  sprintf(text, "%lld", (long long)value);
  write_word(l, text);
}
void says(Line *l, const i64 *values, int count) {
  for (int k = 0; k < count; ++k) say(l, values[k]);
}

static Settings widths_of(Line *l, bool coefficients) {
  Settings s = defaults();
  s.xy_bits = number(l);
  s.z_bits = number(l);
  if (coefficients) s.coefficient_bits = number(l);
  widths(&s);
  return s;
}

static View view_of(Line *l) {
  View v;
  numbers(l, v.right, 3), numbers(l, v.up, 3), numbers(l, v.back, 3), numbers(l, v.target, 3);
  v.extent = number(l);
  v.distance = number(l);
  v.near = number(l);
  v.far = number(l);
  return v;
}

static void decimals(Line *l) {
  const char *written = word(l);
  say(l, decimal(written, (int)number(l)));
}

static void sines(Line *l) {
  i64 both[2];
  sine_cosine(number(l), both, both + 1);
  says(l, both, 2);
}

static void views(Line *l) {
  const char *kind = word(l);
  View v;
  i64 from[3], to[3], points[16][3];
  if (!strcmp(kind, "fit")) {
    v = view_of(l);
    numbers(l, points[0], 6);
    for (int k = 2; k < 16; ++k) memcpy(points[k], v.target, sizeof v.target);
    fit_depths(&v, points, 16);
    say(l, v.near), say(l, v.far);
    return;
  }
  numbers(l, from, strcmp(kind, "angles") ? 3 : 2);
  if (!strcmp(kind, "angles")) {
    axes_from_angles(from[0], from[1], &v);
  } else {
    numbers(l, to, 3);
    axes_from_points(from, to, &v);
  }
  says(l, v.right, 3), says(l, v.up, 3), says(l, v.back, 3);
}

static void say_loaded(Line *l, bool good, const Loaded *m) {
  if (!good) {
    write_word(l, "refused");
    return;
  }
  says(l, m->c[0], 16);
  for (int r = 0; r < 4; ++r) say(l, m->e[r]);
}

static void matrices(Line *l) {
  const char *kind = word(l), *unit;
  Exact m;
  Loaded loaded;
  if (!strcmp(kind, "bias")) {
    Settings s = defaults();
    i64 bias = number(l);
    set(&s, "bias_unit", unit = word(l));
    View light = view_of(l);
    say(l, bias_quanta(&light, bias, s.bias_unit, &s));
    return;
  }
  Settings s = widths_of(l, true);
  i64 n = number(l);
  View observer = view_of(l);
  if (!strcmp(kind, "screen")) {
    world_to_screen(&observer, &s, &m);
    say_loaded(l, load(&m, &s, (int)n, 1 << 14, &loaded), &loaded);
    return;
  }
  View light = view_of(l);
  observer_to_light(&observer, &light, n, &s, &m);
  say_loaded(l, load(&m, &s, (int)s.input_fraction, s.one_word, &loaded), &loaded);
}

static void ground(Line *l) {
  bool flat = !strcmp(word(l), "flat");
  Settings s = defaults();
  i64 fraction = 0, plane[3][3], points[3][3], centre[3], a[3], b[3], patch = 0;
  if (flat) {
    s = widths_of(l, true);
    fraction = number(l);
  } else {
    patch = number(l);
  }
  numbers(l, plane[0], 9);
  Patch control = plane_patch(plane[0], plane[1], plane[2]);
  numbers(l, points[0], flat ? 3 : 9);
  if (!flat) {
    ellipse(&control, points, 3, centre, a, b);
    says(l, centre, 3), says(l, a, 3), says(l, b, 3);
    Patch blob = ellipse_patch(centre, a, b, (int)patch);
    says(l, blob.p[0], 48);
    return;
  }
  View observer = view_of(l), light = view_of(l);
  Exact m;
  Loaded loaded;
  bool good = shadow_matrix(&observer, &light, &control, points, 1, &s, &m) &&
              load(&m, &s, (int)fraction, 1 << 14, &loaded);
  say_loaded(l, good, &loaded);
}

static void transform_unit(Line *l) {
  static const char *const statuses[] = {"ok", "divisor_not_positive", "overflow"};
  Settings s = widths_of(l, true);
  s.fraction_bits = number(l);
  s.accumulator_bits = number(l);
  set(&s, "product_rounding", word(l));
  set(&s, "transform_rounding", word(l));
  set(&s, "divide_order", word(l));
  widths(&s);
  Loaded m = {
      .affine = !strcmp(word(l), "affine"), .fraction = (int)s.input_fraction, .one = s.one_word};
  i64 p[3], out[3];
  numbers(l, m.c[0], 16);
  for (int r = 0; r < 4; ++r) m.e[r] = (int)number(l);
  numbers(l, p, 3);
  Status status = transform(&m, &s, p, out);
  write_word(l, statuses[status]);
  if (status == OK) says(l, out, 3);
}

static void noise(Line *l) {
  Settings s = defaults();
  s.xy_bits = number(l);
  s.fraction_bits = number(l);
  set(&s, "dither", word(l));
  int bytes = bytes_a_word(&s);
  i64 size = number(l), seed = number(l), px = number(l), py = number(l), d[2];
  Noise n = noise_at(seed, (u64)(16 * bytes * ((py << s.xy_bits) + px)));
  dither_pair(&n, bytes, amplitude(bytes, size, (int)s.fraction_bits), d);
  says(l, d, 2);
}

/* The light map of shadow_test.txt. */
static void map_codes(const Settings *s, int32_t map[256]) {
  for (i64 b = 0; b < 16; ++b)
    for (i64 a = 0; a < 16; ++a)
      map[16 * b + a] = (int32_t)((a + 2 * b) % 11 == 0
                                      ? s->background_code
                                      : (7919 * a + 104729 * b + 613 * a * b) % (1 << s->z_bits));
}

static void shadow_test(Line *l) {
  i64 words[3], p[3], dither[2];
  int32_t map[256];
  Settings s = defaults();
  if (!strcmp(word(l), "words")) {
    s = widths_of(l, false);
    set(&s, "registration", word(l));
    numbers(l, p, 3);
    input_words(p[0], p[1], p[2], &s, words);
    says(l, words, 3);
    return;
  }
  s.xy_bits = 4;
  s.z_bits = number(l);
  s.fraction_bits = number(l);
  set(&s, "lookup", word(l));
  set(&s, "background", word(l));
  widths(&s);
  numbers(l, p, 3), numbers(l, dither, 2);
  map_codes(&s, map);
  say(l, darkness(map, &s, p, dither, NULL, NULL, false));
}

static void windows(Line *l) {
  Settings s = defaults();
  i64 p[3], dither[2];
  int32_t map[256];
  int taps[25][2];
  s.xy_bits = 4;
  s.z_bits = number(l);
  s.fraction_bits = number(l);
  set(&s, "lookup", word(l));
  s.taps = number(l);
  set(&s, "tap_places", word(l));
  widths(&s);
  numbers(l, p, 3), numbers(l, dither, 2);
  i64 seed = number(l), px = number(l), py = number(l);
  map_codes(&s, map);
  tap_bytes(seed, s.taps, 16 * py + px, taps);
  say(l, darkness(map, &s, p, dither, taps, NULL, false));
}

static int digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

/* Hexadecimal: 256 pixels of a bit or a byte. */
static void unpacked(const char *digits, int32_t values[256], bool bytes) {
  for (int p = 0; p < 256; ++p)
    values[p] = bytes ? 16 * digit(digits[2 * p]) + digit(digits[2 * p + 1])
                      : digit(digits[p / 4]) >> (3 - p % 4) & 1;
}

static void filtered(Line *l, bool dequantized) {
  int32_t in[256], seen[256], out[256];
  bool visible[256];
  char digits[513];
  int passes = dequantized ? (int)number(l) : 0;
  unpacked(word(l), in, !dequantized);
  unpacked(word(l), seen, false);
  for (int p = 0; p < 256; ++p) {
    visible[p] = seen[p];
    if (dequantized) in[p] *= 255;
  }
  if (dequantized)
    dequantize(in, visible, passes, 16, out);
  else
    low_pass(in, visible, 16, out);
  for (int p = 0; p < 256; ++p) sprintf(digits + 2 * p, "%02x", (unsigned)out[p]);
  write_word(l, digits);
}

static void compute(Line *l, const char *stage) {
  static const struct {
    const char *name;
    void (*of)(Line *);
  } known[] = {{"decimals", decimals}, {"sines", sines},
               {"views", views},       {"matrices", matrices},
               {"ground", ground},     {"transform_unit", transform_unit},
               {"noise", noise},       {"shadow_test", shadow_test},
               {"windows", windows}};
  for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
    if (!strcmp(known[k].name, stage)) {
      known[k].of(l);
      return;
    }
  i64 n[4];
  if (!strcmp(stage, "dequantize"))
    filtered(l, true);
  else if (!strcmp(stage, "low_pass"))
    filtered(l, false);
  else if (!strcmp(stage, "composite"))
    numbers(l, n, 4), say(l, darken(n[0], n[1], n[2], n[3]));
  else
    surface_vector(l, stage);
}

static bool check_line(const char *path, int at, char *text, const char *stage) {
  char *words[512], *wanted = strstr(text, " -> ");
  static Line line;
  if (!wanted) fail("%s:%d: no result", path, at);
  *wanted = 0;
  wanted += 4;
  line = (Line){.words = words};
  for (char *next = strtok(text, " "); next && line.count < 512; next = strtok(NULL, " "))
    words[line.count++] = next;
  compute(&line, stage);
  if (!strcmp(line.result, wanted)) return true;
  printf("%s:%d: %s for %s  DIFFERS\n", path, at, line.result, wanted);
  return false;
}

static int check_stage(const char *folder, const char *stage) {
  char path[512], text[8192];
  snprintf(path, sizeof path, "%s/%s.txt", folder, stage);
  FILE *file = fopen(path, "r");
  if (!file) fail("%s: cannot be read", path);
  int lines = 0, wrong = 0;
  for (int at = 1; fgets(text, sizeof text, file); ++at) {
    text[strcspn(text, "\n")] = 0;
    if (!*text || *text == '#') continue;
    ++lines;
    wrong += !check_line(path, at, text, stage);
  }
  fclose(file);
  printf("%s: %d vectors, %d wrong\n", stage, lines, wrong);
  return wrong + !lines;
}

int check_vectors(const char *folder) {
  static const char *const stages[] = {
      "decimals",       "sines",       "patches",  "views",      "matrices", "ground",
      "transform_unit", "corrections", "splits",   "block_rule", "samples",  "shading",
      "triangles",      "dicing",      "bias",     "normals",    "noise",    "shadow_test",
      "windows",        "dequantize",  "low_pass", "composite"};
  int wrong = 0;
  for (size_t k = 0; k < sizeof stages / sizeof *stages; ++k)
    wrong += check_stage(folder, stages[k]);
  return wrong;
}
